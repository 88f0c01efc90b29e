# Thin front of CMake: everything is in CMakeLists.txt and CMakePresets.json.
CASE ?= cases/bellow_a2/bellow_a2.yaml
OUT ?=
# A compiler at work takes up to 3 GB.
JOBS ?= $(shell awk -v cores="$$(nproc)" '/MemAvailable/ {j = int($$2 / 3e6); \
  print j < 1 ? 1 : j < cores ? j : cores}' /proc/meminfo)

# A text of the user's as one word of the shell, blanks and quotes included.
quoted = '$(subst ','\'',$(1))'

.PHONY: run test check sanitize slow sealed table bench mpi program build deps test-deps check-deps bench-deps mpi-deps clean

# Without OUT the results go into out/, under the name of the case.
run: program
	@case=$(call quoted,$(CASE)); out=$(call quoted,$(OUT)); \
	name=$$(basename -- "$$case"); out=$${out:-out/$${name%.*}}; \
	build/app/plica run "$$case" --out "$$out" && cmake/open_report.sh "$$out/report.html"

test: build
	ctest --preset release -j $(JOBS)

# After the tests: every source of the program by clang-tidy, warnings as errors; the rule of includes, a
# consumer of each component of the installed package, the Debian package in a root that has nothing
# else, the verification table.
check: check-deps build
	ctest --preset guards
	ctest --preset release -R rule_of_includes

# As long again: every source of the program and its tests read by itself, by clang, warnings as errors;
# of that readers, elements and what costs little run under AddressSanitizer and UBSan.
sanitize: check-deps
	cmake --preset sanitize
	cmake --build --preset sanitize -j $(JOBS)
	ctest --preset sanitize -j $(JOBS)

slow: check-deps build
	ctest --preset slow

# The sealed suite of the diagnosis: specimens made, diagnosed, scored; then with guards left out.
sealed: build
	ctest --preset slow -R sealed_smoke
	ctest --preset slow -R sealed_suite --verbose
	ctest --preset slow -R sealed_mounted --verbose
	ctest --preset slow -R sealed_strangers --verbose
	ctest --preset slow -R sealed_changes --verbose
	ctest --preset slow -R sealed_sets --verbose
	ctest --preset slow -R sealed_ablations --verbose

# What the tests of mechanics found beside what their sources say.
table: test
	tests/verification_table.sh build/tests/table > docs/verification_table.md

bench: bench-deps
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS)
	bench/run.sh

# The engine over ranks: build/engine/plica-mpi.
mpi: mpi-deps
	cmake --preset engine
	cmake --build --preset engine -j $(JOBS)

# The program alone, in a tree with tests too, and with its tests.
program: deps
	@test -f build/build.ninja || cmake --preset run
	cmake --build build --target plica plica_mesher -j $(JOBS)

build: test-deps
	cmake --preset release
	cmake --build --preset release -j $(JOBS)

# What is missing of the packages of cmake/packages.txt.
deps:
	@cmake/install_packages.sh run
test-deps:
	@cmake/install_packages.sh run test
check-deps:
	@cmake/install_packages.sh run test check
bench-deps:
	@cmake/install_packages.sh run bench
mpi-deps:
	@cmake/install_packages.sh run mpi

clean:
	rm -rf build build-dev build-sanitize build-tidy out
