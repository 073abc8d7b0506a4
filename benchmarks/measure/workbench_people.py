"""Many people at one workbench: fifty sessions with programs at once, and ten thousand messages, whole and broken.

Every message must be answered once, by words where it is refused, and what comes back must be for the arm of the
session that asked: each answer is put through that arm's own forward kinematics.
"""

from __future__ import annotations

import asyncio
import collections
import contextlib
import json
import random
import statistics
import time
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from oracle.page_messages import broken, wholes

ARMS = ("denso-vp6242", "fanuc-r2000ic-165f", "abb-irb140", "unimation-puma-560", "kuka-kr5-arc")
#: Tables of fewer and of more joints, which a fuzz sends as well.
ODD_ARMS = ("dfrobot-rob0036", "franka-panda", "stanford-arm")
#: Metres and radians by which an answer may miss what was asked for: an answer for another arm is off by far more.
MISSED = 1e-6
#: Messages a second of one session of the fuzz; the server takes 200.
PACE = 150
#: Messages of one session of the fuzz that are on their way at once, at most.
ON_THE_WAY = 64
#: Seconds to wait for the last answers.
LAST = 120
#: How often each kind of message is sent in a fuzz, beside the others.
WEIGHTS = {
    "report": 0.001,
    "film": 0.01,
    "cures": 0.02,
    "route_others": 0.05,
    "route_program": 0.1,
    "equations": 0.1,
    "program": 0.1,
    "voxels": 0.2,
    "cloud": 0.2,
    "formulas": 0.2,
    "self_motions": 0.2,
    "python": 0.3,
    "program_file": 0.3,
    "nearest": 0.5,
    "route": 0.5,
}


def spread(values: list[float]) -> dict[str, float]:
    """Return the median, the best and the 95th percentile."""
    ordered = sorted(values)
    return {
        "median": statistics.median(ordered),
        "best": ordered[0],
        "p95": ordered[min(int(0.95 * len(ordered)), len(ordered) - 1)],
        "n": len(ordered),
    }


def connect(port: int) -> Any:
    """Return a connection to a session, as a page of that server opens it."""
    from websockets.asyncio.client import connect as opened
    from websockets.typing import Origin

    url, origin = f"ws://localhost:{port}/session", f"http://localhost:{port}"
    return opened(url, origin=Origin(origin), open_timeout=60, max_size=None, ping_interval=None)


class Asked:
    """One session: what it sent, and every answer by the number of its message."""

    def __init__(self, socket: Any) -> None:
        self.socket = socket
        self.seq = 0
        self.sent: dict[int, tuple[dict[str, Any], float]] = {}
        self.answers: dict[int, list[tuple[dict[str, Any], float]]] = {}
        self.unnumbered = 0
        self._came = asyncio.Event()
        self._ears = asyncio.create_task(self._listen())

    async def _listen(self) -> None:
        from websockets.exceptions import ConnectionClosed

        with contextlib.suppress(ConnectionClosed):
            async for text in self.socket:
                answer = json.loads(text)
                if answer.get("progress"):
                    continue
                if answer.get("seq") is None:
                    self.unnumbered += 1
                else:
                    self.answers.setdefault(answer["seq"], []).append((answer, time.perf_counter()))
                self._came.set()
        self._came.set()

    async def say(self, op: str, message: dict[str, Any]) -> int:
        """Send a message and return its number."""
        self.seq += 1
        whole = {"op": op, **message, "seq": self.seq}
        self.sent[self.seq] = (whole, time.perf_counter())
        await self.socket.send(json.dumps(whole))
        return self.seq

    async def answer(self, seq: int, patience: float = LAST) -> dict[str, Any] | None:
        """Return the answer of a message, or None where none came."""
        end = time.monotonic() + patience
        while seq not in self.answers and (left := end - time.monotonic()) > 0 and not self._ears.done():
            self._came.clear()
            try:
                await asyncio.wait_for(self._came.wait(), left)
            except TimeoutError:
                break
        return self.answers[seq][0][0] if seq in self.answers else None

    def took(self, seq: int) -> float:
        """Return the milliseconds from a message to its answer."""
        return 1e3 * (self.answers[seq][0][1] - self.sent[seq][1])

    @property
    def alive(self) -> bool:
        """Whether the connection is still there."""
        return not self._ears.done()


def _posture(arm: pieper.Arm, rng: np.random.Generator) -> npt.NDArray[np.float64]:
    """Return a posture well inside the limits, near zero where they allow it."""
    lower, upper = np.clip(arm.limits.T, -2 * np.pi, 2 * np.pi)
    width = upper - lower
    middle = np.clip(0.3, lower + 0.3 * width, upper - 0.3 * width)
    return middle + rng.uniform(-1, 1, arm.n) * np.minimum(0.2 * width, 0.6)


def _apart(T: npt.ArrayLike, wanted: npt.ArrayLike) -> float:
    return float(np.abs(np.reshape(T, (-1, 16)) - np.reshape(wanted, (-1, 16))).max(initial=0))


