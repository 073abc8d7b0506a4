# Needs Python 3.11 or newer and make; everything else is fetched into .venv.
#   make          the same as `make tour`
#   make tour     install, then run the tour and say where its page is
#   make test     install with the test tools, then every test (fetches Chromium for the browser tests if none is there);
#                 in as many processes as there are processors (WORKERS=0: in this one); TESTS='-m "not slow"' for the quick ones
#   make check    what needs no test run: style, types, formats, pages, the law of the house (tests/tools/check.py)
#   make house    who imports whom, how long files are, what breaks the law of the house
#   make format   put Python, kernels and page into their style
#   make dev      an environment for work in place (.venv-dev), the kernels built for one instruction set
#   make pages    write the pages of docs/ that are made from benchmarks/results
#   make site     build the page without a server (out/site), which opens from a file (ARMS="my.toml" sets robot files on it)
#   make docs     build the site (out/docs), its pictures drawn by the code on its pages; a warning is an error
#   make wheels   build the wheels that are handed out (dist), audit them, try them on every Python of this machine
#   make bench    measure beside other solvers (installed in environments of their own)
#   make cover    run the tests and say which lines they reach (out/coverage)
#   make mutants  change the code in 200 small ways and say which of them no test notices; goes on where it stopped
#   make soak     random arms, limits and poses against every law for an hour (MINUTES=60 SEED=0), until the first one broken
#   make kernel   rebuild the native module in place, for work on the kernels, for one instruction set (ISAS="baseline;avx2" for two)
#   make sanitize build the kernels with the address and undefined-behaviour sanitizers and run their tests
#   make clean    remove what these targets made

PYTHON ?= python3
VENV ?= .venv
BIN = $(abspath $(VENV))/bin
# The widest instruction set that this machine runs and the kernels are built for.
ISAS ?= $(shell grep -q ' avx512dq ' /proc/cpuinfo 2> /dev/null && echo avx512 || { grep -q ' avx2 ' /proc/cpuinfo 2> /dev/null && echo avx2 || echo baseline; })
CCACHE = $(if $(shell command -v ccache),-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
SOURCES = pyproject.toml CMakeLists.txt $(shell find kernels build_backend src -name '*.so' -prune -o -type f -not -path '*/__pycache__/*' -print)

WORKERS ?= $(shell nproc 2> /dev/null || echo 2)
TESTS ?=
PAGE = src/pieper/workbench/page

.PHONY: tour test check house format dev pages docs wheels site bench soak cover mutants kernel kernel-now sanitize clean
.DELETE_ON_ERROR:

tour: $(VENV)/.installed
	$(BIN)/pieper tour

test: $(VENV)/.installed-for-tests
	CHROMIUM="$$(sh tests/browser/find_chromium.sh)" $(BIN)/python -m pytest -n $(WORKERS) $(TESTS)

check: $(VENV)/.check-tools page-tools
	PATH="$(BIN):$$PATH" $(BIN)/python -m tests.tools.check

house: $(VENV)/.check-tools
	$(BIN)/python -m tests.tools.house

format: $(VENV)/.check-tools page-tools
	$(BIN)/ruff check --fix --quiet . && $(BIN)/ruff format .
	git ls-files 'kernels/*.hpp' 'kernels/*.cpp' 'oracle/*.cpp' | xargs $(BIN)/clang-format -i
	if [ -d $(PAGE)/node_modules ]; then cd $(PAGE) && npm run --silent format; fi

# Of Node's packages only the page's formatter and bundler; where there is no Node the checks say that they left them out.
.PHONY: page-tools
page-tools:
	@if command -v npm > /dev/null && [ ! -d $(PAGE)/node_modules ]; then cd $(PAGE) && npm ci --silent --no-audit --no-fund; fi

pages: $(VENV)/.installed-for-checks
	$(BIN)/python -m benchmarks.pages

docs: $(VENV)/.installed-for-docs
	$(BIN)/python -m sphinx -W --keep-going -q -b html docs out/docs
	@echo "open out/docs/index.html"

# The compiler comes with the environment that is made for each Python; PYTHON only runs the script.
wheels:
	$(PYTHON) build_backend/wheels.py

cover: $(VENV)/.installed-for-checks
	CHROMIUM="$$(sh tests/browser/find_chromium.sh)" $(BIN)/python -m coverage run -m pytest $(TESTS)
	$(BIN)/python -m coverage report --skip-covered --sort=cover
	$(BIN)/python -m coverage html --quiet

MINUTES ?= 60
SEED ?= 0
soak: $(VENV)/.installed-for-tests
	$(BIN)/python -m benchmarks.measure.soak --minutes $(MINUTES) --seed $(SEED) --out out/soak.json

mutants: $(VENV)/.installed-for-checks
	$(BIN)/python -m tests.tools.mutants

# Its own environment, in which nothing of pieper is installed: a .pth file names src/, the module is built in place.
dev:
	$(MAKE) --no-print-directory VENV=.venv-dev .venv-dev/.for-work kernel
	@echo "say: . .venv-dev/bin/activate; after a change in kernels/: make kernel VENV=.venv-dev"

# The compiler of the page's kernels is an extra that nothing else asks for.
site: $(VENV)/.installed-for-tests
	$(BIN)/python -m tests.tools.requirements wasm | xargs $(BIN)/python -m pip install --quiet --disable-pip-version-check
	$(BIN)/python -m static_page.build out/site $(if $(ARMS),--own $(ARMS))

bench: $(VENV)/.installed-for-tests
	$(BIN)/python -m benchmarks.measure.speed

$(BIN)/python:
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "pieper needs Python 3.11 or newer; say make PYTHON=python3.12, for one. This is " + sys.version)'
	$(PYTHON) -m venv $(VENV)

