"""What surrounds a command breaks: disks, folders, streams, limits, clocks, signals at any moment. It ends in one line,
what was there before stays, and nothing half-done is left."""

import json
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from itertools import cycle
from pathlib import Path
from typing import Any

import pytest
from problems import ENDLESS, changed, names, written
from processes import SMALL, largest_file

from dynsplines import motion, recordings
from dynsplines.system import output
from dynsplines.system.output import TEMPORARY, Replacement

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="needs Linux limits, forks and signals")

TESTS = Path(__file__).parents[1]
SUPPORT = TESTS / "support"
Tried = Callable[..., dict[str, Any]]
COMMANDS = {
    "solve": ("solve", "tiny.toml", "-o", "out.npz"),
    "thin": ("thin", "motion.npz", "-o", "out.toml"),
    "render": ("render", "motion.npz", "--size", "64x48", "-o", "out.png"),
}
EDITS = ("thin",)
SEARCHING = ("solve", "thin")  # which keep what they have found by then
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129, signal.SIGXCPU: 152}
SHARES = (0.6, 0.97, 0.3)  # of a command's calls
QUICK = changed("evaluations = 8\nframes = 2", "evaluations = 1\nframes = 0")
MOMENTS = list(zip(COMMANDS, cycle(CODES), cycle(SHARES), strict=False))


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tried]:
    """Runs the command in a folder with the tiny clip and its motion in it."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(TESTS), str(SUPPORT)]), "MUJOCO_GL": "disable"}
    environment |= {"OMP_NUM_THREADS": "1"}
    process = subprocess.Popen(
        [sys.executable, str(SUPPORT / "faulty.py")],
        env=environment,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        cwd=tmp_path_factory.mktemp("server"),
    )
    assert process.stdin is not None and process.stdout is not None
    talk, heard = process.stdin, process.stdout

    def tried(*words: str, **conditions: object) -> dict[str, Any]:
        talk.write(json.dumps({"words": words, **conditions}) + "\n")
        talk.flush()
        return json.loads(heard.readline())

    yield tried
    process.kill()
    process.communicate()


@pytest.fixture
def tried(server: Tried, tmp_path: Path, motion_file: Path) -> Tried:
    """In the test's folder, which has the tiny clip in it, and its motion."""
    written(tmp_path, QUICK)
    (tmp_path / "motion.npz").write_bytes(motion_file.read_bytes())

    def tried(*words: str, before: str = "", **conditions: object) -> dict[str, Any]:
        return server(*words, before=f"import os; os.chdir({str(tmp_path)!r})\n{before}", **conditions)

    return tried


def assert_told(ended: dict[str, Any], words: str, code: int = 2) -> None:
    """Ended with that code and a line that says why."""
    assert "Traceback" not in ended["err"]
    assert (ended["code"], ended["err"].splitlines()[-1:]) == (code, [ended["err"].splitlines()[-1]]), ended
    assert words in ended["err"].splitlines()[-1]


def is_whole(path: Path) -> bool:
    """Whether it is a motion or a clip."""
    return bool(motion.load(path) if path.suffix == ".npz" else recordings.load(str(path)))


def left(folder: Path) -> list[str]:
    return [name for name in names(folder) if TEMPORARY.fullmatch(name)]


# signals, in every phase of every command


@pytest.mark.slow
@pytest.mark.parametrize(("command", "number", "share"), MOMENTS)
def test_a_signal_at_any_moment_leaves_the_older_file_or_the_whole_new_one(
    command: str, number: signal.Signals, share: float, tried: Tried, tmp_path: Path
):
    words = COMMANDS[command]
    target = tmp_path / words[-1]
    more = ("--overwrite",) if command in EDITS else ()
    whole = tried(*words, calls=True)
    assert whole["code"] == 0 and whole["calls"] > 50, whole
    new = target.read_bytes()
    target.write_bytes(b"older")
    ended = tried(*words, *more, at=max(1, int(share * whole["calls"])), signal=int(number))
    assert ended["code"] == CODES[number], ended
    assert "Traceback" not in ended["err"]
    assert target.read_bytes() in (b"older", new) or (command in SEARCHING and is_whole(target))
    assert left(tmp_path) == []


# disks and folders

WRITING = {
    "motion": ("solve", "tiny.toml", "-o", "out.npz"),
    "page": ("export", "motion.npz", "-o", "out.html", "--overwrite"),
    "clip": ("thin", "motion.npz", "-o", "out.toml", "--overwrite"),
    "film": ("render", "motion.npz", "--size", "64x48", "--fps", "2", "-o", "out.gif"),
}


