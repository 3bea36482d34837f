"""The command as a user meets it: what it writes, what it says where, and one clear line for every mistake."""

import contextlib
import importlib
import json
import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from operator import itemgetter
from pathlib import Path
from typing import Any

import crew
import nlopt
import numpy as np
import pytest
from PIL import Image
from problems import CLIP, FIGURE, HINGE, LOOP, changed, written
from processes import Command, Done, refusal
from typer.main import get_command

from dynsplines import cli, models, motion, solving
from dynsplines.clip.kinds import KINDS
from dynsplines.exchange import formats
from dynsplines.picture import graphics, show

SMALL = ("--size", "32x32")
COMMANDS: dict[str, Any] = get_command(cli.app).commands  # type: ignore[attr-defined]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: Command) -> Command:
    """Runs the command in an empty folder with the tiny clip in it."""
    monkeypatch.setattr(graphics, "_draws", lambda _: False)  # software
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back
    monkeypatch.chdir(tmp_path)
    written(tmp_path)
    return command


@pytest.fixture
def solving_forbidden(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object, **__: object) -> None:
        raise AssertionError("solved again")

    for name in ("inbetween", "solve"):
        monkeypatch.setattr(solving, name, never)
    monkeypatch.setattr(nlopt.opt, "optimize", never)


def assert_refused(done: Done, *words: str) -> None:
    line = refusal(done)
    for word in words:
        assert word in line
    assert not re.search(r"\bframe\b", line), "a user has keyframes"


def test_the_version_is_reported_and_that_of_mujoco(run: Command) -> None:
    done = run("--version")
    assert done.code == 0
    assert re.fullmatch(r"dynsplines \d+\.\d+\.\d+, MuJoCo \d+\.\d+\.\d+, solving with .*\n", done.out)


def told_last(done: Done) -> str:
    """The last line but for what is wrong with the motion."""
    return [line for line in done.err.splitlines() if not line.startswith("violation: ")][-1]


def size_of(path: Path) -> tuple[int, int]:
    with Image.open(path) as image:
        return image.size


@contextlib.contextmanager
def nothing_written(folder: Path) -> Iterator[None]:
    before = {path: path.read_bytes() if path.is_file() else b"" for path in folder.rglob("*")}
    yield
    assert {path: path.read_bytes() if path.is_file() else b"" for path in folder.rglob("*")} == before


# what works


def test_solve_writes_a_motion_named_after_its_clip(run, tmp_path):
    for words, count in (((), 9), (("--fps", 100), 42)):
        done = run("solve", "tiny.toml", *words)
        assert (done.code, done.out) == (0, "")
        assert told_last(done) == "wrote tiny.npz"
        assert any(line.startswith("solving") and "objective" in line for line in done.err.splitlines())
        with np.load(tmp_path / "tiny.npz") as data:
            assert data["qpos"].shape == (count, 11)


def test_clips_from_other_editors_are_read(run, tmp_path):
    (tmp_path / "UPPER.TOML").write_bytes(CLIP.replace("\n", "\r\n").encode("utf-8-sig"))
    assert run("solve", "UPPER.TOML", "-o", "m.npz").code == 0


def test_report_of_a_motion_does_not_solve(run, motion_file, solving_forbidden):
    done = run("report", motion_file)
    assert done.code == 0
    assert {line.split()[0] for line in done.err.splitlines()} <= {"measuring"}
    assert "keyframe error" in done.out
    strict = json.loads(run("report", motion_file, "--json").out, parse_constant=lambda name: pytest.fail(name))
    assert strict["keyframes"] == 3


@pytest.mark.slow
def test_plot_of_a_motion_does_not_solve(run, motion_file, solving_forbidden, tmp_path):
    done = run("plot", motion_file)
    assert (done.code, done.out, done.err) == (0, "", "wrote tiny.png\n")
    assert size_of(tmp_path / "tiny.png") == (1440, 540)


@pytest.mark.parametrize(
    ("ending", "only", "at", "magic"),
    [("mp4", "", 4, b"ftyp"), ("gif", "before", 0, b"GIF8"), ("webm", "after", 0, b"\x1aE\xdf\xa3"),
     ("png", "keys", 0, b"\x89PNG")],
)  # fmt: skip
def test_the_ending_selects_what_is_rendered_and_a_motion_is_not_solved(
    run, motion_file, solving_forbidden, tmp_path, ending, only, at, magic
):
    words = ("--only", only, "-o", f"tiny.{ending}") if only else ()
    done = run("render", motion_file, *SMALL, "--fps", 5, *words)
    assert (done.code, done.out) == (0, "")
    assert done.err.splitlines()[0].startswith("renderer: ")
    assert told_last(done) == f"wrote tiny.{ending}"
    assert (tmp_path / f"tiny.{ending}").read_bytes()[at:].startswith(magic)


