# `make help` lists the targets. Each kind of build (another compiler, other flags) needs a folder of its own: BUILD=...
# Prints one line for each file; V=1 prints the commands.
.DEFAULT_GOAL := all

CC       ?= cc
CXX      ?= c++
BUILD    ?= build
CFLAGS   ?= -O2 -g
# The oracle compiles faster than with -O2, and runs as fast.
CXXFLAGS ?= -O1
# Added to CFLAGS for most test programs: they compile in a quarter of the time, and run nearly as fast.
TEST_CFLAGS ?= -O0
WERROR   ?=
# Empty: a build without threads.
THREADS  ?= -pthread
V        ?=
Q        := $(if $(V),,@)
show      = $(if $(V),,@printf '  %-6s %s\n' $1 '$2')
STD      := -std=c17 -D_POSIX_C_SOURCE=200809L
# -ffp-contract=off: a fused multiply-add would make signs depend on the compiler (see src/base/vec.h)
# -fno-math-errno: a square root is one instruction, not followed by a test whether errno must be set; nothing reads it
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla
COMPILE   = $(CC) $(STD) $(WARN) $(WERROR) -ffp-contract=off -fno-math-errno -fPIC $(THREADS) $(CFLAGS) \
             -Iinclude -Isrc \
            $(TEST_DIRS) $(NEEDS) $(UNOPTIMIZED) -MMD -MP
LINK      = $(CC) $(THREADS) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^)
# Evaluated only where used: `make demo` must start without pkg-config.
NEEDS        =
UNOPTIMIZED  =
CAIRO_CFLAGS = $(shell pkg-config --cflags cairo zlib)
QHULL_CFLAGS = $(shell pkg-config --cflags qhull_r)
LIBS         = $(shell pkg-config --libs qhull_r zlib) -lm -ldl
CAIRO_LIBS   = $(shell pkg-config --libs cairo)
CMOCKA_LIBS  = $(shell pkg-config --libs cmocka)

