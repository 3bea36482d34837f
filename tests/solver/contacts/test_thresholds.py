"""Figures of one shape and of any size have one schedule of stances and flights, and one motion."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scaled import enlarged, scaled
from walking_biped import FPS, TEXT, walk

from dynsplines import models
from dynsplines.clip import load
from dynsplines.clip.load import Clip
from dynsplines.scene.compose import compose
from dynsplines.solver.array import Array
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.figure.size import Size
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.problem import Problem

STRIDES = 7  # keyframes of run_and_step before the step: two flights, and a foot on the ground between them
EVERY = 8  # samples of the walk between keyframes
INSTANTS = 101  # at which motions are compared


@cache
def keyframes(figure: str) -> tuple[str, Array, Array]:
    """Text of the model, times (K,) [s] and configurations (K, nq): a human that runs, a biped that walks."""
    if figure == "human":
        keys = load.load("run_and_step").keys[:STRIDES]
        times, poses = np.array([k.time for k in keys]), np.array([k.state for k in keys], np.float64)
        return models.figure_text("human"), times, poses
    poses = np.array(walk()[::EVERY], np.float64)
    times = np.array([EVERY / FPS * k for k in range(len(poses))])
    return TEXT, times, poses


def clip_of(figure: str, factor: float, *, gravity: bool) -> Clip:
    """The clip of a figure of another size: with gravity as much stronger, or else in dynamic similarity slower."""
    text, times, poses = keyframes(figure)
    spec = scaled(text, factor, gravity=gravity)
    bare = spec.compile()
    slower = 1.0 if gravity else np.sqrt(factor)
    return load.from_qpos(figure, compose(spec, bare=bare), slower * times, enlarged(bare, poses, factor), 30, figure)


def schedule(clip: Clip, slower: float) -> list[tuple[str, float, float]]:
    """Stances, footings and flights by name, their times [s] divided by how much slower the clip is."""
    support = clip.context.support
    assert support is not None
    rows = [(kind, each.point.name, each.first, each.last) for kind, some in (
        ("stance", clip.context.schedule.stances), ("footing", support.footings)) for each in some]  # fmt: skip
    rows += [("flight", "", *flight) for flight in support.flights]
    return [(f"{kind} {name}", round(first / slower, 6), round(last / slower, 6)) for kind, name, first, last in rows]


def summed(clip: Clip, slower: float) -> Problem:
    """A clip's problem, its integrals summed over panels as much longer as the clip is slower."""
    problem = clip.problem
    panels = replace(problem.settings.quadrature, longest=slower * problem.settings.quadrature.longest)
    return replace(problem, settings=replace(problem.settings, quadrature=panels))


@pytest.mark.parametrize(("figure", "factor", "gravity"), [("human", 3.0, False), ("biped", 0.3, True)])
def test_a_doll_and_a_giant_stand_and_fly_when_an_adult_does(figure, factor, gravity):
    slower = 1.0 if gravity else float(np.sqrt(factor))
    adult, other = (clip_of(figure, each, gravity=gravity) for each in (1.0, factor))
    expected = schedule(adult, 1.0)
    assert schedule(other, slower) == expected
    kinds = {row[0].split()[0] for row in expected}
    assert kinds >= ({"stance", "footing", "flight"} if figure == "human" else {"stance", "footing"})


@pytest.mark.slow
@pytest.mark.parametrize(("figure", "factor", "gravity"), [("human", 0.3, True), ("biped", 3.0, False)])
def test_a_doll_and_a_giant_move_as_an_adult_does(figure, factor, gravity):
    adult, other = (clip_of(figure, each, gravity=gravity) for each in (1.0, factor))
    slower = 1.0 if gravity else float(np.sqrt(factor))
    motions = [inbetween(summed(clip, each)) for clip, each in ((adult, 1.0), (other, slower))]
    poses = []
    for clip, motion, each in zip((adult, other), motions, (1.0, factor), strict=True):
        times = np.linspace(clip.keys[0].time, clip.keys[-1].time, INSTANTS)
        poses.append(enlarged(clip.figure.model, motion.at(times), 1 / each))
    # spheres are at fixed distances along limbs
    np.testing.assert_allclose(poses[1], poses[0], atol=0.02)
    assert motions[1].trace[-1][2] == pytest.approx(motions[0].trace[-1][2], rel=0.02)


def test_lengths_times_and_speeds_grow_with_the_figure():
    text = models.figure_text("human")
    for factor in (0.25, 4.0):
        figure = load.figure_of(compose(scaled(text, factor), bare=scaled(text, factor).compile()), "scaled")
        size, found = Size.of(figure), Thresholds.of(figure)
        assert size.length == pytest.approx(factor, rel=1e-6)
        assert size.time == pytest.approx(np.sqrt(factor), rel=1e-6)
        speeds = ("travels", "lowering", "fast", "drift", "fastest", "slowest")
        powers = {"near_surface": 1, "step": 0.5, "finest": -0.5, "lively": 0.5, "height_turn": -1}
        for name, power in (powers | dict.fromkeys(speeds, 0.5)).items():
            assert getattr(found, name) == pytest.approx(factor**power * getattr(Thresholds(), name), rel=1e-6)
