"""Ten thousand broken messages over routes, programs and films: each is answered or refused in words, never a fault."""

from __future__ import annotations

import random
import threading

import numpy as np
import pytest

import pieper
from oracle.page_messages import broken, wholes
from pieper.workbench import films, programs, reach, routes, snippet
from pieper.workbench.messages import Refused
from tests.workbench.test_messages import table


def arm():
    from pieper.workbench.table import arm_from_table

    return arm_from_table(table(2))


def answer(kind: str, one: pieper.Arm, message: dict) -> None:
    stop = threading.Event()
    long = {**routes.LONG, **reach.LONG, "program": programs.run, "film": films.film}
    if kind in long:
        long[kind](one, message, lambda part: None, stop)
    else:
        {**routes.QUICK, "program_file": programs.write, "python": snippet.python}[kind](one, message)


#: How many of each: what is refused late, or comes through and draws, takes longer.
COUNTS = {
    "route": 4500,
    "route_posture": 4500,
    "python": 400,
    "program": 250,
    "program_file": 250,
    "film": 100,
    "voxels": 60,
}


# numbers that look like degrees are warned of, as everywhere
@pytest.mark.filterwarnings("ignore::pieper.PieperWarning")
@pytest.mark.parametrize("kind", list(COUNTS))
def test_a_broken_message_is_refused_in_words_and_is_no_fault(kind):
    whole, one, rng = wholes([0, 0], np.eye(4), np.eye(4))[kind], arm(), random.Random(kind)
    refused = 0
    for _ in range(COUNTS[kind]):
        message = broken(whole, rng)
        try:
            answer(kind, one, message)
        except (Refused, pieper.PieperError) as error:
            refused += 1
            assert str(error).strip(), message
        except Exception as error:
            raise AssertionError(f"{type(error).__name__}: {error}\n{message}") from error
    assert refused > COUNTS[kind] / 2