LIB_SRC  := $(sort $(wildcard $(foreach room,base read model view hide ray draw write part,src/$(room)/*.c)))
CLI_SRC  := $(sort $(wildcard src/cli/*.c))
TOOL_SRC := $(sort $(wildcard tools/*.c))
MODEL_SRC:= $(sort $(wildcard tools/models/*.c))
TEST_SRC := $(sort $(wildcard tests/test_*.c tests/*/test_*.c))
ORACLE_P := tests/oracle/compare.c tests/oracle/mesh_compare.c tests/oracle/region_compare.c tests/oracle/regolden.c
ORACLE   := $(filter-out $(ORACLE_P) $(TEST_SRC),$(sort $(wildcard tests/oracle/*.c)))
ORACLE_X := $(sort $(wildcard tests/oracle/*.cpp))
PAPER_P  := tests/paper/compare.c
PAPER    := $(filter-out $(PAPER_P) $(TEST_SRC),$(sort $(wildcard tests/paper/*.c)))
FUZZ_SRC := $(filter-out $(TEST_SRC),$(sort $(wildcard tests/fuzz/*.c)))
C_SRC    := $(LIB_SRC) $(CLI_SRC) $(TOOL_SRC) $(MODEL_SRC) $(TEST_SRC) $(ORACLE) $(ORACLE_P) \
            $(FUZZ_SRC) $(PAPER) $(PAPER_P) tests/support/loose_ends.c
VERSION  := $(shell sed -n 's/^.define ROBERTS_VERSION "\(.*\)"/\1/p' include/roberts.h)
SONAME   := libroberts.so.$(firstword $(subst ., ,$(VERSION)))
SHARED   := libroberts.so.$(VERSION)
PREFIX   ?= /usr/local
LIBDIR   ?= $(PREFIX)/lib
# A relative PREFIX starts here: roberts.pc needs an absolute path. (Not $(abspath): it splits names at blanks.)
from_here = $(if $(filter /%,$(firstword $1)),$1,$(if $1,$(CURDIR)/$1))
override PREFIX := $(call from_here,$(PREFIX:~/%=$(HOME)/%))
override LIBDIR := $(call from_here,$(LIBDIR:~/%=$(HOME)/%))
ifneq ($(findstring ',$(PREFIX)$(LIBDIR)$(DESTDIR)),)
$(error PREFIX, LIBDIR and DESTDIR must have no apostrophe in them)
endif
ifneq ($(word 2,$(BUILD)),)
$(error BUILD=$(BUILD): make cannot build in a folder with blanks in its name)
endif
object    = $(1:%.c=$(BUILD)/obj/%.o)
HERSHEY  ?= /usr/share/hershey-fonts
TOOL_BIN := $(TOOL_SRC:%.c=$(BUILD)/%)
PAGES    := $(BUILD)/roberts.1 $(BUILD)/completions/bash $(BUILD)/completions/zsh $(BUILD)/completions/fish
# tests/unit/test_off.c becomes build/tests/test_off: names of tests are unique across folders.
TEST_BIN := $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(TEST_SRC)))
# `make test-quick` omits these. The others take less than 20 s together, on two idle cores. Those that take longest
# begin first, so that none is left at the end.
SLOW     := mesh_oracle cluster render metamorphic memory_order oracle paper readme region_oracle same_bytes \
            cross_oracle faults layers batch install off labels union_drawing verify_spoiled union image union_oracle \
            fault_files python verify web objet face_pieces parts covers strokes
SLOW_BIN  = $(SLOW:%=$(BUILD)/tests/test_%)
QUICK_BIN = $(filter-out $(SLOW_BIN),$(TEST_BIN))
RUN_TESTS = CC='$(CC)' CXX='$(CXX)' CFLAGS_USED='$(CFLAGS)' ROBERTS_BUILD=$(BUILD) \
            LOCPATH='$(abspath $(BUILD)/locale)' tests/run.sh
DEMO     := table temple tower staircase city lattice
EDGES    ?= 5000000
REGIONS  ?= 1000000
DRAWINGS ?= 1000
SANITIZE := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
FUZZER   := $(FUZZ_SRC:tests/fuzz/%.c=$(BUILD)/fuzz/%)
FUZZ     := -O1 -g -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
FUZZ_SECONDS ?= 60

##@ Start with these; both install missing packages, as root or with passwordless sudo
demo: ## builds the program and draws some of models/ to build/demo/*.svg
	@CC='$(CC)' tools/install-deps.sh build
	@$(MAKE) --no-print-directory drawings

check: ## builds everything, runs all tests
	@CC='$(CC)' CXX='$(CXX)' tools/install-deps.sh build test
	@$(MAKE) --no-print-directory test

##@ To build and test with the installed packages
all: $(BUILD)/roberts $(BUILD)/libroberts.a $(PAGES) ## program, library and manual page (what `make` alone does)

tools: $(TOOL_BIN) ## builds the tools for building and measuring, in build/tools/

models: $(BUILD)/tools/make-models ## rewrites the files of models/
	$< --all models

figures: $(BUILD)/roberts ## redraws the figures of src/*/README.md, in models/figures/
	ROBERTS_BUILD=$(BUILD) tools/draw-figures.sh

gallery: $(BUILD)/roberts ## redraws the pictures of README's gallery, in models/gallery/
	ROBERTS_BUILD=$(BUILD) tools/draw-gallery.sh

drawings: $(PAGES) $(DEMO:%=$(BUILD)/demo/%.svg) ## manual page, completions and the drawings of `make demo`
	@echo "drawn: $(sort $(filter %.svg,$^))"

TESTED   := all tools $(BUILD)/$(SHARED) $(BUILD)/locale/de_DE.UTF-8

test: check-includes check-map $(TESTED) $(TEST_BIN) ## runs all tests, JOBS=n programs at a time
	@$(RUN_TESTS) $(SLOW_BIN) $(QUICK_BIN)

test-quick: $(TESTED) $(QUICK_BIN) ## runs the quick tests; `make test` also has the slow ones (SLOW)
	@$(RUN_TESTS) $(QUICK_BIN)

# 5,000,000 edges and 1,000,000 regions against the exact oracles (EDGES=n, REGIONS=n), 1,000 drawings against their
# tables (DRAWINGS=n)
LONG := $(addprefix $(BUILD)/tests/,oracle/compare oracle/mesh_compare oracle/region_compare test_regions paper/compare)
check-long: $(LONG) ## compares millions of edges with the oracle; fuzzes
	$(BUILD)/tests/oracle/compare --folder $(BUILD) --edges $(EDGES) --per-family
	$(BUILD)/tests/oracle/mesh_compare --folder $(BUILD) --edges $(EDGES)
	$(BUILD)/tests/oracle/region_compare --folder $(BUILD) --regions $(REGIONS)
	REGIONS=$(REGIONS) $(BUILD)/tests/test_regions
	$(BUILD)/tests/paper/compare --folder $(BUILD) --count $(DRAWINGS)
	@$(MAKE) --no-print-directory fuzz

fuzz: ## runs all fuzzers, FUZZ_SECONDS=60 each; needs clang (tools/install-deps.sh fuzz)
	@$(MAKE) --no-print-directory fuzzers BUILD=$(BUILD)/fuzzing CC=clang THREADS= CFLAGS='$(FUZZ)'
	tests/fuzz/fuzz.sh $(BUILD)/fuzzing $(FUZZ_SECONDS)

goldens: $(BUILD)/tests/oracle/regolden ## rewrites tests/golden/ where program and oracle agree
	@find models -name '*.off' ! -path 'models/star/*' ! -path 'models/shapes/*' | sort | while read -r model; do \
	    case $$model in models/tests/*) view=top ;; *) view=iso ;; esac; \
	    golden=tests/golden/$${model#models/}; mkdir -p $${golden%/*}; \
	    $< $$model $$view $${golden%.off}.txt || exit 1; done

test-sanitize: ## runs the tests with the address and undefined behaviour sanitizers, in build/sanitize/
	@$(MAKE) --no-print-directory test BUILD=$(BUILD)/sanitize CFLAGS='$(SANITIZE)' CXXFLAGS='$(SANITIZE)'

bench: all tools ## measures speed and memory, 10 minutes; shorter: BENCH_MAX=1e5 (see tools/bench.sh)
	ROBERTS_BUILD=$(BUILD) CC='$(CC)' tools/bench.sh

bench-meshes: all tools ## measures only triangle meshes, up to 1.4 million triangles
	ROBERTS_BUILD=$(BUILD) CC='$(CC)' tools/bench.sh all-meshes

bench-web: web tools ## measures the frames per second of the page, in node and in Chromium
	node tools/bench-web.mjs $(BUILD)
	node tools/bench-page.mjs $(BUILD)

bench-baseline: all tools ## counts instructions (valgrind) and writes them to tools/bench-baseline.txt
	ROBERTS_BUILD=$(BUILD) CC='$(CC)' tools/bench.sh baseline

test-threads: ## runs the tests with several threads under the thread sanitizer, in build/threads/
	@$(MAKE) --no-print-directory build/threads/tests/test_threads build/threads/tests/test_off_pieces \
	    build/threads/tests/test_schedule BUILD=build/threads CFLAGS='-O1 -g -fsanitize=thread'
	TSAN_OPTIONS=suppressions=tests/threads.supp build/threads/tests/test_threads
	build/threads/tests/test_off_pieces
	build/threads/tests/test_schedule

##@ To install
TO  = $(DESTDIR)$(PREFIX)
LIB = $(DESTDIR)$(LIBDIR)
to-install: all $(BUILD)/$(SHARED)
	@:

# Checks the rights before it builds anything. What another user has built completely can be installed as it is.
install: ## program, man page, completions, libraries, header and roberts.pc
	@for folder in '$(TO)/bin' '$(TO)/include' '$(TO)/share/man/man1' '$(LIB)/pkgconfig'; do \
	    there=$$folder; while [ ! -e "$$there" ]; do there=$$(dirname "$$there"); done; \
	    mkdir -p "$$folder" 2>/dev/null && [ -w "$$folder" ] || { \
	        [ "$$(id -u)" = 0 ] && how='choose another PREFIX' || how='as root: sudo make install'; \
	        echo "make install: cannot write to $$there; $$how; or for yourself alone:" >&2; \
	        echo "    make install PREFIX=\"$$HOME/.local\"" >&2; exit 1; }; done
	@$(MAKE) --no-print-directory to-install || { [ -w '$(BUILD)' ] || { \
	    echo "make install: cannot write to $(BUILD), where it builds; choose a folder of your own:" >&2; \
	    echo "    make install BUILD=FOLDER" >&2; }; exit 1; }
	$(Q)install -d '$(TO)/bin' '$(TO)/include' '$(LIB)/pkgconfig'
	$(Q)install -m 755 $(BUILD)/roberts '$(TO)/bin/'
	$(Q)install -m 644 include/roberts.h '$(TO)/include/'
	$(Q)install -m 644 $(BUILD)/libroberts.a $(BUILD)/$(SHARED) '$(LIB)/'
	$(Q)ln -sf $(SHARED) '$(LIB)/$(SONAME)'
	$(Q)ln -sf $(SONAME) '$(LIB)/libroberts.so'
	@# Libs.private: what else a program needs that links the static library.
	@printf '%s\n' 'prefix=$(PREFIX)' 'libdir=$(LIBDIR)' 'includedir=$${prefix}/include' '' 'Name: roberts' \
	    'Description: line drawings of polyhedra with the hidden lines removed' 'Version: $(VERSION)' \
	    'Requires.private: qhull_r zlib' 'Libs: -L"$${libdir}" -lroberts' 'Libs.private: $(THREADS) -lm -ldl' \
	    'Cflags: -I"$${includedir}"' >'$(LIB)/pkgconfig/roberts.pc'
	$(Q)chmod 644 '$(LIB)/pkgconfig/roberts.pc'
	$(Q)install -D -m 644 $(BUILD)/roberts.1 '$(TO)/share/man/man1/roberts.1'
	$(Q)install -D -m 644 $(BUILD)/completions/bash '$(TO)/share/bash-completion/completions/roberts'
	$(Q)install -D -m 644 $(BUILD)/completions/zsh '$(TO)/share/zsh/site-functions/_roberts'
	$(Q)install -D -m 644 $(BUILD)/completions/fish '$(TO)/share/fish/vendor_completions.d/roberts.fish'
	@# As root, renew the loader's cache if the loader searches LIBDIR. Packages (DESTDIR) do that themselves.
	@if [ -z '$(DESTDIR)' ] && [ "$$(id -u)" = 0 ] && ldconfig -v -N -X 2>/dev/null | grep -q '^$(LIBDIR):'; then \
	    ldconfig; fi
	@echo 'installed below $(TO)'

PYTHON   ?= python3
# Where Python looks for packages below PREFIX: Debian's own packages are elsewhere than what is installed locally.
PYTHONTO ?= $(PREFIX)/lib/$(if $(filter /usr,$(PREFIX)),python3/dist-packages,$\
            $(shell $(PYTHON) -c 'import sys; v = sys.version_info; print("python%d.%d" % v[:2])')/$\
            $(if $(filter /usr/local,$(PREFIX)),dist,site)-packages)
install-python: install ## the same, and the Python package (PYTHON=python3, PYTHONTO= its folder)
	$(Q)install -d '$(DESTDIR)$(PYTHONTO)/roberts'
	$(Q)install -m 644 src/python/roberts/*.py src/python/roberts/py.typed '$(DESTDIR)$(PYTHONTO)/roberts/'
	$(Q)sed 's|^INSTALLED = .*|INSTALLED = "$(LIBDIR)/$(SONAME)"|' src/python/roberts/_library.py \
	    >'$(DESTDIR)$(PYTHONTO)/roberts/_library.py'
	@echo 'the package is in $(DESTDIR)$(PYTHONTO)'
	@$(PYTHON) -c 'import sys; sys.exit("$(PYTHONTO)" not in sys.path)' || \
	    echo '$(PYTHON) does not look there; set PYTHONPATH=$(PYTHONTO)'
	@$(PYTHON) -c 'import numpy' 2>/dev/null || echo 'it needs numpy, which $(PYTHON) lacks (Debian: python3-numpy)'

uninstall: ## removes the installed files
	$(Q)rm -f '$(TO)/bin/roberts' '$(TO)/include/roberts.h' '$(LIB)/libroberts.a' '$(LIB)'/libroberts.so* \
	    '$(LIB)/pkgconfig/roberts.pc' '$(TO)/share/man/man1/roberts.1' \
	    '$(TO)/share/bash-completion/completions/roberts' '$(TO)/share/zsh/site-functions/_roberts' \
	    '$(TO)/share/fish/vendor_completions.d/roberts.fish'
	$(Q)rm -rf '$(DESTDIR)$(PYTHONTO)/roberts'

include src/web/module.mk

##@ To check
check-includes: ## checks that the includes of src/ point one way (part of `make test`)
	@tools/check-includes.sh

check-map: ## checks that src/README.md names every source (part of `make test`)
	@tools/check-map.sh

lint: lint-format lint-tidy lint-cppcheck ## runs the formatter and static checks (tools/install-deps.sh lint)

clean: ## removes build/
	rm -rf $(BUILD)

help: ## lists the targets
	@sed -n -e 's/^##@ \(.*\)/\n\1:/p' -e 's/^\([a-z-]*\):[^#]*## \(.*\)/  make \1\t\2/p' Makefile src/web/module.mk | \
	    expand -t 24
	@printf '\nVariables: CC CXX CFLAGS CXXFLAGS TEST_CFLAGS LDFLAGS WERROR=-Werror THREADS= V=1 BUILD= '
	@printf 'PREFIX= LIBDIR= DESTDIR=\n'

# How things are made
$(BUILD)/libroberts.a: $(call object,$(LIB_SRC))
	$(call show,AR,$@)
	$(Q)rm -f $@ && $(AR) rcs $@ $^

# Only functions declared in roberts.h can be called from outside.
$(BUILD)/$(SHARED): $(call object,$(LIB_SRC))
	@printf '{ global: roberts_*; local: *; };\n' >$(BUILD)/exported.map
	$(call show,LD,$@)
	$(Q)$(CC) $(THREADS) $(CFLAGS) $(LDFLAGS) -shared -Wl,-soname,$(SONAME) -Wl,--version-script,$(BUILD)/exported.map \
	    -Wl,-z,defs -o $@ $^ $(LIBS)

$(BUILD)/roberts: $(call object,$(CLI_SRC)) $(BUILD)/libroberts.a
	$(call show,LD,$@)
	$(Q)$(LINK) $(LIBS)

$(TOOL_BIN): $(BUILD)/%: $(BUILD)/obj/%.o $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(call show,LD,$@)
	$(Q)$(LINK) $(LIBS)

$(BUILD)/tools/make-models: $(call object,$(MODEL_SRC))
$(BUILD)/tools/print-options: $(filter-out %/main.o,$(call object,$(CLI_SRC)))

# The manual page and the completions get the options from their table in src/cli/option_table.c.
$(BUILD)/roberts.1: src/cli/roberts.1 $(BUILD)/tools/print-options
	$(call show,GEN,$@)
	$(Q)$(BUILD)/tools/print-options manual <$< >$@

$(BUILD)/completions/%: src/cli/completions/% $(BUILD)/tools/print-options
	@mkdir -p $(@D)
	$(call show,GEN,$@)
	$(Q)$(BUILD)/tools/print-options $* <$< >$@

$(BUILD)/obj/tests/%.o: TEST_DIRS = -iquote tests -iquote tests/support
# The oracles, the readers of pages and some tests compute much: they keep CFLAGS as they are.
$(BUILD)/obj/tests/unit/%.o $(BUILD)/obj/tests/cli/%.o $(BUILD)/obj/tests/faults/%.o: UNOPTIMIZED = $(TEST_CFLAGS)
OPTIMIZED := unit/test_image unit/test_metamorphic unit/test_objet cli/test_render
$(OPTIMIZED:%=$(BUILD)/obj/tests/%.o): UNOPTIMIZED =
$(foreach test,$(TEST_SRC),$(eval $(BUILD)/tests/$(basename $(notdir $(test))): $(call object,$(test))))
$(TEST_BIN): $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(call show,LD,$@)
	$(Q)$(LINK) $(TEST_LIBS) $(CMOCKA_LIBS) $(LIBS)

# Tests that look at pixels. (The program itself loads Cairo when it needs it.)
$(patsubst %,$(BUILD)/tests/test_%,gallery image render): TEST_LIBS = $(CAIRO_LIBS)

# Tests that make allocations fail: tests/support/memory.h
$(BUILD)/tests/test_memory_%: TEST_LIBS = -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc \
    -Wl,--wrap=posix_memalign,--wrap=free

# The fuzzers: libFuzzer has main() and calls a function with a fixed name, which the linker maps to ours.
fuzzers: $(FUZZER)
$(FUZZER): $(BUILD)/fuzz/%: $(BUILD)/obj/tests/fuzz/%.o $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(call show,LD,$@)
	$(Q)$(LINK) -fsanitize=fuzzer -Wl,--defsym=LLVMFuzzerTestOneInput=$* $(LIBS)

# The checks of every reader
$(FUZZER): $(call object,tests/fuzz/fuzz_read.c)

# Tests of the program's own functions
$(BUILD)/tests/test_options $(BUILD)/tests/test_verify_report $(BUILD)/tests/test_names \
    $(BUILD)/tests/test_memory_names $(BUILD)/tests/test_batch_memory \
    $(BUILD)/tests/test_format_table: $(filter-out %/main.o,$(call object,$(CLI_SRC)))
$(BUILD)/tests/test_fuzz: $(call object,$(FUZZ_SRC))

$(BUILD)/tests/test_loose_ends: $(call object,tests/support/loose_ends.c)

# The exact oracle: C++ with CGAL, only for tests.
ORACLE_CGAL := $(BUILD)/obj/tests/oracle/cgal.o
ORACLE_OBJ  := $(call object,$(ORACLE)) $(ORACLE_CGAL)
ORACLE_LIBS := -lgmp -lmpfr -lstdc++
ORACLE_TEST := $(BUILD)/tests/test_oracle $(BUILD)/tests/test_mesh_oracle $(BUILD)/tests/test_cross_oracle \
               $(BUILD)/tests/test_union_oracle $(BUILD)/tests/test_region_oracle $(BUILD)/tests/test_golden
$(ORACLE_TEST): $(ORACLE_OBJ)
$(ORACLE_TEST): TEST_LIBS = $(ORACLE_LIBS)

$(ORACLE_P:%.c=$(BUILD)/%): $(BUILD)/%: $(BUILD)/obj/%.o $(ORACLE_OBJ) $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(call show,LD,$@)
	$(Q)$(LINK) $(ORACLE_LIBS) $(LIBS)

# Reading pages back: PDF with zlib, PNG with Cairo. The scenes are those of the oracle.
PAPER_LIBS  = $(ORACLE_LIBS) $(CAIRO_LIBS)
PAPER_TEST := $(BUILD)/tests/test_paper $(BUILD)/tests/test_plots
$(PAPER_TEST): $(call object,$(PAPER)) $(ORACLE_OBJ)
$(PAPER_TEST): TEST_LIBS = $(PAPER_LIBS)

$(PAPER_P:%.c=$(BUILD)/%): $(BUILD)/%: $(BUILD)/obj/%.o $(call object,$(PAPER)) $(ORACLE_OBJ) $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(LINK) $(PAPER_LIBS) $(LIBS)

# All are compiled as one, since most of the time goes to CGAL's headers. So a name must not stand in two of them.
# -frounding-math: intervals of doubles change the rounding mode, so the compiler must not assume one.
# CGAL_HAS_NO_THREADS: its numbers take no locks. The oracle is asked by one thread.
$(ORACLE_CGAL): $(ORACLE_X) $(BUILD)/flags
	@mkdir -p $(@D)
	$(call show,CXX,tests/oracle/*.cpp)
	$(Q)$(CXX) -std=c++17 -Wall -Wextra -Wshadow $(WERROR) -frounding-math -DCGAL_HAS_NO_THREADS $(CXXFLAGS) \
	    -Iinclude -MMD -MP \
	    $(ORACLE_X:%=-include %) -x c++ -c -o $@ /dev/null

$(BUILD)/obj/src/write/%.o $(BUILD)/obj/tests/paper/%.o: NEEDS = $(CAIRO_CFLAGS)
$(BUILD)/obj/tests/unit/test_image.o $(BUILD)/obj/tests/cli/test_render.o \
    $(BUILD)/obj/tests/cli/test_gallery.o: NEEDS = $(CAIRO_CFLAGS)
$(BUILD)/obj/src/model/hull.o: NEEDS = $(QHULL_CFLAGS)

# The letters, from the fonts of HERSHEY
$(BUILD)/obj/src/draw/letters.o: NEEDS = -I$(BUILD)/generated
$(BUILD)/obj/src/draw/letters.o: $(BUILD)/generated/draw/letters_data.h
$(BUILD)/generated/draw/letters_data.h: tools/make-letters.sh $(wildcard $(HERSHEY)/futural.jhf $(HERSHEY)/greeks.jhf)
	@mkdir -p $(@D)
	$(call show,GEN,$@)
	$(Q)tools/make-letters.sh '$(HERSHEY)' >$@

$(BUILD)/obj/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(call show,CC,$<)
	$(Q)$(COMPILE) -c -o $@ $<

# The compiler and its flags as last used: when they change, everything is recompiled.
FLAGS = $(CC) $(CXX) $(THREADS) $(CFLAGS) $(CXXFLAGS) $(TEST_CFLAGS) $(WERROR) $(LDFLAGS)
$(BUILD)/flags: force
	@mkdir -p $(@D)
	@echo '$(FLAGS)' | cmp -s - $@ || echo '$(FLAGS)' >$@

$(BUILD)/demo/%.svg: models/%.off $(BUILD)/roberts
	@mkdir -p $(@D)
	$(call show,DRAW,$@)
	$(Q)$(BUILD)/roberts $< -o $@

# A locale that writes 0,5: tests check that nothing depends on the locale. Without it they are skipped.
$(BUILD)/locale/de_DE.UTF-8:
	@mkdir -p $(@D)
	-@localedef -i de_DE -f UTF-8 $@ 2>/dev/null || echo "no locale de_DE.UTF-8: its tests are skipped"

# Static checks, warnings as errors
C_FILES  = $(wildcard include/*.h src/*/*.[ch] tools/*.[ch] tools/*/*.[ch] tests/*.[ch] tests/*/*.[ch] tests/*/*.cpp)
CPUS     = $(shell nproc 2>/dev/null || echo 1)
lint-format:
	@echo clang-format on $(words $(C_FILES)) files
	$(Q)clang-format --dry-run -Werror $(C_FILES)

lint-tidy: $(BUILD)/generated/draw/letters_data.h
	@mkdir -p $(BUILD)
	@echo clang-tidy on $(words $(C_SRC)) files
	@printf '%s\n' $(C_SRC) | xargs -P $(CPUS) -I FILE \
	    clang-tidy --quiet FILE -- $(STD) $(WARN) -Iinclude -Isrc -I$(BUILD)/generated -iquote tests \
	    -iquote tests/support \
	    $(patsubst -I%,-isystem%,$(CAIRO_CFLAGS) $(QHULL_CFLAGS)) 2>$(BUILD)/tidy.err || \
	    { cat $(BUILD)/tidy.err; exit 1; }

# uninitvar is off: it mistakes taking an address for a use, and does not see that two loops have the same length. Both
# compilers and the analyzer of clang-tidy check the same thing.
lint-cppcheck:
	@echo cppcheck on src and tools
	$(Q)cppcheck --quiet --error-exitcode=1 --enable=warning,performance,portability --inline-suppr \
	    --suppress=missingIncludeSystem --suppress=uninitvar -j $(CPUS) --std=c11 -Iinclude -Isrc src tools

.PHONY: all bench bench-baseline bench-meshes bench-web check check-includes check-long check-map clean demo \
    drawings figures force fuzz fuzzers gallery goldens help install install-python lint lint-cppcheck lint-format \
    lint-tidy models test test-quick test-sanitize test-threads to-install tools uninstall web
.SECONDARY:
.DELETE_ON_ERROR:
-include $(patsubst %.c,$(BUILD)/obj/%.d,$(C_SRC)) $(ORACLE_CGAL:.o=.d)
