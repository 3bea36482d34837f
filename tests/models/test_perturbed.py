"""The benchmark of keyframes moved at random: what it moves, what it measures, and two quick clips that do not whip."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import mujoco
import numpy as np
import pytest

from dynsplines import solving
from dynsplines.clip import load as clips
from dynsplines.clip.build import Clip
from dynsplines.solver import Frame, Solution
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import JointKind

FOLDER = Path(__file__).parents[2] / "benchmarks"
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS", "NUMEXPR_NUM_THREADS",
           "VECLIB_MAXIMUM_THREADS")  # fmt: skip


@pytest.fixture(scope="module")
def benchmark() -> ModuleType:
    with pytest.MonkeyPatch.context() as patch:
        for name in THREADS:
            patch.setenv(name, "1")
        patch.syspath_prepend(str(FOLDER))
        spec = importlib.util.spec_from_file_location("perturbed_benchmark", FOLDER / "perturbed.py")
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        patch.setitem(sys.modules, spec.name, module)
        own = set(sys.modules)
        spec.loader.exec_module(module)
        for name in set(sys.modules) - own:
            if str(FOLDER) in str(getattr(sys.modules[name], "__file__", "")):
                del sys.modules[name]
        return module


def turned(clip: Clip, before: Frame, after: Frame) -> Array:
    """[rad] by how much every ball joint of a keyframe was turned, NaN where it is not fixed."""
    out = []
    for link in clip.figure.links[1:]:
        if link.kind is JointKind.BALL:
            columns = slice(link.qpos, link.qpos + 4)
            angle = float(quat.angle_between(before.state[columns], after.state[columns]))
            out.append(angle if before.fixed[columns].all() else np.nan)
    return np.array(out)


@pytest.mark.slow
def test_joints_turn_by_five_degrees_and_the_root_moves_by_three_centimetres(benchmark):
    clip = clips.load("sit_down")
    other, again, third = (benchmark.perturbed(clip, seed) for seed in (1, 1, 2))
    assert [key.time for key in other.keys] == [key.time for key in clip.keys]
    for before, after, same, unlike in zip(clip.keys, other.keys, again.keys, third.keys, strict=True):
        np.testing.assert_array_equal(after.state, same.state)
        assert not np.array_equal(after.state, unlike.state)
        np.testing.assert_array_equal(after.fixed, before.fixed)
        angles = turned(clip, before, after)
        np.testing.assert_allclose(angles[~np.isnan(angles)], np.radians(5), rtol=1e-9)
        if before.fixed[:3].all():
            np.testing.assert_allclose(np.linalg.norm(after.state[:3] - before.state[:3]), 0.03)
        np.testing.assert_array_equal(after.state[3:7], before.state[3:7])


@pytest.mark.slow
@pytest.mark.parametrize("name", ["walk_loop", "run_loop"])
def test_what_a_keyframe_leaves_free_is_not_moved_and_a_loop_still_closes(benchmark, name):
    clip = clips.load(name)
    other = benchmark.perturbed(clip, 3)
    for before, after in zip(clip.keys, other.keys, strict=True):
        np.testing.assert_array_equal(after.state[~before.fixed], before.state[~before.fixed])
    first, last = other.keys[0], other.keys[-1]
    both = first.fixed & last.fixed
    way = clip.keys[-1].state - clip.keys[0].state
    np.testing.assert_allclose((last.state - first.state)[both], way[both], atol=1e-12)
    assert not np.array_equal(first.state, clip.keys[0].state)


@pytest.mark.slow
def test_contacts_that_moved_keyframes_contradict_are_left_out_and_the_others_kept(benchmark):
    clip = clips.load("cartwheel")
    kept = [len(benchmark.perturbed(clip, seed).context.schedule.contacts.requested) for seed in range(6)]
    assert min(kept) < len(clip.context.schedule.contacts.requested)
    assert 0 < max(kept) <= len(clip.context.schedule.contacts.requested)


def accelerations(motion: Solution, t: Array) -> Array:
    """(T, b) [rad/s²] of MuJoCo's bodies relative to their parents, by differences of their turns."""
    model, h = motion.figure.model, 1e-3
    data = mujoco.MjData(model)

    def relative(time: Array) -> Array:
        out = []
        for qpos in motion.at(time):
            data.qpos[:] = qpos
            mujoco.mj_kinematics(model, data)
            parents = data.xquat[model.body_parentid]
            out.append(np.concatenate([data.xquat[1:], parents[1:]], axis=1))
        return np.array(out)

    def rates(time: Array) -> Array:
        after, before = relative(time + h), relative(time - h)
        spins = [
            quat.rotation_vector(quat.product(after[..., k : k + 4], quat.inverse(before[..., k : k + 4])))
            for k in (0, 4)
        ]
        return (spins[0] - spins[1]) / (2 * h)

    return np.linalg.norm((rates(t + h) - rates(t - h)) / (2 * h), axis=2)


@pytest.fixture(scope="module")
def run(benchmark) -> Solution:
    return benchmark.solved(clips.load("run_loop"))


@pytest.mark.slow
def test_the_peak_and_the_limb_that_strays_are_those_of_mujoco(benchmark, run):
    seen, (first, last) = benchmark.Seen.of(run), run.path.span
    t = np.linspace(first, last, round(benchmark.RATE * (last - first)) + 1)
    bodies = run.figure.model.body
    found = accelerations(run, t[2:-2])[:, 1:]  # but for the pelvis, which no joint turns
    joints = [bodies(i + 2).jntnum[0] > 0 for i in range(found.shape[1])]
    assert 0.9 * found[:, joints].max() <= seen.peak <= 1.2 * found[:, joints].max()
    data, apart = mujoco.MjData(run.figure.model), []
    for pair in zip(run.at(t), run.figure.to_qpos(path_of(run.raw).at(t)), strict=True):
        places = []
        for qpos in pair:
            data.qpos[:] = qpos
            mujoco.mj_kinematics(run.figure.model, data)
            places.append(data.xpos[1:].copy())
        apart.append(np.linalg.norm(places[0] - places[1], axis=1))
    moving = np.array([bodies(i + 1).jntnum[0] > 0 for i in range(len(apart[0]))])
    np.testing.assert_allclose(seen.farthest, np.array(apart)[:, moving].max(), rtol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "count"), [("run_loop", 3), ("walk_loop", 2)])
def test_quick_clips_do_not_whip_when_their_keyframes_move_a_little(benchmark, name, count):
    section = benchmark.compared([name], range(count), benchmark.Effort(quick=True, tell=lambda _: None))
    assert [target.met for target in section.targets] == [True] * 3
    ((clip, sets, *_),) = section.rows
    assert (clip, sets) == (name, count)
    assert len(section.data["sets"]) == count
    assert {each["seed"] for each in section.data["sets"]} == set(range(count))


def test_a_set_that_stands_out_is_named_with_what_its_motion_costs(benchmark):
    seen = benchmark.Seen(900.0, "left_knee", 0.7, "left_ankle")
    bad = benchmark.Outcome("walk", 17, 7.5, seen, 1.0, 30, {"covariant": 2.0, "bend": 9.0, "root": 0.001}, 0)
    assert bad.stands_out
    assert bad.text == "walk seed 17: 7.5 × (left_knee), left_ankle 70 cm away; E = 11 (bend 9, covariant 2)"


@pytest.mark.slow
def test_solving_is_what_the_command_does(benchmark, run):
    from dynsplines.system.progress import Progress

    done = solving.solve(clips.load("run_loop"), Progress())
    np.testing.assert_array_equal(done.motion.timeline.rows, run.timeline.rows)
