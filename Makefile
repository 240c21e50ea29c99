# The commands of this project; `make help` lists them. CI runs the same lines.
# Needed on the machine: Python 3.11 or newer, a Rust toolchain with a C linker, make.

SHELL := /bin/sh
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
# Parts of `make lint`; with --jobs=2 they run two at a time.
LINTS := $(addprefix lint-,files style rust linux win32 darwin)
.PHONY: help build demo test peers evidence pages docs fuzz golden lint $(LINTS) bench counts page pictures wheel windows fmu arm clean \
	check-python check-rust

VENV := .venv
BIN := $(VENV)/bin
PEERS := $(VENV)/peers
WITH_PEERS = $(if $(wildcard $(PEERS)/.packages),PYTHONPATH="$(CURDIR)/python" $(PEERS)/bin/python,$(BIN)/python)
DEMO := en50318-ac-simple-320
# Neighbours stay in one process, which keeps what they share; an idle one takes half of the rest.
ON_ALL_CORES := --numprocesses=auto --maxprocesses=8 --dist=worksteal
# Hundreds of processes are started by tests: each would compile the package anew.
KEEPING := PYTHONDONTWRITEBYTECODE=
OLDEST_PYTHON := 3.11
FUZZ := crates/core/fuzz
SECONDS := 600
HOST = $(shell rustc -vV | sed -n 's/^host: //p')
# What `cargo fuzz` sets, without its address sanitiser: the core has no unsafe code.
FUZZING = RUSTC_BOOTSTRAP=1 RUSTFLAGS="--cfg fuzzing -Cpasses=sancov-module \
	-Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
	-Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares"
OLDEST_RUST := $(shell sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)

# What NumPy's and h5py's wheels ask for; zig links against this version wherever it runs.
GLIBC := manylinux_2_28
GLIBC_TARGET := x86_64-unknown-linux-gnu.2.28
ZIG := ziglang>=0.13
NEEDS_ZIG = $(BIN)/python -m ziglang version >/dev/null 2>&1 && test -x $(BIN)/cargo-zigbuild \
	|| $(BIN)/python -m pip install --quiet '$(ZIG)' cargo-zigbuild

# The first interpreter that is new enough; `make PYTHON=/path/to/python3 build` overrides it.
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do \
	"$$p" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo "$$p" && break; \
	done)

RUST_INPUTS := Cargo.toml $(wildcard crates/*/Cargo.toml crates/*/build.rs crates/ffi/include/*.h) \
	$(shell find crates/*/src -name '*.rs')
# Named together they share one core: packages alone have other features of what the core needs.
BUILT := -p arcless-loop -p arcless-ffi -p arcless-py
# What FMUs of Arcless carry, for the platform that compiles.
LIBRARIES := python/arcless/fmi/libraries
PLATFORM = $(shell uname -m)-linux
MATURIN := env -u CONDA_PREFIX PIP_QUIET=1 VIRTUAL_ENV="$(CURDIR)/$(VENV)" $(BIN)/maturin
# PyO3 asks this interpreter for its ABI when clippy compiles the binding crate.
export PYO3_PYTHON := $(CURDIR)/$(BIN)/python
export PIP_DISABLE_PIP_VERSION_CHECK := 1

help: ## list these commands
	@sed -n 's/^\([a-z]*\):.* ## /  make \1\t/p' Makefile | expand -t 16

build: $(VENV)/.built ## make the environment in .venv with the command .venv/bin/arcless

demo: build ## run the reference case AC simple at 320 km/h, say how sure it is; write its report
	@rm -f runs/$(DEMO)/report.html
	@$(BIN)/arcless run $(DEMO) --certainty --overwrite \
	|| { test $$? -eq 3 && test -s runs/$(DEMO)/report.html; } # a criterion not met is a result

