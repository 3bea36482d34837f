"""`dynsplines thin`: from motions and recordings to clips that give the same motion, measured on what was written."""

import re
from pathlib import Path

import motions
import numpy as np
import pytest
from problems import LOOP, names, written

from dynsplines import motion, recordings, solving
from dynsplines.edit import edits, thinning
from dynsplines.edit.thinning import recorded_of, thin_motion
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.motion import Saved
from dynsplines.solver.curve.spline import path_of
from dynsplines.system.progress import Progress
from dynsplines.system.quantity import length

BOUND = (0.02, np.radians(5))
FINE = (0.002, np.radians(5))


@pytest.fixture(scope="module")
def loop(tmp_path_factory: pytest.TempPathFactory) -> Saved:
    """A loop of the tiny figure as its raw spline."""
    path = written(tmp_path_factory.mktemp("loop"), LOOP)
    return solving.raw_spline(recordings.load(str(path)))


def run(
    source: Path | str,
    target: Path | None = None,
    *,
    bound: tuple[float, float] = BOUND,
    solve: bool = False,
    overwrite: bool = False,
    **told,
) -> Path:
    return thinning.run(str(source), bound, target, solve=solve, overwrite=overwrite, progress=Progress(), **told)


def apart(one: Saved, other: Saved) -> float:
    """The largest distance of a body or site [m] between two motions."""
    recorded = recorded_of(one, *BOUND)
    return recorded.worst(other.timeline)[0][0]


@pytest.mark.parametrize(("text", "metres"), [("2cm", 0.02), ("20 mm", 0.02), ("1e-3 m", 0.001), (2, 2.0)])
def test_lengths_are_read_with_their_units(text, metres):
    assert length(text, "--max-error") == pytest.approx(metres, rel=1e-12)


UNIT = "{}: the unit is missing; give {:g}cm, .*mm or .*m$"


@pytest.mark.parametrize("text", ["2", " 1e-3 ", "0", "-1cm", "cm", "2 inches", "nan"])
def test_what_is_no_length_is_refused(text):
    words = UNIT.format(text, float(text)) if text in ("2", " 1e-3 ") else ".*such as 2cm"
    with pytest.raises(UserError, match=f"--max-error {words}"):
        length(text, "--max-error")


def test_the_spline_through_a_thinned_clips_keyframes_is_the_motion_that_was_measured(motion_file, tmp_path, capsys):
    target, measured = tmp_path / "step.toml", motion.load(motion_file)
    run(motion_file, target)
    again = solving.raw_spline(recordings.load(str(target)))
    told = " ".join(capsys.readouterr().err.split())
    said = re.search(r"(\d+) keyframes of (\d+); at most ([\d.]+) cm at ([\d.]+) s \(([\w ]+)\)", told)
    assert said, told
    assert int(said[1]) == len(again.keys) < 15
    assert float(said[3]) == pytest.approx(100 * apart(measured, again), rel=0.01)
    assert apart(measured, again) <= 0.02
    fine = np.arange(0, 0.41, 1e-3)  # between the instants looked at, too
    one, other = (each.figure.to_qpos(path_of(each.timeline).at(fine)) for each in (measured, again))
    assert np.abs(one - other)[:, :3].max() < 0.025


def test_a_loop_stays_a_loop_in_its_clip(loop, tmp_path):
    source, target = tmp_path / "loop.npz", tmp_path / "loop_thin.toml"
    motion.save(loop, source)
    run(source, target)
    found = recordings.load(str(target))
    assert found.ends == "periodic"
    assert np.array(found.problem.travel)[0] == pytest.approx(0.3)
    assert not found.context.schedule.on_ground  # those of the clip that was solved


def test_a_searched_clip_is_reported_beside_its_spline_and_keeps_the_bound_where_that_is_requested(
    loop, tmp_path, capsys
):
    source, target, step = tmp_path / "step.npz", tmp_path / "step.toml", edits.trim(loop, 0.1, 0.4)
    motion.save(step, source)
    run(source, tmp_path / "spline.toml", bound=FINE)
    spline, solved = (
        float(number) for number in re.findall(r"at most ([\d.]+) cm", "".join(capsys.readouterr().err.splitlines()))
    )
    head = (tmp_path / "spline.toml").read_text().splitlines()[0]
    assert f"at most {spline:g} cm" in head and f"at most {solved:.3g} cm" in head
    run(source, target, bound=FINE, solve=True)
    off = []
    for file in (tmp_path / "spline.toml", target):
        found = recordings.load(str(file))
        assert found.settings.max_evaluations > 1 and found.settings.variable != 0
        again = solving.solve(found, Progress())
        assert again.timeline.variable_count > 0
        off.append(apart(step, again))
    assert spline <= 0.2 < solved  # few keyframes are too few for what the search changes
    assert solved == pytest.approx(100 * off[0], rel=0.01)
    assert off[1] <= FINE[0] * (1 + 1e-6)


def test_a_recording_is_thinned_at_its_own_instants_and_its_figure_named_if_it_ships(tmp_path, capsys):
    spin, source = motions.motion_of("spinner", start=0.1), tmp_path / "step.csv"
    formats.export(spin, "csv", source, fps=60)
    target = run(source, tmp_path / "again.toml", figure="spinner")
    assert "keyframes of 73;" in capsys.readouterr().err
    on_grid = (np.array([key.time for key in recordings.load(str(target)).keys]) - 0.1) * 60
    np.testing.assert_allclose(on_grid, on_grid.round(), atol=1e-6)
    assert names(tmp_path) == ["again.toml", "step.csv"]
    assert 'figure = "spinner"' in target.read_text()
    source = tmp_path / "walk.qpos.npz"  # plain arrays are a recording by their ending
    formats.export(edits.trim(spin, 0.1, 0.2), "npz", source)
    assert len(recordings.load(str(run(source, tmp_path / "thin.toml"))).keys) < 6


@pytest.mark.slow
def test_another_scene_is_written_next_to_the_clip(motion_file, tmp_path):
    target = run(motion_file, tmp_path / "small.toml")
    assert names(tmp_path) == ["small.toml", "small.xml"]
    found = recordings.load(str(target))
    assert [link.name for link in found.figure.links[1:]] == ["root", "left_knee"]
    target.unlink()
    run(motion_file, target)  # the same scene is no other one
    target.unlink()
    (tmp_path / "small.xml").write_text("<mujoco/>")
    with pytest.raises(UserError, match=r"small\.xml' already exists.*overwrite"):
        run(motion_file, target)
    run(motion_file, target, overwrite=True)


@pytest.mark.parametrize("ending", [".csv", ".bvh", ""])
def test_other_endings_are_refused_before_anything_is_read(ending, tmp_path):
    with pytest.raises(UserError, match=r"as a clip, \.toml, or as a motion, \.npz"):
        run("nowhere.npz", tmp_path / f"out{ending}")


def test_bounds_that_make_no_sense_are_refused(saved):
    for angle in (0.0, 181.0):
        with pytest.raises(UserError, match="--max-angle"):
            thinning.bound_of("2cm", angle, ("--max-error", "--max-angle"))
    for distance in (0.0, np.nan, np.inf):
        with pytest.raises(UserError, match="more than 0"):
            thin_motion(saved, distance, 0.1)
