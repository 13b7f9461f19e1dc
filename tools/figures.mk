# What the READMEs show and claim, made anew: pictures, charts and measurements. Included by the Makefile.
.PHONY: gallery atlas atlas-light references honesty bias-scan sheets shapes skies charts points march-tolerance march-peer site view check-view measure-view

# The README's pictures.
gallery: all
	tools/demo.sh $(BUILD)/magichour out/gallery --size 256x256
	mkdir -p scenes/gallery && cp out/gallery/*.png scenes/gallery

# Charts of every sky method's error, over view and sun and height.
atlas: all
	@tools/deps.sh --missing figures
	tools/atlas.sh $(BUILD)/magichour out/atlas scenes/gallery

# Which light method is the fastest where: an hour of one core.
atlas-light: all
	@tools/deps.sh --missing figures
	tools/atlas_light.sh $(BUILD)/magichour out/atlas_light scenes/gallery

# march() beside a plain sphere tracer: a quarter of an hour of one core.
march-peer: all
	@tools/deps.sh --missing figures
	tools/march_peer.sh $(BUILD)/magichour out/march_peer scenes/gallery

# What the study of honesty compares with: three quarters of an hour.
references: all
	tools/references.sh $(BUILD)/magichour out/references

# Whether --error keeps its word, in all scenes: hours. What is measured already is kept in out/.
honesty: references $(BUILD)/tools/true_error
	tools/honesty.sh $(BUILD)/magichour $(BUILD)/tools/true_error out/honesty out/references

# Whether the sky's methods err by no more than is claimed of them: two hours the first time.
bias-scan: all $(BUILD)/tools/bias_claim
	tools/bias_scan.sh $(BUILD)/magichour out/bias-scan

# Contact sheets of the scenes, the shapes and the materials: a quarter of an hour.
sheets: all
	@tools/deps.sh --missing figures
	tools/sheets.sh $(BUILD)/magichour out/sheets scenes/gallery

# Contact sheets of the distances and their operators: ten minutes.
shapes: all
	@tools/deps.sh --missing figures
	tools/shapes_sheet.sh $(BUILD)/magichour out/shapes scenes/gallery

# The README's skies from noon to night under two atmospheres, and scenes under one of them: a few minutes.
skies: all
	@tools/deps.sh --missing figures
	tools/skies.sh $(BUILD)/magichour out/skies scenes/gallery

# The READMEs' charts of speed against accuracy, measured here in a quarter of an hour; what is measured already is only drawn again.
charts: all
	tools/charts.sh $(BUILD)/magichour out/charts scenes/gallery

# The points of Mitsuba and of the paper's own method in these charts: two minutes. tools/peer_error.py says how Mitsuba is installed.
points: all
	tools/points.sh $(BUILD)/magichour scenes/gallery

# What the march's tolerances leave and cost: half an hour of one core.
march-tolerance: all
	@tools/deps.sh --missing figures
	tools/march_tolerance.sh $(BUILD)/magichour out/march-tolerance scenes/gallery

# The scenes as static pages, for any web server: a quarter of an hour on two slow cores.
site: all
	tools/site.sh $(BUILD)/magichour out/site

# The window, on the paper's scene.
view: all
	$(BUILD)/magichour view scenes/crater.glsl

# The window under a storm of events and edits; best with MODE=asan. And its speed on this machine.
check-view: $(BUILD)/magichour $(BUILD)/tests/test_window_load
	MAGICHOUR=$$PWD/$< MAGICHOUR_EVENTS=1000 MAGICHOUR_RELOADS=200 \
	LSAN_OPTIONS=suppressions=$$PWD/tests/lsan.supp:print_suppressions=0 $(BUILD)/tests/test_window_load

measure-view: $(BUILD)/magichour $(BUILD)/tests/test_window_load
	MAGICHOUR=$$PWD/$< $(BUILD)/tests/test_window_load measure scenes/crater.glsl 640x360

# The program of tools/spectrum.sh.
$(BUILD)/tools/spectrum_fit: $(BUILD)/tools/spectrum_fit.o $(BUILD)/tests/colors.o $(LIBRARY) $(KEEP)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

# The program of tools/bias_scan.sh.
$(BUILD)/tools/bias_claim: $(BUILD)/tools/bias_claim.o $(LIBRARY) $(KEEP)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

# The program of tools/honesty.sh.
$(BUILD)/tools/true_error: $(BUILD)/tools/true_error.o $(LIBRARY) $(KEEP)
	@echo link $@
	@$(CXX) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

-include $(wildcard $(BUILD)/tools/*.d)