# Without Node or a network `make test` says so in a sentence, and skips what needs the page.
test: build ## run every test: the page's own, the Rust core, then the Python package
	@$(BIN)/python -m page.build --test --where-possible
	cargo test -p arcless-core
	cargo test --release $(BUILT) # beside what is built already; else the core is compiled again
	$(KEEPING) $(BIN)/python -m pytest $(ON_ALL_CORES)

peers: $(PEERS)/.packages ## install the other programs, those that can be, and compare with them
	PYTHONPATH="$(CURDIR)/python" $(PEERS)/bin/python -m pytest $(ON_ALL_CORES) \
	tests/verification/peers tests/verification/test_tables.py \
	|| test $$? -eq 5 # none of them is here: every comparison was skipped

evidence: build ## run every check, the slow ones too, and write the pages of docs/validation
	$(KEEPING) $(WITH_PEERS) -m pytest $(ON_ALL_CORES) --dist=loadfile -m "" --publish \
	tests/verification tests/faults tests/drills
	$(KEEPING) $(BIN)/python -m pytest $(ON_ALL_CORES) -m evidence \
	tests/golden tests/hostile tests/interface tests/pages tests/scenarios tests/studio tests/unit
	OPENBLAS_NUM_THREADS=1 $(BIN)/python docs/make_pages.py --all

pages: build ## write the generated parts of pages that take seconds; CHECK=1 says which are out of date
	@$(BIN)/python docs/make_pages.py $(if $(CHECK),--check) $(PAGES)

fuzz: build ## look for input that breaks something, for SECONDS (600) each target
	@command -v c++ >/dev/null || { echo 'make fuzz: a C++ compiler is missing, which libFuzzer needs'; exit 1; }
	$(FUZZING) cargo build --release --manifest-path $(FUZZ)/Cargo.toml --target $(HOST) --target-dir target/fuzz
	@$(BIN)/python -m tests.hostile.corpus unpack target/fuzz/corpus
	@for target in border lcp; do \
	mkdir -p target/fuzz/kept/$$target; \
	echo "Fuzzing $$target for $(SECONDS) s; what is found stays in target/fuzz"; \
	target/fuzz/$(HOST)/release/$$target -max_total_time=$(SECONDS) -timeout=20 -max_len=256 -len_control=0 \
	-verbosity=0 -artifact_prefix=target/fuzz/$$target- target/fuzz/kept/$$target target/fuzz/corpus/$$target || exit 1; done
	ARCLESS_SEARCH=20 $(BIN)/python -m pytest -m "" tests/hostile
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m tests.hostile.campaign --seconds $(SECONDS)

golden: build ## compare the bits of results with those kept; REASON="why" keeps them anew
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m tests.golden $(if $(REASON),--renew "$$REASON")

lint: $(LINTS) ## check format, lints and types, and that no lock file or local path is tracked

lint-rust: build
	cargo fmt --all --check
	cargo clippy --workspace --all-targets -- -D warnings

lint-style: build
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m tests.prose

# A cache for each platform: one in common would be made again every time.
lint-linux lint-win32 lint-darwin: lint-%: build
	$(BIN)/mypy --platform $* --cache-dir .mypy_cache/$*

lint-files:
	@! git ls-files '*.lock' 2>/dev/null | grep . \
	|| { echo 'make lint: lock files record download addresses: remove them from git'; exit 1; }
	@! git grep -lE '"resolved": *"[a-z+]+:' -- '*package-lock.json' '*npm-shrinkwrap.json' 2>/dev/null \
	|| { echo 'make lint: a lock file of npm records download addresses: set omit-lockfile-registry-resolved'; exit 1; }
	@for path in "$(CURDIR)" "$${HOME:-/}"; do \
	test "$$path" = / || ! git grep -nIF -e "$$path/" -- 2>/dev/null \
	|| { echo 'make lint: a tracked file names a path of this machine'; exit 1; }; done

