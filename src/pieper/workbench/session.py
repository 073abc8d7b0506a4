"""One open page: its arm, its messages in order, and the work that is done for it."""

from __future__ import annotations

import asyncio
import contextlib
import json
import threading
import time
from concurrent.futures import Executor
from typing import Any, NamedTuple, Protocol

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
#: Long work that may take minutes and cannot be stopped on its way.
SEARCHES = ("cures", "route_others")
#: Messages a second that one page may send on average, and how many at once; a hand on a gizmo sends about 60.
RATE, BURST = 200.0, 400.0
#: Messages of one page that may wait for their turn; more are refused at once.
MOST_WAITING = 400
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


class Hands(NamedTuple):
    """Threads for quick answers, for long work, and for searches that may take minutes: none keeps another waiting."""

    quick: Executor
    long: Executor
    search: Executor


class Session:
    """What the server knows of one open page; nothing here is shared with another.

    Args:
        websocket: The accepted connection.
        hands: Threads for everything that computes.
        looks: What arms look like, and the meshes that pages may fetch.
        start: The arm that a new page opens with, or None.
        bench: The script or notebook that the page stands beside, or None.
    """

    def __init__(
        self,
        websocket: WebSocket,
        hands: Hands,
        *,
        looks: Looks,
        start: pieper.Arm | None = None,
        bench: Beside | None = None,
    ) -> None:
        self._websocket = websocket
        self._hands = hands
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
        """Answer messages until the page goes away; then stop whatever still runs for it.

        Messages are taken off the line while earlier ones are answered: what lies unread there would keep the signs of
        life behind it from being read, and the line would be given up.
        """
        waiting: asyncio.Queue[tuple[int | None, dict[str, Any]]] = asyncio.Queue()
        hand = asyncio.create_task(self._work(waiting))
        try:
            while (message := await self._websocket.receive())["type"] != "websocket.disconnect":
                await self._take(message.get("text"), waiting)
                if self._refusals >= PATIENCE:
                    await self._websocket.close(1008, "too many messages were refused")
                    break
        except (WebSocketDisconnect, RuntimeError):
            pass
        finally:
            hand.cancel()
            if self._bench is not None:
                self._bench.left(self)
            for task, stop in self._tasks.values():
                stop.set()
                task.cancel()

    async def _take(self, text: str | None, waiting: asyncio.Queue) -> None:
        """Check one message and put it behind those that wait, or refuse it."""
        seq = None
        try:
            allowed = self._within_rate()
            if text is None:
                raise Refused("Messages are text, not binary.")
            message = parse(text)
            seq = message["seq"]
            if not allowed:
                raise Refused(f"Too many messages: at most {RATE:g} a second.")
            if waiting.qsize() >= MOST_WAITING:
                raise Refused(f"Too many messages: {MOST_WAITING} wait for their answers already.")
            if seq <= self._last_seq:
                raise Refused(f"Message {seq} is out of order: {self._last_seq} was sent already.")
            self._last_seq = seq
            waiting.put_nowait((seq, message))
        except Refused as error:
            await self._refuse(seq, error)

    async def _work(self, waiting: asyncio.Queue) -> None:
        """Answer one message after the other; nothing a page says ends the session."""
        while True:
            seq, message = await waiting.get()
            try:
                await self._answer(message["op"], seq, message)
                self._refusals = 0
            except (Refused, pieper.PieperError) as error:
                await self._refuse(seq, error)
            except WebSocketDisconnect:
                return
            except Exception as error:  # a fault of ours must reach the reader of the page, and not end the session
                await self._send({"seq": seq, "ok": False, "error": _fault(error)})

    async def _refuse(self, seq: int | None, error: Exception) -> None:
        self._refusals += isinstance(error, Refused)
        await self._send({"seq": seq, "ok": False, "error": _short(error)})

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
        return await self.loop.run_in_executor(self._hands.quick, work, *args)

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
            hands = self._hands.search if kind in SEARCHES else self._hands.long
            result = await loop.run_in_executor(hands, long_work.KINDS[kind], arm, message, progress, stop)
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
