"""A map that is interrupted says what it leaves behind, and the same command goes on there to the same bits."""

from __future__ import annotations

import contextlib
import os
import pty
import signal
import subprocess
import sys
import time

import pytest

ASK = ["denso-vp6242", "--box", "-600 600 -600 600 -200 800", "--step", "50", "--symmetry", "none"]
RUN = [sys.executable, "-m", "pieper", "map", *ASK]
#: Seconds that the first tiles may take on a busy machine.
PATIENCE = 120.0


def begun(*more, stderr=subprocess.PIPE):
    # a parent that ignores Ctrl-C hands that down; here it must arrive
    restore = lambda: signal.signal(signal.SIGINT, signal.default_int_handler)  # noqa: E731
    return subprocess.Popen([*RUN, *more], stderr=stderr, stdout=subprocess.PIPE, text=True, preexec_fn=restore)


def test_an_interrupted_map_says_how_many_tiles_it_keeps_and_goes_on(tmp_path):
    folder, until = tmp_path / "kept", time.monotonic() + PATIENCE
    run = begun("--out", str(folder))
    while len(list(folder.glob("*.sha256"))) < 2 and time.monotonic() < until and run.poll() is None:
        time.sleep(0.02)
    run.send_signal(signal.SIGINT)
    _, said = run.communicate(timeout=PATIENCE)
    tiles = sorted(folder.glob("*.sha256"))
    if run.returncode == 0:
        pytest.skip("the map was done before it could be interrupted")
    assert run.returncode == 130 and f"interrupted; {len(tiles)} finished tiles in {folder}" in said, said
    assert "the same command goes on there" in said and "Traceback" not in said
    before = {tile: tile.stat().st_mtime_ns for tile in tiles}
    subprocess.run([*RUN, "--out", str(folder)], check=True, capture_output=True)
    assert len(list(folder.glob("*.sha256"))) > len(tiles)
    assert {tile: tile.stat().st_mtime_ns for tile in tiles} == before


def test_without_a_folder_it_says_that_nothing_is_kept():
    ours, terminal = pty.openpty()
    run = begun(stderr=terminal)
    os.close(terminal)
    # on a terminal it says how far it is: it has begun, however long that took
    words = [os.read(ours, 4096)]
    run.send_signal(signal.SIGINT)
    with contextlib.suppress(OSError):  # the other end of a terminal is closed with an error
        while words[-1]:
            words.append(os.read(ours, 4096))
    os.close(ours)
    run.communicate(timeout=PATIENCE)
    said = b"".join(words).decode()
    if run.returncode == 0:
        pytest.skip("the map was done before it could be interrupted")
    assert run.returncode == 130 and "interrupted" in said and "Traceback" not in said


@pytest.mark.parametrize("address", ["foo", "8786", "", "tcp://foo"])
def test_what_is_no_address_of_a_scheduler_is_said(run, address):
    code, _, err = run(
        "map", "denso-vp6242", "--box", "-600 600 -600 600 -100 700", "--step", "60", "--scheduler", address
    )
    assert code == 2 and "is no address" in err and "tcp://host:8786" in err