def test_ghosts_make_a_still_of_the_requested_size(run, motion_file, tmp_path):
    assert run("render", motion_file, "--ghosts", "--size", "48x40", "--camera", "high").code == 0
    assert size_of(tmp_path / "tiny.png") == (48, 40)


@pytest.mark.slow
def test_render_of_a_clip_solves_it_unless_only_the_keyframes_are_wanted(run, monkeypatch):
    solved: list[str] = []
    solve = solving.solve
    monkeypatch.setattr(solving, "solve", lambda clip, progress: solved.append(clip.name) or solve(clip, progress))
    for only in ("keys", "before"):
        assert run("render", "tiny.toml", *SMALL, "--only", only, "--fps", 5).code == 0
    assert solved == []
    assert run("render", "tiny.toml", *SMALL, "--fps", 5, "--slow", 2).code == 0
    assert solved == ["tiny"]


def test_clips_and_models_are_listed_with_what_they_are(run):
    for command, found in (("clips", models.clips()), ("models", models.figures())):
        done = run(command)
        assert (done.code, done.err) == (0, "")
        assert [line.split()[0] for line in done.out.splitlines()] == list(found)
        assert all(line in done.out for line in found.values())


def test_soft_constraints_are_listed_with_weights_options_and_units(run):
    done = run("penalties")
    assert (done.code, done.err) == (0, "")
    assert [line.split()[0] for line in done.out.splitlines() if not line.startswith(" ")] == list(KINDS)
    assert "collision\n  soles         30  depth of heels and toes" in done.out
    assert f"{'':20}speed (degrees/s)\n" in done.out
    told = {row["kind"]: row for row in json.loads(run("penalties", "--json").out)}
    assert told["support"]["options"] == {"friction": "coefficient; default 0.8"}
    assert told["attach"]["options"] == {}
    weights = {part["part"]: part["weight"] for part in told["attach"]["parts"]}
    assert weights == {"stance": 30, "contact": 750, "grasp": 750}
    assert [part["is on"] for part in told["collision"]["parts"]] == [True, True, True]
    assert not told["torque"]["parts"][0]["is on"]


def test_the_help_groups_all_commands_and_cuts_no_summary(run, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    lines = run("--help").out.splitlines()
    panels = [line.rstrip(":") for line in lines if re.fullmatch(r"[A-Z]\w+:", line)]
    assert panels == ["Options", "Create", "Edit", "Analyse", "Exchange", "Recordings", "Batch"]
    listed = dict(line.split(maxsplit=1) for line in lines[lines.index("Create:") :] if line.startswith("  "))
    assert listed.keys() == COMMANDS.keys()
    for name, command in COMMANDS.items():
        assert command.help.partition("\n")[0] == f"{listed[name]}."
        assert len(listed[name]) < 60


@pytest.mark.parametrize("name", COMMANDS)
def test_the_help_of_a_command_has_all_options_with_units_and_defaults(run, name):
    text = "".join(run(name, "--help").out.split())
    for option in COMMANDS[name].params:
        words = option.help.replace(" ", "")
        assert words in text
        if option.param_type_name == "option" and not option.is_flag:
            assert option.metavar  # such as SECONDS
            assert option.required or f"{words}[default:" in text


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_help_is_quick_because_it_imports_nothing_heavy(option):
    script = (
        f"import sys; from dynsplines import cli; sys.argv = ['dynsplines', '{option}']\n"
        "try: cli.main()\nexcept SystemExit: pass\n"
        "print(sorted({'mujoco', 'numpy', 'scipy', 'nlopt', 'matplotlib', 'pydantic', 'av', 'PIL'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
    assert done.stdout.splitlines()[-1] == "[]"


@pytest.mark.slow
def test_what_draws_nothing_needs_no_graphics_and_the_threads_requested_change_no_byte(run, tmp_path):
    script = (
        "import sys; from dynsplines import cli\nimported = []\n"
        "for words in (['solve', 'tiny.toml'], ['report', 'tiny.npz']):\n"
        "    sys.argv = ['dynsplines', *words]\n"
        "    try: cli.main()\n    except SystemExit as end: assert not end.code\n"
        "    imported.append(sorted({'glfw', 'OpenGL', 'matplotlib', 'av', 'PIL'} & set(sys.modules)))\n"
        "print(imported)"
    )
    settings = os.environ | {"MUJOCO_GL": "nonsense", "OMP_NUM_THREADS": "4", "OPENBLAS_NUM_THREADS": "4"}
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, cwd=tmp_path, env=settings, check=True, capture_output=True, text=True)
    assert done.stdout.splitlines()[-1] == "[[], []]"
    of_four_threads = (tmp_path / "tiny.npz").read_bytes()
    assert run("solve", "tiny.toml").code == 0
    assert (tmp_path / "tiny.npz").read_bytes() == of_four_threads


# mistakes in the clip

MISTAKES = tomllib.loads((Path(__file__).parent / "mistakes.toml").read_text(encoding="utf-8"))


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MISTAKES["clip"], ids=itemgetter("name"))
def test_a_mistake_in_a_clip_is_one_line_that_says_where(run, tmp_path, mistake):
    text = mistake.get("before", "") + mistake.get("text", CLIP) + mistake.get("after", "")
    text = changed(*mistake["change"]) if "change" in mistake else text
    text = "a = " + mistake["repeat"][0] * mistake["repeat"][1] if "repeat" in mistake else text
    (tmp_path / "bad.toml").write_text(text, encoding="utf-8")
    with nothing_written(tmp_path):
        assert_refused(run("solve", "bad.toml"), "bad.toml: ", *mistake["told"])


