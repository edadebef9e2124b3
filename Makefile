# Short names for the CMake presets; CI uses these same words.
.PHONY: all plan test test-all asan fuzz tidy format bench golden clean deps
PART ?= step_parts/rounded_pocket.step
OUT ?= out/$(basename $(notdir $(PART)))
STEPMILL = build/release/bin/stepmill

all: build/release/build.ninja
	cmake --build --preset release

plan: build/release/build.ninja
	cmake --build --preset release --target stepmill-app
	$(STEPMILL) plan $(PART) -o $(OUT) || test $$? -eq 1

test: all
	ctest --test-dir build/release -L 'unit|property' --output-on-failure -j2

test-all: all
	ctest --test-dir build/release --output-on-failure -j2

asan: build/dev/build.ninja
	cmake --build --preset dev --target unit_tests
	LSAN_OPTIONS=suppressions=$(CURDIR)/tests/lsan.supp \
	  ctest --test-dir build/dev -L 'unit' --output-on-failure -j2

fuzz: build/dev/build.ninja
	cmake --build --preset dev --target region_text_fuzz
	ctest --test-dir build/dev -L fuzz --output-on-failure

tidy: build/tidy/build.ninja
	cmake --build --preset tidy

format:
	clang-format -i $$(git ls-files '*.h' '*.cpp')

bench: all
	build/release/bin/stepmill_bench

golden: all
	STEPMILL_REWRITE_GOLDEN=1 ctest --test-dir build/release -L golden --output-on-failure

build/%/build.ninja: | deps
	cmake --preset $*

deps:
	@scripts/install-dependencies

clean:
	rm -rf build out
