"""The files that ship: found from anywhere, true to their source, and built as the solver relies on."""

import mujoco
import numpy as np
import pytest
from oracles import kinematics

from dynsplines import models

SIDES = ("left", "right")
BODIES = ["pelvis", "chest"]
BODIES += [f"{side}_{part}" for side in SIDES for part in ("upper_arm", "forearm")]
BODIES += [f"{side}_{part}" for side in SIDES for part in ("thigh", "shin", "foot")]
JOINTS = ["root", "spine"]
JOINTS += [f"{side}_{joint}" for side in SIDES for joint in ("shoulder", "elbow")]
JOINTS += [f"{side}_{joint}" for side in SIDES for joint in ("hip", "knee", "ankle")]
SITES = {f"{side}_{place}" for side in SIDES for place in ("heel", "toe", "wrist", "hand")} | {"head_top"}
MIRROR = np.array([1.0, -1.0, 1.0])

# De Leva (1996), Table 4, males: length [m], mass [% of the body], centre of mass [% of the length, from the upper or
# hind end], radii of gyration about the sagittal, transverse and longitudinal axes [% of the length].
DE_LEVA = {
    "head": (0.2429, 6.94, 50.02, (30.3, 31.5, 26.1)),
    "upper trunk": (0.1707, 15.96, 29.99, (71.6, 45.4, 65.9)),
    "middle trunk": (0.2155, 16.33, 45.02, (48.2, 38.3, 46.8)),
    "lower trunk": (0.1457, 11.17, 61.15, (61.5, 55.1, 58.7)),
    "upper arm": (0.2817, 2.71, 57.72, (28.5, 26.9, 15.8)),
    "forearm": (0.2689, 1.62, 45.74, (27.6, 26.5, 12.1)),
    "hand": (0.0862, 0.61, 79.00, (62.8, 51.3, 40.1)),
    "thigh": (0.4222, 14.16, 40.95, (32.9, 32.9, 14.9)),
    "shank": (0.4403, 4.33, 43.95, (25.1, 24.6, 10.2)),
    "foot": (0.2581, 1.37, 44.15, (25.7, 24.5, 12.4)),
}
BODY_MASS = 73.0
LENGTH_SCALE = 0.98
PARTS = {
    "pelvis": ["lower trunk"], "chest": ["middle trunk", "upper trunk", "head"], "upper_arm": ["upper arm"],
    "forearm": ["forearm", "hand"], "thigh": ["thigh"], "shin": ["shank"], "foot": ["foot"],
}  # fmt: skip


@pytest.fixture(scope="module")
def human() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(models.figure_text("human"))


def test_every_figure_compiles_alone_and_is_described_in_one_line() -> None:
    assert {"human", "spinner"} <= set(models.figures())
    assert "stage" not in models.figures()
    for name, description in models.figures().items():
        assert description and "\n" not in description
        assert mujoco.MjModel.from_xml_string(models.figure_text(name)).nbody > 1


def test_unknown_names_are_key_errors_with_a_suggestion_and_the_list() -> None:
    with pytest.raises(KeyError) as caught:
        models.figure_text("humam")
    assert caught.value.args[0] == "no figure 'humam'; did you mean 'human'? Figures: human, spinner"
    with pytest.raises(KeyError, match="no clip 'no such clip'"):
        models.clip_text("no such clip")


def test_the_human_has_12_bodies_and_39_degrees_of_freedom(human: mujoco.MjModel) -> None:
    assert [human.body(i).name for i in range(1, human.nbody)] == BODIES
    assert [human.joint(i).name for i in range(human.njnt)] == JOINTS
    assert {human.site(i).name for i in range(human.nsite)} == SITES
    np.testing.assert_array_equal(human.site_group, 4)  # hidden
    assert (human.nq, human.nv) == (51, 39)
    assert human.jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE
    assert (human.jnt_type[1:] == mujoco.mjtJoint.mjJNT_BALL).all()
    np.testing.assert_array_equal(kinematics(human).xquat, np.tile([1.0, 0, 0, 0], (human.nbody, 1)))
    assert human.jnt_limited[1:].all() and (human.jnt_range[1:, 1] >= np.deg2rad(60) - 1e-9).all()


def test_the_human_stands_on_the_floor() -> None:
    """Its soles touch a plane at nought, and so do the sites that mark their ends."""
    spec = mujoco.MjSpec.from_string(models.figure_text("human"))
    spec.worldbody.add_geom(name="floor", type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 1])
    data = kinematics(human := spec.compile())
    floor = human.geom("floor").id
    gaps = [mujoco.mj_geomDistance(human, data, floor, g, 1.0, None) for g in range(human.ngeom) if g != floor]
    assert min(gaps) == pytest.approx(0, abs=1e-12)
    for end in (f"{side}_{part}" for side in SIDES for part in ("heel", "toe")):
        assert data.site(end).xpos[2] == pytest.approx(0, abs=1e-12)
        gap = mujoco.mj_geomDistance(human, data, floor, human.geom(f"{end}_sole").id, 1.0, None)
        assert gap == pytest.approx(0, abs=1e-12)


def test_left_mirrors_right(human: mujoco.MjModel) -> None:
    np.testing.assert_array_equal(human.jnt_pos, 0.0)
    for name in BODIES:
        if name.startswith("left_"):
            left, right = human.body(name), human.body(name.replace("left_", "right_"))
            np.testing.assert_array_equal(left.mass, right.mass)
            np.testing.assert_array_equal(left.inertia, right.inertia)
            np.testing.assert_array_equal(left.pos * MIRROR, right.pos)
            np.testing.assert_array_equal(left.ipos * MIRROR, right.ipos)


@pytest.mark.parametrize("name", BODIES)
def test_masses_are_those_of_the_table_and_inertias_those_of_its_limbs(human: mujoco.MjModel, name: str) -> None:
    body, parts = human.body(name), PARTS[name.removeprefix("left_").removeprefix("right_")]
    assert body.mass[0] == pytest.approx(BODY_MASS / 100 * sum(DE_LEVA[part][1] for part in parts), abs=1e-4)
    if name.endswith(("upper_arm", "thigh", "shin")):  # bodies of one segment that hangs down
        length, _, centre, radii = DE_LEVA[parts[0]]
        length *= LENGTH_SCALE
        np.testing.assert_allclose(body.ipos, [0, 0, -centre / 100 * length], atol=1e-5)
        axes = np.zeros(9)
        mujoco.mju_quat2Mat(axes, body.iquat)
        inertia = axes.reshape(3, 3) @ np.diag(body.inertia) @ axes.reshape(3, 3).T
        expected = body.mass[0] * (np.array(radii) / 100 * length) ** 2
        np.testing.assert_allclose(inertia, np.diag(expected), atol=1e-6)


def test_segment_lengths_are_the_scaled_lengths_of_the_table(human: mujoco.MjModel) -> None:
    drops = {"left_forearm": "upper arm", "left_shin": "thigh", "left_foot": "shank", "chest": "lower trunk"}
    for body, segment in drops.items():
        assert abs(human.body(body).pos[2]) == pytest.approx(LENGTH_SCALE * DE_LEVA[segment][0], abs=1e-3)
