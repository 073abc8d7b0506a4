"""Which side an arm is on: how far it reaches forward of its first axis, and to which side its elbows bend.

These signs name branches as people do, front and rear, elbow up and down, and bound the regions in which a formula with
one root or one atan2 holds.
"""

from __future__ import annotations

import numpy as np

from pieper.judge.model import ArmModel
from pieper.judge.samples import Samples
from pieper.tolerances import JUDGED_ZERO

Feature = tuple[str, np.ndarray]
FORWARD = "cos(theta1) "  # how the words begin that say how far an arm reaches forward


def arm_features(model: ArmModel, samples: Samples) -> list[Feature]:
    """The signs of an arm's sides at every sample, (words, value (K,)).

    Args:
        model: The arm.
        samples: Where it stands.
    """
    env, n = samples.env, model.n
    frames = [np.broadcast_to(np.eye(4), samples.frames["T"].shape)]
    for joint in range(1, n + 1):
        frames.append(frames[-1] @ samples.frames[f"A{joint}"])
    ends = {k: frames[k][:, :3, 3] for k in (n - 1, n) if k > 1}
    out: list[Feature] = []
    if not model.sliding(1):
        c, s = np.cos(env["theta1"]), np.sin(env["theta1"])
        out.append((FORWARD + "px + sin(theta1) py", c * env["px"] + s * env["py"]))
        for k, p in ends.items():
            out.append((f"{FORWARD}P0{k}[1] + sin(theta1) P0{k}[2]", c * p[:, 0] + s * p[:, 1]))
    own = model.axis_frames(samples.frames, env)
    axes = [before @ axis for before, axis in zip(frames, own, strict=False)]
    for joint in range(2, n):
        z, o = axes[joint - 1][:, :3, 2], axes[joint - 1][:, :3, 3]
        before = axes[joint - 2]
        parallel = np.abs(np.abs((z * before[:, :3, 2]).sum(1)) - 1).max() < JUDGED_ZERO
        if model.sliding(joint) or model.sliding(joint - 1) or not parallel:
            continue
        for k, p in ends.items():
            if k >= joint:
                bend = (z * np.cross(o - before[:, :3, 3], p - o)).sum(1)
                words = (
                    f"the elbow's bend (about axis {joint}, from the line from axis {joint - 1} to the line to P0{k})"
                )
                out.append((words, bend))
    floor = JUDGED_ZERO * max(1.0, model.length())
    return [(words, value) for words, value in out if np.abs(value).min() > 0 and np.abs(value).max() > floor]
