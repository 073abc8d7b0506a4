"""Programs kept in files, splines, circles about a centre, frames and calls."""

import numpy as np
import pytest

import pieper
from pieper.errors import InputError
from pieper.kinematics.pose import pose_error
from pieper.motion.spline import spline

ARM = pieper.load("denso-vp6242")
HOME = np.radians([0, 51.492738, -150.638208, 0, 99.14547, 0])
LIMITS = pieper.Limits(speed=3.0, acceleration=[20.0] * 6, tool_speed=0.4, turn_speed=3.0)
T0 = ARM.fk(HOME)


def shifted(x=0.0, y=0.0, z=0.0, roll=0.0):
    T = T0.copy()
    T[:3, 3] += [x, y, z]
    T[:3, :3] = pieper.pose(0, 0, 0, rpy=(roll, 0, 0))[:3, :3] @ T[:3, :3]
    return T


TAUGHT = np.array([shifted(-0.05, 0.02, 0.03, 0.1), shifted(-0.06, -0.05, 0.02, -0.1), shifted(-0.02, 0.05, -0.03)])


def program():
    return pieper.Program(ARM, LIMITS, start=HOME)


def whole():
    p = program().move_l(shifted(y=0.08), speed=0.1, blend=0.01).move_c(shifted(-0.05, 0.04), shifted(-0.08)).wait(0.2)
    return p.move_s(TAUGHT, speed=0.15).gripper(0.5).move_j(HOME, speed=0.5).output(2, True)


def test_a_program_comes_back_from_its_file(tmp_path):
    p = whole()
    file = pieper.save_program(p, tmp_path / "p.toml")
    again = pieper.load_program(ARM, file)
    assert again.limits.tool_speed == pytest.approx(0.4) and again.limits.turn_speed == pytest.approx(3.0)
    assert [type(i) for i in again.instructions] == [type(i) for i in p.instructions]
    a, b = p.motion(rate=100), again.motion(rate=100)
    assert a.duration == pytest.approx(b.duration, rel=1e-9) and np.abs(a.between(b.t) - b.q).max() < 1e-6
    assert [e[1:] for e in a.events] == [e[1:] for e in b.events]
    pieper.save_program(again, tmp_path / "q.toml")
    assert (tmp_path / "q.toml").read_text() == file.read_text()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[limits", "cannot read"),
        ('arm = "denso-vp6242"', r"no \[limits\]"),
        ('arm = "ur5e"\n[limits]\nspeed = 1\nacceleration = 1', "a program of ur5e"),
        ("[limits]\nspeed = 1\nacceleration = 1\nsped = 3", "'sped' is no limit"),
        ("speed = 1", "'speed' is no field of a program"),
        ("{L}[[step]]\nmove_q = [1]", "step 1: say one of"),
        ("{L}[[step]]\nwait = 1\nmove_l = [1]", "step 1: say one of"),
        ("{L}[[step]]\nwait = 1\nspeed = 3", "'speed' is no field beside wait"),
        ("{L}[[step]]\nmove_j = [1, 2]", "step 1: move_j must be 6 numbers"),
        ("{L}[[step]]\nwait = 1\n[[step]]\nmove_l = [1, 2, 3]", r"step 2: move_l .* must be 6 numbers"),
        ("{L}[[step]]\nmove_l = [350, 0, nan, 0, 0, 0]", "must be 6 numbers"),
        ("{L}[[step]]\nmove_l = [9350, 0, 400, 0, 0, 0]", "step 1: move 1 cannot be followed"),
        ("{L}[[step]]\nmove_c = [350, 0, 300, 0, 0, 0]", "needs via"),
        ('{L}[[step]]\nmove_s = "x"', "a list of poses"),
        (
            '{L}[[step]]\nmove_l = [350, 50, 400, 0, 0, 0]\nspeed = "fast"',
            "speed must be a finite number above 0, mm/s",
        ),
        ("{L}[[step]]\noutput = 3", "output is"),
        ("{L}[[step]]\nwait = -1", "step 1: wait must be"),
    ],
)
def test_a_file_that_is_none_is_answered_by_file_and_step(tmp_path, text, words):
    file = tmp_path / "p.toml"
    start = f"start = {np.degrees(HOME).tolist()}\n"
    file.write_text(text.replace("{L}", start + "[limits]\nspeed = 180\nacceleration = 600\n"))
    with pytest.raises(pieper.PieperError, match=words):
        pieper.load_program(ARM, file)