def taught(arm: pieper.Arm, rng: np.random.Generator) -> tuple[dict[str, Any], npt.NDArray[np.float64]]:
    """Return a program of joint moves, lines, a gripper and a wait, and the pose where it ends."""
    q = _posture(arm, rng)
    other = _posture(arm, rng)
    over, end = arm.fk(other), arm.fk(other)
    over[2, 3] += 0.02
    end[0, 3] -= 0.01
    steps = [
        {"kind": "joint", "q": other.tolist(), "blend": 0.005},
        {"kind": "line", "T": over.ravel().tolist(), "blend": 0.003},
        {"kind": "gripper", "value": 1.0},
        {"kind": "wait", "seconds": 0.2},
        {"kind": "joint", "q": (other + 0.02).tolist()},
        {"kind": "joint", "q": other.tolist()},
        {"kind": "line", "T": end.ravel().tolist()},
    ]
    limits = {"speed": [1.5] * arm.n, "acceleration": 4, "jerk": None, "tool_speed": 0.3}
    return {"steps": steps, "start": q.tolist(), "limits": limits, "rate": 100, "world": []}, end


async def _person(port: int, k: int, updates: int, programs: int) -> dict[str, Any]:
    """One person: a target dragged at ten updates a second, and programs planned meanwhile, one after the other."""
    from pieper.workbench.table import table_from_arm

    arm, rng = pieper.load(ARMS[k % len(ARMS)]), np.random.default_rng(k)
    found: dict[str, Any] = {"lost": 0, "foreign": 0, "late": 0, "ms": [], "program_ms": [], "failed": []}
    async with connect(port) as socket:
        page = Asked(socket)
        await page.answer(await page.say("arm", {"table": table_from_arm(arm)}))
        await asyncio.sleep(rng.uniform(0, 0.1))

        async def drag() -> None:
            began = time.perf_counter()
            for r in range(updates):
                q = rng.uniform(-1, 1, arm.n)
                ask = {"T": arm.fk(q).ravel().tolist(), "q": q.tolist(), "brief": True}
                seq = await page.say("ik", ask)
                answer = await page.answer(seq)
                if answer is None or not answer["ok"]:
                    found["lost"] += 1
                    continue
                found["ms"].append(page.took(seq))
                rows = np.array([row["q"] for row in answer["rows"]]).reshape(-1, arm.n)
                miss = np.abs(np.angle(np.exp(1j * (rows - q)))).max(1).min(initial=np.inf)
                found["foreign"] += bool(miss > MISSED)
                due = began + 0.1 * (r + 1)
                found["late"] += time.perf_counter() > due
                await asyncio.sleep(max(0.0, due - time.perf_counter()))

        async def plan() -> None:
            for _ in range(programs):
                message, end = taught(arm, rng)
                seq = await page.say("program", message)
                answer = await page.answer(seq)
                if answer is None:
                    found["lost"] += 1
                    continue
                if not answer["ok"]:
                    found["failed"].append(answer["error"])
                    continue
                found["program_ms"].append(page.took(seq))
                if answer["failed"]:
                    found["failed"].append(answer["failed"]["text"])
                    continue
                q = np.array(answer["q"])
                ends = np.abs(q[0] - message["start"]).max()
                found["foreign"] += bool(ends > MISSED or _apart(arm.fk(q[-1]), end) > MISSED)

        await asyncio.gather(drag(), plan())
    return found


def measure_people(port: int, updates: int, programs: int, sessions: int = 50) -> dict[str, Any]:
    """Return what fifty sessions at ten updates a second each, and planning programs meanwhile, got."""

    async def all_of_them() -> list[dict[str, Any]]:
        return await asyncio.gather(*(_person(port, k, updates, programs) for k in range(sessions)))

    found = asyncio.run(all_of_them())
    out: dict[str, Any] = {
        "sessions": sessions,
        "messages": sessions * (updates + programs),
        "programs": sum(len(f["program_ms"]) for f in found),
        "lines_that_stop": sum(len(f["failed"]) for f in found),
        "lost": sum(f["lost"] for f in found),
        "foreign": sum(f["foreign"] for f in found),
        "latency_ms": spread([ms for f in found for ms in f["ms"]]),
        "late": sum(f["late"] for f in found),
    }
    if programs:
        out["program_ms"] = spread([ms for f in found for ms in f["program_ms"]])
    return out


