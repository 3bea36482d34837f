"""The commands export and import as a user meets them: what they say, and what can be done with an imported motion."""

from pathlib import Path

import motions
import pytest
from processes import refusal
from texts import read_cases

from dynsplines import motion
from dynsplines.exchange import formats


@pytest.fixture
def run(tmp_path, monkeypatch, command):
    """Runs the command in a folder with a robot's motion in it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot.xml").write_text(motions.ROBOT)
    motion.save(motions.motion_of("robot.xml"), tmp_path / "wild.npz")
    return command


@pytest.mark.slow
def test_an_imported_motion_is_measured_when_a_report_is_requested(run, tmp_path):
    assert (
        run("export", "wild.npz", "--to", "mjlab").last == "wrote wild.mjlab.npz"
    )  # beside it, no other: it has no ball joints
    assert sorted(path.name for path in tmp_path.iterdir()) == ["robot.xml", "wild.mjlab.npz", "wild.npz"]
    assert run("import", "wild.mjlab.npz", "--figure", "robot.xml", "-o", "back.npz").code == 0
    done = run("report", "back.npz")
    assert done.code == 0 and "not searched: imported" in " ".join(done.out.split()) and "objective" in done.out


def test_formats_are_listed_and_a_wrong_one_is_reported(run):
    rows = {line.split()[0]: line for line in run("formats").out.splitlines()}
    assert {"csv", "npz", "mjcf", "mjlab", "mjlab-csv", "locomujoco", "gmr", "mimickit"} <= rows.keys()
    assert "reads and writes" in rows["gmr"] and "writes" not in rows["amass"]
    assert "read only; written are: csv" in refusal(run("export", "wild.npz", "--to", "amass"))
    assert "did you mean 'mjlab" in refusal(run("export", "wild.npz", "--to", "mjlb"))


@pytest.mark.slow
def test_an_export_is_called_after_what_it_came_from(run, tmp_path):
    (tmp_path / "wild.npz").rename(tmp_path / "v1.npz")  # whose name inside is still wild
    assert run("export", "v1.npz", "--to", "csv").last == "wrote v1.csv"
    assert run("export", "v1.npz", "--to", "simulate").code == 0
    assert {path.name for path in tmp_path.iterdir()} == {"robot.xml", "v1.npz", "v1.csv", "v1.simulate.xml"}


@pytest.mark.slow
def test_more_columns_are_for_tables(run, tmp_path):
    assert run("export", "wild.npz", "--to", "csv", "--with", "velocities,torques").code == 0
    assert "arm_pitch.t [N m]" in (tmp_path / "wild.csv").read_text().splitlines()[0]
    refused = refusal(run("export", "wild.npz", "-o", "a.bvh", "--with", "all"))
    assert "'bvh' cannot hold columns of forces or velocities; csv can" in refused
    assert "did you mean 'torques'" in refusal(run("export", "wild.npz", "-o", "a.csv", "--with", "torqes"))
    assert not list(tmp_path.glob("a.*"))


def test_the_longest_ending_selects_the_format_and_is_dropped_and_one_that_fits_goes_with_a_formats_name():
    stems = {"in/a.b.mjlab.csv": "a.b", "A.KEYS.XML": "A", "a.b.csv": "a.b", ".csv": ".csv", "a.b.pkl": "a.b", "a": "a"}
    assert {name: formats.stem(Path(name)) for name in stems} == stems
    kinds = {"a.bvh": "bvh", "a.MJLAB.csv": "mjlab-csv", "a.csv": "csv", "t.glb": "gltf", "t.keys.xml": "mjcf"}
    assert {name: formats.choose(None, Path(name)).name for name in kinds} == kinds
    for name, kind in (("a.npz", "mjlab"), ("a.xml", "mjcf"), ("A.BVH", "bvh")):
        assert formats.choose(kind, Path(name)).name == kind


@pytest.mark.parametrize(("words", "told"), read_cases("export_names.toml"))
def test_a_name_that_does_not_fit_is_refused_before_anything_is_written(run, tmp_path, words, told):
    assert told in refusal(run("export", "wild.npz", *words))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["robot.xml", "wild.npz"]


@pytest.mark.parametrize(("words", "told"), read_cases("import_names.toml"))
def test_a_file_that_is_not_read_is_refused(run, words, told):
    assert told in refusal(run("import", *words, "-o", "new.npz"))


def test_an_import_reports_violations_as_solve_does(run, tmp_path):
    rows = "\n".join("0,0,-0.5,1,0,0,0,0,0,0,0,0" for _ in range(5))
    (tmp_path / "low.csv").write_text(rows + "\n")
    words = ("import", "low.csv", "--from", "csv", "--figure", "robot.xml", "--fps", "30", "-o", "low.npz")
    done = run(*words)
    first, *violations = done.err.splitlines()
    assert (done.code, first) == (0, "wrote low.npz")
    assert "violation: base is 600 mm in the floor at 0.00 s, 5 samples in all" in violations
    assert len({line.split()[1] for line in violations}) == len(violations)  # one line a body
    assert run(*words, "--strict", "--overwrite").code == 3 and (tmp_path / "low.npz").exists()
