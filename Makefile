# magichour. The two commands: `make demo` and `make test`; both install what is missing first (tools/deps.sh).
# MODE=asan builds with the address and undefined-behaviour sanitizers, into build/asan. WERROR=1 makes warnings errors.
# WINDOW=0 leaves out the window with GLFW and Dear ImGui, CHART=0 leaves out `chart` with Cairo, ALMANAC=0 the sun by place and time with ERFA.

MODE ?= release
PREFIX ?= /usr/local
BUILD := $(if $(filter release,$(MODE)),build,build/$(MODE))

# A file *_none.c stands in for what is left out, and says so.
LEFT_OUT := $(if $(filter 0,$(WINDOW)),src/view/% %/context_glfw.c %/cmd_view.c,%/context_glfw_none.c %/cmd_view_none.c)
LEFT_OUT += $(if $(filter 0,$(CHART)),src/chart/chart% src/chart/plot% %/cmd_chart.c,%/cmd_chart_none.c)
LEFT_OUT += $(if $(filter 0,$(ALMANAC)),%/scene/almanac.c tests/test_almanac.c,%/almanac_none.c)
LEFT_OUT += $(if $(filter 0,$(WINDOW)),tests/test_view.c tests/test_window%) $(if $(filter 0,$(CHART)),tests/test_chart.c)
# The tests in a browser need a library for JSON. Without it they are skipped, and say so.
WEB_LIBS := $(shell pkg-config --libs jansson 2>/dev/null)
LEFT_OUT += $(if $(WEB_LIBS),tests/test_browser_none.c,tests/browser%.c tests/web.c tests/test_browser.c tests/test_web%.c)

# pkg-config is slow, so it is asked once. Its answer is empty where a library is missing.
PKGS := OpenEXR libpng $(if $(filter 0,$(ALMANAC)),,erfa) $(if $(filter 0,$(CHART)),,cairo) $(if $(filter 0,$(WINDOW)),,glfw3 imgui)
ANSWER := $(shell pkg-config --cflags --libs $(PKGS) 2>/dev/null)
PKG_LIBS := $(filter -L% -l% -Wl%,$(ANSWER))
PKG_CFLAGS := $(filter-out $(PKG_LIBS),$(ANSWER))

# The packages of tools/deps.sh that this build needs, and those that its tests need besides.
NEEDS := build $(if $(filter 0,$(WINDOW)),,window) $(if $(filter 0,$(CHART)),,chart) $(if $(filter 0,$(ALMANAC)),,almanac)
TEST_NEEDS := test $(if $(filter 0,$(WINDOW)),,window-test)

ifeq ($(MODE),asan)
SANITIZE := -fsanitize=address,undefined -fno-sanitize-recover=all
KEEP := $(BUILD)/tests/asan/keep_libraries.o
endif
CFLAGS ?= -O2 -g
CXXFLAGS ?= -O2 -g
CPPFLAGS += -Isrc -Itests -D_DEFAULT_SOURCE -D_POSIX_C_SOURCE=200809L
WARNINGS := -Wall -Wextra $(if $(filter 1,$(WERROR)),-Werror)
C_WARNINGS := $(WARNINGS) -Wshadow -Wconversion -Wmissing-prototypes -Wstrict-prototypes
ALL_CFLAGS := -std=c11 $(C_WARNINGS) $(CFLAGS) $(SANITIZE) $(PKG_CFLAGS)
ALL_CXXFLAGS := -std=c++20 $(WARNINGS) -ffp-contract=off $(CXXFLAGS) $(SANITIZE)
# An asan build exports its dlclose (tests/asan) to the libraries.
LDFLAGS += $(if $(KEEP),-rdynamic)
LDLIBS := $(PKG_LIBS) -ldl -lm