def test_text_that_is_not_utf_8_is_reported_as_such(run, tmp_path):
    (tmp_path / "bad.toml").write_bytes(CLIP.replace("Three", "Dr\u00e9i").encode("latin-1"))
    with nothing_written(tmp_path):
        assert_refused(run("solve", "bad.toml"), "bad.toml", "not UTF-8", "byte 5")


@pytest.mark.parametrize("mistake", MISTAKES["mjcf"], ids=itemgetter("name"))
def test_a_mistake_in_an_mjcf_is_one_line(run, tmp_path, mistake):
    text = mistake.get("text") or HINGE.format(keys=mistake["keys"])
    (tmp_path / "bad.xml").write_text(text, encoding="utf-8")
    with nothing_written(tmp_path):
        assert_refused_whatever_mujoco_says(run("new", "bad.xml", "-o", "a.toml"), "bad.xml", mistake["told"])


def assert_refused_whatever_mujoco_says(done: Done, *words: str) -> None:
    assert (done.code, done.out) == (2, "")
    (line,) = (line for line in done.err.splitlines() if not line.startswith("note: MuJoCo: "))
    assert all(word in line for word in words)


@pytest.mark.parametrize("figure", ["<mujoco", FIGURE.replace("freejoint", "freejiont")])
def test_a_broken_figure_of_a_clip_names_the_clip_and_the_figure(run, tmp_path, figure):
    (tmp_path / "tiny.xml").write_text(figure, encoding="utf-8")
    with nothing_written(tmp_path):
        assert_refused_whatever_mujoco_says(run("solve", "tiny.toml"), "tiny.toml: tiny.xml: MuJoCo cannot read it")


# mistakes on the command line

MOTION = "MOTION"


@pytest.mark.parametrize("mistake", MISTAKES["command"], ids=lambda mistake: " ".join(mistake["words"]))
def test_a_mistake_on_the_command_line_is_one_line_and_writes_nothing(run, tmp_path, motion_file, monkeypatch, mistake):
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder.npz").mkdir()
    (tmp_path / "tiny.txt").write_text("hello", encoding="utf-8")
    np.savez(tmp_path / "poses.npz", time=np.arange(2.0), qpos=np.zeros((2, 2)))
    monkeypatch.setattr(solving, "solve", lambda *_: pytest.fail("solved before it looked"))
    with nothing_written(tmp_path):
        words = (motion_file if word == MOTION else word for word in mistake["words"])
        assert_refused(run(*words), *mistake["told"])


WRITING = [
    ("new", "hinge.xml", "-o", "there.toml"),
    ("trim", MOTION, "--to", "0.3", "-o", "there.npz"),
    ("thin", MOTION, "--max-error", "20mm"),
    ("thin", MOTION, "-o", "there.npz"),
    ("export", MOTION, "--to", "csv", "-o", "there.csv"),
    ("export", MOTION, "--to", "csv"),
    ("import", "poses.csv", "--figure", "tiny.xml"),
]


