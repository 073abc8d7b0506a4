"""The workbench: the arm in the browser, served by `pieper workbench`, or beside Python by `pieper.workbench(arm)`."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import TYPE_CHECKING

from pieper.workbench.bench import Bench
from pieper.workbench.server import create_app, serve

if TYPE_CHECKING:
    import pieper

__all__ = ["Bench", "create_app", "serve"]


class _Workbench(ModuleType):
    """This package, which can be called: `pieper.workbench(arm)`."""

    def __call__(self, arm: pieper.Arm | str, *, port: int = 0, open_browser: bool | None = None) -> Bench:
        """Open a workbench beside this script or notebook; see `Bench`."""
        return Bench(arm, port=port, open_browser=open_browser)


sys.modules[__name__].__class__ = _Workbench