@pytest.mark.parametrize("kind", WRITING)
def test_a_full_disk_is_reported_with_the_files_name_and_the_older_file_stays(kind: str, tried: Tried, tmp_path: Path):
    words = WRITING[kind]
    target = tmp_path / words[words.index("-o") + 1]
    target.write_bytes(b"older")
    ended = tried(*words, before=SMALL)
    assert_told(ended, f"cannot write '{target.stem}.")
    assert target.read_bytes() == b"older"
    assert left(tmp_path) == []


def test_a_manifest_on_a_full_disk_is_reported_and_continues_later(tmp_path: Path):
    from dynsplines.batch.manifest import Entry, Manifest
    from dynsplines.errors import UserError

    manifest = Manifest.of(tmp_path)
    manifest.record(Entry(clip="a", source="a.toml", state="done"))
    full = pytest.raises(UserError, match=r"cannot write '.*manifest.jsonl': ")
    with largest_file(manifest.path.stat().st_size + 20), full:
        manifest.record(Entry(clip="b", source="b.toml", state="done"))
    assert set(Manifest.of(tmp_path).entries) == {"a"}
    Manifest.of(tmp_path).record(Entry(clip="c", source="c.toml", state="done"))
    assert set(Manifest.of(tmp_path).entries) == {"a", "c"}


def test_a_folder_without_write_permission_is_reported(tried: Tried, tmp_path: Path):
    (tmp_path / "sealed").mkdir()
    (tmp_path / "sealed").chmod(0o555)
    place = "sealed" if os.geteuid() else "/sys"  # who may do anything may not write there
    for words in (("solve", "tiny.toml"), ("export", "motion.npz", "--to", "npz"), ("new", "tiny.xml")):
        ending = "toml" if words[0] == "new" else "npz"
        assert_told(tried(*words, "-o", f"{place}/a.{ending}"), f"cannot write '{place}/a.{ending}'")


GONE = "import os, tempfile; os.chdir(place := tempfile.mkdtemp()); os.rmdir(place)\n"


def test_a_folder_that_vanished_beneath_the_command_is_no_harm_to_what_lies_elsewhere(tried: Tried, tmp_path: Path):
    source = str(tmp_path / "tiny.toml")
    assert tried("solve", source, "-o", str(tmp_path / "out.npz"), before=GONE)["code"] == 0
    assert motion.load(tmp_path / "out.npz").name == "tiny"
    assert_told(
        tried("solve", source, "-o", "out.npz", before=GONE), "the folder that the command was started in is gone"
    )
    assert_told(tried("solve", "tiny.toml", before=GONE), "the folder that the command was started in is gone")


def test_paths_that_are_no_text_are_read_and_written(tried: Tried, tmp_path: Path):
    name = os.fsdecode(b"caf\xe9")
    os.rename(tmp_path / "tiny.toml", tmp_path / f"{name}.toml")  # noqa: PTH104
    ended = tried("solve", f"{name}.toml", "-o", f"{name}.csv.npz")
    assert ended["code"] == 0, ended
    assert motion.load(tmp_path / f"{name}.csv.npz").figure.width == 11
    assert_told(tried("solve", f"{name}2.toml"), "no file 'caf\\udce92.toml'")


# streams

CLOSED = "sys = __import__('sys')\nfor number, name in (({}, '{}'),):\n    os.close(number); setattr(sys, name, None)\n"
FULL = "os.dup2(os.open('/dev/full', os.O_WRONLY), {})\n"
UNREAD = "r, w = os.pipe(); os.close(r); os.dup2(w, 1)\n"


@pytest.mark.parametrize(
    ("words", "before"),
    [
        (("report", "motion.npz"), FULL.format(1)),
        (("clips",), CLOSED.format(1, "stdout")),
        (("report", "motion.npz"), UNREAD),
    ],
)
def test_what_cannot_be_printed_is_no_mistake_of_the_program(words: tuple[str, ...], before: str, tried: Tried):
    ended = tried(*words, before=before)
    assert ended["code"] in (0, 1, 2, 120, 141), ended
    assert "Traceback" not in ended["err"] and "internal error" not in ended["err"]


HARMLESS = {
    "closed streams": "".join(CLOSED.format(i, name) for i, name in enumerate(("stdin", "stdout", "stderr"))),
    "a home that is missing": "os.environ |= dict.fromkeys(('HOME', 'XDG_CACHE_HOME', 'TMPDIR'), '/nowhere')\n"
    "import tempfile; tempfile.tempdir = None\n",
    "a clock that goes back": "import itertools, time\nticks = itertools.count()\n"
    "time.time = lambda: 1e9 - 1000 * next(ticks)\n",
    "files from the future": "for name in os.listdir():\n    os.utime(name, (4e9, 4e9))\n",
}


