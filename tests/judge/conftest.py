"""What several tests of the judge ask: a robot in a file."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import DH, Arm


@pytest.fixture(scope="session")
def robot(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The path of a robot file of three joints."""
    file = tmp_path_factory.mktemp("robots") / "three.toml"
    rows = [DH(d=0.35, alpha=np.pi / 2), DH(a=0.4), DH(a=0.3)]
    Arm.from_dh(rows, convention="standard", name="three").save(str(file))
    return str(file)
