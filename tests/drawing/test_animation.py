"""Moving pictures: as long as the motion, the arm where forward kinematics says, and every bad input answered."""

import json
import re

import numpy as np
import pytest
from PIL import Image

import pieper
from pieper.drawing.animation import encoders
from pieper.drawing.animation.painter import Painter
from pieper.drawing.style import AXES
from pieper.errors import InputError
from pieper.motion.joint_move import joint_move

ARM = pieper.load("denso-vp6242")
HOME = np.radians([0, 51.492738, -150.638208, 0, 99.14547, 0])
LIMITS = pieper.Limits(speed=2.0, acceleration=8.0)


@pytest.fixture(scope="module")
def motion():
    return pieper.Program(ARM, LIMITS, start=HOME).move_j(HOME + 0.3).gripper(1.0).wait(0.2).motion(rate=200)


def held(file):
    found = re.search(r'<script id="numbers" type="application/json">(.*?)</script>', file.read_text(encoding="utf-8"))
    return json.loads(found[1])


@pytest.mark.parametrize("suffix", ["gif", "webp"])
def test_a_moving_picture_lasts_as_long_as_the_motion(motion, tmp_path, suffix):
    said = []
    file = motion.animate(tmp_path / f"m.{suffix}", rate=10, progress=lambda done, of: said.append((done, of)))
    with Image.open(file) as picture:
        assert picture.size == (640, 480)
        lasts = 0
        for k in range(picture.n_frames):
            picture.seek(k)
            picture.load()
            lasts += picture.info["duration"]
    # encoders may join equal pictures; the time they stand is kept
    assert lasts == pytest.approx(1000 * motion.duration, abs=201)
    assert said[-1] == (len(said), len(said)) and len(said) == int(np.ceil(motion.duration * 10)) + 1


def test_pictures_differ_where_the_arm_moves_and_only_there(motion):
    painter = Painter(motion, ARM.description, (320, 240), (22, -58))
    first, again, last = painter.picture(0.0), painter.picture(0.0), painter.picture(motion.duration)
    assert first.shape == (240, 320, 3) and np.array_equal(first, again)
    assert np.mean(first != last) > 0.01


def test_half_the_speed_takes_twice_as_long(motion, tmp_path):
    def pictures(**how):
        return len(held(motion.animate(tmp_path / "m.html", rate=10, **how))["times"])

    assert pictures(speed=0.5) == pytest.approx(2 * pictures(), abs=2)


def test_the_page_holds_the_motion_and_asks_nobody(motion, tmp_path):
    file = motion.animate(tmp_path / "m.html", rate=50)
    numbers, text = held(file), file.read_text(encoding="utf-8")
    assert "http" not in text and "{{" not in text
    q = np.radians(numbers["q"])
    assert np.abs(q - motion.between(numbers["times"])).max() < 1e-5
    assert np.abs(np.array(numbers["tools"]) - ARM.fk(q)[:, :3]).max() < 2e-4
    assert numbers["told"][0] == "" and numbers["told"][-1] == "gripper closed"


def test_between_samples_a_motion_is_its_own_cubic():
    fine, coarse = (joint_move(HOME, HOME + 0.4, LIMITS, rate=rate) for rate in (1000, 100))
    assert np.abs(coarse.between(fine.t) - fine.q).max() < 3e-5  # a jump of the acceleration within a sample
    assert np.array_equal(coarse.between(coarse.t), coarse.q)
    assert np.array_equal(coarse.between([-1.0, 1e9]), coarse.q[[0, -1]])


def test_an_mp4_is_a_video_of_that_size(motion, tmp_path):
    reader = pytest.importorskip("imageio_ffmpeg")
    file = motion.animate(tmp_path / "m.mp4", rate=10, size=(320, 240))
    about = next(reader.read_frames(str(file)))
    assert about["size"] == (320, 240) and about["duration"] == pytest.approx(motion.duration, abs=0.21)


def test_without_ffmpeg_the_cure_is_said(motion, tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "imageio_ffmpeg", None)
    monkeypatch.setattr(encoders.shutil, "which", lambda _: None)
    with pytest.raises(InputError, match=r"pieper\[video\]"):
        motion.animate(tmp_path / "m.mp4")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("words", "how"),
    [
        ("ends in .avi", dict(path="m.avi")),
        ("rate must be a finite", dict(rate=0)),
        ("speed must be a finite", dict(speed=float("nan"))),
        ("two even numbers", dict(size=(641, 480))),
        ("two even numbers", dict(size=(10, 10))),
        ("a width and a height", dict(size=3)),
        ("at most 100,000", dict(rate=1e6)),
    ],
)
def test_bad_input_is_answered_and_nothing_is_written(motion, tmp_path, words, how):
    how = {"path": "m.gif"} | how
    with pytest.raises(InputError, match=words):
        motion.animate(tmp_path / how.pop("path"), **how)
    assert not list(tmp_path.iterdir())


def test_a_motion_of_nobody_asks_whose_it_is(tmp_path):
    lonely = pieper.move(HOME, HOME + 0.1, 1.0)
    with pytest.raises(InputError, match="does not know its arm"):
        lonely.animate(tmp_path / "m.html")
    with pytest.raises(InputError, match="5 joints, the motion has 6"):
        lonely.animate(tmp_path / "m.html", arm=pieper.load("dfrobot-rob0036"))
    assert lonely.animate(tmp_path / "m.html", arm=ARM).exists()


def test_a_track_in_time_knows_its_arm_and_its_limits(tmp_path):
    T = ARM.fk(HOME)
    goal = T.copy()
    goal[:3, 3] += [0, 0.05, 0]
    motion = pieper.time_law(ARM.follow(pieper.line(T, goal, 20), start=HOME), LIMITS)
    assert motion.description.name == "denso-vp6242" and motion.limits is LIMITS
    assert motion.animate(tmp_path / "m.html").exists()
    assert repr(motion).startswith("Motion(denso-vp6242: 6 joints, ")


def test_a_gif_keeps_the_colours_of_the_tools_axes(motion, tmp_path):
    true = Painter(motion, ARM.description, (640, 480), (22, -58)).picture(0.0).astype(int)
    with Image.open(motion.animate(tmp_path / "m.gif", rate=10)) as file:
        drawn = np.array(file.convert("RGB")).astype(int)
    for colour in AXES:
        wanted = [int(colour[k : k + 2], 16) for k in (1, 3, 5)]
        there, kept = ((np.abs(picture - wanted).max(-1) < 12).sum() for picture in (true, drawn))
        # a few pixels among many: a palette of what is seen most has none of them
        assert there > 5 and kept >= there / 2, colour
