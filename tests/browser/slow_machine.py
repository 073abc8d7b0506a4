"""A slow machine: with PIEPER_SLOW set to a seed the page's processor is throttled and the server's answers come late.

A test that waits for what it means passes there too; one that takes the first thing it finds does not, and a page that
shows an old answer beside a new question is seen doing it.
"""

from __future__ import annotations

import asyncio
import os
import random
import time

from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: How many times slower the page computes.
THROTTLE = 8
#: Seconds from an answer to its arrival at the page, evenly between the two.
LATE = (0.3, 1.5)


def seed() -> str:
    """Return the seed of the delays; empty on a machine as fast as it is."""
    return os.environ.get("PIEPER_SLOW", "")


def throttle(page) -> None:
    """Slow the processor of a page."""
    if seed():
        page.context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": THROTTLE})


class Line:
    """The line from a server to its pages: how late it is, and whether it is held, so that nothing arrives."""

    def __init__(self, late: tuple[float, float] = (0.0, 0.0)) -> None:
        self.late = late
        self.held = False
        self.chance = random.Random(seed())


class Late:
    """An ASGI application whose WebSocket messages arrive late, in the order in which they were sent.

    Sending itself does not wait: what is late is what the page hears, as where the line is long.
    """

    def __init__(self, app: ASGIApp, line: Line) -> None:
        self.app = app
        self.line = line

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass everything on; the messages of a WebSocket after a while."""
        if scope["type"] != "websocket":
            await self.app(scope, receive, send)
            return
        underway: asyncio.Queue[tuple[float, Message]] = asyncio.Queue()

        async def deliver() -> None:
            while True:
                due, message = await underway.get()
                await asyncio.sleep(max(due - time.monotonic(), 0))
                while self.line.held:
                    await asyncio.sleep(0.01)
                try:
                    await send(message)
                except Exception:  # the page is gone, and with it everybody who would hear the rest
                    return

        async def late(message: Message) -> None:
            if message["type"] == "websocket.send":
                underway.put_nowait((time.monotonic() + self.line.chance.uniform(*self.line.late), message))
            else:
                await send(message)

        carrier = asyncio.create_task(deliver())
        try:
            await self.app(scope, receive, late)
        finally:
            carrier.cancel()


def slowly(create_app):
    """Return a maker of applications whose answers come late."""

    def create(**options):
        app = create_app(**options)
        app.add_middleware(Late, line=Line(LATE))
        return app

    return create
