"""The web server of the workbench: the page's files from an allow-list, one WebSocket, and who may talk to it."""

from __future__ import annotations

import asyncio
import ipaddress
import sys
import webbrowser
from collections.abc import AsyncIterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from pathlib import Path

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket

import pieper
from pieper import InputError
from pieper.workbench.long_work import prepare
from pieper.workbench.looks import Looks
from pieper.workbench.session import Beside, Hands, Session
from pieper.workbench.table import table_from_arm

PAGE = Path(__file__).parent / "page" / "dist"
TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".woff2": "font/woff2",
    ".svg": "image/svg+xml",
}
#: Nothing inline, nothing from elsewhere; blob: is for the files that the page itself makes for download.
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
#: Beside a notebook the page stands in its cell: the notebook's own server is another port of this machine.
POLICY_FRAMED = POLICY.replace("frame-ancestors 'none'", "frame-ancestors http://localhost:* http://127.0.0.1:*")
HEADERS = {
    "Content-Security-Policy": POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}
MESH = "application/octet-stream"
LOOPBACK = ("localhost", "127.0.0.1", "[::1]")
MAX_SESSIONS = 200
#: Seconds from a page's opening until what reports need is imported; before that a page has better things to wait for.
AT_EASE = 4.0
#: A frame above this closes the connection before it is read into memory; the session refuses smaller ones politely.
LARGEST_FRAME = 1 << 20


