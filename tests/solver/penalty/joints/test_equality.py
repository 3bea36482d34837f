"""Equality constraints: coupled joints and closed loops, kept by default and told where keyframes break them."""

from pathlib import Path

import mujoco
import numpy as np
import pytest
from figures import figure_of
from motions import raw_violations
from processes import quiet
from random_models import random_samples
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.clip.build import Clip
from dynsplines.measure.report import report
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import Attachment, CouplingPenalty, closures, couplings

GRIPPER = read_data("gripper.xml")

GEARS = read_data("gears.xml")

FOUR_BAR = read_data("four_bar.xml")


def read(text: str, keys: str, folder: Path) -> Clip:
    (folder / "it.xml").write_text(text, encoding="utf-8")
    return recordings.from_text('figure = "it.xml"\n' + keys, name="it", folder=folder)


def measured(clip: Clip) -> dict:
    return report(clip, solving.solve(clip, quiet()))["after"]["largest"]


@pytest.mark.parametrize(("text", "units"), [(GRIPPER, ["degrees", "m", "degrees"]), (GEARS, ["m", "degrees", "m"])])
def test_couplings_are_those_of_mujoco(text, units, rng):
    model = mujoco.MjModel.from_xml_string(text)
    figure, data = Figure(model), mujoco.MjData(model)
    samples = random_samples(figure, rng)
    found = couplings(figure)
    active = [i for i in range(model.neq) if model.eq_active0[i]]
    assert [coupling.name for coupling in found] == [model.joint(model.eq_obj1id[i]).name for i in active]
    assert [coupling.unit for coupling in found] == units
    away, slopes = CouplingPenalty(found).away(samples)
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        data.qpos[:] = qpos
        mujoco.mj_forward(model, data)
        equality = data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
        np.testing.assert_allclose(away[:, i], data.efc_pos[equality], atol=1e-12)
        if not mujoco.mj_isSparse(model):
            rows = data.efc_J.reshape(-1, model.nv)[equality]
            for row, coupling, slope in zip(rows, found, slopes[:, i], strict=True):
                driver = 0.0 if coupling.driver < 0 else -row[coupling.driver]  # no joint of many axes: dof = column
                assert slope == pytest.approx(driver, abs=1e-12)


def test_points_of_closed_loops_are_those_of_mujoco(rng):
    model = mujoco.MjModel.from_xml_string(FOUR_BAR)
    figure, data = Figure(model), mujoco.MjData(model)
    samples = random_samples(figure, rng)
    apart = Attachment(closures(figure), name="closed").displacements(samples)[2].reshape(3, -1, samples.count)
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        data.qpos[:] = qpos
        mujoco.mj_forward(model, data)
        equality = data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
        np.testing.assert_allclose(apart[:, 0, i], data.efc_pos[equality][6:9], atol=1e-12)
        np.testing.assert_allclose(apart[:, 1, i], data.efc_pos[equality][9:12], atol=1e-12)
    assert len(closures(figure)) == 4


def test_a_closure_is_called_by_its_name_or_else_by_its_bodies_or_the_world():
    names = [closure.point.name for closure in closures(figure_of(FOUR_BAR))]
    assert names == ["rod and rocker", *["lid and world"] * 3]
    named = FOUR_BAR.replace("<connect body1", '<connect name="joint of rod" body1')
    assert closures(figure_of(named))[0].point.name == "joint of rod"


def test_a_weld_without_torque_leaves_rotations_alone():
    weld = '<weld name="pin" body1="one" body2="two" torquescale="{}"/>'
    bodies = "".join(f'<body name="{name}"><joint type="ball"/><geom size=".1"/></body>' for name in ("one", "two"))
    for torque, points in (("1", 3), ("0", 1)):
        text = f"<mujoco><worldbody>{bodies}</worldbody><equality>{weld.format(torque)}</equality></mujoco>"
        assert len(closures(figure_of(text))) == points


@pytest.mark.slow
def test_followers_follow_within_half_a_degree_by_default(tmp_path):
    keys = """
[[keyframe]]
time = 0
joints = {swing = 0, left = 5}
[[keyframe]]
time = 0.5
joints = {swing = 50, left = 40}
[[keyframe]]
time = 0.9
joints.tip = -30
joints.swing = 0
[[keyframe]]
time = 1.4
joints = {swing = 10, left = 10}
others = "previous"
"""
    clip = read(GRIPPER, keys, tmp_path)
    assert "equality" in [penalty.name for penalty, _ in clip.penalties]
    tip, right, lock = (clip.figure.model.joint(name).qposadr[0] for name in ("tip", "right", "lock"))
    assert all(key.fixed[right] for key in clip.keys[:2])
    assert all(key.fixed[lock] for key in clip.keys)
    d = np.radians(35)
    assert clip.keys[1].state[tip] == pytest.approx(-1.5 * d + 0.4 * d**2)
    assert clip.keys[1].state[right] == pytest.approx(0.01 + 0.05 * d)
    assert measured(clip)["coupled"]["amount"] < 0.5


@pytest.mark.slow
def test_a_closed_loop_stays_closed_by_default(tmp_path):
    keys = """
[[keyframe]]
time = 0
joints = {crank = 0, rod = 0, rocker = 0}
roots.lid = {position = [0, 1, 1], rotation = {rotvec = [0, 0, 0]}}
[[keyframe]]
time = 0.5
joints.crank = 50
[[keyframe]]
time = 1
joints = {crank = -20}
roots.lid = {position = [0, 1, 1], rotation = {rotvec = [0, 0, 0]}}
"""
    clip = read(FOUR_BAR, keys, tmp_path)
    (ignored,) = [note for note in clip.notes if "mocap" in note]
    assert ignored == "equality constraints to mocap bodies, which do not move, are ignored: '0'"
    torn = measured(clip)["torn"]
    assert torn["amount"] < 2e-3


def test_keyframes_that_break_a_coupling_or_tear_a_loop_are_kept_and_reported(tmp_path):
    keys = "".join(f"[[keyframe]]\ntime = {t}\njoints = {{left = 20, right = 0.08, swing = 0}}\n" for t in (0, 1))
    off = raw_violations(read(GRIPPER, keys, tmp_path))
    assert "keyframe 1 itself: right is 57 mm off what it follows at 0.00 s" in map(str, off)
    text = "[[keyframe]]\ntime = {}\njoints = {{crank = {}, rod = 0, rocker = 0}}\nothers = 'rest'\n"
    torn = raw_violations(read(FOUR_BAR, text.format(0, 0) + text.format(1, 40), tmp_path))
    assert any(str(each).startswith("keyframe 2 itself: the loop of rod and rocker is torn by ") for each in torn)
