"""Slow answers beside quick ones: the line stays alive, nobody waits for others' long work, nothing is lost."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import pieper

uvicorn = pytest.importorskip("uvicorn", reason="the workbench extra is not installed")
pytest.importorskip("websockets", reason="the workbench extra is not installed")

from benchmarks.measure import workbench_people as crowd  # noqa: E402
from pieper.workbench import long_work, session  # noqa: E402
from pieper.workbench.server import LARGEST_FRAME, create_app  # noqa: E402
from pieper.workbench.table import table_from_arm  # noqa: E402

ARM = pieper.load("denso-vp6242")
T = ARM.fk(np.radians([20, 60, -150, 10, 40, 25])).ravel().tolist()


@contextlib.contextmanager
def server(**options):
    """Serve the workbench for a while and give its port."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    config = uvicorn.Config(create_app(), port=port, log_level="error", ws_max_size=LARGEST_FRAME, **options)
    one = uvicorn.Server(config)
    thread = threading.Thread(target=one.run, daemon=True)
    thread.start()
    while not one.started:
        time.sleep(0.02)
    yield port
    one.should_exit = True
    thread.join(10)


def apart(call):
    """In a thread of its own: a browser that this process has opened leaves its loop running in the main one."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(call).result()


def talk(story):
    return apart(lambda: asyncio.run(asyncio.wait_for(story, 600)))


def test_the_line_stays_alive_while_an_answer_is_slow_and_messages_wait_behind_it(monkeypatch):
    def slow(arm, message):
        time.sleep(6)
        return {}

    monkeypatch.setitem(session.QUICK, "formulas", slow)

    async def story(port):
        async with crowd.connect(port) as line:
            page = crowd.Asked(line)
            await page.answer(await page.say("arm", {"table": table_from_arm(ARM)}))
            asked = [await page.say("formulas", {"T": T})]
            asked += [await page.say("ik", {"T": T, "brief": True}) for _ in range(150)]
            answers = [await page.answer(seq) for seq in asked]
            assert page.alive and all(a is not None and a["ok"] for a in answers)
            assert [len(page.answers[seq]) for seq in asked] == [1] * len(asked)

    # a line without signs of life for as long as the slow answer takes is given up; a busy machine gives one in time
    with server(ws_ping_interval=0.4, ws_ping_timeout=4.0) as port:
        talk(story(port))


def test_long_work_of_others_keeps_no_answer_waiting_and_what_is_refused_says_which(monkeypatch):
    done = threading.Event()

    def report(arm, message, progress, stop):
        done.wait(100)
        return {}

    monkeypatch.setitem(long_work.KINDS, "report", report)
    monkeypatch.setattr(session, "MOST_WAITING", 20)

    async def story(port):
        async with contextlib.AsyncExitStack() as stack:
            pages = [crowd.Asked(await stack.enter_async_context(crowd.connect(port))) for _ in range(12)]
            for page in pages:
                await page.answer(await page.say("arm", {"table": table_from_arm(ARM)}))
            reports = [await page.say("report", {"q": [0.0] * 6}) for page in pages]
            answer = await pages[-1].answer(await pages[-1].say("ik", {"T": T}), 60)
            assert answer is not None and len(answer["rows"]) == 8, "twelve reports are being written"
            done.set()
            for page, seq in zip(pages, reports, strict=True):
                assert (await page.answer(seq))["ok"]
            many = [await pages[0].say("nearest", {"T": T}) for _ in range(100)]
            answers = [await pages[0].answer(seq) for seq in many]
            refused = [a for a in answers if not a["ok"]]
            assert None not in answers and refused and "wait for their answers" in refused[0]["error"]

    with server() as port:
        talk(story(port))


def test_programs_planned_by_many_at_once_are_each_for_their_own_arm():
    with server() as port:
        found = apart(lambda: crowd.measure_people(port, updates=3, programs=1, sessions=10))
    assert found["lost"] == found["foreign"] == 0 and found["programs"] == 10


def test_whole_and_broken_messages_of_every_kind_are_answered_once_and_for_the_right_arm():
    with server() as port:
        found = apart(lambda: crowd.measure_fuzz(port, 160, sessions=4))
    assert (found["lost"], found["twice"], found["unread"], found["connections_lost"]) == (0, 0, 0, 0)
    assert found["faults"] == found["foreign"] == [] and found["judged"] > 0
