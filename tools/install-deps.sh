#!/bin/sh
# Installs the Debian packages that are missing, and nothing else:
# tools/install-deps.sh [build] [test] [lint] [fuzz] [web]
#
# A package counts as installed if the needed part works (a command runs, a header is found) or if dpkg says so.
# If nothing is missing, on Debian or elsewhere, it installs nothing. It installs as root or with passwordless sudo;
# otherwise it lists what is missing and stops with exit status 1. It never prompts, and needs only a POSIX shell.
#   build  packages for building the program and its library
#   test   packages for building and running the tests
#   lint   the second compiler, the formatter and the static checks
#   fuzz   clang with libFuzzer and the sanitizers
#   web    clang and a C library for WebAssembly, and what runs it
set -eu

cc=${CC:-cc}
cxx=${CXX:-c++}

has_command() {
    command -v "$1" >/dev/null 2>&1
}

# has_header COMPILER LANGUAGE HEADER: the compiler finds the header
has_header() {
    printf '#include <%s>\n' "$3" | $1 -E -x "$2" - >/dev/null 2>&1
}

has_library() {
    pkg-config --exists "$1" 2>/dev/null
}

has_fuzzer() {
    ls "$(clang -print-runtime-dir 2>/dev/null)"/libclang_rt.fuzzer* >/dev/null 2>&1
}

has_wasm_runtime() {
    [ -e "$(clang --target=wasm32-wasi --rtlib=compiler-rt -print-libgcc-file-name 2>/dev/null)" ]
}

has_numpy() {
    python3 -c 'import numpy' 2>/dev/null || /usr/bin/python3 -c 'import numpy' 2>/dev/null
}

# The tests call Debian's Python for this one.
has_ezdxf() {
    /usr/bin/python3 -c 'import ezdxf' 2>/dev/null
}

# The tests draw pages in Chromium, or in a browser made from it.
has_browser() {
    has_command chromium || has_command chromium-browser || has_command google-chrome
}

has_tikz() {
    kpsewhich tikz.sty >/dev/null 2>&1
}

# Daemons are found by root alone.
has_sbin() {
    (PATH=$PATH:/usr/sbin:/sbin && has_command "$1")
}

has_package() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# need PACKAGE PROBE...: records the package if the probe fails
need() {
    package=$1
    shift
    "$@" || has_package "$package" || missing="$missing $package"
}

find_missing() {
    missing=
    for set in "$@"; do
        case $set in
        build)
            need gcc has_command "$cc"
            need libc6-dev has_header "$cc" c stdio.h
            need pkg-config has_command pkg-config
            need libcairo2-dev has_library cairo-svg
            need libqhull-dev has_library qhull_r
            need zlib1g-dev has_library zlib
            need hershey-fonts-data test -e "${HERSHEY:-/usr/share/hershey-fonts}/futural.jhf"
            ;;
        test)
            need libcmocka-dev has_library cmocka
            need g++ has_command "$cxx"
            need libcgal-dev has_header "$cxx" c++ CGAL/version.h
            need libgmp-dev has_header "$cxx" c++ gmp.h
            need libmpfr-dev has_header "$cxx" c++ mpfr.h
            need assimp-utils has_command assimp
            need librsvg2-bin has_command rsvg-convert
            need poppler-utils has_command pdftotext
            need python3-numpy has_numpy
            need python3-ezdxf has_ezdxf
            need chromium has_browser
            need openscad has_command openscad
            need gmsh has_command gmsh
            need qhull-bin has_command rbox
            need gnuplot-nox has_command gnuplot
            need ffmpeg has_command ffmpeg
            need texlive-latex-base has_command pdflatex
            need texlive-pictures has_tikz
            need parallel has_command parallel
            need slurmctld has_sbin slurmctld
            need slurmd has_sbin slurmd
            need munge has_sbin munged
            need locales test -e /usr/share/i18n/locales/de_DE
            ;;
        lint)
            need clang has_command clang
            need clang-format has_command clang-format
            need clang-tidy has_command clang-tidy
            need cppcheck has_command cppcheck
            ;;
        fuzz)
            need clang has_command clang
            need libclang-rt-dev has_fuzzer
            ;;
        web)
            need clang has_command clang
            need lld has_command wasm-ld
            need wasi-libc test -e /usr/include/wasm32-wasi/stdio.h
            need libclang-rt-dev-wasm32 has_wasm_runtime
            need bzip2 has_command bzip2
            need nodejs has_command node
            need node-typescript has_command tsc
            need chromium has_browser
            ;;
        *)
            echo "usage: $0 [build] [test] [lint] [fuzz] [web]" >&2
            exit 2
            ;;
        esac
    done
}

# refuse WHY: reports what is missing and stops
refuse() {
    echo "$0: $1; missing (by Debian's package names):" >&2
    printf '    %s\n' $missing >&2
    echo "as root: apt-get update && apt-get install --no-install-recommends$missing" >&2
    exit 1
}

find_missing "$@"
[ -n "$missing" ] || exit 0

has_command apt-get || refuse "there is no apt-get here"
if [ "$(id -u)" = 0 ]; then
    as_root=
elif sudo -n true 2>/dev/null; then
    as_root="sudo -n"
else
    refuse "not root, and no passwordless sudo"
fi

apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 "$@" </dev/null
}

echo "installing:$missing"
apt update || echo "$0: the package lists could not be brought up to date; trying with the old ones" >&2
apt install --no-install-recommends $missing || refuse "apt-get failed"
find_missing "$@"
[ -z "$missing" ] || refuse "apt-get did not install everything"
