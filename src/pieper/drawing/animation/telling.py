"""What a picture says about a moment: the gripper, outputs that are on, whether the arm waits."""

from __future__ import annotations

from pieper.drawing.animation.moving import Moving


def happenings(motion: Moving, time: float) -> str:
    """Return the state at a time, s, as a few words; empty where nothing was ever told."""
    gripper: object = None
    outputs: dict[object, bool] = {}
    waiting = False
    for when, kind, value in motion.events:
        if when > time:
            break
        if kind == "gripper":
            gripper = value
        elif kind == "output" and isinstance(value, tuple):
            outputs[value[0]] = bool(value[1])
        elif kind == "wait" and isinstance(value, (int, float)):
            waiting = time < when + value
    words = [] if gripper is None else [f"gripper {_share(gripper)}"]
    words += [f"output {port} on" for port, on in outputs.items() if on]
    return ", ".join([*words, "waiting"] if waiting else words)


def _share(value: object) -> str:
    number = float(value) if isinstance(value, (int, float)) else 0.0
    return "open" if number == 0 else "closed" if number == 1 else f"{100 * number:z.0f} % closed"