@pytest.fixture(scope="module")
def usual(server: Tried, tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The motion file of the clip, solved under no such condition."""
    folder = tmp_path_factory.mktemp("usual")
    written(folder, QUICK)
    assert server(*COMMANDS["solve"], before=f"import os; os.chdir({str(folder)!r})\n")["code"] == 0
    return (folder / "out.npz").read_bytes()


@pytest.mark.parametrize("before", HARMLESS.values(), ids=HARMLESS)
def test_a_clip_is_solved_as_usual_in_spite_of(before: str, usual: bytes, tried: Tried, tmp_path: Path):
    target = tmp_path / "out.npz"
    target.write_bytes(b"older")
    ended = tried(*COMMANDS["solve"], before=before)
    assert (ended["code"], "Traceback" in ended["err"]) == (0, False), ended
    assert target.read_bytes() == usual and is_whole(target)


# limits


def test_too_few_handles_are_reported(tried: Tried, tmp_path: Path):
    few = "import resource; resource.setrlimit(resource.RLIMIT_NOFILE, (8, 8))\n"
    for words in (("solve", "tiny.toml", "-o", "out.npz"), ("export", "motion.npz", "-o", "out.html")):
        ended = tried(*words, before=few)
        assert ended["code"] in (0, 2) and "Traceback" not in ended["err"], ended
    assert left(tmp_path) == []


def test_too_little_memory_is_reported(tried: Tried, tmp_path: Path):
    """The samples exceed the limit by so much that small requests still have memory: NumPy may crash without."""
    little = (
        "import resource; used = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()\n"
        "resource.setrlimit(resource.RLIMIT_AS, (used + 200_000_000,) * 2)\n"
        "from dynsplines import motion; motion.sample_count = lambda *_: 50_000_000\n"
    )
    ended = tried(*COMMANDS["solve"], before=little)
    assert_told(ended, "not enough memory for this")
    assert left(tmp_path) == []


SHORTLY = """
# a limit of processor time that ends 20 ms after the search begins; limits are whole seconds
import importlib, resource, time
module = importlib.import_module("dynsplines.solver.inbetween")
minimise = module.minimise
def limited(*arguments, **options):
    module.minimise = minimise
    while time.process_time() % 1 < 0.98:
        pass
    end = int(time.process_time()) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (end, end + 60))
    return minimise(*arguments, **options)
module.minimise = limited
"""


def test_a_limit_of_processor_time_ends_the_search_and_keeps_its_motion(tried: Tried, tmp_path: Path):
    written(tmp_path, ENDLESS, "long.toml")
    ended = tried("solve", "long.toml", "-o", "out.npz", before=SHORTLY)
    assert ended["code"] == CODES[signal.SIGXCPU] and "Traceback" not in ended["err"]
    assert is_whole(tmp_path / "out.npz") and left(tmp_path) == []


# others at work


def test_two_writers_of_one_file_leave_one_of_the_two_whole(tmp_path: Path):
    target, sizes, ready = tmp_path / "a.bin", (100_000, 300_000), threading.Barrier(2)

    def write(letter: bytes, size: int) -> None:
        for _ in range(15):
            ready.wait(10)
            with Replacement(target) as temporary:
                temporary.write_bytes(letter * size)

    writers = [threading.Thread(target=write, args=each) for each in zip((b"a", b"b"), sizes, strict=True)]
    for each in writers:
        each.start()
    seen: set[bytes] = set()
    while any(each.is_alive() for each in writers):
        if target.exists():
            seen.add(target.read_bytes())
    assert seen <= {b"a" * sizes[0], b"b" * sizes[1]} and len(seen | {target.read_bytes()}) >= 1
    assert names(tmp_path) == ["a.bin"]


def test_a_writer_whose_file_is_taken_for_a_leftover_before_it_is_locked_begins_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    target, real, taken = tmp_path / "a.bin", output.hold, []

    def hold(handle: int, *, waits: bool) -> bool:
        if not taken:
            taken.append([path.unlink() for path in tmp_path.iterdir()])
        return real(handle, waits=waits)

    monkeypatch.setattr(output, "hold", hold)
    with Replacement(target) as temporary:
        temporary.write_bytes(b"whole")
    assert taken == [[None]] and target.read_bytes() == b"whole" and names(tmp_path) == ["a.bin"]


def test_a_clip_that_is_removed_or_cut_while_it_is_read_is_reported(tried: Tried, tmp_path: Path):
    gone = "import dynsplines.clip.load as c; load = c.from_parsed\ndef f(*a, **k):\n"
    gone += "    os.unlink('tiny.xml'); return load(*a, **k)\n"
    assert_told(tried("solve", "tiny.toml", before=gone + "c.from_parsed = f\n"), "no file 'tiny.xml'")
    (tmp_path / "motion.npz").write_bytes((tmp_path / "motion.npz").read_bytes()[:-100])
    assert_told(tried("report", "motion.npz"), "motion.npz: not an .npz file, or cut short")
