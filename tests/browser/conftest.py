"""A real server and a real Chromium for the stories; each page must end without console errors or foreign requests."""

from __future__ import annotations

import contextlib
import os
import re
import threading
import time
from pathlib import Path

import pytest

import pieper
from oracle.browser import free_port

from . import slow_machine

SHOTS = Path(__file__).resolve().parents[2] / "out" / "browser"
#: Milliseconds; generous, since a story must not fail because the machine is busy.
PATIENCE = 120_000


class Server:
    """The workbench in a thread of this process; can be stopped and started again on the same port."""

    def __init__(self, arm: pieper.Arm | None = None, line: slow_machine.Line | None = None) -> None:
        self.arm = arm
        self.line = line
        self.port = free_port()
        self.url = f"http://localhost:{self.port}/"
        self.start()

    def start(self) -> None:
        import uvicorn

        from pieper.workbench.server import LARGEST_FRAME, create_app

        self.app = create_app(start=self.arm)
        if self.line is not None:
            self.app.add_middleware(slow_machine.Late, line=self.line)
        config = uvicorn.Config(self.app, port=self.port, log_level="error", ws_max_size=LARGEST_FRAME)
        config.timeout_graceful_shutdown = 1
        self._server = uvicorn.Server(config)
        self._thread = threading.Thread(target=self._server.run, daemon=True)
        self._thread.start()
        while not self._server.started:
            time.sleep(0.02)

    def stop(self) -> None:
        self._server.should_exit = True
        self._thread.join(10)

    @property
    def sessions(self) -> set:
        return self.app.state.sessions


@pytest.fixture(scope="session", autouse=True)
def slow_answers():
    """On a slow machine (PIEPER_SLOW) every server that is started here, a script's too, answers late."""
    with pytest.MonkeyPatch.context() as patch:
        if slow_machine.seed():
            from pieper.workbench import server

            patch.setattr(server, "create_app", slow_machine.slowly(server.create_app))
        yield


@pytest.fixture(scope="session")
def server(slow_answers):
    served = Server()
    yield served
    served.stop()


#: The postures of a sequence of joint moves of the VS-6577, deg.
SEED_003 = [
    [0, -90, 180, 0, 0, 0],
    [170, -90, 180, 0, 0, 0],
    [0, -60, 150, 20, 30, 0],
    [-170, -90, 180, 0, 0, 0],
    [0, -120, 200, 0, -40, 90],
]


