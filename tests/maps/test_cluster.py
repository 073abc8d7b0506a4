"""A map on a dask cluster has the same bits, whoever is killed on the way."""

from __future__ import annotations

import hashlib
import os
import resource
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import pieper
from pieper.maps import reach_map as maps

distributed = pytest.importorskip("distributed")
pytestmark = pytest.mark.slow
ASK = {"box": ((-0.6, 0.6), (-0.6, 0.6), (-0.2, 1.0)), "step": 0.1, "orientations": (64, 8), "symmetry": "none"}
#: Small tiles, so that there are many.
POSES = 20_000

DRIVER = """
import sys
from distributed import Client
import pieper
from pieper.maps import reach_map as maps
maps.TILE_POSES = {poses}
if __name__ == "__main__":
    with Client(sys.argv[1]) as client:
        arm = pieper.load("universal-robots-ur5e")
        arm.reach_map(**{ask}, store=sys.argv[2], executor=client.get_executor())
"""


@pytest.fixture(scope="module")
def whole():
    return pieper.load("universal-robots-ur5e").reach_map(**ASK)


@pytest.fixture
def cluster(monkeypatch):
    monkeypatch.setattr(maps, "TILE_POSES", POSES)
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options) as own:
        yield own


def test_a_killed_worker_changes_no_bit(cluster, whole, tmp_path):
    arm, killed = pieper.load("universal-robots-ur5e"), []
    with distributed.Client(cluster) as client:

        def progress(done, tiles):
            if done == 5:
                pid = next(iter(client.run(os.getpid).values()))
                killed.append(pid)
                os.kill(pid, signal.SIGKILL)

        m = arm.reach_map(**ASK, store=tmp_path, executor=client.get_executor(), progress=progress)
    assert killed
    assert np.array_equal(m.bits, whole.bits) and np.array_equal(m.count, whole.count)
    names = sorted(p.name for p in tmp_path.iterdir())
    assert arm.reach_map(**ASK, store=tmp_path).computed == 0 and sorted(p.name for p in tmp_path.iterdir()) == names


def test_a_killed_driver_is_taken_over(cluster, whole, tmp_path):
    script, store = tmp_path / "driver.py", tmp_path / "map"
    script.write_text(DRIVER.format(poses=POSES, ask=repr(ASK)))
    driver = subprocess.Popen([sys.executable, script, cluster.scheduler_address, store])
    until = time.monotonic() + 120
    while len(list(store.glob("*.sha256"))) < 3 and time.monotonic() < until and driver.poll() is None:
        time.sleep(0.02)
    driver.kill()
    driver.wait()
    before = len(list(store.glob("*.sha256")))
    assert before >= 3
    arm = pieper.load("universal-robots-ur5e")
    with distributed.Client(cluster) as client:
        m = arm.reach_map(**ASK, store=store, executor=client.get_executor())
    assert np.array_equal(m.bits, whole.bits) and np.array_equal(m.count, whole.count)
    assert m.computed <= -(-m.grid.count // (POSES // 512)) - 3


def _room(most):
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, resource.RLIM_INFINITY))


def test_a_full_disk_and_a_spoilt_tile_change_no_bit(cluster, whole, tmp_path):
    arm = pieper.load("universal-robots-ur5e")
    with distributed.Client(cluster) as client:
        ask = {**ASK, "store": tmp_path, "executor": client.get_executor(retries=0)}
        # no file can grow beyond a few bytes in the workers, as on a full disk
        client.run(_room, 500)
        with pytest.raises(pieper.InputError, match=r"cannot write .*tile_.*: File too large\. Free room there"):
            arm.reach_map(**ask)
        assert not list(tmp_path.glob("*.npz"))
        client.run(_room, resource.RLIM_INFINITY)
        m = arm.reach_map(**ask)
        assert np.array_equal(m.bits, whole.bits)
        spoilt = sorted(tmp_path.glob("*.npz"))[3]
        before = {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in tmp_path.iterdir()}
        data = bytearray(spoilt.read_bytes())
        data[len(data) // 3] ^= 4
        spoilt.write_bytes(data)
        assert arm.reach_map(**ask).computed == 1
        assert {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in tmp_path.iterdir()} == before
