# make            the program, build/roberts, and build/libroberts.a
# make demo       installs what is missing, builds, draws a few models to build/demo/*.svg
# make check      installs what is missing, builds and runs all tests
# make help       lists the targets
.DEFAULT_GOAL := all

CC       ?= cc
BUILD    ?= build
CFLAGS   ?= -O2 -g
WERROR   ?=
STD      := -std=c17 -D_POSIX_C_SOURCE=200809L
# -ffp-contract=off: a fused multiply-add would make signs depend on the compiler (see src/base/vec.h)
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla $(WERROR)
COMPILE   = $(CC) $(STD) $(WARN) -ffp-contract=off -fPIC $(CFLAGS) -Iinclude -Isrc -MMD -MP
CAIRO_CFLAGS = $(shell pkg-config --cflags cairo)
CAIRO_LIBS   = $(shell pkg-config --libs cairo)

LIB_SRC  := $(sort $(wildcard src/base/*.c src/model/*.c src/view/*.c src/hide/*.c src/ray/*.c src/draw/*.c))
CLI_SRC  := $(sort $(wildcard src/cli/*.c))
LIB_OBJ  := $(LIB_SRC:src/%.c=$(BUILD)/obj/%.o)
CLI_OBJ  := $(CLI_SRC:src/%.c=$(BUILD)/obj/%.o)
TEST_SRC := $(sort $(wildcard tests/test_*.c))
TEST_BIN := $(TEST_SRC:tests/%.c=$(BUILD)/tests/%)
TOOL_BIN := $(patsubst tools/%.c,$(BUILD)/tools/%,$(sort $(wildcard tools/*.c)))

all: $(BUILD)/roberts

$(BUILD)/libroberts.a: $(LIB_OBJ)
	rm -f $@ && $(AR) rcs $@ $^

$(BUILD)/roberts: $(CLI_OBJ) $(BUILD)/libroberts.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(CAIRO_LIBS) -lm

$(BUILD)/obj/draw/%.o: src/draw/%.c
	@mkdir -p $(@D)
	$(COMPILE) $(CAIRO_CFLAGS) -c -o $@ $<

$(BUILD)/obj/%.o: src/%.c
	@mkdir -p $(@D)
	$(COMPILE) -c -o $@ $<

$(BUILD)/tools/%: tools/%.c $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(COMPILE) $(LDFLAGS) -o $@ $^ $(CAIRO_LIBS) -lm

$(BUILD)/tests/%: tests/%.c $(BUILD)/libroberts.a
	@mkdir -p $(@D)
	$(COMPILE) $(LDFLAGS) -o $@ $^ -lcmocka $(CAIRO_LIBS) -lm

tools: $(TOOL_BIN)

# Builds and runs every test program; goes on after a failure and fails at the end.
test: $(TEST_BIN) $(BUILD)/roberts $(TOOL_BIN)
	@failed=0; for t in $(TEST_BIN); do $$t || failed=1; done; exit $$failed

clean:
	rm -rf $(BUILD)

.PHONY: all tools test clean
.SECONDARY:
-include $(LIB_OBJ:.o=.d) $(CLI_OBJ:.o=.d) $(wildcard $(BUILD)/tests/*.d $(BUILD)/tools/*.d)
