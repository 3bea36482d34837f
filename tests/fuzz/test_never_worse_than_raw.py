"""Clips changed at random, searched for long or for a moment by any optimiser: finite, through their keyframes, and
never worse than the raw spline, E of both summed over one fine grid.

A short run is part of the tests; DYNSPLINES_FUZZ=300 makes a long one: as many clips, of which some take minutes.
"""

import os
from dataclasses import replace

import mujoco
import numpy as np
import problems
import pytest
from processes import quiet
from rekeyed import with_keys
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.clip.build import Clip
from dynsplines.errors import UserError
from dynsplines.measure.report import keyframe_error
from dynsplines.solver import Frame
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.search.nlopt_methods import METHODS
from dynsplines.solver.search.restarts import common_grid

CLIPS = ("sit_down", "tumble", "walk_loop", "run_loop", "cartwheel", "run_and_step", "stairs")
EVALUATIONS = (1, 2, 5, 20, 60)
BRIEF = (1, 2, 5, 20)  # evaluations of the short run
COUNT = int(os.environ.get("DYNSPLINES_FUZZ", 0))
SHIPPED = range(COUNT) if COUNT else [1]
FINER = 7  # parts of the spans of both splines: another grid than the search's own
EXACT = 1e-12
ROUNDING = 1e-15  # of E: what two keyframes alone ask for can be kept exactly, and then E is 1e-26 or so
DEGREES, METRES = 8.0, 0.05  # by which joints and the root are moved, at most
DROPPED, FREED = 0.2, 0.1  # of the keyframes but the first and last, and of the joints of a keyframe


def varied(seed: int) -> Clip:
    """A shipped clip with numbers moved, keyframes left out, joints freed; drawn again while contacts forbid that."""
    rng = np.random.default_rng(seed)
    clip = recordings.load(CLIPS[seed % len(CLIPS)])
    for size in np.geomspace(1, 0.01, 20):
        inner = [key for key in clip.keys[1:-1] if rng.random() > DROPPED]
        ends = [clip.keys[0], clip.keys[-1]] if clip.ends == "periodic" else []
        keys = [
            key if any(key is end for end in ends) else changed(clip.figure, key, float(size), rng)
            for key in (clip.keys[0], *inner, clip.keys[-1])
        ]
        try:
            other = with_keys(clip, keys)
        except UserError:  # keyframes that contradict a contact
            continue
        evaluations, method = int(rng.choice(EVALUATIONS if COUNT else BRIEF)), str(rng.choice([*METHODS]))
        return other.with_problem(settings=replace(other.settings, max_evaluations=evaluations, optimiser=method))
    raise AssertionError(f"{clip.name}: whatever is moved contradicts a contact")


def changed(figure: Figure, key: Frame, size: float, rng: np.random.Generator) -> Frame:
    """A keyframe moved by up to a share `size` of the most, some of its joints free."""
    state, fixed = np.array(key.state), np.array(key.fixed)
    for link in figure.links[1:]:
        if link.kind is JointKind.FREE:
            state[link.qpos : link.qpos + 3] += size * rng.uniform(-METRES, METRES, 3)
        elif link.kind is JointKind.BALL:
            columns = slice(link.qpos, link.qpos + 4)
            state[columns] = quat.product(state[columns], turn(size, rng))
            if rng.random() < FREED:
                fixed[columns] = False
    return Frame(key.time, state, fixed)


def turn(size: float, rng: np.random.Generator) -> Array:
    return quat.from_rotation_vector(np.radians(size * rng.uniform(-DEGREES, DEGREES, 3)))


@pytest.mark.slow
@pytest.mark.parametrize("seed", SHIPPED)
def test_a_changed_clip_is_never_worse_than_its_raw_spline(seed):
    assert_no_worse(varied(seed))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["nearly_zero", "nearly_zero_turns"])
def test_a_clip_whose_quaternions_come_near_zero_is_never_worse_than_its_raw_spline(name):
    spec = mujoco.MjSpec.from_string(problems.FIGURE)
    assert_no_worse(recordings.from_text(read_data(f"{name}.toml"), name=name, spec=spec))


def assert_no_worse(clip: Clip) -> None:
    """Searched, and held against its raw spline on a grid of its own."""
    motion = solving.solve(clip, quiet())
    assert np.isfinite(motion.timeline.rows).all()
    assert keyframe_error(clip, motion.timeline) <= EXACT
    edges = common_grid([motion.timeline, motion.raw])
    share = np.arange(FINER) / FINER
    times = np.append((edges[:-1, None] + share * np.diff(edges)[:, None]).ravel(), edges[-1])
    objective = clip.problem.objective
    found, raw = (objective.value(path_of(line), times) for line in (motion.timeline, motion.raw))
    assert found <= raw * (1 + 1e-6) + ROUNDING, (clip.name, clip.settings.optimiser, clip.settings.max_evaluations)
