"""The page driven from Python: `bench = pieper.workbench(arm)` shows it, moves it, and reads what a person did."""

from __future__ import annotations

import asyncio
import sys
import threading
import time
import webbrowser
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.workbench.around import scene_of
from pieper.workbench.messages import Refused, pose, vector
from pieper.workbench.programs import build
from pieper.workbench.table import arm_from_table, is_of_catalog, table_from_arm
from pieper.workbench.things import thing

if TYPE_CHECKING:
    from pieper.workbench.session import Session


class Bench:
    """A workbench in the browser beside a script or a notebook; both move the same arm.

    Attributes:
        url: The page's address.

    Args:
        arm: The arm, or its catalogue name or file.
        port: Port of the page; 0 picks a free one.
        open_browser: Whether to open the page; None opens it but in a notebook, which shows it in its cell.
    """

    def __init__(self, arm: pieper.Arm | str, *, port: int = 0, open_browser: bool | None = None) -> None:
        self._arm = pieper.load(arm) if isinstance(arm, str) else arm
        self._q = np.clip(np.zeros(self._arm.n), *self._arm.limits.T)
        self._target: npt.NDArray[np.float64] | None = None
        self._program: dict[str, Any] | None = None
        self._world: list[Any] = []
        self._things: dict[str, dict[str, Any]] = {}
        self._pages: set[Session] = set()
        self._said = self._heard = self._noticed = 0
        self._changed = threading.Condition()
        self._start(port)
        notebook = "ipykernel" in sys.modules
        if open_browser or (open_browser is None and not notebook):
            webbrowser.open(self.url)

    def _start(self, port: int) -> None:
        import uvicorn

        from pieper.workbench.server import LARGEST_FRAME, create_app

        app = create_app(start=self._arm, bench=self)
        self._looks = app.state.looks
        config = uvicorn.Config(app, port=port, log_level="error", ws_max_size=LARGEST_FRAME, ws="auto")
        config.timeout_graceful_shutdown = 1
        listener = config.bind_socket()
        self.url = f"http://localhost:{listener.getsockname()[1]}/"
        self._server = uvicorn.Server(config)
        run = self._server.run
        self._thread = threading.Thread(target=run, kwargs={"sockets": [listener]}, daemon=True, name="workbench")
        self._thread.start()
        while not self._server.started and self._thread.is_alive():
            time.sleep(0.01)

    # ---- what a script reads and sets
    @property
    def arm(self) -> pieper.Arm:
        """The arm that the page shows; a person may have edited it. Setting it shows another one."""
        with self._changed:
            return self._arm

    @arm.setter
    def arm(self, arm: pieper.Arm | str) -> None:
        shown = pieper.load(arm) if isinstance(arm, str) else arm
        with self._changed:
            self._arm, self._target = shown, None
            self._q = np.clip(np.zeros(shown.n), *shown.limits.T)
        table = table_from_arm(shown, is_of_catalog(shown))
        self._push({"table": table, "looks": self._looks.of(shown), "q": self._q.tolist()})

    @property
    def q(self) -> npt.NDArray[np.float64]:
        """(n,) The posture on the screen, rad or m, whoever made it. Setting it, or a posture's name, moves the arm."""
        with self._changed:
            return self._q.copy()

    @q.setter
    def q(self, value: npt.ArrayLike | str) -> None:
        if isinstance(value, str):
            value = self._posture(value)
        try:
            q = np.array(value, dtype=float)
        except (TypeError, ValueError):
            said = f"q must be {self._arm.n} finite numbers or a posture's name, got {type(value).__name__}."
            raise pieper.InputError(said, given=value) from None
        if q.shape != (self._arm.n,) or not np.isfinite(q).all():
            raise pieper.InputError(
                f"q must be {self._arm.n} finite numbers, one a joint of {self._arm.name}, got shape {q.shape}.",
                given=q.shape,
            )
        with self._changed:
            self._q = q
        self._push({"q": q.tolist()})

    def _posture(self, name: str) -> npt.NDArray[np.float64]:
        postures = self._arm.postures
        if name not in postures:
            raise pieper.InputError(f"{name!r} is no posture; there are {', '.join(postures) or 'none'}.", given=name)
        return np.asarray(postures[name])

    @property
    def T(self) -> npt.NDArray[np.float64]:
        """(4, 4) Where the tool is. Setting it sets the page's target, which the arm follows."""
        return self._arm.fk(self.q)

    @T.setter
    def T(self, value: Any) -> None:
        self.target = value

    @property
    def target(self) -> npt.NDArray[np.float64] | None:
        """(4, 4) The page's target, or None where none was set. Setting it solves it; the arm goes to the nearest."""
        with self._changed:
            return None if self._target is None else self._target.copy()

    @target.setter
    def target(self, value: Any) -> None:
        solutions = self._arm.ik(value)
        with self._changed:
            self._target = np.array(solutions.T)
            if len(solutions):
                self._q = np.asarray(solutions.nearest(self._q))
        self._push({"target": self._target.ravel().tolist(), "q": self._q.tolist()})

    @property
    def solutions(self) -> pieper.Solutions | None:
        """Every solution of the target, as `arm.ik` gives them; None without a target."""
        target = self.target
        return None if target is None else self.arm.ik(target)

    @property
    def program(self) -> pieper.Program | None:
        """What a person taught in *Program*, up to the first step that cannot be done; None where nothing is taught."""
        with self._changed:
            arm, program = self._arm, self._program
        if program is None:
            return None
        try:
            return build(arm, program).program
        except Refused as refused:
            raise pieper.InputError(f"The page's program cannot be read: {refused}") from None

    @property
    def scene(self) -> pieper.Scene:
        """The obstacles that a person put into *World*; what a gripper takes is none."""
        with self._changed:
            return scene_of(self._world)

    def add(self, what: object, name: str | None = None, *, kind: str | None = None, every: float = 0.02) -> str:
        """Show something beside the arm, and return its name; the same name again replaces it.

        Args:
            what: A pose (4, 4) is a frame, poses (k, 4, 4) or points (k, 3) a curve, postures (k, n), a `Track`, a
                `Motion` or a `Program` something to play; a box, a capsule or a cylinder is a body.
            name: Its name; one is made when left out.
            kind: "frame", "path", "points" or "postures", where an array could be two of them.
            every: Seconds between two postures that come without a time.

        Raises:
            InputError: It is nothing that can be shown.
        """
        shown = thing(self._arm, what, kind, every)
        with self._changed:
            if name is None:
                k = 1
                while f"{shown['kind']} {k}" in self._things:
                    k += 1
                name = f"{shown['kind']} {k}"
            self._things[name] = {**shown, "name": name}
        self._push({"things": list(self._things.values())})
        return name

    def remove(self, name: str) -> None:
        """Take something away again, by its name."""
        with self._changed:
            if name not in self._things:
                known = ", ".join(self._things) or "nothing"
                raise pieper.InputError(f"{name!r} is not shown; there is {known}.", given=name)
            del self._things[name]
        self._push({"things": list(self._things.values())})

    def clear(self) -> None:
        """Take away everything that was added."""
        with self._changed:
            self._things.clear()
        self._push({"things": []})

    def wait(self, timeout: float | None = None) -> bool:
        """Wait for what a person does since the last wait; return whether it came within the timeout (s)."""
        with self._changed:
            came = self._changed.wait_for(lambda: self._heard != self._noticed, timeout)
            self._noticed = self._heard
            return came

    def stay(self) -> None:
        """Wait until the last page is closed, as a script does at its end."""
        with self._changed:
            self._changed.wait_for(lambda: bool(self._pages))
            self._changed.wait_for(lambda: not self._pages)

    def close(self) -> None:
        """End the page's server."""
        self._server.should_exit = True
        self._thread.join(5)

    def __enter__(self) -> Bench:
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Bench({self._arm.name!r}, {self.url})"

    def _repr_html_(self) -> str:
        """Return the page as a notebook shows it."""
        return f'<iframe src="{self.url}" title="pieper workbench" width="100%" height="640" style="border:0"></iframe>'

    # ---- the page's side, called from the server's thread
    def joined(self, page: Session) -> None:
        """A page opened."""
        with self._changed:
            self._pages.add(page)
            self._changed.notify_all()

    def left(self, page: Session) -> None:
        """A page was closed."""
        with self._changed:
            self._pages.discard(page)
            self._changed.notify_all()

    def opening(self) -> dict[str, Any]:
        """Return what a page that opens has to show."""
        with self._changed:
            return {
                "said": self._said,
                "q": self._q.tolist(),
                "target": None if self._target is None else self._target.ravel().tolist(),
                "things": list(self._things.values()),
            }

    def hear(self, message: dict[str, Any]) -> dict[str, Any]:
        """Take what a page shows after a person did something; what Python said meanwhile goes before it."""
        table = message.get("table")
        arm = None if table is None else arm_from_table(table)
        n = (arm or self._arm).n
        q = vector(message.get("q"), n, "q")
        target = None if message.get("target") is None else pose(message["target"], "target")
        said = message.get("said")
        if not isinstance(said, int):
            raise Refused("said must be a whole number.")
        program, world = message.get("program"), message.get("world")
        if program is not None and not isinstance(program, dict):
            raise Refused("program must be an object of start, limits and steps, or null.")
        if world is not None:
            scene_of(world)
        with self._changed:
            if said < self._said:
                return {"late": True}
            if arm is not None:
                self._arm = arm
            self._q, self._target = q, target
            if "program" in message:
                self._program = program
            if world is not None:
                self._world = world
            self._heard += 1
            self._changed.notify_all()
        return {}

    def _push(self, what: dict[str, Any]) -> None:
        with self._changed:
            self._said += 1
            pages = list(self._pages)
            what = {**what, "said": self._said}
        for page in pages:
            asyncio.run_coroutine_threadsafe(page.push(what), page.loop)
