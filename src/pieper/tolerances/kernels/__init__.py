"""The tolerances of the kernels: the build writes a C++ header from these pages, NAME becoming kName."""
