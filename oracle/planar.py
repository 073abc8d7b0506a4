"""What a planar arm of three turning joints reaches along a path, by the plane's own formulas."""

import numpy as np

from oracle.joints import around


def rows(point, heading, links, limits):
    """Return for each elbow (k, 3) joints and (k,) whether they are inside, at a point with headings (k,)."""
    a, b, c = links
    x, y = (np.asarray(point)[:, None] - c * np.stack([np.cos(heading), np.sin(heading)])).reshape(2, -1)
    cosine = (x * x + y * y - a * a - b * b) / (2 * a * b)
    out = []
    for sense in (1, -1):
        q2 = sense * np.arccos(np.clip(cosine, -1, 1))
        q1 = np.arctan2(y, x) - np.arctan2(b * np.sin(q2), a + b * np.cos(q2))
        q = around(np.stack([q1, q2, heading - q1 - q2], -1))
        out.append((q, (np.abs(cosine) <= 1) & ((q >= limits[:, 0]) & (q <= limits[:, 1])).all(1)))
    return out


def reached(points, links, limits, headings=2401, step=0.3, beside=0.15):
    """Return the last of points (N, 2) that is reached, -1 for none; limits (3, 2) within half a turn."""
    heading = np.arange(headings) * 2 * np.pi / headings
    now, before = np.zeros((2, headings), bool), None
    for i, point in enumerate(points):
        here = rows(point, heading, links, limits)
        ok = np.array([inside for _, inside in here])
        if before is None:
            now = ok.copy()
        else:
            near = [np.abs(q - b).max(1) < step for (q, _), (b, _) in zip(here, before, strict=True)]
            now &= ok & np.array(near)
        if not now.any():
            return i - 1
        linked = np.array([np.abs(q - np.roll(q, 1, 0)).max(1) < beside for q, _ in here])
        straight = ok[0] & ok[1] & (np.abs(here[0][0] - here[1][0]).max(1) < beside)
        count = -1
        while now.sum() != count:
            count = now.sum()
            now |= ok & np.roll(now, 1, 1) & linked
            now |= ok & np.roll(now & linked, -1, 1)
            now |= straight & now.any(0)
        before = here
    return len(points) - 1
