"""One adapter a contestant; worker.py runs it in the contestant's own environment, where only NumPy is sure."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Case:
    """What a contestant is given: an arm's name and table, and whether its geometry is a general one."""

    arm: str
    table: np.ndarray  # (6, 3): d, a, m; alpha, rad
    general: bool


class Pieper:
    """This package."""

    batch_threads = (1, 2)

    def __init__(self, case: Case):
        import pieper

        rows = [pieper.DH(a=a, alpha=alpha, d=d, theta=0) for d, a, alpha in case.table.tolist()]
        self.arm = pieper.Arm.from_dh(rows, convention="standard")
        self.arm.ik(self.arm.fk(np.zeros(6)))  # the plan is made on first use

    def single(self, T):
        return self.arm.ik(T)

    def rows(self, answer):
        return answer.all_q

    def batch(self, T, threads):
        return lambda: self.arm.ik_many(T, threads=threads)

    def batch_into(self, T, threads):
        out = self.arm.ik_many(T, threads=threads)
        return lambda: self.arm.ik_many(T, threads=threads, out=out)

    def fk(self, q):
        return lambda: self.arm.fk(q)

    def jacobian(self, q):
        return lambda: self.arm.jacobian(q)


class Eaik:
    """EAIK (Ostermeier et al., 2024)."""

    batch_threads = (1, 2)

    def __init__(self, case: Case):
        from eaik.IK_DH import DhRobot  # pyright: ignore[reportMissingImports]

        d, a, alpha = np.ascontiguousarray(case.table.T)
        self.arm = DhRobot(alpha, a, d)
        if not self.arm.hasKnownDecomposition():
            raise NotImplementedError(self.arm.getKinematicFamily())

    def single(self, T):
        return self.arm.IK(T)

    def rows(self, answer):
        return np.asarray(answer.Q, float).reshape(-1, 6)[~np.asarray(answer.is_LS, bool).reshape(-1)]

    def batch(self, T, threads):
        poses = [np.ascontiguousarray(t) for t in T]
        return lambda: self.arm.IK_batched(poses, threads)


class Ssik:
    """ssik; its arms are made from the table, as ours are."""

    batch_threads = ()
    few = 200  # poses: it takes a hundred times as long

    def __init__(self, case: Case):
        from ssik import Manipulator  # pyright: ignore[reportMissingImports]

        if case.general:
            raise NotImplementedError("minutes to make an arm of no special geometry")
        d, a, alpha = np.ascontiguousarray(case.table.T)
        self.arm = Manipulator.from_dh(alpha, a, d)

    def single(self, T):
        return self.arm.solve(T)

    def rows(self, answer):
        return np.array([row.q for row in answer], float).reshape(-1, 6)


class Crx:
    """crx-kinematics, for Fanuc's CRX arms only; in its own joints (the controller's) and poses (millimetres)."""

    batch_threads = ()

    def __init__(self, case: Case):
        if case.arm != "fanuc-crx-10ia":
            raise NotImplementedError("Fanuc CRX arms only")
        from crx_kinematics import Crx as Arm  # pyright: ignore[reportMissingImports]

        self.arm = Arm.crx10ia()

    def poses(self, count):
        """Return joint vectors (count, 6), rad, and their poses (count, 4, 4) as it writes them."""
        q = np.random.default_rng(3).uniform(-np.pi, np.pi, (count, 6))
        return q, np.array([self.arm.fk(row) for row in np.degrees(q)])

    def single(self, T):
        return self.arm.ik(T)

    def rows(self, answer):
        return np.radians(np.array([list(row) for row in answer], float).reshape(-1, 6))


CONTESTANTS = {"pieper": Pieper, "pieper-baseline": Pieper, "eaik": Eaik, "ssik": Ssik, "crx-kinematics": Crx}
#: What a contestant is told by its environment: ours once more, without the wide registers.
SETTINGS = {"pieper-baseline": {"PIEPER_ISA": "baseline"}}
#: What to install for each peer.
PACKAGES = {"eaik": "eaik", "ssik": "ssik", "crx-kinematics": "crx-kinematics"}