class Workbench:
    """One person in front of one page."""

    def __init__(self, page, url: str) -> None:
        self.page = page
        self.url = url
        self.requests: list[str] = []
        self.errors: list[str] = []
        page.set_default_timeout(PATIENCE)
        slow_machine.throttle(page)
        page.on("request", lambda r: self.requests.append(r.url))
        page.on("websocket", lambda w: self.requests.append(w.url))
        page.on("console", lambda m: self.errors.append(m.text) if m.type in ("error", "warning") else None)
        page.on("pageerror", lambda e: self.errors.append(str(e)))

    def open(self, address: str = "") -> Workbench:
        self.page.goto(self.url + address)
        self.page.wait_for_selector("html[data-ready=yes]")
        self.until("workbench.table.joints.length > 0")
        return self

    def until(self, condition: str, arg: object = None) -> None:
        """Wait for a condition; asked from outside, since the page's policy forbids it to evaluate text itself."""
        ask = condition if re.match(r"\w+ =>", condition) else f"() => Boolean({condition})"
        end = time.monotonic() + PATIENCE / 1000
        while not self.page.evaluate(ask, arg):
            assert time.monotonic() < end, f"still not so: {condition}"
            self.page.wait_for_timeout(30)

    def tab(self, name: str) -> None:
        self.page.get_by_role("tab", name=name, exact=True).click()

    def button(self, name: str) -> None:
        self.page.get_by_role("button", name=name, exact=True).click()

    def fill(self, testid: str, text: object) -> None:
        field = self.page.get_by_test_id(testid)
        field.fill(str(text))
        field.press("Enter")

    def text(self, testid: str) -> str:
        """Return what stands there, once it is of the newest question."""
        return self.page.locator(f'[data-testid="{testid}"]:not([aria-busy=true])').inner_text()

    def arm(self, name: str) -> None:
        self.page.get_by_test_id("catalog").select_option(name)
        self.until("name => workbench.table.name === name", name)

    def joints(self, values) -> None:
        """Type joint values in the units shown."""
        self.tab("Move")
        for i, value in enumerate(values):
            self.fill(f"q-{i + 1}", value)

    def table(self, rows) -> None:
        """Type a table of turning joints, (a, alpha, d) each, into an empty one."""
        self.tab("DH table")
        self.button("Blank")
        for i, row in enumerate(rows):
            self.page.get_by_test_id("add-joint").click()
            for key, value in zip(("a", "alpha", "d"), row, strict=True):
                self.fill(f"dh-{i + 1}-{key}", value)

    def plan(self, start, end) -> None:
        """Ask for a straight line between two poses typed in the panel, which is open."""
        for key, pose in (("from", start), ("to", end)):
            for i, value in enumerate(pose):
                self.fill(f"path-{key}-{i}", value)
        self.page.get_by_test_id("plan").click()

    def sequence(self, q1: float, seconds: float) -> None:
        """Run a sequence from the arm's posture to one with another first joint."""
        self.tab("Sequence")
        self.page.get_by_test_id("add-posture").click()
        self.page.get_by_test_id("add-posture").click()
        self.fill("seq-1-q1", q1)
        self.fill("seq-1-seconds", seconds)
        self.page.get_by_test_id("run-sequence").click()

    def joint_steps(self, *postures) -> None:
        """Add a joint move to each posture to the program."""
        for q in postures:
            self.joints(q)
            self.tab("Program")
            self.page.get_by_test_id("step-add-joint").click()

    def value(self, expression: str):
        return self.page.evaluate(expression)

    def answered(self, rows: int = 1) -> None:
        """Wait for all that is said of the target as it stands, self-motions and nearest pose included."""
        self.until("n => workbench.settled && workbench.solutions.rows.length >= n", rows)

    def rest(self) -> None:
        """Wait until every question has its answer, nothing followed from it for a while and the address holds it."""
        self.until("workbench.resting")

    def settle(self) -> None:
        """Wait until every question has its answer and the picture has come to rest."""
        self.rest()
        before, drawn = -1, self.value("workbench.pictures")
        while before != drawn:
            before = drawn
            self.page.wait_for_timeout(450)
            drawn = self.value("workbench.pictures")

    def shot(self, name: str, *, both: bool = False) -> None:
        """Keep a picture of the page, where pictures are asked for: a picture at rest, twice, takes seconds."""
        if not os.environ.get("PIEPER_SHOTS"):
            return
        SHOTS.mkdir(parents=True, exist_ok=True)
        self.settle()
        self.page.screenshot(path=SHOTS / f"{name}.png")
        if both:
            self.page.get_by_test_id("theme").select_option("dark")
            self.settle()
            self.page.screenshot(path=SHOTS / f"{name}-dark.png")
            self.page.get_by_test_id("theme").select_option("light")

    def foreign(self) -> list[str]:
        mine = (self.url, self.url.replace("http", "ws", 1), "blob:", "data:")
        return [r for r in self.requests if not r.startswith(mine)]


@pytest.fixture
def people(browser, server):
    """Open as many independent people as a story needs; none may end with an error or a foreign request."""
    with contextlib.ExitStack() as stack:
        opened: list[Workbench] = []

        def person(
            *, width: int = 1280, height: int = 800, dark: bool = False, touch: bool = False, url: str = server.url
        ) -> Workbench:
            context = browser.new_context(
                viewport={"width": width, "height": height},
                color_scheme="dark" if dark else "light",
                reduced_motion="reduce",
                accept_downloads=True,
                has_touch=touch,
                permissions=["clipboard-read", "clipboard-write"],
            )
            stack.callback(context.close)
            opened.append(Workbench(context.new_page(), url))
            return opened[-1]

        yield person
        for one in opened:
            assert one.foreign() == []
            assert [e for e in one.errors if e not in getattr(one, "expected_errors", ())] == []


@pytest.fixture
def bench(people):
    return people().open()


@pytest.fixture(scope="module")
def calculator(browser, server):
    """A page that is only asked to compute, shared by the tests of a file."""
    context = browser.new_context(viewport={"width": 400, "height": 300})
    yield Workbench(context.new_page(), server.url).open()
    context.close()