@pytest.mark.slow
@pytest.mark.parametrize("words", WRITING, ids=" ".join)
def test_a_file_that_is_there_stays_by_default(run, tmp_path, motion_file, words):
    formats.export(motion.load(motion_file), "csv", tmp_path / "poses.csv")
    words = [motion_file if word == MOTION else word for word in words]
    target = Path(
        words[-1]
        if "-o" in words
        else {"thin": "tiny_thin.toml", "export": "tiny.csv", "import": "poses.npz"}[words[0]]
    )
    target.write_text("mine", encoding="utf-8")
    with nothing_written(tmp_path):
        assert_refused(run(*words), f"'{target}' already exists; give another -o, or --overwrite")
    assert run(*words, "--overwrite").code == 0
    assert target.read_bytes() != b"mine"


UNITS = ("HZ", "N", "SECONDS", "FACTOR", "MB", "DEGREES", "METRES", "PORT")
NUMBERS = {  # one command of each option with one range
    (each.opts[-1], (each.help or "").rpartition(", ")[2]): (name, each)
    for name in COMMANDS
    for each in COMMANDS[name].params
    if each.metavar in UNITS
}.values()


@pytest.mark.parametrize(("name", "option"), NUMBERS, ids=lambda v: v if isinstance(v, str) else v.opts[0])
def test_a_number_that_is_none_or_out_of_its_range_is_refused(run, tmp_path, name, option):
    """The range is read from the help."""
    span = re.search(r"(?:, (\S+) (?:to (\S+)|or more))?$", option.help)
    assert span is not None
    wrong = ["nan", "many"]
    if span[1] is not None:
        wrong += [str(float(span[1]) - 1e-6), *([f"{2 * float(span[2]):.0f}"] if span[2] else [])]
    if option.metavar in ("N", "PORT"):
        wrong += ["2e0"]
    with nothing_written(tmp_path):
        for word in wrong:
            assert re.match(rf"{option.opts[-1]} .*: give a (whole )?number", refusal(run(name, option.opts[-1], word)))


@pytest.mark.parametrize("content", ['{"before": {}}', '{"before": 1, "after": 2}'])
def test_a_motion_with_the_report_of_an_older_version_is_measured_again(run, tmp_path, motion_file, content):
    with np.load(motion_file) as data:
        np.savez(tmp_path / "m.npz", **{**data, "report": content})  # type: ignore[arg-type]
    done = run("report", "m.npz")
    assert done.code == 0
    assert "largest whip" in done.out


@pytest.mark.parametrize(
    "content", ['{"before": {}, "after": {"largest": {}}}', '{"before": 1, "after": {"largest": 2}}']
)
def test_a_motion_with_half_a_report_is_one_line(run, tmp_path, motion_file, content):
    with np.load(motion_file) as data:
        np.savez(tmp_path / "m.npz", **{**data, "report": content})  # type: ignore[arg-type]
    with nothing_written(tmp_path):
        assert_refused(run("report", "m.npz"), "m.npz", "its report is not complete")


def test_what_went_wrong_in_drawing_is_reported_and_nothing_is_written(run, tmp_path, motion_file, monkeypatch):
    monkeypatch.setattr(show, "_stage", crew.locked)
    with nothing_written(tmp_path):
        done = run("render", motion_file, *SMALL)
    assert (done.code, done.out, done.err.splitlines()[-1]) == (2, "", "dynsplines: the bench is locked")


# loops and edits


@pytest.mark.slow
def test_a_travelling_loop_is_solved_repeated_and_rendered(run, tmp_path):
    (tmp_path / "loop.toml").write_text(LOOP, encoding="utf-8")
    assert run("solve", "loop.toml").code == 0
    done = run("solve", "loop.toml", "--repeat", 3, "-o", "three.npz", "--json")
    assert done.code == 0
    assert json.loads(done.out)["duration, s"] == pytest.approx(3 * 0.41)
    measured = json.loads(run("report", "three.npz", "--json").out)
    assert measured["after"]["seam"]["travel, m"] == pytest.approx([0.9, 0, 0])
    assert measured["stopped because"] == "one period was solved and is played 3 times"
    with np.load("loop.npz") as one, np.load("three.npz") as three:
        assert len(three["time"]) == int(3 * 0.41 * 20) + 1
        np.testing.assert_allclose(three["qpos"][:9], one["qpos"], atol=1e-9)
        assert len(three["key_time"]) == 7
    assert "seam: state" in run("report", "loop.npz").out
    assert run("render", "loop.toml", *SMALL, "--fps", 5, "--repeat", 2, "-o", "twice.gif").code == 0
    with Image.open(tmp_path / "twice.gif") as film:
        assert getattr(film, "n_frames", 1) == int(2 * 0.41 * 5) + 1
    assert run("render", "loop.npz", *SMALL, "--repeat", 2, "--at", 0.8, "-o", "late.png").code == 0


