"""What a wheel asks of a machine: processor, C library, other libraries; its tags put right."""

from __future__ import annotations

import base64
import hashlib
import re
import struct
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

#: ELF's number of each processor.
PROCESSORS = {62: "x86_64", 183: "aarch64"}
#: Libraries that every glibc brings; the C++ library must be inside the module.
OF_THE_SYSTEM = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1"}
OF_THE_SYSTEM |= {"ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
#: Wheels that grow beyond this (bytes) hold something they should not.
LARGEST = 25_000_000


@dataclass
class Module:
    """What a shared library says about itself.

    Attributes:
        machine: The processor it is for.
        libraries: The libraries it names.
        versions: Versions of their symbols that it needs, such as "GLIBC_2.14".
        undefined: Symbols that somebody else must bring.
    """

    machine: str
    libraries: list[str] = field(default_factory=list)
    versions: list[str] = field(default_factory=list)
    undefined: list[str] = field(default_factory=list)


def read_module(data: bytes) -> Module:
    """Read the dynamic section of a 64-bit little-endian ELF file.

    Raises:
        ValueError: It is none.
    """
    if data[:6] != b"\x7fELF\x02\x01":
        raise ValueError("not a 64-bit little-endian ELF file")
    found = Module(PROCESSORS.get(struct.unpack_from("<H", data, 18)[0], "another processor"))
    start, size, count = struct.unpack_from("<Q", data, 40)[0], *struct.unpack_from("<HH", data, 58)
    sections = [struct.unpack_from("<IIQQQQIIQQ", data, start + i * size) for i in range(count)]
    for _name, kind, _flags, _address, offset, length, link, info, _align, entry in sections:
        if kind not in (6, 11, 0x6FFFFFFE):
            continue
        strings = sections[link][4]
        if kind == 6:
            tags = (struct.unpack_from("<qQ", data, offset + i) for i in range(0, length, entry))
            found.libraries += [_string(data, strings + value) for tag, value in tags if tag == 1]
        elif kind == 11:
            symbols = (struct.unpack_from("<IBBHQQ", data, offset + i) for i in range(entry, length, entry))
            found.undefined += [
                _string(data, strings + name) for name, _i, _o, section, _v, _s in symbols if not section
            ]
        else:
            found.versions += _needed(data, offset, info, strings)
    return found


def _string(data: bytes, at: int) -> str:
    return data[at : data.index(b"\0", at)].decode()


def _needed(data: bytes, offset: int, libraries: int, strings: int) -> Iterator[str]:
    for _ in range(libraries):
        _version, count, _file, first, following = struct.unpack_from("<HHIII", data, offset)
        at = offset + first
        for _ in range(count):
            _hash, _flags, _other, name, beyond = struct.unpack_from("<IHHII", data, at)
            yield _string(data, strings + name)
            at += beyond
        offset += following


def audit(wheel: Path, glibc: tuple[int, int]) -> list[str]:
    """Return what is wrong with a wheel, a sentence each.

    Args:
        wheel: The file; its name says for which Python and machine it is.
        glibc: The newest version of the C library that it may ask for.
    """
    python, abi, platform = wheel.stem.split("-")[-3:]
    machine = "aarch64" if platform.endswith("aarch64") else "x86_64"
    complaints = []
    with zipfile.ZipFile(wheel) as packed:
        names = packed.namelist()
        modules = [name for name in names if name.endswith(".so")]
        if len(modules) != 2:
            complaints.append(f"two modules are expected, it has {modules}.")
        for name in modules:
            ending = ".abi3.so" if abi == "abi3" else f".cpython-{python[2:]}-{machine}-linux-gnu.so"
            if not name.endswith(ending):
                complaints.append(f"{name} would not be found by {python}: it must end in {ending}.")
            module = read_module(packed.read(name))
            newest = max(_glibc(module.versions), default=(0, 0))
            if module.machine != machine:
                complaints.append(f"{name} is for {module.machine}.")
            if newest > glibc:
                complaints.append(f"{name} needs glibc {newest[0]}.{newest[1]}.")
            strange = sorted(set(module.libraries) - OF_THE_SYSTEM)
            if strange:
                complaints.append(f"{name} needs {', '.join(strange)}.")
            private = [
                symbol for symbol in module.undefined if symbol.startswith("_Py") and symbol not in STABLE_PRIVATE
            ]
            if abi == "abi3" and private:
                complaints.append(f"{name} uses what the stable ABI does not have: {', '.join(private)}.")
            print(
                f"{wheel.name}: {name.split('/')[-1]}: {module.machine}, glibc {newest[0]}.{newest[1]}, "
                f"{', '.join(module.libraries)}"
            )
        # exports in C++ bring the kernels' headers along
        others = [n for n in names if not n.startswith("pieper/code/kernels/")]
        unwanted = [n for n in others if re.search(r"page/(src|node_modules)/|\.(cpp|hpp)$|__pycache__", n)]
        if unwanted:
            complaints.append(f"it holds what nobody runs: {', '.join(unwanted[:3])}.")
    if wheel.stat().st_size > LARGEST:
        complaints.append(f"it has {wheel.stat().st_size:,} bytes.")
    return complaints


#: Names with an underscore that are in the stable ABI all the same.
STABLE_PRIVATE = {"_Py_NoneStruct", "_Py_TrueStruct", "_Py_FalseStruct", "_Py_Dealloc", "_Py_NotImplementedStruct"}
STABLE_PRIVATE |= {"_Py_EllipsisObject", "_PyObject_New", "_PyObject_GC_New", "_PyArg_ParseTuple_SizeT"}
STABLE_PRIVATE |= {"_PyObject_CallFunction_SizeT", "_Py_BuildValue_SizeT", "_PyWeakref_ProxyType", "_Py_IncRef"}
STABLE_PRIVATE |= {"_Py_DecRef", "_Py_CheckRecursiveCall", "_PyObject_NewVar", "_PyWeakref_RefType"}


def _glibc(versions: list[str]) -> Iterator[tuple[int, int]]:
    for version in versions:
        if match := re.fullmatch(r"GLIBC_(\d+)\.(\d+)(?:\.\d+)?", version):
            yield int(match[1]), int(match[2])


def retagged(wheel: Path, folder: Path, machine: str, glibc: tuple[int, int]) -> Path:
    """Write a wheel anew with the manylinux tag of its C library and its modules' names as the machine expects them.

    What was compiled for another machine has the names of this one; nothing else changes.
    """
    python, abi, _ = wheel.stem.split("-")[-3:]
    tag = f"manylinux_{glibc[0]}_{glibc[1]}_{machine}"
    target = folder / ("-".join([*wheel.stem.split("-")[:-1], tag]) + ".whl")
    record: list[str] = []
    with zipfile.ZipFile(wheel) as old, zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as new:
        for info in old.infolist():
            name, data = info.filename, old.read(info)
            if name.endswith(".dist-info/RECORD"):
                where = name
                continue
            if name.endswith(".dist-info/WHEEL"):
                kept = [line for line in data.decode().splitlines() if not line.startswith("Tag:") and line]
                data = "\n".join([*kept, f"Tag: {python}-{abi}-{tag}", ""]).encode()
            if name.endswith(".so") and abi != "abi3":
                name = re.sub(r"\.cpython-.*\.so$", f".cpython-{python[2:]}-{machine}-linux-gnu.so", name)
            info.filename = name
            new.writestr(info, data, zipfile.ZIP_DEFLATED)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}")
        new.writestr(where, "\n".join([*record, f"{where},,", ""]))
    return target
