# The oracle: GLSL cases, flattened and compiled as C++, at float and at double. Included by the Makefile.
CASES := $(patsubst %.glsl,$(BUILD)/%,$(wildcard tests/oracle/cases/*.glsl))
$(BUILD)/tests/test_oracle: $(BUILD)/tests/oracle/oracle.o $(CASES:%=%_float.o) $(CASES:%=%_double.o)

$(BUILD)/tests/oracle/flatten: $(BUILD)/tests/oracle/flatten.o $(filter $(BUILD)/src/source/%,$(OBJECTS)) $(BASE) $(KEEP)
	@echo link $@
	@$(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^

$(BUILD)/tests/oracle/cases/%.cpp: tests/oracle/cases/%.glsl $(BUILD)/tests/oracle/flatten
	@mkdir -p $(@D)
	@$(BUILD)/tests/oracle/flatten $< $@

COMPILE_CASE = echo compile $@; $(CXX) $(CPPFLAGS) $(ALL_CXXFLAGS) -c -o $@ $<
$(BUILD)/%_float.o: $(BUILD)/%.cpp tests/oracle/glsl.hpp $(BUILD)/flags
	@$(COMPILE_CASE) -DREAL=float -fsingle-precision-constant

$(BUILD)/%_double.o: $(BUILD)/%.cpp tests/oracle/glsl.hpp $(BUILD)/flags
	@$(COMPILE_CASE) -DREAL=double

-include $(CASES:=.cpp.d) $(wildcard $(BUILD)/tests/oracle/*.d)
