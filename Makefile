# `make help` lists the targets. Each kind of build (another compiler, other flags) has a folder of its own: BUILD=...
.DEFAULT_GOAL := all

CC       ?= cc
CXX      ?= c++
BUILD    ?= build
CFLAGS   ?= -O2 -g
CXXFLAGS ?= -O2 -g
WERROR   ?=
# Empty for a build without threads; clang then needs no libomp-dev.
OPENMP   ?= -fopenmp
STD      := -std=c17 -D_POSIX_C_SOURCE=200809L
# -ffp-contract=off: a fused multiply-add would make signs depend on the compiler (see src/base/vec.h)
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla
COMPILE   = $(CC) $(STD) $(WARN) $(WERROR) -ffp-contract=off -fPIC $(OPENMP) $(CFLAGS) -Iinclude -Isrc $(TEST_DIRS) $(NEEDS) -MMD -MP
LINK      = $(CC) $(OPENMP) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^)
# Asked for only where used: `make demo` has to start without pkg-config.
NEEDS        =
CAIRO_CFLAGS = $(shell pkg-config --cflags cairo)
QHULL_CFLAGS = $(shell pkg-config --cflags qhull_r)
LIBS         = $(shell pkg-config --libs cairo qhull_r) -lm
CMOCKA_LIBS  = $(shell pkg-config --libs cmocka)

