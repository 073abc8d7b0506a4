"""The exit statuses of the command line."""

from __future__ import annotations

DONE, NO_SOLUTION, MISUSE, INTERRUPTED = 0, 1, 2, 130
