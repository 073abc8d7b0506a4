"""One open page: its arm, its messages in order, and the work that is done for it."""

from __future__ import annotations

import asyncio
import contextlib
import json
import threading
import time
from concurrent.futures import Executor
from typing import Any, Protocol

from starlette.websockets import WebSocket, WebSocketDisconnect

import pieper
from pieper.workbench import answers, around, long_work, programs, routes, snippet
from pieper.workbench.looks import Looks
from pieper.workbench.messages import Refused, Stopped, parse

QUICK = {
    **answers.QUICK,
    "clearance": around.clearance,
    "bodies": around.bodies,
    "python": snippet.python,
    "program_file": programs.write,
    **routes.QUICK,
}
#: Messages a second that one page may send on average, and how many at once; a hand on a gizmo sends about 60.
RATE, BURST = 200.0, 400.0
#: Refusals in a row after which the connection is closed.
PATIENCE = 200


class Beside(Protocol):
    """The script or notebook that a page stands beside."""

    @property
    def arm(self) -> pieper.Arm:
        """The arm that pages open with."""
        ...

    def joined(self, page: Session) -> None:
        """A page opened."""

    def left(self, page: Session) -> None:
        """A page was closed."""

    def opening(self) -> dict[str, Any]:
        """Return what a page that opens has to show."""
        ...

    def hear(self, message: dict[str, Any]) -> dict[str, Any]:
        """Take what a page shows after a person did something."""
        ...


