# Needs Python 3.11 or newer and make; everything else is fetched into .venv.
#   make          the same as `make tour`
#   make tour     install, then run the tour and say where its page is
#   make test     install with the test tools, then every test (fetches Chromium for the browser tests if none is there)
#   make bench    measure beside other solvers (installed in environments of their own)
#   make kernel   rebuild the native module in place, for work on the kernels
#   make clean    remove what these targets made

PYTHON ?= python3
VENV ?= .venv
BIN = $(abspath $(VENV))/bin
SOURCES = pyproject.toml CMakeLists.txt $(shell find kernels src -name '*.so' -prune -o -type f -not -path '*/__pycache__/*' -print)

.PHONY: tour test bench kernel kernel-now clean
.DELETE_ON_ERROR:

tour: $(VENV)/.installed
	$(BIN)/pieper tour

test: $(VENV)/.installed-for-tests
	CHROMIUM="$$(sh tests/browser/find_chromium.sh)" $(BIN)/python -m pytest

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

# In place, without pip: run with PYTHONPATH=src afterwards.
# One build at a time: two in one folder would write over each other.
kernel: $(VENV)/.kernel-tools
	@mkdir -p build; if command -v flock > /dev/null; then flock build/.lock $(MAKE) --no-print-directory kernel-now; else $(MAKE) --no-print-directory kernel-now; fi

kernel-now:
	PATH="$(BIN):$$PATH" cmake -S . -B build/dev -G Ninja -DPython_EXECUTABLE=$(BIN)/python > /dev/null
	PATH="$(BIN):$$PATH" cmake --build build/dev
	for so in build/dev/_kernel*.so; do cp $$so src/pieper/.new.so && mv -f src/pieper/.new.so src/pieper/$$(basename $$so); done

$(VENV)/.kernel-tools: | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check cmake ninja nanobind numpy
	touch $@

clean:
	rm -rf $(VENV) build dist .pytest_cache .ruff_cache .hypothesis
	rm -f src/pieper/_kernel*.so
	find src tests -name __pycache__ -type d -prune -exec rm -rf {} +