# One core, as its tables say: NumPy's library would take all for a product. The studio is measured
# with the page of these sources.
bench: build ## measure speed and accuracy; PARTS="sides runs" for some, PAGE=yes for docs/performance.md
	$(if $(or $(if $(PARTS),,all),$(findstring studio,$(PARTS))),@$(BIN)/python -m page.build --where-possible)
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(WITH_PEERS) -m benchmarks.run $(PARTS) $(if $(PAGE),--page)

counts: build ## count the instructions of a step under valgrind; RENEW=1 stores them
	@$(BIN)/python benchmarks/counts.py $(if $(RENEW),--renew)

page: build ## build the page of the studio, which the wheel has: TypeScript and Vite on Node from PyPI
	@$(BIN)/python -m page.build

pictures: page ## take the pictures of the studio and of a report, in Chromium
	@$(BIN)/python docs/make_studio.py
	@$(BIN)/python docs/make_report.py

docs: build ## build the site of the documentation in target/docs/html; a warning or a broken link fails
	@$(BIN)/python docs/website/build.py

wheel: page ## make dist/arcless-*.whl for Linux of glibc 2.28, and try it in an empty environment
	@rm -f dist/arcless-*-manylinux*_x86_64.whl
	@$(NEEDS_ZIG)
	@PATH="$(CURDIR)/$(BIN):$$PATH" cargo zigbuild --release --quiet -p arcless-ffi --target $(GLIBC_TARGET)
	@install -D -m 644 -s target/$(basename $(basename $(GLIBC_TARGET)))/release/libarcless_loop.so $(LIBRARIES)/$(PLATFORM)/arcless_loop.so
	$(MATURIN) build --release --strip --out dist --zig --compatibility $(GLIBC)
	@trial=$$(mktemp -d) && trap 'rm -rf "$$trial"' EXIT && set -e; \
	$(BIN)/python -m venv "$$trial"; \
	"$$trial/bin/python" -m pip install --quiet --no-deps dist/arcless-*-$(GLIBC)_x86_64.whl; \
	site=$$("$(BIN)/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))'); \
	rm -f "$$trial"/lib/python3*/site-packages/*.pth; \
	echo "$$site" > "$$(ls -d "$$trial"/lib/python3*/site-packages)/dependencies.pth"; \
	cd "$$trial" && "$$trial/bin/python" "$(CURDIR)/tests/interface/check_wheel.py" "$(CURDIR)"

# Debian's packages are needed, see docs/guide/systems.md; nothing in CI builds for other systems.
windows: page ## make dist/arcless-*-win_amd64.whl on Debian; try it and the core's tests under wine
	$(BIN)/python -m cross.windows $(PARTS)

fmu: build ## add the library for Windows to the FMUs that are exported here, on Debian
	$(BIN)/python -m cross.windows library

arm: page ## make the wheel for Linux on aarch64 on Debian; try it and the core's tests under qemu
	$(if $(filter-out core,$(or $(PARTS),wheel)),@$(NEEDS_ZIG))
	$(BIN)/python -m cross.arm $(PARTS)

clean: ## remove everything that was built; runs/ stays
	rm -rf $(VENV) target dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find page python tests -name __pycache__ -type d -prune -exec rm -rf {} +
	rm -rf page/node_modules python/arcless/studio/page
	rm -rf python/arcless/_core*.so $(LIBRARIES)

check-python:
	@test -n "$(PYTHON)" && command -v "$(PYTHON)" >/dev/null \
	|| { echo 'make: Python $(OLDEST_PYTHON) or newer is missing; install it, or say where it is: make PYTHON=/path/to/python3'; exit 1; }
	@"$(PYTHON)" -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	|| { echo "make: $$($(PYTHON) --version) is too old; Python $(OLDEST_PYTHON) or newer is needed: make PYTHON=/path/to/python3"; exit 1; }
	@"$(PYTHON)" -c 'import venv, ensurepip' 2>/dev/null \
	|| { echo 'make: $(PYTHON) cannot make environments; install its `venv` module (on Debian and Ubuntu: the package `python3-venv`)'; exit 1; }

check-rust:
	@command -v cargo >/dev/null && command -v rustc >/dev/null \
	|| { echo 'make: the Rust toolchain (`cargo`, `rustc` $(OLDEST_RUST) or newer) is missing; install it, for example with `rustup`'; exit 1; }
	@have=$$(rustc --version | cut -d' ' -f2); \
	printf '%s\n%s\n' "$(OLDEST_RUST)" "$$have" | sort -V -C \
	|| { echo "make: rustc $$have is too old; Rust $(OLDEST_RUST) or newer is needed: rustup update"; exit 1; }
	@command -v cc >/dev/null \
	|| { echo 'make: the C linker `cc`, which Rust needs, is missing; install `gcc` or `clang`'; exit 1; }

# Everything the commands above need, by the lower bounds in pyproject.toml.
$(VENV)/.packages: pyproject.toml
	@$(MAKE) --no-print-directory check-python check-rust
	@"$(BIN)/python" -c '' 2>/dev/null \
	|| { echo 'Making the environment in $(VENV)'; "$(PYTHON)" -m venv --clear $(VENV); }
	@$(BIN)/python -c 'import tomllib; t = tomllib.load(open("pyproject.toml", "rb")); p = t["project"]; \
	print(*t["build-system"]["requires"], *p["dependencies"], *(n for g in ("study", "dev", "docs") \
	for n in p["optional-dependencies"][g]), sep="\n")' \
	> $(VENV)/requirements.txt
	@mkdir -p target
	@echo 'Installing the packages that pyproject.toml names, compiling the numerical core beside it'
	@offline() { echo 'make: the packages could not be installed; the first build needs a network'; exit 1; }; \
	$(BIN)/python -m pip install --quiet "$$(head -n 1 $(VENV)/requirements.txt)" || offline; \
	$(MATURIN) build --release --quiet --out target/wheels > target/first-build.log 2>&1 & compiling=$$!; \
	$(BIN)/python -m pip install --quiet --requirement $(VENV)/requirements.txt || { kill $$compiling; offline; }; \
	wait $$compiling || true # what stopped it is told where the core is built
	@touch $@

# `develop` points the environment at python/, so Python edits need no rebuild.
$(VENV)/.built: $(VENV)/.packages $(RUST_INPUTS)
	@$(MAKE) --no-print-directory check-rust
	@echo 'Compiling the numerical core'
	@$(MATURIN) develop --release --quiet
	@cargo build --release --quiet $(BUILT) # with the binding, the core is as it is already
	@install -D -m 644 -s target/release/libarcless_loop.so $(LIBRARIES)/$(PLATFORM)/arcless_loop.so
	@install -m 644 crates/ffi/include/arcless_loop.h $(LIBRARIES)/
	@touch $@

# Beside the packages of .venv, so that none of those changes. One by one: each may be missing.
$(PEERS)/.packages: pyproject.toml | build
	@$(BIN)/python -m venv --clear $(PEERS)
	@$(BIN)/python -c 'import sysconfig; print(sysconfig.get_path("purelib"))' \
	> "$$(ls -d $(PEERS)/lib/python3*/site-packages)/dependencies.pth"
	@$(BIN)/python -c 'import tomllib; t = tomllib.load(open("pyproject.toml", "rb")); \
	print(*t["project"]["optional-dependencies"]["peers"], sep="\n")' > $(PEERS)/requirements.txt
	@echo 'Installing the programs that results are compared with'
	@missing=0; while read -r program; do \
	$(PEERS)/bin/python -m pip install --quiet --only-binary :all: "$$program" < /dev/null \
	|| { missing=1; echo "make peers: $$program does not install here: not compared with it"; }; \
	done < $(PEERS)/requirements.txt; test $$missing -eq 1 || touch $@