class Session:
    """What the server knows of one open page; nothing here is shared with another.

    Args:
        websocket: The accepted connection.
        pool: Threads for everything that computes.
        looks: What arms look like, and the meshes that pages may fetch.
        start: The arm that a new page opens with, or None.
        bench: The script or notebook that the page stands beside, or None.
    """

    def __init__(
        self,
        websocket: WebSocket,
        pool: Executor,
        *,
        looks: Looks,
        start: pieper.Arm | None = None,
        bench: Beside | None = None,
    ) -> None:
        self._websocket = websocket
        self._pool = pool
        self._looks = looks
        self._start = start
        self._bench = bench
        self.loop = asyncio.get_running_loop()
        self._arm: pieper.Arm | None = None
        self._last_seq = -1
        self._tokens = BURST
        self._filled = time.monotonic()
        self._refusals = 0
        self._tasks: dict[str, tuple[asyncio.Task, threading.Event]] = {}
        self._sending = asyncio.Lock()

    async def run(self) -> None:
        """Answer messages until the page goes away; then stop whatever still runs for it."""
        try:
            while self._refusals < PATIENCE:
                message = await self._websocket.receive()
                if message["type"] == "websocket.disconnect":
                    break
                await self._take(message.get("text"))
            else:
                await self._websocket.close(1008, "too many messages were refused")
        except (WebSocketDisconnect, RuntimeError):
            pass
        finally:
            if self._bench is not None:
                self._bench.left(self)
            for task, stop in self._tasks.values():
                stop.set()
                task.cancel()

    async def _take(self, text: str | None) -> None:
        """Check one message and answer it or refuse it; nothing a page says ends the session."""
        seq = None
        try:
            if not self._within_rate():
                raise Refused(f"Too many messages: at most {RATE:g} a second.")
            if text is None:
                raise Refused("Messages are text, not binary.")
            message = parse(text)
            seq = message["seq"]
            if seq <= self._last_seq:
                raise Refused(f"Message {seq} is out of order: {self._last_seq} was answered already.")
            self._last_seq = seq
            await self._answer(message["op"], seq, message)
            self._refusals = 0
        except (Refused, pieper.PieperError) as error:
            self._refusals += isinstance(error, Refused)
            await self._send({"seq": seq, "ok": False, "error": _short(error)})
        except (WebSocketDisconnect, asyncio.CancelledError):
            raise
        except Exception as error:  # a fault of ours must reach the reader of the page, and must not end the session
            await self._send({"seq": seq, "ok": False, "error": _fault(error)})

    async def _answer(self, op: str, seq: int, message: dict[str, Any]) -> None:
        if op == "cancel":
            self._cancel(message.get("kind"))
            await self._send({"seq": seq, "ok": True})
        elif op in answers.TABLES:
            first = self._start if self._bench is None else self._bench.arm
            result = await self._in_pool(answers.TABLES[op], message, first, self._looks)
            if op == "hello" and self._bench is not None:
                self._bench.joined(self)
                result["bench"] = self._bench.opening()
            await self._send({"seq": seq, "ok": True, **result})
        elif op == "arm":
            arm, result = await self._in_pool(answers.take_arm, message)
            self._arm = arm
            await self._send({"seq": seq, "ok": True, **result})
        elif op == "shown" and self._bench is not None:
            await self._send({"seq": seq, "ok": True, **await self._in_pool(self._bench.hear, message)})
        elif op in QUICK:
            result = await self._in_pool(QUICK[op], self._some_arm(), message)
            await self._send({"seq": seq, "ok": True, **result})
        elif op in long_work.KINDS:
            self._begin(op, seq, self._some_arm(), message)
        else:
            known = sorted({"arm", "cancel", *answers.TABLES, *QUICK, *long_work.KINDS})
            raise Refused(f"op is unknown; known are {', '.join(known)}.")

    async def push(self, what: dict[str, Any]) -> None:
        """Tell the page what Python did."""
        await self._send({"push": what})

    def _some_arm(self) -> pieper.Arm:
        if self._arm is None:
            raise Refused("There is no arm yet: send one first.")
        return self._arm

    async def _in_pool(self, work: Any, *args: object) -> Any:
        return await asyncio.get_running_loop().run_in_executor(self._pool, work, *args)

    def _begin(self, kind: str, seq: int, arm: pieper.Arm, message: dict[str, Any]) -> None:
        """Start long work; a newer request of the same kind takes the place of an older one."""
        self._cancel(kind)
        stop = threading.Event()
        task = asyncio.create_task(self._long(kind, seq, arm, message, stop))
        self._tasks[kind] = (task, stop)
        task.add_done_callback(lambda done: self._forget(kind, done))

    def _forget(self, kind: str, task: asyncio.Task) -> None:
        if kind in self._tasks and self._tasks[kind][0] is task:
            del self._tasks[kind]

    def _cancel(self, kind: object) -> None:
        if isinstance(kind, str) and kind in self._tasks:
            self._tasks[kind][1].set()

    async def _long(self, kind: str, seq: int, arm: pieper.Arm, message: dict[str, Any], stop: threading.Event) -> None:
        loop = asyncio.get_running_loop()

        def progress(part: dict[str, Any]) -> None:
            """Send a piece on its way from the working thread; waits, so that a slow page slows the work."""
            if stop.is_set():
                raise Stopped
            asyncio.run_coroutine_threadsafe(
                self._send({"seq": seq, "ok": True, "progress": True, **part}), loop
            ).result(30)

        try:
            result = await self._in_pool(long_work.KINDS[kind], arm, message, progress, stop)
            await self._send({"seq": seq, "ok": True, **result})
        except Stopped:
            await self._send({"seq": seq, "ok": True, "stopped": True})
        except (Refused, pieper.PieperError) as error:
            await self._send({"seq": seq, "ok": False, "error": _short(error)})
        except Exception as error:  # as above
            await self._send({"seq": seq, "ok": False, "error": _fault(error)})

    async def _send(self, data: dict[str, Any]) -> None:
        with contextlib.suppress(WebSocketDisconnect, RuntimeError):
            text = json.dumps(data, allow_nan=False, separators=(",", ":"))
            async with self._sending:
                await self._websocket.send_text(text)

    def _within_rate(self) -> bool:
        now = time.monotonic()
        self._tokens = min(BURST, self._tokens + (now - self._filled) * RATE)
        self._filled = now
        if self._tokens < 1:
            return False
        self._tokens -= 1
        return True


def _short(error: Exception) -> str:
    text = str(error)
    return text if len(text) < 600 else text[:600] + " …"


def _fault(error: Exception) -> str:
    return f"This is a fault of pieper, not yours: {type(error).__name__}: {str(error)[:300]}"
