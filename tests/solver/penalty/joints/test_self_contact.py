"""Limbs in the trunk and in each other: depths against MuJoCo's distances, gradients, what is left out, and a clip."""

import io
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import figure_of
from oracles import geom_pairs, kinematics
from paper.penetration import self_penetration
from processes import quiet
from random_models import random_samples
from rich.console import Console
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.measure.report import report, tables
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import SelfContact

SPIDER = read_data("spider.xml")
COORDINATES = ["world", "joint"]


def spider(coordinates: str = "world") -> Figure:
    return figure_of(SPIDER, coordinates)


def tangled(figure: Figure, rng: np.random.Generator, count: int = 60) -> Samples:
    return random_samples(figure, rng, count)


@pytest.mark.parametrize("coordinates", COORDINATES)
def test_the_penalty_is_the_sum_of_squared_depths_by_mujoco(coordinates, rng):
    figure = spider(coordinates)
    penalty, samples, model = SelfContact.of(figure), tangled(figure, rng), figure.model
    pairs = {tuple(sorted(model.geom(g).name for g in pair)) for pair in geom_pairs(penalty).T}
    assert pairs == {
        ("hand", "trunk"), ("arm", "other"), ("arm", "pad"), ("hand", "other"), ("hand", "pad"),
    }  # fmt: skip
    expected = []
    for qpos in figure.to_qpos(samples.y):
        data = kinematics(model, qpos)
        depths = [-mujoco.mj_geomDistance(model, data, a, b, 1, None) for a, b in geom_pairs(penalty).T]
        expected.append(np.sum(np.maximum(depths, 0) ** 2))
    np.testing.assert_allclose(penalty.evaluate(samples), expected, atol=1e-6)
    assert np.count_nonzero(np.array(expected) > 1e-4) > 5


GIANT = """<mujoco><worldbody>
<body name="one"><freejoint name="one"/>
  <geom name="elbow" size=".3" pos="0 0 3"/><geom name="toe" size=".3" pos="0 0 -1"/></body>
<body name="two"><freejoint name="two"/>
  <geom name="knee" size=".3" pos=".2 0 3"/><geom name="heel" size=".3" pos="1 0 -1"/></body>
</worldbody></mujoco>"""


def test_shapes_that_overlap_at_rest_are_left_out_though_they_lie_far_from_their_links_origins():
    figure = figure_of(GIANT)
    penalty, rest = SelfContact.of(figure), figure.model.qpos0
    pairs = {tuple(sorted(figure.model.geom(g).name for g in pair)) for pair in geom_pairs(penalty).T}
    assert pairs == {("elbow", "heel"), ("knee", "toe"), ("heel", "toe")}
    shifted = np.array(rest)
    shifted[0] = 0.5  # the toe comes within 0.5 m of the heel, and elbow and knee go on overlapping
    lowered = np.array(shifted)
    lowered[2] = -4.0  # the elbow is where the toe was
    y = figure.to_state(np.array([rest, shifted, lowered]))
    np.testing.assert_allclose(penalty.evaluate(Samples(figure, y, 0 * y, 0 * y)), [0, 0.1**2, 0.1**2], atol=1e-12)
    shifted[0] = 1.0  # the toe is where the heel is, and moves out in some direction
    samples = Samples.still(figure, figure.to_state(shifted)[None])
    penalty.evaluate(samples, into := Cotangent(samples))
    assert np.linalg.norm(into.gradients()[0][:, :3]) == pytest.approx(2 * 0.6)  # twice the depth


def clusters(rng: np.random.Generator, scale: float) -> tuple[Figure, Samples]:
    """Three free bodies of five shapes each, far from each other at rest, and samples in which they are tangled."""
    spec = mujoco.MjSpec()
    for i in range(3):
        body = spec.worldbody.add_body(pos=[10 * scale * i, 0, 0])
        body.add_freejoint()
        for kind in ("CAPSULE", "CAPSULE", "CAPSULE", "SPHERE", "SPHERE"):
            shape, size = getattr(mujoco.mjtGeom, f"mjGEOM_{kind}"), [rng.uniform(0.02, 0.1), rng.uniform(0.05, 0.4), 0]
            place = rng.normal(size=3) * [0.6, 0.2, 0.2]
            body.add_geom(type=shape, size=scale * np.array(size), pos=scale * place, quat=rng.normal(size=4))
    figure = Figure(spec.compile())
    y = rng.normal(size=(300, figure.width))
    y[:, [link.qpos + k for link in figure.links[1:] for k in range(3)]] *= 0.3 * scale
    return figure, Samples.still(figure, figure.to_state(y))


@pytest.mark.parametrize(("scale", "margin"), [(0.2, 0.0), (1.0, 0.03), (20.0, 0.0)])
def test_no_pair_is_missed_among_links_of_many_shapes(rng, scale, margin):
    figure, samples = clusters(rng, scale)
    penalty, model = SelfContact.of(figure, margin), figure.model
    pairs, data = geom_pairs(penalty), mujoco.MjData(model)
    expected, deep = [], 0
    for qpos in figure.to_qpos(samples.y):
        kinematics(model, qpos, data)
        depths = margin - np.array([mujoco.mj_geomDistance(model, data, a, b, scale, None) for a, b in pairs.T])
        expected.append(np.sum(np.maximum(depths, 0) ** 2))
        deep += np.count_nonzero(depths > 0)
    np.testing.assert_allclose(penalty.evaluate(samples), expected, atol=1e-6 * scale**2)
    assert deep > 300