# The package is installed, not linked: what runs is what a user gets. A stamp tells when it is out of date.
$(VENV)/.installed: $(SOURCES) | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check ".[all]"
	touch $@

$(VENV)/.installed-for-tests: $(SOURCES) | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check ".[test]"
	touch $@ $(VENV)/.installed

$(VENV)/.installed-for-checks: $(SOURCES) | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check ".[dev]"
	touch $@ $(VENV)/.installed-for-tests $(VENV)/.installed

# Reads the sources, so nothing of pieper is built: what the extra asks for, and no package.
$(VENV)/.check-tools: pyproject.toml | $(BIN)/python
	$(BIN)/python -m tests.tools.requirements dev | xargs $(BIN)/python -m pip install --quiet --disable-pip-version-check
	touch $@

$(VENV)/.installed-for-docs: $(SOURCES) | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check ".[docs]"
	touch $@ $(VENV)/.installed

$(VENV)/.for-work: pyproject.toml | $(BIN)/python
	$(BIN)/python -m tests.tools.requirements dev | xargs $(BIN)/python -m pip install --quiet --disable-pip-version-check
	$(BIN)/python -c 'import pathlib, sysconfig; pathlib.Path(sysconfig.get_path("purelib"), "pieper-in-place.pth").write_text(str(pathlib.Path("src").resolve()))'
	touch $@

# In place, without pip: run with PYTHONPATH=src afterwards.
# One build at a time: two in one folder would write over each other.
kernel: $(VENV)/.kernel-tools
	@mkdir -p build; if command -v flock > /dev/null; then flock build/.lock $(MAKE) --no-print-directory kernel-now; else $(MAKE) --no-print-directory kernel-now; fi

kernel-now:
	PATH="$(BIN):$$PATH" cmake -S . -B build/dev -G Ninja -DPython_EXECUTABLE=$(BIN)/python "-DPIEPER_ISAS=$(ISAS)" $(CCACHE) > /dev/null
	PATH="$(BIN):$$PATH" cmake --build build/dev
	for so in build/dev/_kernel*.so build/dev/_code*.so; do cp $$so src/pieper/.new.so && mv -f src/pieper/.new.so src/pieper/$$(basename $$so); done

# A copy of the package with its own module, so that the one in place stays as it is. The interpreter itself is not built with
# the sanitizer, so its library is loaded first; what Python and NumPy never free is no leak of ours.
sanitize: $(VENV)/.installed-for-tests $(VENV)/.kernel-tools
	PATH="$(BIN):$$PATH" cmake -S . -B build/sanitize -G Ninja -DPython_EXECUTABLE=$(BIN)/python "-DPIEPER_ISAS=$(ISAS)" $(CCACHE) -DPIEPER_SANITIZE=ON > /dev/null
	PATH="$(BIN):$$PATH" cmake --build build/sanitize
	rm -rf build/sanitize/src && cp -r src build/sanitize/src && rm -f build/sanitize/src/pieper/_kernel*.so build/sanitize/src/pieper/_code*.so && cp build/sanitize/_kernel*.so build/sanitize/_code*.so build/sanitize/src/pieper/
	LD_PRELOAD="$$(c++ -print-file-name=libasan.so) $$(c++ -print-file-name=libubsan.so)" ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=halt_on_error=1 \
	  PYTHONPATH=build/sanitize/src $(BIN)/python -m pytest tests/kernels tests/solver/families

$(VENV)/.kernel-tools: | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check cmake ninja nanobind numpy
	touch $@

clean:
	rm -rf $(VENV) .venv-dev build dist out .coverage .pytest_cache .ruff_cache .hypothesis
	rm -f src/pieper/_kernel*.so src/pieper/_code*.so
	find src tests oracle benchmarks -name __pycache__ -type d -prune -exec rm -rf {} +
