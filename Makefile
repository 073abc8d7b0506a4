VENV ?= .venv
kernel:
	$(VENV)/bin/cmake -S . -B build/dev -G Ninja -DCMAKE_MAKE_PROGRAM=$(abspath $(VENV))/bin/ninja -DPython_EXECUTABLE=$(abspath $(VENV))/bin/python > /dev/null
	$(VENV)/bin/cmake --build build/dev
	for so in build/dev/_kernel*.so; do cp $$so src/pieper/.new.so && mv -f src/pieper/.new.so src/pieper/$$(basename $$so); done
