"""The build backend: scikit-build-core, with the compiler of the ziglang package where the machine has none.

PEP 517 hooks. `pip install` asks what the build needs; a machine without a C++ compiler is told to fetch ziglang, whose
clang then builds the kernels.
"""

from __future__ import annotations

import os
import shutil
import sysconfig
import tempfile
from pathlib import Path

from scikit_build_core import build as backend
from zig_compiler import zig_tools

COMPILERS = ("c++", "g++", "clang++")


def _has_compiler() -> bool:
    chosen = os.environ.get("CXX")
    if chosen:
        return shutil.which(chosen.split()[0]) is not None
    return any(shutil.which(name) for name in COMPILERS)


def _cmake_arguments(tools: dict[str, str]) -> str:
    return f"-DCMAKE_AR={tools['AR']} -DCMAKE_RANLIB={tools['RANLIB']}"


class _Compiler:
    """For the time of a build, zig stands in for the compiler that is missing."""

    def __enter__(self) -> None:
        self._before = dict(os.environ)
        self._folder = None
        if _has_compiler():
            return
        # zig keeps its cache by path: a folder of its own, gone afterwards
        self._folder = tempfile.TemporaryDirectory(prefix="pieper-zig-")
        folder = Path(self._folder.name)
        tools = zig_tools(folder)
        os.environ.update(tools)
        os.environ.setdefault("ZIG_GLOBAL_CACHE_DIR", str(folder / "cache"))
        os.environ.setdefault("ZIG_LOCAL_CACHE_DIR", str(folder / "cache"))
        arguments = os.environ.get("CMAKE_ARGS", "")
        os.environ["CMAKE_ARGS"] = f"{arguments} {_cmake_arguments(tools)}".strip()

    def __exit__(self, *_: object) -> None:
        os.environ.clear()
        os.environ.update(self._before)
        if self._folder is not None:
            self._folder.cleanup()


def _with_zig(requirements: list[str]) -> list[str]:
    if _has_compiler():
        return requirements
    # the wheels of ziglang are Python packages with a binary inside; they exist for the platforms named here
    if sysconfig.get_platform().split("-")[0] not in {"linux", "macosx", "win32", "win"}:
        return requirements
    return [*requirements, "ziglang>=0.13"]


def get_requires_for_build_wheel(config_settings: dict | None = None) -> list[str]:
    """Return what building a wheel needs: CMake and Ninja where missing, ziglang where no compiler is."""
    return _with_zig(backend.get_requires_for_build_wheel(config_settings))


def get_requires_for_build_sdist(config_settings: dict | None = None) -> list[str]:
    """Return what packing the sources needs."""
    return backend.get_requires_for_build_sdist(config_settings)


def get_requires_for_build_editable(config_settings: dict | None = None) -> list[str]:
    """Return what an editable install needs."""
    return _with_zig(backend.get_requires_for_build_editable(config_settings))


def build_wheel(
    wheel_directory: str, config_settings: dict | None = None, metadata_directory: str | None = None
) -> str:
    """Build the wheel."""
    with _Compiler():
        return backend.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(
    wheel_directory: str, config_settings: dict | None = None, metadata_directory: str | None = None
) -> str:
    """Build for an editable install."""
    with _Compiler():
        return backend.build_editable(wheel_directory, config_settings, metadata_directory)


def build_sdist(sdist_directory: str, config_settings: dict | None = None) -> str:
    """Pack the sources."""
    return backend.build_sdist(sdist_directory, config_settings)


prepare_metadata_for_build_wheel = backend.prepare_metadata_for_build_wheel
prepare_metadata_for_build_editable = backend.prepare_metadata_for_build_editable