LIB_SRC  := $(sort $(wildcard $(foreach room,base model view hide ray draw,src/$(room)/*.c)))
CLI_SRC  := $(sort $(wildcard src/cli/*.c))
TOOL_SRC := $(sort $(wildcard tools/*.c))
MODEL_SRC:= $(sort $(wildcard tools/models/*.c))
TEST_SRC := $(sort $(wildcard tests/test_*.c tests/*/test_*.c))
ORACLE_P := tests/oracle/compare.c tests/oracle/regolden.c
ORACLE   := $(filter-out $(ORACLE_P) $(TEST_SRC),$(sort $(wildcard tests/oracle/*.c)))
ORACLE_X := $(sort $(wildcard tests/oracle/*.cpp))
FUZZ_SRC := $(filter-out $(TEST_SRC),$(sort $(wildcard tests/fuzz/*.c)))
C_SRC    := $(LIB_SRC) $(CLI_SRC) $(TOOL_SRC) $(MODEL_SRC) $(TEST_SRC) $(ORACLE) $(ORACLE_P) \
            $(FUZZ_SRC)
VERSION  := $(shell sed -n 's/^.define ROBERTS_VERSION "\(.*\)"/\1/p' include/roberts.h)
SONAME   := libroberts.so.$(firstword $(subst ., ,$(VERSION)))
SHARED   := libroberts.so.$(VERSION)
PREFIX   ?= /usr/local
LIBDIR   ?= $(PREFIX)/lib
object    = $(1:%.c=$(BUILD)/obj/%.o)
TOOL_BIN := $(TOOL_SRC:%.c=$(BUILD)/%)
# tests/unit/test_off.c becomes build/tests/test_off: names of tests are different in all folders.
TEST_BIN := $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(TEST_SRC)))
# What takes longer than a second or two is left out of `make test-quick`.
SLOW     := fault_files faults install memory_ahead metamorphic off oracle render same_bytes hull_memory
QUICK_BIN = $(filter-out $(SLOW:%=$(BUILD)/tests/test_%),$(TEST_BIN))
RUN_TESTS = CC='$(CC)' CXX='$(CXX)' CFLAGS_USED='$(CFLAGS)' ROBERTS_BUILD=$(BUILD) \
            LOCPATH='$(abspath $(BUILD)/locale)' tests/run.sh
DEMO     := table temple tower staircase city lattice
EDGES    ?= 5000000
SANITIZE := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
FUZZER   := $(BUILD)/fuzz/fuzz_read $(BUILD)/fuzz/fuzz_pipeline
FUZZ     := -O1 -g -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
FUZZ_SECONDS ?= 60

##@ The two to begin with; both install what is missing, as root or by a sudo that asks nothing
demo: ## builds, and draws some of models/ to build/demo/*.svg
	CC='$(CC)' tools/install-deps.sh build
	@$(MAKE) --no-print-directory drawings

check: ## builds everything, runs all tests
	CC='$(CC)' CXX='$(CXX)' tools/install-deps.sh build test
	@$(MAKE) --no-print-directory test

##@ To build and test with what is there
all: $(BUILD)/roberts $(BUILD)/libroberts.a ## the program and the library (what `make` alone does)

tools: $(TOOL_BIN) ## what helps to build and measure, to build/tools/

models: $(BUILD)/tools/make-models ## the files of models/, anew
	$< --all models

figures: $(BUILD)/roberts ## the figures of src/*/README.md, anew, to models/figures/
	ROBERTS_BUILD=$(BUILD) tools/draw-figures.sh

gallery: $(BUILD)/roberts ## the pictures of README's gallery, anew, to models/gallery/
	ROBERTS_BUILD=$(BUILD) tools/draw-gallery.sh

drawings: $(DEMO:%=$(BUILD)/demo/%.svg) ## the drawings of `make demo`
	@echo "drawn: $(sort $^)"

test: all tools $(BUILD)/$(SHARED) $(BUILD)/roberts.pc $(TEST_BIN) $(BUILD)/locale/de_DE.UTF-8 ## runs all tests
	@$(RUN_TESTS) $(TEST_BIN)

test-quick: all tools $(QUICK_BIN) $(BUILD)/locale/de_DE.UTF-8 ## runs the fast ones, for work in between
	@$(RUN_TESTS) $(QUICK_BIN)

check-long: $(BUILD)/tests/oracle/compare ## some 5,000,000 edges against the exact oracle (EDGES=n), and a short fuzzing
	$(BUILD)/tests/oracle/compare --folder $(BUILD) --edges $(EDGES) --per-family
	@$(MAKE) --no-print-directory fuzz

fuzz: ## both fuzzers, by clang, FUZZ_SECONDS=60 each (tools/install-deps.sh fuzz)
	@$(MAKE) --no-print-directory fuzzers BUILD=$(BUILD)/fuzzing CC=clang OPENMP= CFLAGS='$(FUZZ)'
	tests/fuzz/fuzz.sh $(BUILD)/fuzzing $(FUZZ_SECONDS)

goldens: $(BUILD)/tests/oracle/regolden ## tests/golden/ anew, as far as program and oracle agree
	@find models -name '*.off' | sort | while read -r model; do \
	    case $$model in models/tests/*) view=top ;; *) view=iso ;; esac; \
	    golden=tests/golden/$${model#models/}; mkdir -p $${golden%/*}; \
	    $< $$model $$view $${golden%.off}.txt || exit 1; done

test-sanitize: ## the same with the address and the undefined behaviour sanitizer, in build/sanitize/
	@$(MAKE) --no-print-directory test BUILD=$(BUILD)/sanitize CFLAGS='$(SANITIZE)' CXXFLAGS='$(SANITIZE)'

bench: all tools ## measures speed and memory, 10 minutes; shorter: BENCH_MAX=1e5 (see tools/bench.sh)
	ROBERTS_BUILD=$(BUILD) CC='$(CC)' tools/bench.sh

bench-baseline: all tools ## counts instructions (valgrind) and keeps them in tools/bench-baseline.txt
	ROBERTS_BUILD=$(BUILD) CC='$(CC)' tools/bench.sh baseline

test-threads: ## calls the library from several threads at once, and reads and hides by them, under the thread sanitizer, in build/threads/
	@$(MAKE) --no-print-directory build/threads/tests/test_threads build/threads/tests/test_off_pieces build/threads/tests/test_hide_chunks \
	    BUILD=build/threads OPENMP= CFLAGS='-O1 -g -fsanitize=thread'
	TSAN_OPTIONS=suppressions=tests/threads.supp build/threads/tests/test_threads
	build/threads/tests/test_off_pieces
	build/threads/tests/test_hide_chunks

##@ To install
install: all $(BUILD)/$(SHARED) $(BUILD)/roberts.pc ## program, man page, completions, libraries, header and roberts.pc
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(PREFIX)/include
	install -m 755 $(BUILD)/roberts $(DESTDIR)$(PREFIX)/bin/
	install -m 644 include/roberts.h $(DESTDIR)$(PREFIX)/include/
	install -m 644 $(BUILD)/libroberts.a $(BUILD)/$(SHARED) $(DESTDIR)$(LIBDIR)/
	ln -sf $(SHARED) $(DESTDIR)$(LIBDIR)/$(SONAME)
	ln -sf $(SONAME) $(DESTDIR)$(LIBDIR)/libroberts.so
	install -m 644 $(BUILD)/roberts.pc $(DESTDIR)$(LIBDIR)/pkgconfig/
	install -D -m 644 src/cli/roberts.1 $(DESTDIR)$(PREFIX)/share/man/man1/roberts.1
	install -D -m 644 src/cli/completions/bash $(DESTDIR)$(PREFIX)/share/bash-completion/completions/roberts
	install -D -m 644 src/cli/completions/zsh $(DESTDIR)$(PREFIX)/share/zsh/site-functions/_roberts
	install -D -m 644 src/cli/completions/fish $(DESTDIR)$(PREFIX)/share/fish/vendor_completions.d/roberts.fish
	@# The loader's cache, where the loader looks into LIBDIR: root alone can renew it, and packages (DESTDIR) do it themselves.
	@if [ -z "$(DESTDIR)" ] && [ "$$(id -u)" = 0 ] && ldconfig -v -N -X 2>/dev/null | grep -q "^$(LIBDIR):"; then ldconfig; fi

uninstall: ## takes them away again
	rm -f $(DESTDIR)$(PREFIX)/bin/roberts $(DESTDIR)$(PREFIX)/include/roberts.h \
	    $(DESTDIR)$(LIBDIR)/libroberts.a $(DESTDIR)$(LIBDIR)/libroberts.so* $(DESTDIR)$(LIBDIR)/pkgconfig/roberts.pc \
	    $(DESTDIR)$(PREFIX)/share/man/man1/roberts.1 \
	    $(DESTDIR)$(PREFIX)/share/bash-completion/completions/roberts \
	    $(DESTDIR)$(PREFIX)/share/zsh/site-functions/_roberts \
	    $(DESTDIR)$(PREFIX)/share/fish/vendor_completions.d/roberts.fish

##@ To check
lint: lint-format lint-tidy lint-cppcheck ## formatter and static checks (tools/install-deps.sh lint)

clean: ## removes build/
	rm -rf $(BUILD)

help: ## lists the targets
	@sed -n -e 's/^##@ \(.*\)/\n\1:/p' -e 's/^\([a-z-]*\):[^#]*## \(.*\)/  make \1\t\2/p' Makefile | expand -t 24
	@printf '\nVariables: CC CXX CFLAGS CXXFLAGS LDFLAGS WERROR=-Werror OPENMP= BUILD=folder PREFIX=/usr/local LIBDIR DESTDIR\n'

# How things are made
$(BUILD)/libroberts.a: $(call object,$(LIB_SRC))
	rm -f $@ && $(AR) rcs $@ $^

# Nothing but what roberts.h declares can be called from outside.
$(BUILD)/$(SHARED): $(call object,$(LIB_SRC))
	@printf '{ global: roberts_*; local: *; };\n' >$(BUILD)/exported.map
	$(CC) $(OPENMP) $(CFLAGS) $(LDFLAGS) -shared -Wl,-soname,$(SONAME) -Wl,--version-script,$(BUILD)/exported.map \
	    -Wl,-z,defs -o $@ $^ $(LIBS)

# What a program that links the static library needs besides stands under Libs.private.
$(BUILD)/roberts.pc: force
	@mkdir -p $(@D)
	@printf '%s\n' 'prefix=$(PREFIX)' 'libdir=$(LIBDIR)' 'includedir=$${prefix}/include' '' 'Name: roberts' \
	    'Description: line drawings of convex polyhedra with the hidden lines removed' 'Version: $(VERSION)' \
	    'Requires.private: cairo qhull_r' 'Libs: -L$${libdir} -lroberts' 'Libs.private: $(OPENMP) -lm' \
	    'Cflags: -I$${includedir}' >$@

$(BUILD)/roberts: $(call object,$(CLI_SRC)) $(BUILD)/libroberts.a
	$(LINK) $(LIBS)

$(TOOL_BIN): $(BUILD)/%: $(BUILD)/obj/%.o $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(LINK) $(LIBS)

$(BUILD)/tools/make-models: $(call object,$(MODEL_SRC))

$(BUILD)/obj/tests/%.o: TEST_DIRS = -iquote tests -iquote tests/support
$(foreach test,$(TEST_SRC),$(eval $(BUILD)/tests/$(basename $(notdir $(test))): $(call object,$(test))))
$(TEST_BIN): $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(LINK) $(TEST_LIBS) $(CMOCKA_LIBS) $(LIBS)

# Tests in which allocations fail: tests/support/memory.h
$(BUILD)/tests/test_memory_%: TEST_LIBS = -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free

# The fuzzers: libFuzzer brings main() and calls one function of a fixed name, which the linker makes of ours.
fuzzers: $(FUZZER)
$(FUZZER): $(BUILD)/fuzz/%: $(BUILD)/obj/tests/fuzz/%.o $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(LINK) -fsanitize=fuzzer -Wl,--defsym=LLVMFuzzerTestOneInput=$* $(LIBS)

# It holds a source of the program, which has something to say.
$(BUILD)/tests/test_verify_report: $(call object,src/cli/message.c src/cli/progress.c)
$(BUILD)/tests/test_fuzz: $(call object,$(FUZZ_SRC))

# The exact oracle: C++ with CGAL, for tests alone.
ORACLE_OBJ  := $(call object,$(ORACLE)) $(ORACLE_X:%.cpp=$(BUILD)/obj/%.o)
ORACLE_LIBS := -lgmp -lmpfr -lstdc++
$(BUILD)/tests/test_oracle $(BUILD)/tests/test_golden: $(ORACLE_OBJ)
$(BUILD)/tests/test_oracle $(BUILD)/tests/test_golden: TEST_LIBS = $(ORACLE_LIBS)

$(ORACLE_P:%.c=$(BUILD)/%): $(BUILD)/%: $(BUILD)/obj/%.o $(ORACLE_OBJ) $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(LINK) $(ORACLE_LIBS) $(LIBS)

# -frounding-math: intervals of doubles set the rounding mode, which the compiler must not assume.
$(BUILD)/obj/%.o: %.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	$(CXX) -std=c++17 -Wall -Wextra -Wshadow $(WERROR) -frounding-math $(CXXFLAGS) -Iinclude -MMD -MP -c -o $@ $<

$(BUILD)/obj/src/draw/%.o $(BUILD)/obj/tests/cli/test_render.o $(BUILD)/obj/tests/cli/test_gallery.o: NEEDS = $(CAIRO_CFLAGS)
$(BUILD)/obj/src/model/qhull.o: NEEDS = $(QHULL_CFLAGS)

$(BUILD)/obj/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(COMPILE) -c -o $@ $<

# The compiler and its flags as last used; other ones compile everything anew.
FLAGS = $(CC) $(CXX) $(OPENMP) $(CFLAGS) $(CXXFLAGS) $(WERROR) $(LDFLAGS)
$(BUILD)/flags: force
	@mkdir -p $(@D)
	@echo '$(FLAGS)' | cmp -s - $@ || echo '$(FLAGS)' >$@

$(BUILD)/demo/%.svg: models/%.off $(BUILD)/roberts
	@mkdir -p $(@D)
	$(BUILD)/roberts $< -o $@

# A locale that writes 0,5: for the tests that nothing depends on the locale, which skip themselves where it is not there.
$(BUILD)/locale/de_DE.UTF-8:
	@mkdir -p $(@D)
	-@localedef -i de_DE -f UTF-8 $@ 2>/dev/null || echo "no locale de_DE.UTF-8: its tests are skipped"

# Static checks, warnings as errors
C_FILES  = $(wildcard include/*.h src/*/*.[ch] tools/*.[ch] tools/*/*.[ch] tests/*.[ch] tests/*/*.[ch] tests/*/*.cpp)
CPUS     = $(shell nproc 2>/dev/null || echo 1)
lint-format:
	clang-format --dry-run -Werror $(C_FILES)

lint-tidy:
	@mkdir -p $(BUILD)
	@echo clang-tidy on $(words $(C_SRC)) files
	@printf '%s\n' $(C_SRC) | xargs -P $(CPUS) -I FILE \
	    clang-tidy --quiet FILE -- $(STD) $(WARN) -Iinclude -Isrc -iquote tests -iquote tests/support $(patsubst -I%,-isystem%,$(CAIRO_CFLAGS) $(QHULL_CFLAGS)) 2>$(BUILD)/tidy.err || \
	    { cat $(BUILD)/tidy.err; exit 1; }

# uninitvar: it takes an address for a use, and two loops of one length for two lengths; both compilers and the analyzer
# of clang-tidy watch over the same
lint-cppcheck:
	cppcheck --quiet --error-exitcode=1 --enable=warning,performance,portability --inline-suppr \
	    --suppress=missingIncludeSystem --suppress=uninitvar -j $(CPUS) --std=c11 -Iinclude -Isrc src tools

JOBS     ?= $(CPUS)
export JOBS

.PHONY: all demo figures gallery check check-long test-quick install uninstall test-threads tools models drawings test test-sanitize fuzz fuzzers bench bench-baseline lint \
    lint-format lint-tidy lint-cppcheck clean help force
.SECONDARY:
.DELETE_ON_ERROR:
-include $(patsubst %.c,$(BUILD)/obj/%.d,$(C_SRC)) $(ORACLE_X:%.cpp=$(BUILD)/obj/%.d)
