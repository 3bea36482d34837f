"""A limb that would go through an obstacle goes over it, measured by MuJoCo at 1 kHz."""

from __future__ import annotations

import io

import pytest
from paper.penetration import penetration
from rail import OBSTACLES, WITHOUT, written
from rich.console import Console

from dynsplines import solving
from dynsplines.clip import load as clip
from dynsplines.motion import sampled
from dynsplines.system.progress import Progress


def deepest(path: str) -> float:
    """Deepest penetration [m] of a clip's solved motion at 1 kHz."""
    solved = solving.solve(clip.load(path), Progress(Console(file=io.StringIO())))
    run = sampled(solved.clip.figure, solved.motion.timeline, 1000.0)
    return penetration(solved.clip.figure.model, run.time, run.qpos).deepest


@pytest.mark.slow
@pytest.mark.parametrize("obstacle", OBSTACLES)
def test_a_limb_goes_through_an_obstacle_without_the_penalty_and_at_most_two_millimetres_with_it(tmp_path, obstacle):
    assert deepest(written(tmp_path, obstacle, WITHOUT)) > 0.015
    assert deepest(written(tmp_path, obstacle)) <= 0.002