def test_a_spline_goes_through_its_poses_without_a_corner():
    T = spline(T0, TAUGHT, np.linspace(0, 1, 4001))
    for taught in (T0, *TAUGHT):
        assert pose_error(T, np.broadcast_to(taught, T.shape)).sum(1).min() < 1e-3
    exact = spline(T0, TAUGHT, np.array([0.0, 1.0]))
    assert np.array_equal(exact[0], T0) and np.array_equal(exact[1], TAUGHT[-1])
    # no corner: second differences shrink with the square of the step
    worst = [np.abs(np.diff(T[::k, :3], 2, axis=0)).max() for k in (1, 4)]
    assert worst[0] < worst[1] / 12
    assert np.abs(np.linalg.det(T[:, :3, :3]) - 1).max() < 1e-12


def test_a_spline_is_followed_and_a_turned_world_changes_nothing():
    motion = program().move_s(TAUGHT).motion(rate=400)
    for taught in TAUGHT:
        assert pose_error(ARM.fk(motion.q), np.broadcast_to(taught, (len(motion.q), 4, 4))).sum(1).min() < 1e-2
    W = pieper.pose(0.3, -0.2, 0.1, rpy=(0.4, 1.1, -2.0))
    s = np.linspace(0, 1, 50)
    assert np.abs(spline(W @ T0, W @ TAUGHT, s) - W @ spline(T0, TAUGHT, s)).max() < 1e-12


def test_splines_that_are_none_are_refused():
    with pytest.raises(InputError, match="at least 2"):
        program().move_s(TAUGHT[:1])
    with pytest.raises(InputError, match="the pose the arm is in and pose 1"):
        program().move_s(np.array([T0, TAUGHT[0]]))
    with pytest.raises(InputError, match="pose 1 and pose 2"):
        program().move_s(TAUGHT[[0, 0, 1]])


def test_a_spline_is_not_written_as_a_line(tmp_path):
    with pytest.raises(InputError, match="is a spline"):
        program().move_s(TAUGHT).write(tmp_path / "p.pcs")
    assert not list(tmp_path.iterdir())
    program().move_s(TAUGHT).write(tmp_path / "p.csv")
    motion = pieper.read_motion(tmp_path / "p.csv", ARM)
    assert np.abs(ARM.fk(motion.q[-1]) - TAUGHT[-1]).max() < 1e-6


def test_a_spline_is_named_as_the_program_counts_and_not_as_a_file_does_that_cuts_circles(tmp_path):
    round_ = program().move_c(None, shifted(x=-0.08), centre=T0[:3, 3] + [-0.04, 0.03, 0], the_long_way=True)
    round_.move_s(TAUGHT + (shifted(x=-0.08) - T0))
    with pytest.raises(InputError, match="^move 2 is a spline") as refused:
        round_.write(tmp_path / "p.pcs")
    assert refused.value.data["move"] == 2


def test_a_circle_is_said_by_its_centre():
    centre, goal = T0[:3, 3] + [-0.04, 0.03, 0], shifted(x=-0.08)
    for long, side in ((False, -1), (True, 1)):
        motion = program().move_c(None, goal, centre=centre, the_long_way=long).motion(rate=200)
        off = ARM.fk(motion.q)[:, :3, 3] - centre
        assert np.abs(np.linalg.norm(off, axis=1) - 0.05).max() < 2e-5
        assert np.abs(ARM.fk(motion.q[-1]) - goal).max() < 1e-6
        assert off[np.argmax(np.abs(off[:, 1])), 1] * side > 0.03
    for words, how in (
        ("a via or a centre", dict()),
        ("as far from both", dict(centre=centre + [0.01, 0, 0])),
        ("in line", dict(centre=T0[:3, 3] + [-0.04, 0, 0])),
        ("a point", dict(centre=[1, 2])),
    ):
        with pytest.raises(InputError, match=words):
            program().move_c(None, goal, **how)
    with pytest.raises(InputError, match="a via or a centre"):
        program().move_c(shifted(-0.04, 0.04), goal, centre=centre)


