"""The workbench's server under good and bad company: who may talk to it, what is served, what it survives."""

from __future__ import annotations

import asyncio
import dataclasses
import http.client
import json
import random
import socket
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import pieper

uvicorn = pytest.importorskip("uvicorn", reason="the workbench extra is not installed")
websockets = pytest.importorskip("websockets", reason="the workbench extra is not installed")

from pieper.workbench import server as room  # noqa: E402
from pieper.workbench.messages import MAX_BYTES  # noqa: E402
from pieper.workbench.table import table_from_arm  # noqa: E402


@pytest.fixture(scope="module")
def served():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    app = room.create_app()
    server = uvicorn.Server(uvicorn.Config(app, port=port, log_level="error", ws_max_size=room.LARGEST_FRAME))
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    while not server.started:
        time.sleep(0.02)
    yield port, app
    server.should_exit = True
    thread.join(10)


def nobody_left(app) -> bool:
    """Return whether the sessions of pages that are closed are freed, as soon as the server has heard of it."""
    until = time.monotonic() + 60
    while app.state.sessions and time.monotonic() < until:
        time.sleep(0.05)
    return not app.state.sessions


def get(port: int, path: str, host: str | None = None):
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
    connection.putrequest("GET", path, skip_host=True)
    connection.putheader("Host", host or f"localhost:{port}")
    connection.endheaders()
    answer = connection.getresponse()
    return answer.status, dict(answer.getheaders()), answer.read()


class Page:
    """A page's side of the conversation."""

    def __init__(self, socket) -> None:
        self.socket, self.seq = socket, 0

    async def ask(self, op: str, **body):
        self.seq += 1
        await self.socket.send(json.dumps({"op": op, "seq": self.seq, **body}))
        while (answer := json.loads(await self.socket.recv())).get("progress"):
            pass
        assert answer["seq"] == self.seq
        return answer


def connect(port: int, origin: str | None = ""):
    if origin == "":
        origin = f"http://localhost:{port}"
    return websockets.connect(f"ws://localhost:{port}/session", origin=origin, max_size=None)


