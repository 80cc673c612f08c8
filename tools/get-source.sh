#!/bin/sh
# Unpacks the source of a Debian package into a folder: tools/get-source.sh PACKAGE FOLDER
#
# The sources come from where apt gets its packages, with its keys. Its own lists are left alone, so this needs no root.
set -eu
[ $# = 2 ] || { echo "usage: $0 PACKAGE FOLDER" >&2; exit 2; }
package=$1 folder=$2

command -v apt-get >/dev/null || { echo "$0: there is no apt-get here to get the source of $package" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
mkdir -p "$work/parts" "$work/lists/partial"
for list in /etc/apt/sources.list.d/*.sources; do
    [ ! -r "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" >"$work/parts/${list##*/}"
done
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ ! -r "$list" ] || sed -n 's/^deb /deb-src /p' "$list" >"$work/parts/${list##*/}.list"
done
chmod -R a+rX "$work"
cd "$work"
apt() {
    apt-get -qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/parts" \
        -o Dir::State::lists="$work/lists" -o APT::Sandbox::User=root "$@" </dev/null
}
apt update || echo "$0: not all lists of sources could be read" >&2
apt source --download-only "$package"
cd - >/dev/null
rm -rf "$folder"
mkdir -p "$folder"
tar -xf "$work/${package}"_*.orig.tar.* -C "$folder" --strip-components=1
