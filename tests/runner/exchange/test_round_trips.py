"""Formats for figures of their own have the same qpos when read back; those for any figure: test_random_robots."""

import pytest
import wild
from round_trip import check_round_trip

from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording


@pytest.mark.slow
def test_the_humanoid_of_deepmimic_and_the_skeleton_of_a_bvh_file_come_back(tmp_path):
    knees = wild.with_hinges(wild.motion_of("human", spread=0.8), "knee", "elbow")
    check_round_trip(knees, "deepmimic", tmp_path, "human")
    first = formats.export(wild.motion_of("human"), "bvh", tmp_path / "first.bvh")
    check_round_trip(import_recording(first), "bvh", tmp_path, None)