def talk(story):
    """Run a conversation in a thread of its own: the main one may hold the browser stories' event loop."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(lambda: asyncio.run(asyncio.wait_for(story, 600))).result()


def test_the_page_comes_with_a_strict_policy(served):
    status, headers, body = get(served[0], "/")
    assert status == 200 and b"<script type" in body
    policy = headers["content-security-policy"]
    assert "default-src 'none'" in policy and "unsafe" not in policy and "frame-ancestors 'none'" in policy
    assert headers["x-content-type-options"] == "nosniff"


def test_the_page_has_nothing_inline_and_nothing_from_elsewhere():
    html = (room.PAGE / "index.html").read_text()
    assert "http:" not in html and "https:" not in html
    assert "style=" not in html and "onclick" not in html and "<style" not in html


def test_everything_shipped_weighs_less_than_two_and_a_half_megabytes():
    assert sum(p.stat().st_size for p in room.PAGE.rglob("*") if p.is_file()) < 2.5e6


@pytest.mark.parametrize(
    "path",
    ["/../server.py", "/..%2fserver.py", "/%2e%2e/server.py", "//etc/passwd", "/fonts/../../package.json", "/fonts/",
     "/index.html%00", "/server.py", "/..\\server.py", "/" + "a" * 5000],
)  # fmt: skip
def test_only_files_of_the_bundle_are_served(served, path):
    status, _, body = get(served[0], path)
    assert status in (400, 404, 414) and b"import" not in body and b"root:" not in body


@pytest.mark.parametrize("host", ["evil.example", "localhost.evil.example", "192.168.0.7:80", "127.0.0.1.nip.io"])
def test_a_foreign_host_name_is_turned_away(served, host):
    assert get(served[0], "/", host)[0] == 421


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", None, "http://localhost:1", "https://localhost.evil.example"]
)
def test_a_page_of_another_origin_cannot_open_a_session(served, origin):
    async def story():
        with pytest.raises(websockets.exceptions.InvalidStatus, match="403"):
            async with connect(served[0], origin=origin):
                pass

    talk(story())


def test_anything_but_loopback_needs_to_be_said_and_says_what_it_means():
    with pytest.raises(pieper.InputError, match="no password"):
        room.serve(host="0.0.0.0", open_browser=False)


def test_messages_out_of_order_too_large_or_binary_are_refused_and_the_session_lives_on(served):
    async def story():
        async with connect(served[0]) as socket:
            page = Page(socket)
            table = table_from_arm(pieper.load("denso-vp6242"))
            assert (await page.ask("ik", T=[0] * 16))["error"].startswith("There is no arm yet")
            assert (await page.ask("arm", table=table))["plan"]["max_solutions"] == 8
            for raw, reason in [
                (json.dumps({"op": "ik", "seq": 1, "T": [0] * 16}), "out of order"),
                ("x" * (MAX_BYTES + 10), "at most"),
                (b"\x00\x01", "not binary"),
                (json.dumps({"op": "launch", "seq": 9_000}), "op is unknown"),
            ]:
                await socket.send(raw)
                answer = json.loads(await socket.recv())
                assert not answer["ok"] and reason in answer["error"]
            page.seq = 10_000
            answer = await page.ask("ik", T=[2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
            assert not answer["ok"] and "rotation" in answer["error"]
            assert not (await page.ask("arm", table={**table, "joints": table["joints"] * 84}))["ok"]
            T = pieper.load("denso-vp6242").fk([0.3, 1.2, -2.6, 0.4, 0.7, 0.1])
            assert len((await page.ask("ik", T=T.ravel().tolist()))["rows"]) == 8

    talk(story())


def test_a_frame_beyond_all_measure_closes_only_its_own_connection(served):
    async def story():
        async with connect(served[0]) as bad, connect(served[0]) as good:
            with pytest.raises(websockets.exceptions.ConnectionClosed):
                await bad.send("x" * (room.LARGEST_FRAME + 1))
                await bad.recv()
            assert (await Page(good).ask("hello"))["ok"]

    talk(story())


def test_a_flood_is_slowed_with_a_reason(served):
    async def story():
        async with connect(served[0]) as socket:
            for seq in range(1, 701):
                await socket.send(json.dumps({"op": "cancel", "seq": seq}))
            answers = [json.loads(await socket.recv()) for _ in range(400)]
            rest = []
            try:
                while True:
                    rest.append(json.loads(await asyncio.wait_for(socket.recv(), 2)))
            except (TimeoutError, websockets.exceptions.ConnectionClosed):
                pass
            refused = [a for a in answers + rest if not a["ok"]]
            assert refused and "Too many messages" in refused[0]["error"]

    talk(story())


def random_message(rng: random.Random, seq: int) -> str | bytes:
    """A message that is wrong in some way, or right by accident."""
    junk = lambda: rng.choice([None, True, -1, 1e308, "", "x" * 90, [], [[]], {}, {"a": 1}, [1] * 16, "pi/2", 2**70])  # noqa: E731
    ops = (
        "hello load open arm ik nearest save follow self_motions motion cloud voxels equations cancel report program "
        "program_file python clearance bodies catalog shown no "
    ).split()
    message = {"op": rng.choice(ops), "seq": rng.choice([seq, seq, seq, seq, -3, "1", None])}
    keys = (
        "T T0 T1 n start q table name text count which kind postures redundancy digits steps limits world "
        "program path target dialect step colour "
    ).split()
    for key in rng.sample(keys, 5):
        message[key] = junk()
    if rng.random() < 0.2:
        row = {"type": "R", "a": 0.1, "alpha": junk(), "d": 0, "theta": 0}
        message["table"] = {"convention": "standard", "joints": [row] * rng.choice([1, 3, 500])}
    text = json.dumps(message)
    way = rng.random()
    if way < 0.1:
        return text[: rng.randrange(len(text))]
    if way < 0.15:
        return bytes(rng.randrange(256) for _ in range(30))
    if way < 0.2:
        return text.replace("1", "NaN", 1)
    return text


def test_ten_thousand_random_messages_leave_it_standing(served, monkeypatch):
    from pieper.workbench import session

    monkeypatch.setattr(session, "RATE", 1e9)
    monkeypatch.setattr(session, "BURST", 1e9)
    monkeypatch.setattr(session, "PATIENCE", 10**9)
    monkeypatch.setattr(session, "MOST_WAITING", 10**9)
    port, app = served

    async def fuzz(seed: int, count: int) -> int:
        rng, faults = random.Random(seed), 0
        async with connect(port) as socket:
            await Page(socket).ask("arm", table=table_from_arm(pieper.load("three-r")))

            markers: asyncio.Queue[int] = asyncio.Queue()

            async def listen():
                nonlocal faults
                async for text in socket:
                    answer = json.loads(text)
                    faults += "fault of pieper" in str(answer.get("error"))
                    if (answer.get("seq") or 0) % 2 and answer["seq"] > 0:
                        markers.put_nowait(answer["seq"])

            ears = asyncio.create_task(listen())
            for k in range(count):
                await socket.send(random_message(rng, 2 * k + 10))
                # no page runs ahead of its answers: signs of life must not lie behind thousands of messages
                if k % 100 == 99:
                    await socket.send(json.dumps({"op": "hello", "seq": 2 * k + 11}))
                    assert await asyncio.wait_for(markers.get(), 120) == 2 * k + 11
            assert not ears.done(), "the connection was lost"
            ears.cancel()
        return faults

    async def story():
        faults = await asyncio.gather(*(fuzz(seed, 2_500) for seed in range(4)))
        async with connect(port) as socket:
            page = Page(socket)
            assert (await page.ask("hello"))["ok"]
        return faults

    assert sum(talk(story())) == 0
    assert nobody_left(app)


def test_fifty_people_at_ten_updates_a_second_each_see_only_their_own_arm(served):
    port, app = served
    names = ["denso-vp6242", "fanuc-r2000ic-165f", "abb-irb140", "unimation-puma-560", "kuka-kr5-arc"]
    arms = {name: pieper.load(name) for name in names}
    tables = {name: table_from_arm(arm) for name, arm in arms.items()}
    rounds = 20

    async def person(k: int) -> int:
        name, rng = names[k % len(names)], np.random.default_rng(k)
        arm, right = arms[name], 0
        async with connect(port) as socket:
            page = Page(socket)
            assert (await page.ask("arm", table=tables[name]))["ok"]
            began = time.perf_counter()
            for r in range(rounds):
                q = rng.uniform(-1, 1, arm.n)
                answer = await page.ask("ik", T=arm.fk(q).ravel().tolist(), q=q.tolist())
                found = np.array([row["q"] for row in answer["rows"]])
                miss = np.abs(np.angle(np.exp(1j * (found - q)))).max(1).min()
                right += bool(miss < 1e-6)
                await asyncio.sleep(max(0.0, began + 0.1 * (r + 1) - time.perf_counter()))
        return right

    async def everybody():
        return await asyncio.gather(*(person(k) for k in range(50)))

    assert sum(talk(everybody())) == 50 * rounds
    assert nobody_left(app), "closed pages free their sessions"


def test_a_closed_page_stops_its_long_work(served):
    port, app = served

    async def story():
        async with connect(port) as socket:
            page = Page(socket)
            await page.ask("arm", table=table_from_arm(pieper.load("denso-vp6242")))
            await socket.send(json.dumps({"op": "cloud", "seq": 50, "count": 200_000, "colour": "manipulability"}))
            assert json.loads(await socket.recv())["progress"]
        assert await asyncio.to_thread(nobody_left, app)

    talk(story())


def test_a_redundant_arm_answers_at_once_and_sends_its_self_motions_after(served):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    q = np.radians([15, 40, 10, -70, 20, 50, 30])
    asked = {"T": arm.fk(q).ravel().tolist(), "q": q.tolist()}

    async def story():
        async with connect(served[0]) as socket:
            page = Page(socket)
            await page.ask("arm", table=table_from_arm(arm))
            free = await page.ask("ik", **asked)
            assert free["self_motions"] is None and np.allclose(free["nearest"], q, atol=1e-9)
            assert [c["name"] for c in free["spare"]][:1] == ["joint_1"]
            held = await page.ask("ik", **asked, redundancy={"joint_1": 0.5})
            assert held["rows"] and all(row["q"][0] == pytest.approx(0.5, abs=1e-12) for row in held["rows"])
            motions = (await page.ask("self_motions", **asked))["self_motions"]
            assert motions and all(len(point) == 7 for motion in motions for point in motion["q"])
            # the elbow's angle follows from the pose alone: it is not anybody's to choose
            refused = await page.ask("ik", **asked, redundancy={"joint_4": 0.5})
            assert not refused["ok"] and "joint_4" in refused["error"]

    talk(story())


def test_long_work_can_be_cancelled(served):
    async def story():
        async with connect(served[0]) as socket:
            page = Page(socket)
            await page.ask("arm", table=table_from_arm(pieper.load("denso-vp6242")))
            await socket.send(json.dumps({"op": "cloud", "seq": 50, "count": 200_000, "colour": "manipulability"}))
            assert json.loads(await socket.recv())["progress"]
            await socket.send(json.dumps({"op": "cancel", "seq": 51, "kind": "cloud"}))
            last = {}
            while last.get("seq") != 50 or last.get("progress"):
                last = json.loads(await socket.recv())
            assert last["stopped"]

    talk(story())


def test_an_arm_with_coupled_joints_is_taken_and_solved(served, tmp_path):
    plain = pieper.load("denso-vp6242").description
    C = np.eye(6)
    C[2, 1] = 1.0
    arm = pieper.Arm(dataclasses.replace(plain, name="coupled-arm", coupling=C))
    room.create_app(start=arm)
    arm.save(tmp_path / "coupled.toml")
    text = (tmp_path / "coupled.toml").read_text()
    q = np.radians([20, 60, -150, 10, 40, 25])

    async def story():
        async with connect(served[0]) as socket:
            page = Page(socket)
            opened = await page.ask("open", text=text, name="coupled.toml")
            await page.ask("arm", table=opened["table"])
            return opened["table"], await page.ask("ik", T=arm.fk(q).ravel().tolist())

    table, answer = talk(story())
    assert table["coupling"] == C.tolist()
    rows = np.array([row["q"] for row in answer["rows"]])
    assert np.allclose(arm.fk(rows), arm.fk(q), atol=1e-9)