@pytest.mark.slow
def test_edits_write_a_motion_named_after_what_is_done(run, motion_file, tmp_path):
    assert told_last(run("trim", motion_file, "--from", 0.1, "--to", 0.3)) == "wrote tiny_trimmed.npz"
    assert told_last(run("retime", motion_file, "--speed", 2)) == "wrote tiny_retimed.npz"
    assert told_last(run("retime", "tiny.toml", "--duration", 3)) == "wrote tiny_retimed.toml"
    report = json.loads(run("report", "tiny_trimmed.npz", "--json").out)
    assert report["stopped because"] == "not searched: trimmed"


# what is wrong with a motion

SINKING = changed('root.position = [0.1, 0, "free"]', "root.position = [0.1, 0, 0.4]").replace(
    "joints.left_knee = {rotvec = [0, 40, 0]}",
    "root.rotation = {rotvec = [0, 0, 0]}\njoints.left_knee = {rotvec = [0, 0, 0]}",
)
SUNK = "violation: keyframe 2 itself: shin is 140 mm in the floor at 0.20 s"


@pytest.fixture
def sinking(run: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Command:
    """The command beside a clip that sinks, where measuring at length is forbidden."""
    (tmp_path / "sinks.toml").write_text(SINKING, encoding="utf-8")
    monkeypatch.setattr(
        importlib.import_module("dynsplines.measure.report"), "report", lambda *_: pytest.fail("measured")
    )
    return run


@pytest.mark.parametrize(
    ("words", "wrote", "code"),
    [
        (["solve", "sinks.toml", "--strict"], "sinks.npz", 3),
        (["render", "sinks.toml", *SMALL, "--at", 0.2], "sinks.png", 0),
    ],
)
def test_violations_are_reported_last_and_only_strict_makes_them_an_error(sinking, tmp_path, words, wrote, code):
    done = sinking(*words)
    assert (done.code, done.out) == (code, "")
    lines = done.err.splitlines()
    assert lines[lines.index(f"wrote {wrote}") + 1].startswith(SUNK)
    assert (tmp_path / wrote).stat().st_size > 100


@pytest.mark.parametrize("other", [["--only", "keys"], ["--ghosts"]])
def test_a_picture_of_many_times_has_no_time(sinking, tmp_path, other):
    done = sinking("render", "sinks.toml", *SMALL, "--at", 0.2, *other, "-o", "a.png")
    assert done.code == 2 and "give one of them" in done.last
    assert not (tmp_path / "a.png").exists()


def test_a_motion_that_is_well_ends_with_what_was_written_and_strict_is_content(run, tmp_path):
    well = changed("joints.left_knee = {rotvec = [0, 40, 0]}", "joints.left_knee = {rotvec = [0, 0, 0]}")
    well = well.replace("0, 1]", "0, 0.54]").replace("evaluations = 8", "evaluations = 99")  # on the ground
    (tmp_path / "well.toml").write_text(well, encoding="utf-8")
    done = run("solve", "well.toml", "--strict")
    assert (done.code, done.err.splitlines()[-1]) == (0, "wrote well.npz")


def test_json_says_how_it_went_and_what_is_wrong_and_measures_nothing(sinking):
    done = sinking("solve", "sinks.toml", "--json", "--strict")
    assert done.code == 3
    told = json.loads(done.out)
    assert {"objective", "objective before", "evaluations", "seconds", "stopped because"} <= told.keys()
    assert told["objective"] < told["objective before"]
    worst = told["violations"][0]
    assert SUNK.endswith(worst["text"])
    assert (worst["kind"], worst["name"], worst["keyframe"], worst["unit"]) == ("penetration", "shin", 2, "m")
    assert worst["amount"] == pytest.approx(0.14)
    assert worst["time"] == pytest.approx(0.2)


def flat(data: Any, place: str = "") -> dict[str, Any]:
    """The leaves of JSON by the ways to them."""
    if not isinstance(data, dict | list):
        return {place: data}
    entries = data.items() if isinstance(data, dict) else enumerate(data)
    return {way: leaf for key, each in entries for way, leaf in flat(each, f"{place}/{key}").items()}


@pytest.mark.slow
def test_the_measured_report_of_a_file_is_that_of_the_clip(run):
    assert run("solve", "tiny.toml").code == 0
    one, two = (flat(json.loads(run("report", source, "--json").out)) for source in ("tiny.toml", "tiny.npz"))
    assert one.pop("/seconds") > 0  # which no file knows
    assert one.keys() == two.keys()
    for way in one:
        assert two[way] == (one[way] if isinstance(one[way], str) else pytest.approx(one[way], rel=1e-5, abs=1e-7)), way
