# Thin front of CMake: everything is in CMakeLists.txt and CMakePresets.json.
CASE ?= cases/bellow_a2/bellow_a2.yaml
OUT ?= out/$(basename $(notdir $(CASE)))
JOBS ?= $(shell nproc)

.PHONY: run test slow bench build deps clean

run: build
	build/app/plica run $(CASE) --out $(OUT)
	@cmake/open_report.sh $(OUT)/report.html

test: build
	ctest --preset release -j $(JOBS)

slow: build
	ctest --preset slow

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
