"""The page without a server has a script for every kind of arm, solved there or not."""

from __future__ import annotations

import pieper
from static_page.build import arm_script


def test_every_kind_of_arm_has_its_script():
    kinds = {}
    for name in pieper.catalog():
        said = pieper.load(name).description
        kinds.setdefault((said.joint_types, said.coupling is not None, bool(said.linked)), name)
    for name in kinds.values():
        script, _ = arm_script(pieper.load(name), name)
        assert script.startswith("window.PIEPER.arrived(") and f'"name": "{name}"' in script
