# magichour. The two commands: `make demo` and `make test`; both install what is missing first (tools/deps.sh).
# MODE=asan builds with the address and undefined-behaviour sanitizers, into build/asan.

MODE ?= release
PREFIX ?= /usr/local
BUILD := $(if $(filter release,$(MODE)),build,build/$(MODE))
PKGS := OpenEXR libpng cairo glfw3 imgui

CC ?= cc
ifeq ($(MODE),asan)
SANITIZE := -fsanitize=address,undefined -fno-sanitize-recover=all
KEEP := $(BUILD)/tests/asan/keep_libraries.o
endif
CPPFLAGS += -Isrc -Itests -D_DEFAULT_SOURCE -D_POSIX_C_SOURCE=200809L
WARNINGS := -Wall -Wextra -Wshadow -Wconversion -Wmissing-prototypes -Wstrict-prototypes
CFLAGS ?= -O2 -g
ALL_CFLAGS = -std=c11 $(WARNINGS) $(CFLAGS) $(SANITIZE) $(shell pkg-config --cflags $(PKGS))
CXXFLAGS ?= -O2 -g
ALL_CXXFLAGS = -std=c++20 -Wall -Wextra -ffp-contract=off $(CXXFLAGS) $(SANITIZE)
# An asan build exports its dlclose (tests/asan) to the libraries.
LDFLAGS += $(if $(KEEP),-rdynamic)
LDLIBS = $(shell pkg-config --libs $(PKGS)) -ldl -lm

SOURCES := $(sort $(wildcard src/*.c src/*/*.c src/*/*.cpp))
OBJECTS := $(addprefix $(BUILD)/,$(addsuffix .o,$(basename $(SOURCES))))
BASE := $(filter $(BUILD)/src/base/%,$(OBJECTS))
LIBRARY := $(filter-out $(BUILD)/src/main.o,$(OBJECTS))
TESTS := $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/test_*.c))
SUPPORT := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(wildcard tests/test_*.c),$(wildcard tests/*.c)))
CASES := $(patsubst %.glsl,$(BUILD)/%,$(wildcard tests/oracle/cases/*.glsl))
ORACLE := $(BUILD)/tests/oracle/oracle.o $(CASES:%=%_float.o) $(CASES:%=%_double.o)

.PHONY: all demo view check-view measure-view gallery atlas honesty sheets charts test check check-slow check-all lint format deps clean install FORCE
.SECONDARY:

all: $(BUILD)/magichour

$(BUILD)/magichour: $(OBJECTS) $(KEEP)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/tests/test_%: $(BUILD)/tests/test_%.o $(SUPPORT) $(LIBRARY) $(KEEP)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS) -lcmocka

# The tests that ask the oracle: each of its cases is flattened and compiled, at float and at double.
$(BUILD)/tests/test_oracle: $(ORACLE)

$(BUILD)/tests/oracle/flatten: $(addprefix $(BUILD)/,tests/oracle/flatten.o src/scene/glsl_source.o) $(BASE) $(KEEP)
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

$(BUILD)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	@echo compile $<
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) -MMD -MP -c -o $@ $<

# The window's overlay is the host's one part in C++.
$(BUILD)/src/%.o: src/%.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	@echo compile $<
	@$(CXX) $(CPPFLAGS) $(ALL_CXXFLAGS) $(shell pkg-config --cflags $(PKGS)) -MMD -MP -c -o $@ $<

# Changed flags rebuild everything.
FLAGS = $(CC) $(CPPFLAGS) $(ALL_CFLAGS) $(LDFLAGS) $(CXX) $(ALL_CXXFLAGS)
$(BUILD)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(FLAGS)' | cmp -s - $@ || echo '$(FLAGS)' > $@

demo:
	tools/deps.sh build
	$(MAKE) all
	tools/demo.sh $(BUILD)/magichour out

# The README's pictures.
gallery: all
	tools/demo.sh $(BUILD)/magichour out/gallery --size 256x256
	mkdir -p scenes/gallery && cp out/gallery/*.png scenes/gallery

# Charts of every sky method's error, over view and sun and height.
atlas:
	tools/deps.sh build atlas
	$(MAKE) all
	tools/atlas.sh $(BUILD)/magichour out/atlas scenes/gallery

# Whether --error keeps its word, over 96 pictures: a quarter of an hour.
honesty: all
	tools/honesty.sh $(BUILD)/magichour out/honesty

# Contact sheets of the scenes, the shapes and the materials: a quarter of an hour.
sheets:
	tools/deps.sh build atlas
	$(MAKE) all
	tools/sheets.sh $(BUILD)/magichour out/sheets scenes/gallery

# The README's charts of speed against accuracy, measured here; what is measured already is only drawn again.
charts:
	tools/deps.sh build
	$(MAKE) all
	mkdir -p out scenes/gallery
	$(BUILD)/magichour chart scenes/crater.glsl -o out/charts --time 240
	for chart in paths sky scale; do for kind in png csv; do \
		cp out/charts/$$chart.$$kind scenes/gallery/chart-$$chart.$$kind; done; done

test:
	tools/deps.sh build test
	$(MAKE) check-all

# The fast tests, the slow ones (statistics of pictures, and the window), and all of them.
check: SUITE = fast
check-slow: SUITE = slow
check-all: SUITE = all
check check-slow check-all: $(BUILD)/magichour $(TESTS)
	tests/run.sh $(BUILD) $(SUITE)

# The window, on the paper's scene.
view:
	tools/deps.sh build
	$(MAKE) all
	$(BUILD)/magichour view scenes/crater.glsl

# The window under a storm of events and edits; best with MODE=asan. And its speed on this machine.
check-view: $(BUILD)/magichour $(BUILD)/tests/test_window_load
	MAGICHOUR=$$PWD/$< MAGICHOUR_EVENTS=1000 MAGICHOUR_RELOADS=200 \
	LSAN_OPTIONS=suppressions=$$PWD/tests/lsan.supp:print_suppressions=0 $(BUILD)/tests/test_window_load

measure-view: $(BUILD)/magichour $(BUILD)/tests/test_window_load
	MAGICHOUR=$$PWD/$< $(BUILD)/tests/test_window_load measure scenes/crater.glsl 640x360

lint:
	tools/deps.sh build lint
	tools/lint.sh

format:
	clang-format -i $$(git ls-files '*.c' '*.h' '*.hpp' 'src/*.cpp')

deps:
	tools/deps.sh build test lint

install: $(BUILD)/magichour
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/share/magichour
	install $(BUILD)/magichour $(DESTDIR)$(PREFIX)/bin
	cp -r glsl scenes $(DESTDIR)$(PREFIX)/share/magichour

clean:
	rm -rf build

-include $(OBJECTS:.o=.d) $(TESTS:%=%.d) $(SUPPORT:.o=.d) $(CASES:=.cpp.d) $(wildcard $(BUILD)/tests/oracle/*.d)
