"""How high a foot is taken off the ground, told swing by swing: MuJoCo's own kinematics are the oracle."""

from __future__ import annotations

import numpy as np
import pytest
from oracles import kinematics

from dynsplines import solving
from dynsplines.clip import load as clip
from dynsplines.measure.formatting import swing_text
from dynsplines.measure.quantities import swings
from dynsplines.motion import samples_at
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.spline import path_of

HOPPER = """<mujoco><worldbody>
  <geom type="plane" size="5 5 .1"/>
  <body name="leg" pos="0 0 {}"><joint name="lift" type="slide" axis="0 0 1"/>
    <geom type="capsule" size=".05" fromto="0 0 .1 0 0 .5"/><site name="left_heel" pos="0 0 0"/>
    <body name="toes" pos=".1 0 0"><joint name="toes" axis="0 1 0"/>
      <geom type="capsule" size=".02" fromto="0 0 .02 .1 0 .02"/>
      <site name="left_toe" pos=".1 0 0"/></body></body>
</worldbody></mujoco>"""
LIFTS = {0.0: 0.0, 0.5: 0.3, 1.0: 0.0, 1.2: 0.002, 1.5: 0.0, 2.0: 0.12, 2.5: 0.0}


def hopper(folder, start=0.0):
    (folder / "hopper.xml").write_text(HOPPER.format(start), encoding="utf-8")
    keys = [f"[[keyframe]]\ntime = {t}\njoints.lift = {z}\njoints.toes = 0\n" for t, z in LIFTS.items()]
    (folder / "hop.toml").write_text('figure = "hopper.xml"\n' + "".join(keys), encoding="utf-8")
    problem = clip.load(str(folder / "hop.toml"))
    return problem, path_of(solving.unsolved(problem).motion.raw)


def test_every_swing_is_reported_with_its_height(tmp_path):
    problem, path = hopper(tmp_path)
    time = np.linspace(0, 2.5, 2501)
    found = swings(problem, samples_at(problem.figure, path, time))
    model, qpos = problem.figure.model, problem.figure.to_qpos(path.at(time))
    height = np.array([kinematics(model, row).site("left_heel").xpos[2] for row in qpos])
    assert list(found) == ["leg", "toes"]
    for own in found.values():
        assert len(own) == 2
        for swing, (first, last) in zip(own, ((0, 1), (1.3, 2.5)), strict=True):
            inside = (time > first) & (time < last)
            assert swing["height, m"] == pytest.approx(height[inside].max(), abs=1e-9)
            up = time[inside & (height > Thresholds.of(problem.figure).swings)]
            assert (swing["from, s"], swing["to, s"]) == pytest.approx((up[0], up[-1]))


def test_a_foot_that_is_never_up_has_no_swings(tmp_path):
    problem, path = hopper(tmp_path)
    still = samples_at(problem.figure, path, np.full(20, 0.0))
    assert swings(problem, still) == {"leg": [], "toes": []}


def test_swings_are_reported_in_words():
    assert swing_text([]) == "never"
    assert swing_text([{"height, m": 0.0812}, {"height, m": 0.3}]) == "81, 300 mm"
    assert swing_text([{"height, m": 0.01 * k} for k in range(2, 12)]) == "10 times, 20 to 110 mm"
