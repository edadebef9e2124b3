# Short names for the CMake presets; CI uses these same words.
.PHONY: all plan python test test-all asan fuzz tidy format check-style docs bench golden install clean deps test-deps python-deps
PART ?= step_parts/rounded_pocket.step
OUT ?= out/$(basename $(notdir $(PART)))
PREFIX ?= /usr/local
STEPMILL = build/release/bin/stepmill
# Under the sanitizers whole plans, simulated paths, laws over many cases and every fault of a disk take four fifths of the
# time; PlanPart stands for the plans.
WHOLE_PLANS = *JobFaults*:CrossingHoles.*:ChamferedBlock.*:*PaperCase*:Fixtures.*:FinishingPlan*:PlanProven*:*CutTogether*:*RoughedSample*:CycleTimePlan.*:*AdaptiveCommonPocket*:Adaptive.KeepsArcs:Adaptive.ComesIn*:FormPasses.Keep*:FormPasses.Pass*:FormPasses.LeaveOut*:PlanRecord.RefusesALarge*:PlanPart.GoesThrough*:SampleParts.EveryArc*:SampleParts.ReadBack*:Slice.DoesNotDepend*:EdgeBreaks.AreNoPart*:EdgeBreaks.TakeAChamfer*:SweptRegion.HoldsExactly*:*ByARaster*:Adaptive.IsTheSameEveryTime:Adaptive.NeverMakes*:StickOuts.*:ChangedGround*:Quote.*:*WhatStaysOfResiduals*:ClearanceCases.*:Region.ContainsIsRightBeside*:StockAfter.CountsAir*:PlanPart.IsTheSame*:PlanPart.TotalsAre*:PlanPart.CutsWhat*:Patience.Few*:Holding.Grip*:CuttingPlan.*:HolesProven.E*:HolesProven.W*:ThreadsProven.A*:ThreadsProven.C*:ThreadsProven.D*:ThreadsProven.E*:ThreadsProven.S*:ComparePlans.FindTheSame*:SurrogateReport.*:PlanJson.IsTheSame*:PlanJson.HasOne*:Sheets.AreASound*:*RoundGroove*:LeaningBlanks.*:HolesProven.AFlat*
# The modules whose unit tests run under the sanitizers.
ASAN_MODULES ?= $(notdir $(wildcard tests/unit/*))
SOURCES = $$(git ls-files '*.h' '*.cpp')

all: build/release/tests.configured
	cmake --build --preset release

plan: build/release/build.ninja
	cmake --build --preset release --target stepmill-app
	$(STEPMILL) plan $(PART) -o $(OUT) || test $$? -eq 1

# Importable by PYTHONPATH=build/release/python; ctest's Python.Bindings then runs.
python: python-deps
	cmake --preset release -DSTEPMILL_PYTHON=ON
	cmake --build --preset release --target stepmill_python

test: all
	ctest --test-dir build/release -L 'unit|property' --output-on-failure -j2

test-all: all
	ctest --test-dir build/release --output-on-failure -j2

asan: build/dev/tests.configured
	cmake --build --preset dev --target $(addprefix unit_,$(ASAN_MODULES))
	# A module's tests in one process: they share the plans they look at, which ctest would make for each.
	ls $(addprefix build/dev/bin/unit_,$(ASAN_MODULES)) | LSAN_OPTIONS=suppressions=$(CURDIR)/tests/lsan.supp:print_suppressions=0 \
	  xargs -P2 -I{} env {} --gtest_brief=1 --gtest_filter='-$(WHOLE_PLANS)'

fuzz: build/dev/tests.configured
	cmake --build --preset dev --target fuzz_targets
	ctest --test-dir build/dev -L fuzz --output-on-failure -j6

tidy: test-deps
	scripts/tidy

format: test-deps
	clang-format-14 -i $(SOURCES)

check-style: test-deps
	clang-format-14 --dry-run --Werror $(SOURCES)
	scripts/check-includes

docs:
	scripts/draw-modules
	scripts/check-docs

bench: all
	build/release/bin/stepmill_bench

golden: all
	STEPMILL_REWRITE_GOLDEN=1 ctest --test-dir build/release -L golden --output-on-failure

install: build/release/build.ninja
	cmake --build --preset release --target stepmill-app
	cmake --install build/release --prefix $(PREFIX)

# The program alone needs fewer packages than its tests.
build/%/build.ninja: | deps
	cmake --preset $*

build/%/tests.configured: | test-deps
	cmake --preset $* -DBUILD_TESTING=ON
	touch $@

python-deps:
	@scripts/install-dependencies --python

deps:
	@scripts/install-dependencies

test-deps:
	@scripts/install-dependencies --tests

clean:
	rm -rf build out
