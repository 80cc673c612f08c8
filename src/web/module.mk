# `make web`: the module of WebAssembly, the npm package and the page around it. The Makefile includes this.
#
# The module is built from the same files as the program, but for those that need Cairo, signals or processes, and from
# the sources of zlib and Qhull, which come from Debian's source packages.
WEB     ?= $(BUILD)/web
WASM_CC ?= clang
WASM_LD ?= wasm-ld
WASI    ?= /usr/include/wasm32-wasi
WASM_AS := --target=wasm32-wasi -nostdlibinc -isystem $(WASI) -O3 -ffp-contract=off -fno-math-errno -mmutable-globals \
           -mnontrapping-fptoint -msign-ext -msimd128 -D_WASI_EMULATED_PROCESS_CLOCKS -Isrc/web/wasi
WASM_ZLIB  := adler32 crc32 deflate trees zutil
WASM_QHULL := geom2_r geom_r global_r io_r libqhull_r mem_r merge_r poly2_r poly_r qset_r random_r stat_r user_r \
              usermem_r userprintf_r
WASM_NOT := $(addprefix src/,write/cairo.c write/image.c cli/signals.c cli/batch.c cli/manifest.c cli/workers.c)
WASM_SRC := $(filter-out $(WASM_NOT),$(LIB_SRC) $(CLI_SRC)) $(sort $(wildcard src/web/*.c src/web/wasi/*.c))
WASM_OBJ := $(WASM_SRC:%.c=$(WEB)/obj/%.o) $(WASM_ZLIB:%=$(WEB)/obj/zlib/%.o) $(WASM_QHULL:%=$(WEB)/obj/qhull/%.o)

##@ For browsers and JavaScript
web: $(WEB)/npm/roberts.wasm $(WEB)/page/index.html ## the page and the npm package, in build/web/

$(WEB)/sources/%/unpacked:
	$(call show,GET,$*)
	$(Q)tools/get-source.sh $* $(@D)
	$(Q)touch $@

$(WEB)/obj/src/%.o: src/%.c $(WEB)/sources/zlib/unpacked $(WEB)/sources/qhull/unpacked \
    $(BUILD)/generated/draw/letters_data.h
	@mkdir -p $(@D)
	$(call show,WASM,$<)
	$(Q)$(WASM_CC) $(STD) $(WASM_AS) $(WARN) -Wno-unknown-pragmas -Wno-gnu-statement-expression $(WERROR) \
	    -include src/web/wasi/missing.h -Iinclude -Isrc -I$(BUILD)/generated -isystem $(WEB)/sources/zlib \
	    -isystem $(WEB)/sources/qhull/src -MMD -MP -c -o $@ $<

# Their makers' code, their makers' warnings
$(WEB)/obj/zlib/%.o: $(WEB)/sources/zlib/unpacked
	@mkdir -p $(@D)
	$(Q)$(WASM_CC) $(WASM_AS) -w -c -o $@ $(<D)/$*.c

$(WEB)/obj/qhull/%.o: $(WEB)/sources/qhull/unpacked
	@mkdir -p $(@D)
	$(Q)$(WASM_CC) $(WASM_AS) -w -I$(<D)/src -c -o $@ $(<D)/src/libqhull_r/$*.c

# By the linker itself: clang would have a wasm-opt, where there is one, change the code.
$(WEB)/roberts.wasm: $(WASM_OBJ)
	$(call show,LD,$@)
	$(Q)$(WASM_LD) -o $@ /usr/lib/wasm32-wasi/crt1-reactor.o $(WASM_OBJ) -L/usr/lib/wasm32-wasi \
	    -lwasi-emulated-process-clocks -lc \
	    "$$($(WASM_CC) --target=wasm32-wasi --rtlib=compiler-rt -print-libgcc-file-name)" --entry=_initialize -O2 \
	    --export=__main_argc_argv --export=malloc --export=free --export=__stack_pointer --export-table \
	    --wrap=qh_new_qhull --strip-all -z stack-size=1048576

$(WEB)/npm/roberts.wasm: $(WEB)/roberts.wasm $(wildcard src/web/npm/*)
	@mkdir -p $(@D)
	$(Q)cp src/web/npm/* LICENSE $(@D)/
	$(Q)cp $(WEB)/sources/zlib/LICENSE $(@D)/LICENSE.zlib
	$(Q)cp $(WEB)/sources/qhull/COPYING.txt $(@D)/LICENSE.qhull
	$(Q)sed -i 's/"version": "[^"]*"/"version": "$(VERSION)"/' $(@D)/package.json
	$(Q)cp $< $@

WEB_MODELS := table temple tower spiral-staircase city goblet bracket locomotive torus crystals screw \
              compound-of-five-tetrahedra

$(WEB)/page/index.html: $(WEB)/npm/roberts.wasm $(wildcard src/web/page/*)
	@mkdir -p $(@D)/models
	$(Q)cp src/web/npm/wasi.js src/web/npm/program.js src/web/npm/live.js $(<D)/LICENSE* $< $(@D)/
	$(Q)cp $(foreach model,$(WEB_MODELS),$(wildcard models/$(model).off models/*/$(model).off)) \
	    $(@D)/models/
	$(Q)cp src/web/page/* $(@D)/

-include $(WASM_SRC:%.c=$(WEB)/obj/%.d)