class HostCheck:
    """Answer only requests that call the server by a name it goes by.

    A page of another site that points its own name at this address (DNS rebinding) is turned away here.
    """

    def __init__(self, app: ASGIApp, names: tuple[str, ...] | None) -> None:
        self.app = app
        self.names = names

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, or answer 421; a WebSocket is closed before it opens."""
        if scope["type"] in ("http", "websocket") and self.names is not None:
            host = dict(scope["headers"]).get(b"host", b"").decode("latin-1")
            if _without_port(host) not in self.names:
                if scope["type"] == "websocket":
                    await send({"type": "websocket.close", "code": 1008, "reason": "unknown host"})
                    return
                await PlainTextResponse("This server does not go by that name.", 421)(scope, receive, send)
                return
        await self.app(scope, receive, send)


def _without_port(host: str) -> str:
    name, colon, port = host.rpartition(":")
    return name.lower() if colon and port.isdigit() else host.lower()


def same_origin(websocket: WebSocket) -> bool:
    """Return whether the page that opens the socket came from this very server."""
    origin = websocket.headers.get("origin", "")
    host = websocket.headers.get("host", "")
    return bool(host) and origin in (f"http://{host}", f"https://{host}")


def _files() -> dict[str, Path]:
    """Return what may be fetched: the files that the bundle holds, by the address they have; nothing else exists."""
    found = {f"/{p.relative_to(PAGE).as_posix()}": p for p in PAGE.rglob("*") if p.suffix in TYPES}
    if "/index.html" in found:
        found["/"] = found["/index.html"]
    return found


def create_app(
    *, names: tuple[str, ...] | None = LOOPBACK, start: pieper.Arm | str | None = None, bench: Beside | None = None
) -> Starlette:
    """Return the workbench as an ASGI application.

    Args:
        names: Host names it answers to; None for any (when it is deliberately opened to a network).
        start: Arm that new pages open with, or its catalogue name; None for the page's own choice.
        bench: The script or notebook that the pages stand beside; its pages may be framed by a page of this machine.
    """
    first = pieper.load(start) if isinstance(start, str) else start
    if first is not None:
        table_from_arm(first)  # what the page cannot show is refused before one is opened
    files = {address: (path.read_bytes(), TYPES[path.suffix]) for address, path in _files().items()}
    looks = Looks()
    hands = Hands(
        ThreadPoolExecutor(max_workers=4, thread_name_prefix="workbench"),
        ThreadPoolExecutor(max_workers=4, thread_name_prefix="workbench-long"),
        ThreadPoolExecutor(max_workers=2, thread_name_prefix="workbench-search"),
    )
    sessions: set[Session] = set()
    headers_of_all = HEADERS if bench is None else {**HEADERS, "Content-Security-Policy": POLICY_FRAMED}

    async def page(request: Request) -> Response:
        entry = files.get(request.url.path)
        if entry is None:
            return PlainTextResponse("There is no such file.", 404, headers=headers_of_all)
        # Chunks and fonts carry a hash or never change within a release; the entry points are asked for anew.
        lasting = "-" in request.url.path.rsplit("/", 1)[-1]
        headers = headers_of_all | {"Cache-Control": "max-age=31536000, immutable" if lasting else "no-cache"}
        return Response(entry[0], headers=headers, media_type=entry[1])

    def mesh(request: Request) -> Response:
        found = looks.mesh(request.url.path)
        if found is None:
            return PlainTextResponse("There is no such mesh.", 404, headers=headers_of_all)
        return Response(found, headers={**headers_of_all, "Cache-Control": "no-cache"}, media_type=MESH)

    async def socket(websocket: WebSocket) -> None:
        if not same_origin(websocket):
            await websocket.close(1008, "foreign origin")
            return
        await websocket.accept()
        if len(sessions) >= MAX_SESSIONS:
            await websocket.close(1013, f"{MAX_SESSIONS} pages are open already; close one")
            return
        if not sessions:
            # once the first page has had what it opens with
            asyncio.get_running_loop().call_later(AT_EASE, hands.long.submit, prepare)
        session = Session(websocket, hands, looks=looks, start=first, bench=bench)
        sessions.add(session)
        try:
            await session.run()
        finally:
            sessions.discard(session)

    @asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        yield
        for threads in hands:
            threads.shutdown(wait=False, cancel_futures=True)

    app = Starlette(
        routes=[
            WebSocketRoute("/session", socket),
            Route("/looks/{path:path}", mesh, methods=["GET"]),
            Route("/{path:path}", page, methods=["GET"]),
        ],
        lifespan=lifespan,
    )
    app.state.sessions, app.state.looks = sessions, looks
    app.add_middleware(HostCheck, names=names)
    return app


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def serve(
    *,
    host: str = "127.0.0.1",
    port: int = 8123,
    arm: pieper.Arm | str | None = None,
    open_to_network: bool = False,
    open_browser: bool = True,
) -> None:
    """Serve the workbench until Ctrl-C.

    Args:
        host: Address to listen on; anything but the loopback address needs `open_to_network`.
        port: Port to listen on; 0 picks a free one.
        arm: Arm that new pages open with, or its catalogue name.
        open_to_network: The caller has understood that everyone who can reach this address can use the server:
            there is no password, and every visitor can make this machine compute.
        open_browser: Open the page in the default browser.

    Raises:
        InputError: A foreign address without `open_to_network`, or the page's bundle is missing.
    """
    import uvicorn

    if not _is_loopback(host) and not open_to_network:
        raise InputError(
            f"{host} can be reached from other machines, and the workbench has no password: everyone who can reach it "
            "can use it and make this machine compute. Say --open-to-network if that is what you want, or leave the "
            "host out.",
            host=host,
        )
    if not (PAGE / "index.html").exists():
        raise InputError(f"the page's bundle is missing from {PAGE}; reinstall pieper, or run `npm run build` there.")
    app = create_app(names=None if open_to_network else (*LOOPBACK, host), start=arm)
    config = uvicorn.Config(
        app,
        host=host,
        port=port,
        log_level="warning",
        ws_max_size=LARGEST_FRAME,
        ws="auto",
        server_header=False,
        timeout_graceful_shutdown=2,
    )
    server = uvicorn.Server(config)
    listener = config.bind_socket()
    address = f"http://{'localhost' if _is_loopback(host) else host}:{listener.getsockname()[1]}/"
    print(f"pieper workbench: {address}   (Ctrl-C ends it)", file=sys.stderr)
    if open_browser:
        webbrowser.open(address)
    server.run(sockets=[listener])
