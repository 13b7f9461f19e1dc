# Fuzzing: clang's libFuzzer changes inputs at random and keeps those that reach new code. `make fuzz TIME=20` runs each target of
# tests/fuzz for so many seconds. Included by the Makefile.
TIME ?= 20
# 0 stands for another one each time.
SEED ?= 0
FUZZ := $(patsubst %.c,$(BUILD)/%,$(wildcard tests/fuzz/fuzz_*.c))

.PHONY: fuzz fuzz-programs
fuzz:
	@tools/deps.sh --missing build almanac fuzz
	$(MAKE) BUILD=build/fuzz CC='$(FUZZ_CACHE)clang' CXX='$(FUZZ_CACHE)clang++' WINDOW=0 CHART=0 \
		SANITIZE='-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all' fuzz-programs
	tools/fuzz.sh build/fuzz $(TIME) $(SEED)

fuzz-programs: $(FUZZ)

$(BUILD)/tests/fuzz/fuzz_%: $(BUILD)/tests/fuzz/fuzz_%.o $(BUILD)/tests/fuzz/input.o $(LIBRARY)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) -fsanitize=fuzzer $(LDFLAGS) -o $@ $^ $(LDLIBS)

-include $(FUZZ:%=%.d) $(BUILD)/tests/fuzz/input.d
