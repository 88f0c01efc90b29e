# Thin front of CMake: everything is in CMakeLists.txt and CMakePresets.json.
CASE ?= cases/bellow_a2/bellow_a2.yaml
OUT ?= out/$(basename $(notdir $(CASE)))
JOBS ?= $(shell nproc)

.PHONY: run test slow sealed table bench build deps clean

run: build
	build/app/plica run $(CASE) --out $(OUT)
	@cmake/open_report.sh $(OUT)/report.html

test: build
	ctest --preset release -j $(JOBS)

slow: build
	ctest --preset slow

# The sealed suite of the diagnosis: specimens made, diagnosed, scored; then with guards left out.
sealed: build
	ctest --preset slow -R sealed_suite --verbose
	ctest --preset slow -R sealed_ablations --verbose

# What the tests of mechanics found beside what their sources say.
table: build
	tests/verification_table.sh build/tests/plica_tests > docs/verification_table.md

bench: deps
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS)
	bench/run.sh

build: deps
	cmake --preset release
	cmake --build --preset release -j $(JOBS)

deps:
	@cmake/install_packages.sh

clean:
	rm -rf build build-asan out