def test_targets_stand_in_the_frame_that_was_said():
    W = pieper.pose(0.1, 0.2, -0.05, rpy=(0.1, -0.2, 0.7))
    local = np.linalg.inv(W) @ TAUGHT
    p = program().frame(W).move_l(local[0]).move_s(local[1:]).frame(np.eye(4)).move_l(T0).motion(rate=50)
    plain = program().move_l(TAUGHT[0]).move_s(TAUGHT[1:]).move_l(T0).motion(rate=50)
    assert np.abs(p.between(plain.t) - plain.q).max() < 1e-6


def test_a_called_program_runs_as_often_as_was_said():
    part = program().move_l(shifted(z=-0.04)).gripper(1.0).move_l(T0)
    twice = program().call(part, times=2)
    assert len(twice.moves) == 4 and len(part.moves) == 2
    assert twice.motion().duration == pytest.approx(2 * part.motion().duration, rel=1e-6)
    assert repr(twice) == "<Program of denso-vp6242: 6 instructions>"
    assert len(part.call(part).moves) == 4
    other = pieper.Program(pieper.load("dfrobot-rob0036"), pieper.Limits(speed=1, acceleration=1))
    with pytest.raises(InputError, match="cannot be called"):
        twice.call(other)
    with pytest.raises(InputError, match="whole number"):
        twice.call(part, times=0)


def test_a_wait_rests_at_every_sample():
    motion = program().move_l(shifted(z=-0.04)).wait(0.5).move_l(T0).motion(rate=100)
    begin = next(t for t, kind, _ in motion.events if kind == "wait")
    resting = (motion.t > begin + 0.011) & (motion.t < begin + 0.49)
    assert resting.sum() > 40 and not motion.dq[resting].any() and not motion.ddq[resting].any()


def test_a_motion_comes_back_from_table_and_trajectory(tmp_path):
    p = program().move_l(shifted(y=0.05)).wait(0.1).move_j(HOME)
    motion = p.motion(rate=100)
    for name in ("m.csv", "m.yaml"):
        p.write(tmp_path / name)
        read = pieper.read_motion(tmp_path / name, ARM)
        assert np.abs(read.q - motion.q).max() < 1e-8 and np.abs(read.dq - motion.dq).max() < 1e-7
        assert np.abs(read.t - motion.t).max() < 1e-8
    (tmp_path / "bad.csv").write_text("q1_deg,q2_deg\n1,2\n")
    for name, words in (("m.txt", "a .csv or a .yaml"), ("bad.csv", "the first column must be t_s")):
        with pytest.raises(InputError, match=words):
            pieper.read_motion(tmp_path / name, ARM)


def test_the_limits_of_a_motion_are_drawn():
    figure = pieper.plot.limits_figure(whole().motion(rate=100))
    assert [axes.get_ylabel() for axes in figure.axes[:2]] == ["speed, %", "acceleration, %"]
    for axes in figure.axes[:2]:
        for line in axes.lines:
            assert np.abs(line.get_ydata()).max() <= 100 + 1e-6
    assert "tool speed" in [t.get_text() for t in figure.axes[-1].get_yticklabels()]
    with pytest.raises(InputError, match="not made within limits"):
        pieper.plot.limits_figure(pieper.move(HOME, HOME + 0.1, 1.0))


def test_what_binds_has_the_colour_of_its_joint():
    from matplotlib.colors import to_rgba

    motion = whole().motion(rate=100)
    figure = pieper.plot.limits_figure(motion)
    curves = {line.get_label(): to_rgba(line.get_color()) for line in figure.axes[0].lines}
    strip = figure.axes[-1]
    rows = [t.get_text() for t in strip.get_yticklabels()]
    assert len(rows) == len(strip.collections) > 1
    for words, bars in zip(rows, strip.collections, strict=True):
        if " of " in words:
            np.testing.assert_allclose(bars.get_facecolor()[0], curves[words.split(" of ")[1]])
        # a limit that binds on and on is one bar, also where a motion names another at times
        spans = sorted((v[:, 0].min(), v[:, 0].max()) for v in (path.vertices for path in bars.get_paths()))
        assert all(b[0] > a[1] for a, b in zip(spans, spans[1:], strict=False))
