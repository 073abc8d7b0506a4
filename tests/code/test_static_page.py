"""The page without a server opens from a file, and its answers are the library's."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from static_page.build import build

NAMES = ["denso-vp6242", "universal-robots-ur5e", "stanford-arm", "franka-panda"]


@pytest.mark.slow
def test_the_page_solves_what_the_library_solves(tmp_path, browser):
    assert build(tmp_path, NAMES) == 3
    page = browser.new_page()
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto((tmp_path / "index.html").as_uri())
    for name in NAMES:
        page.select_option("#arm", name)
        page.wait_for_function(f"state.arm && state.arm.name === {name!r}")
        arm = pieper.load(name)
        rng = np.random.default_rng(5)
        limits = np.where(np.isfinite(arm.limits), arm.limits, [-3.0, 3.0])
        for _ in range(10):
            q = rng.uniform(limits[:, 0], limits[:, 1])
            page.evaluate("(q) => move(q)", q.tolist())
            T = arm.fk(q)
            shown = page.locator("#pose td").all_inner_texts()
            assert np.abs(np.array(shown, float).reshape(4, 4) - T).max() < 1e-4
            J = np.array(page.locator("#jacobian td").all_inner_texts(), float).reshape(6, -1)
            assert np.abs(J - arm.jacobian(q)).max() < 1e-4
            if name != "franka-panda":
                assert page.locator("#solutions tr.row").count() == len(arm.ik(T))
                assert page.locator("#solutions tr.here").count() == 1
        assert len(page.locator("#equations").inner_text()) > 100
    assert "library" in page.locator("#says").inner_text()
    assert not faults
    page.close()
