"""The workbench: the arm in the browser, served by `pieper workbench`."""

from pieper.workbench.server import create_app, serve

__all__ = ["create_app", "serve"]