SOURCES := $(filter-out $(LEFT_OUT),$(sort $(wildcard src/*.c src/*/*.c src/*/*.cpp)))
OBJECTS := $(addprefix $(BUILD)/,$(addsuffix .o,$(basename $(SOURCES)))) $(BUILD)/src/export/embedded.o $(BUILD)/src/cmd/templates.o
BASE := $(filter $(BUILD)/src/base/%,$(OBJECTS))
LIBRARY := $(filter-out $(BUILD)/src/main.o,$(OBJECTS))
TESTS := $(patsubst %.c,$(BUILD)/%,$(filter-out $(LEFT_OUT),$(wildcard tests/test_*.c)))
SUPPORT := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(LEFT_OUT) $(wildcard tests/test_*.c),$(wildcard tests/*.c)))

.PHONY: all tests demo test check check-slow check-all torture tests-table lint format deps man install uninstall dist clean compile_commands.json cmocka FORCE
.SECONDARY:

all: $(BUILD)/magichour
# What another choice of parts has left would be run, too.
tests: $(TESTS)
	@rm -f $(filter-out $(TESTS) %.o %.d,$(wildcard $(BUILD)/tests/test_*))

$(BUILD)/magichour: $(OBJECTS) $(KEEP)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/tests/test_%: $(BUILD)/tests/test_%.o $(SUPPORT) $(LIBRARY) $(KEEP)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS) -lcmocka $(WEB_LIBS)

$(BUILD)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	@echo compile $<
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) -MMD -MP -c -o $@ $<

$(TESTS:=.o): | cmocka
cmocka:
	@pkg-config --exists cmocka || tools/deps.sh --missing $(TEST_NEEDS)

# C that has files as strings: embedded_NAME_ENDING of NAME.ENDING. $(1): the header that declares them, $(2): the files, $(3): what sed changes in them.
as_strings = { echo '\#include "$(1)"'; for file in $(2); do echo "const char embedded_$$(basename $$file | tr . _)[] = {"; \
    sed '$(3)' $$file | od -An -v -td1 | sed 's/\([0-9]\)\( \|$$\)/\1,/g'; echo "0};"; done; }

# The files that stand in every page that is exported, without indentation and without lines of comments.
EMBEDDED := src/export/page.html src/export/page.css src/export/page_draw.js src/export/page_spheres.js src/export/page_panel.js
$(BUILD)/src/export/embedded.c: $(EMBEDDED) Makefile
	@mkdir -p $(@D)
	@$(call as_strings,export/embedded.h,$(EMBEDDED),s/^ *//; /^\/\//d) > $@

# The scenes to begin with, which `magichour new` writes.
TEMPLATES := scenes/templates/exact.glsl scenes/templates/marched.glsl scenes/templates/shadertoy.glsl
$(BUILD)/src/cmd/templates.c: $(TEMPLATES) Makefile
	@mkdir -p $(@D)
	@$(call as_strings,cmd/templates.h,$(TEMPLATES),) > $@

$(BUILD)/%.o: $(BUILD)/%.c $(BUILD)/flags
	@echo compile $<
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) -MMD -MP -c -o $@ $<

# The window's overlay and the reader of lossy EXR files are the host's parts in C++.
$(BUILD)/src/%.o: src/%.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	@echo compile $<
	@$(CXX) $(CPPFLAGS) $(ALL_CXXFLAGS) $(PKG_CFLAGS) -MMD -MP -c -o $@ $<

# Changed flags rebuild everything. What is missing is said here, before the first file is compiled.
FLAGS := $(CC) $(CPPFLAGS) $(ALL_CFLAGS) $(LDFLAGS) $(CXX) $(ALL_CXXFLAGS)
$(BUILD)/flags: FORCE
	@$(if $(ANSWER),,tools/deps.sh --missing $(NEEDS) && pkg-config --exists --print-errors $(PKGS))
	@mkdir -p $(@D)
	@echo '$(FLAGS)' | cmp -s - $@ || echo '$(FLAGS)' > $@

# These two install what is missing, and so does `make deps`. All other targets only say what it is.
demo:
	tools/deps.sh $(NEEDS)
	$(MAKE) all
	tools/demo.sh $(BUILD)/magichour out

test:
	tools/deps.sh $(NEEDS) $(TEST_NEEDS)
	$(MAKE) check-all

# The fast tests, the slow ones (statistics of pictures, and the window), and all of them.
check: SUITE = fast
check-slow: SUITE = slow
check-all: SUITE = all
check check-slow check-all: all tests
	tests/run.sh $(BUILD) $(SUITE)

# All 300 cases of random scenes: minutes.
torture: $(BUILD)/magichour $(BUILD)/tests/test_torture
	MAGICHOUR=$(BUILD)/magichour TORTURE=300 $(BUILD)/tests/test_torture

# The tables of figures in tests/README.md: minutes.
tests-table: $(BUILD)/magichour $(BUILD)/tests/test_scenes $(BUILD)/tests/test_noise
	tests/table.sh $(BUILD)

lint:
	@tools/deps.sh --missing $(NEEDS) lint
	tools/lint.sh

format:
	clang-format -i $$(git ls-files '*.c' '*.h' '*.hpp' 'src/*.cpp')

deps:
	tools/deps.sh $(NEEDS) $(TEST_NEEDS) lint figures

# What `make -n` would compile, for editors and clang's tools.
compile_commands.json:
	@$(MAKE) -Bn --no-print-directory all tests | awk -v folder='$(CURDIR)' '/ -c -o [^ ]* [^ ]*\.c(pp)?$$/ { \
		printf "%s\n{\"directory\": \"%s\", \"file\": \"%s\", \"command\": \"%s\"}", n++ ? "," : "[", folder, $$NF, $$0 } \
		END { print "\n]" }' > $@

# The manual page and the shells' completions, made from the table of options.
COMPLETIONS := $(addprefix $(BUILD)/magichour.,bash zsh fish)
man: $(BUILD)/magichour.1
$(COMPLETIONS): $(BUILD)/magichour
	$< help --completion $(subst .,,$(suffix $@)) > $@

$(BUILD)/magichour.1: $(BUILD)/magichour
	$< help --man > $@

# Where the program goes: PREFIX, in front of it DESTDIR if that is given.
export PREFIX DESTDIR
install: all man $(COMPLETIONS)
	@tools/install.sh install $(BUILD)

uninstall:
	@tools/install.sh uninstall

# The source archive, $(BUILD)/magichour-VERSION.tar.gz.
dist:
	@tools/dist.sh $(BUILD)

clean:
	rm -rf build

include tests/oracle/rules.mk tests/fuzz/rules.mk tools/figures.mk
-include $(OBJECTS:.o=.d) $(TESTS:%=%.d) $(SUPPORT:.o=.d)
