"""What `make wheels` says of a wheel: read off real modules, and every fault in it noticed."""

from __future__ import annotations

import importlib.util
import os
import struct
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from tests.tools.house import ROOT


def room(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / "build_backend" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


audit_wheel, try_wheel, zig_compiler = room("audit_wheel"), room("try_wheel"), room("zig_compiler")
pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="ELF is Linux's format")


def native():
    from pieper import _kernel

    return Path(_kernel.__file__).read_bytes()


def wheel(
    folder, name="pieper-0.1.0-cp312-abi3-manylinux_2_17_x86_64.whl", ending=".abi3.so", change=lambda data: data
):
    with zipfile.ZipFile(folder / name, "w") as packed:
        for module in ("_kernel", "_code"):
            packed.writestr(f"pieper/{module}{ending}", change(native()))
        packed.writestr("pieper-0.1.0.dist-info/WHEEL", "Wheel-Version: 1.0\nTag: cp312-abi3-linux_x86_64\n")
        packed.writestr("pieper-0.1.0.dist-info/RECORD", "")
    return folder / name


def test_a_module_says_its_machine_libraries_and_versions():
    found = audit_wheel.read_module(native())
    assert found.machine == os.uname().machine and "libc.so.6" in found.libraries
    assert any(version.startswith("GLIBC_2.") for version in found.versions)
    assert any(symbol.startswith("Py") for symbol in found.undefined)
    with pytest.raises(ValueError, match="ELF"):
        audit_wheel.read_module(b"MZ" + bytes(80))


@pytest.mark.skipif(os.uname().machine != "x86_64", reason="the names below are of x86-64")
def test_every_fault_of_a_wheel_is_named(tmp_path):
    # this module is built for one Python and this system's library: what is asked of a wheel it does not keep
    said = " ".join(audit_wheel.audit(wheel(tmp_path), (2, 0)))
    assert "needs glibc 2." in said
    said = " ".join(audit_wheel.audit(wheel(tmp_path, ending=".cpython-312-x86_64-linux-gnu.so"), (9, 0)))
    assert "would not be found by cp312: it must end in .abi3.so" in said
    other = wheel(tmp_path, change=lambda data: data[:18] + struct.pack("<H", 183) + data[20:])
    assert "is for aarch64." in " ".join(audit_wheel.audit(other, (9, 0)))


def test_a_wheel_of_one_python_gets_the_names_of_its_machine(tmp_path):
    made = wheel(tmp_path, "pieper-0.1.0-cp311-cp311-linux_aarch64.whl", ".cpython-311-x86_64-linux-gnu.so")
    (tmp_path / "out").mkdir()
    target = audit_wheel.retagged(made, tmp_path / "out", "aarch64", (2, 17))
    assert target.name == "pieper-0.1.0-cp311-cp311-manylinux_2_17_aarch64.whl"
    with zipfile.ZipFile(target) as packed:
        names = packed.namelist()
        assert "pieper/_kernel.cpython-311-aarch64-linux-gnu.so" in names
        assert b"Tag: cp311-cp311-manylinux_2_17_aarch64" in packed.read("pieper-0.1.0.dist-info/WHEEL")
        record = packed.read("pieper-0.1.0.dist-info/RECORD").decode().splitlines()
    assert sorted(line.split(",")[0] for line in record) == sorted(names)


def test_zig_is_told_the_machine_and_the_library(tmp_path):
    tools = zig_compiler.zig_tools(tmp_path, "python3", "aarch64-linux-gnu.2.17")
    assert "-mcpu=baseline -target aarch64-linux-gnu.2.17" in Path(tools["CXX"]).read_text()
    assert "-target" not in Path(zig_compiler.zig_tools(tmp_path, "python3")["CXX"]).read_text()


def test_the_interpreter_tried_is_no_script_that_needs_the_path(tmp_path, monkeypatch):
    real = Path(sys.base_prefix, "bin", f"python3.{sys.version_info.minor}").resolve()
    shim = tmp_path / f"python3.{sys.version_info.minor}"
    shim.write_text(f'#!/usr/bin/env bash\nexec "{real}" "$@"\n')
    broken = tmp_path / f"python3.{sys.version_info.minor + 1}"
    broken.write_text("no interpreter")
    for script in (shim, broken):
        script.chmod(0o755)
    monkeypatch.setenv("PATH", os.pathsep.join([str(tmp_path), "/usr/bin", "/bin"]))
    monkeypatch.setenv("PYENV_ROOT", str(tmp_path / "none"))
    there = try_wheel.interpreters()
    python = there[sys.version_info[:2]]
    assert python.samefile(real) and python != shim
    assert (3, sys.version_info.minor + 1) not in there or there[3, sys.version_info.minor + 1] != broken
    said = subprocess.run(
        [str(python), "-c", "print(6 * 7)"], capture_output=True, text=True, env={"PATH": ""}, check=True
    )
    assert said.stdout.strip() == "42"


@pytest.mark.parametrize("wheels", [[], ["pieper-0.1.0-cp311-cp311-none.whl"]])
def test_a_wheel_that_cannot_be_installed_is_a_failure_and_nothing_wrong_is_none(tmp_path, wheels):
    script = str(ROOT / "build_backend" / "try_wheel.py")
    alone = os.environ | {"PYENV_ROOT": str(tmp_path), "PATH": f"{sys.base_prefix}/bin"}
    done = subprocess.run([sys.executable, script, *wheels], capture_output=True, env=alone, cwd=tmp_path, check=False)
    ours = sys.version_info[:2] == (3, 11)
    assert done.returncode == (1 if wheels and ours else 0), done.stderr
    assert bool(done.stderr) == bool(wheels and ours)
