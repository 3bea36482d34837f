"""Clips that turn: headings beside rotations, loops that come back turned, what edits and files make of them."""

import pickle
from pathlib import Path

import numpy as np
import problems
import pytest
from processes import quiet
from scipy.spatial.transform import Rotation

from dynsplines import motion, recordings, solving
from dynsplines.clip import load as clips
from dynsplines.clip.load import clip_from_motion
from dynsplines.clip.mirror import mirrored_tables
from dynsplines.clip.table import ClipTable, KeyframeTable, RootTable, RotationTable, SolveTable
from dynsplines.edit import edits
from dynsplines.edit.thinning import recorded_of
from dynsplines.exchange import formats
from dynsplines.measure.report import report as measured
from dynsplines.motion import Saved
from dynsplines.scene.compose import figure_spec
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit.thin import thin
from dynsplines.solver.figure.figure import Figure

ENDS = 'frames = 2\nends = "periodic"\n'
LAST = "root.position = [0.3, 0, 1]\nroot.rotation = {rotvec = [0, 10, 170]}"
LAST_TURNED = "root.position = [0.3, 0.1, 1]\nroot.rotation = {heading = 45}"
TOLD = problems.changed("frames = 2\n", ENDS).replace(LAST, LAST_TURNED)
GIVEN = problems.changed("frames = 2\n", ENDS + "travel = [0.3, 0.1, 0]\nturn = 45\n").replace(LAST, "")


def solved(folder: Path, text: str) -> Saved:
    return solving.solve(recordings.load(str(problems.written(folder, text))), quiet())


@pytest.fixture(scope="module")
def circle(tmp_path_factory: pytest.TempPathFactory) -> Saved:
    """A loop that turns by an eighth, as its keyframes specify."""
    return solved(tmp_path_factory.mktemp("circle"), TOLD)


def test_the_solve_table_turns_a_loop_as_its_last_keyframe_does(circle, tmp_path):
    given = solved(tmp_path, GIVEN)
    one, two = (Seam.of(each.figure, each.timeline) for each in (given, circle))
    np.testing.assert_allclose(one.headings, two.headings)
    np.testing.assert_allclose(one.travel[:3], two.travel[:3], atol=1e-12)


@pytest.mark.parametrize(
    ("entry", "wanted"),
    [
        ("{heading = 120}", Rotation.from_euler("z", 120, degrees=True)),
        (
            "{euler = [5, -40, 10], heading = 30}",
            Rotation.from_euler("z", 30, degrees=True) * Rotation.from_euler("XYZ", [5, -40, 10], degrees=True),
        ),
        ("{rotvec = [0, 20, 0], heading = -90}", Rotation.from_euler("ZY", [-90, 20], degrees=True)),
        ("{quat = [1, 1, 0, 0], heading = 10}", Rotation.from_euler("ZX", [10, 90], degrees=True)),
    ],
)
def test_a_heading_turns_the_rest_of_a_rotation_about_the_vertical(tmp_path, entry, wanted):
    text = problems.changed("root.rotation = {rotvec = [0, 0, 0]}", f"root.rotation = {entry}")
    key = recordings.load(str(problems.written(tmp_path, text))).keys[0]
    assert (Rotation.from_quat(key.state[3:7], scalar_first=True).inv() * wanted).magnitude() < 1e-12


def test_a_body_and_an_obstacle_take_a_heading(tmp_path):
    ways = ("{rotvec = [0, 8, 0], heading = 30}", '{euler = [30, 8], order = "zy"}')
    text = (
        problems.CLIP
        + '[[scene.box]]\nname = "crate"\nposition = [3, 0, 0.5]\nsize = [1, 1, 1]\nrotation = {heading = 20}\n'
    )
    shins = []
    for way in ways:
        own = problems.changed("joints.left_knee = {rotvec = [0, 0, 0]}", f"bodies.left_shin = {way}", text)
        found = recordings.load(str(problems.written(tmp_path, own)))
        shins.append(found.keys[0].state[7:11])
        crate = Rotation.from_quat(found.figure.model.geom("crate").quat, scalar_first=True)
        assert (crate.inv() * Rotation.from_euler("z", 20, degrees=True)).magnitude() < 1e-6
    assert abs(shins[0] @ shins[1]) == pytest.approx(1, abs=1e-9)
    assert 0.9 < abs(shins[0][0]) < 0.999


@pytest.mark.slow
def test_a_loop_comes_back_turned_and_smooth_and_its_report_contains_it(circle):
    seam = Seam.of(circle.figure, circle.timeline)
    assert np.degrees(seam.headings) == pytest.approx([45])
    np.testing.assert_allclose(seam.travel[:3], [0.3, 0.1, 0], atol=1e-12)
    assert seam.discontinuity(path_of(circle.timeline)).max() < 1e-9
    report = measured(clip_from_motion(circle), circle)
    for side in ("before", "after"):
        found = report[side]["seam"]
        assert found["turn, degrees"] == pytest.approx(45)
        assert max(found[name] for name in ("state", "first derivative", "second derivative")) < 1e-9


def test_a_turning_loop_played_on_goes_round(circle):
    many = edits.repeat(circle, 8)
    first, last = circle.figure.to_qpos(many.timeline.states[[0, -1]])
    assert abs(first[3:7] @ last[3:7]) == pytest.approx(1)
    np.testing.assert_allclose(last[:3], first[:3], atol=1e-9)  # eight eighths are the whole way round
    assert clips.of_motion(many).ends == "periodic"


def test_a_turning_loop_is_saved_retimed_and_thinned_as_one(circle, tmp_path):
    motion.save(circle, tmp_path / "circle.npz")
    again = motion.load(tmp_path / "circle.npz")
    for each in (again, edits.retime(again, 1.5)):
        seam = Seam.of(each.figure, each.timeline)
        assert np.degrees(seam.headings) == pytest.approx([45])
        assert seam.discontinuity(path_of(each.timeline)).max() < 1e-8
    recorded = recorded_of(again, 0.05, 0.2)
    _, few = thin(recorded)
    assert recorded.excess(few).max() <= 1
    assert np.degrees(Seam.of(again.figure, few).headings) == pytest.approx([45])


def test_formats_whose_loops_only_travel_get_no_loop_and_a_note(circle, tmp_path):
    notes = []
    target = formats.export(circle, "mimickit", tmp_path / "a.mimickit.pkl", fps=20.0, report=notes.append)
    assert pickle.loads(target.read_bytes())["loop_mode"] == 0
    assert notes == ["the format has no loops that rotate: one period is written, without a loop"]


def test_a_mirrored_clip_turns_the_other_way():
    figure = Figure(figure_spec("human").compile())
    rotation = {"euler": [5.0, -10.0, 3.0], "heading": 40.0}
    solve = SolveTable(travel=(1.0, 0.5, 0.0), turn=45.0)
    table = RotationTable.model_validate(rotation)
    clip = ClipTable(figure="human", solve=solve, keyframe=[KeyframeTable(time=0.0, root=RootTable(rotation=table))])
    mirrored = mirrored_tables(clip, figure, Mirror.of(figure))
    assert mirrored.solve == SolveTable(travel=(1.0, -0.5, 0.0), turn=-45.0)
    image = mirrored.keyframe[0].root.rotation
    assert isinstance(image, RotationTable)
    one, two = table.quaternion(), image.quaternion()
    np.testing.assert_allclose(two, one * [1, -1, 1, -1], atol=1e-12)