ARM_IN_SLEEVE = """<mujoco><worldbody><body pos="0 0 1"><freejoint/>
  <geom name="sleeve" type="capsule" size=".1" fromto=".3 0 0 .3 0 .4"/>
  <geom name="bone" type="capsule" size=".04" fromto="{}"/></body>
<body pos="3 0 1"><freejoint/><geom name="far" size=".1"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize(
    ("ends", "kept"),
    [
        (".3 .02 .1 .3 .02 .3", False),
        (".3 0 .2 .3 0 .474", False),  # 14 mm above the sleeve
        (".3 0 .2 .3 0 .476", True),
        (".3 0 -.074 .3 0 .2", False),
        (".3 0 -.076 .3 0 .2", True),
        (".3 .074 .2 .3 -.074 .1", False),
        (".3 .076 .2 .3 0 .1", True),
        (".3 0 .2 .3 -.076 .1", True),
        (".3 -.2 .2 .3 .2 .2", True),
    ],
)
def test_a_shape_is_left_out_up_to_15_mm_outside_a_thicker_one(ends, kept):
    figure = figure_of(ARM_IN_SLEEVE.format(ends))
    geoms = {figure.model.geom(geom).name for geom in geom_pairs(SelfContact.of(figure)).ravel()}
    assert geoms == {"sleeve", "far"} | ({"bone"} if kept else set())


def test_a_figure_at_rest_costs_nothing_and_nothing_to_meet_has_no_sides(figure, rng):
    rest = figure.to_state(figure.model.qpos0)[None]
    penalty = SelfContact.of(figure)
    assert not penalty.evaluate(Samples(figure, rest, 0 * rest, 0 * rest)).any()
    samples = random_samples(figure, rng)
    none = SelfContact((), np.zeros((2, 0), np.intp))
    assert not list(none.residuals(samples))
    assert not none.evaluate(samples, Cotangent(samples)).any()
    assert geom_pairs(none).shape == (2, 0)


def shoulder_turned(figure: Figure, angle: float) -> Array:
    """The figure at rest, with a shoulder turned about the x axis: at −2 rad the hand is in the trunk."""
    qpos = np.array(figure.model.qpos0)
    start = int(figure.model.joint("shoulder").qposadr[0])
    qpos[start : start + 4] = quat.from_rotation_vector(np.array([angle, 0, 0]))
    return qpos


def test_a_depth_that_keyframes_specify_is_tolerated_and_fades_towards_the_next_keyframe():
    figure, angles = spider(), (-2.0, 0.0)
    specified = np.ones(figure.model.nq, bool)
    keys = [Frame(t, shoulder_turned(figure, angle), specified) for t, angle in enumerate(angles)]
    penalty, timeline = SelfContact.of(figure), raw_timeline(figure, keys)
    tolerant, times = penalty.allowing(figure, timeline), np.array([0, 0.5, 1])
    same_pose = Samples.still(figure, np.tile(figure.to_state(keys[0].state), (3, 1)), times)
    depth = np.sqrt(penalty.evaluate(same_pose))
    np.testing.assert_allclose(np.sqrt(tolerant.evaluate(same_pose)), depth * [0, 0.5, 1], atol=1e-9)
    loose = np.array(specified)
    loose[figure.model.joint("shoulder").qposadr[0] + np.arange(4)] = False
    partial = raw_timeline(figure, [replace(key, fixed=loose, posed=specified) for key in keys])
    assert penalty.allowing(figure, partial).allowed is None


ARMS = read_data("arm_at_trunk.xml")
SWING = read_data("arm_at_trunk.toml")


@pytest.mark.slow
def test_an_arm_goes_through_the_trunk_without_the_penalty_and_at_most_two_millimetres_with_it(tmp_path):
    (tmp_path / "arms.xml").write_text(ARMS, encoding="utf-8")
    deepest = {}
    for asked in (False, True):
        options = "margin = 0.002" if asked else "self = false"
        (tmp_path / "arms.toml").write_text(f"{SWING}[[penalty]]\nkind = 'collision'\n{options}\n", encoding="utf-8")
        clip = recordings.load(str(tmp_path / "arms.toml"))
        saved = solving.solve(clip, quiet())
        data = report(clip, saved)
        out = io.StringIO()
        Console(file=out, width=160).print(tables(data))
        assert "largest self" in out.getvalue()
        figure, time = clip.figure, np.linspace(0, 1, 1001)
        pairs = geom_pairs(SelfContact.of(figure))
        for side, timeline in (("before", saved.raw), ("after", saved.timeline)):
            found, qpos = data[side]["largest"]["self"], figure.to_qpos(path_of(timeline).at(time))
            depth, _ = self_penetration(figure.model, pairs, time, qpos)
            assert found["amount"] == pytest.approx(depth, abs=0.002)
            assert depth < 0.01 or (found["name"] == "trunk in hand" and 0 < found["at, s"] < 1)
            deepest[side if asked else f"{side} without"] = depth
    assert deepest["after without"] > 0.05
    assert deepest["before"] > 0.05
    assert deepest["after"] <= 0.002