async def _fuzzer(port: int, seed: int, count: int) -> dict[str, Any]:
    """One session that sends whole and broken messages of every kind about arms that change meanwhile."""
    from pieper.workbench.table import table_from_arm

    rng, numbers = random.Random(seed), np.random.default_rng(seed)
    names = [*ARMS, *ODD_ARMS]
    arms = {name: pieper.load(name) for name in names}
    tables = {name: table_from_arm(arm) for name, arm in arms.items()}
    kinds: collections.Counter[str] = collections.Counter()
    shown: dict[int, str] = {}
    async with connect(port) as socket:
        page = Asked(socket)
        name, began = names[seed % len(names)], time.perf_counter()
        shown[await page.say("arm", {"table": tables[name]})] = name
        unread = 0
        while page.seq + unread < count:
            await asyncio.sleep(max(0.0, began + (page.seq + unread) / PACE - time.perf_counter()))
            while page.alive and page.seq - len(page.answers) >= ON_THE_WAY:
                await asyncio.sleep(0.01)
            if not page.alive:
                break
            arm, way = arms[name], rng.random()
            q = _posture(arm, numbers)
            there = arm.fk(q)
            there[0, 3] += 0.004
            all_kinds = {**wholes(q, arm.fk(q), there), "arm": {"table": tables[name]}}
            op = rng.choices(list(all_kinds), [WEIGHTS.get(k, 1) for k in all_kinds])[0]
            kinds[op] += 1
            if way < 0.05:
                text = json.dumps({"op": op, **all_kinds[op]})
                await socket.send(text[: rng.randrange(len(text))] if way < 0.03 else rng.randbytes(40))
                unread += 1
                continue
            message = all_kinds[op] if way < 0.45 else broken(all_kinds[op], rng)
            if op == "arm":
                # a broken table that is taken all the same would be another arm: only whole ones are sent
                name = rng.choice(names)
                message = {"table": tables[name] if way < 0.45 else None}
            seq = await page.say(op, message)
            if op == "arm" and way < 0.45:
                shown[seq] = name
        end = time.monotonic() + LAST
        while time.monotonic() < end and page.alive:
            if len(page.answers) == page.seq and page.unnumbered >= unread:
                break
            await asyncio.sleep(0.05)
        alive = page.alive
    return {**_judged(page, arms, shown), "unread": unread - page.unnumbered, "alive": alive, "kinds": dict(kinds)}


def _judged(page: Asked, arms: dict[str, pieper.Arm], shown: dict[int, str]) -> dict[str, Any]:
    """Return what was not answered once, what was a fault, and what was answered for another arm."""
    faults, refused, foreign, judged, arm = [], 0, [], 0, None
    for seq, (message, _) in sorted(page.sent.items()):
        arm = arms[shown[seq]] if seq in shown else arm
        for answer, _ in page.answers.get(seq, [])[:1]:
            said = str(answer.get("error", ""))
            refused += not answer["ok"]
            if "fault of pieper" in said or (not answer["ok"] and not said.strip()):
                faults.append(f"{message['op']}: {said[:300]}")
            miss = None if arm is None or not answer["ok"] else _missed(arm, message, answer)
            judged += miss is not None
            if arm is not None and miss is not None and not miss <= MISSED:
                foreign.append(f"{arm.name}, {message['op']}, off by {miss}")
    counts = [len(page.answers.get(seq, [])) for seq in page.sent]
    return {
        "messages": len(page.sent),
        "lost": counts.count(0),
        # what came after the first one may only have waited behind it
        "first_lost": [str(page.sent[s][0])[:2000] for s in page.sent if s not in page.answers][:1],
        "twice": sum(c > 1 for c in counts),
        "refused": refused,
        "faults": faults,
        "judged": judged,
        "foreign": foreign,
    }


def _missed(arm: pieper.Arm, message: dict[str, Any], answer: dict[str, Any]) -> float | None:
    """Return by how much an answer misses its question on the arm it should be for; None where that is not asked."""
    op = message["op"]
    if answer.get("stopped"):
        return None
    if op == "ik" and answer["rows"] and not message.get("task") and "missed" not in answer:
        return _apart(arm.fk(np.array([row["q"] for row in answer["rows"]])), [message["T"]] * len(answer["rows"]))
    if op == "nearest":
        return _apart(arm.fk(np.array(answer["q"])), answer["T"])
    if op == "follow" and answer["q"]:
        return _apart(arm.fk(np.array(answer["q"])), answer["path"][: len(answer["q"])])
    if op in ("program", "motion") and answer["q"]:
        # a leg of no time at all has left its first posture at once, so that the last one is looked at
        q, at, wanted = (
            np.array(answer["q"]),
            *((0, message["start"]) if op == "program" else (-1, message["postures"][-1])),
        )
        return float(np.abs(q[at] - wanted).max()) if q.shape[1] == arm.n else np.inf
    return None


def measure_fuzz(port: int, count: int, sessions: int = 8) -> dict[str, Any]:
    """Return what became of so many messages over several sessions at once."""

    async def all_of_them() -> list[dict[str, Any]]:
        return await asyncio.gather(*(_fuzzer(port, k, -(-count // sessions)) for k in range(sessions)))

    found = asyncio.run(all_of_them())
    kinds: collections.Counter[str] = collections.Counter()
    for f in found:
        kinds.update(f["kinds"])
    summed = ("messages", "lost", "twice", "refused", "judged", "unread")
    return {
        "sessions": sessions,
        **{key: sum(f[key] for f in found) for key in summed},
        "not_json_or_binary": -(-count // sessions) * sessions - sum(f["messages"] for f in found),
        "first_lost": [x for f in found for x in f["first_lost"]],
        "connections_lost": sum(not f["alive"] for f in found),
        "faults": [x for f in found for x in f["faults"]],
        "foreign": [x for f in found for x in f["foreign"]],
        "kinds": dict(sorted(kinds.items())),
    }
