"""Batches end to end: each clip once, whatever is killed; a clip that fails stops nothing."""

import gc
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import deeds
import mujoco
import pytest
from problems import CLIP, FIGURE, changed, names, written
from processes import Command, quiet, refusal
from texts import read_cases

import dynsplines.batch

pytest.importorskip("distributed")

import psutil

from dynsplines.batch import dispatch, solving
from dynsplines.batch.manifest import ENTRY, Entry, Manifest, Tally
from dynsplines.batch.task import BatchOptions

pytestmark = pytest.mark.skipif(os.name == "nt", reason="needs POSIX limits and signals")

COMMAND = "from dynsplines.cli import main; main()"
DEEDS = (
    "import deeds; from dynsplines.batch import dispatch; dispatch.run.__kwdefaults__['solve_task'] = deeds.perform; "
    + COMMAND
)
CLUSTER = """
from distributed import LocalCluster
with LocalCluster(n_workers=1, threads_per_worker=1, processes=False, protocol="tcp://", host="127.0.0.1",
                  dashboard_address="127.0.0.1:0", scheduler_kwargs={"dashboard": False}, silence_logs=50) as cluster:
    print(cluster.scheduler_address, flush=True)
    input()
"""  # one process, which a clip can end
PATIENCE = 600.0
TLS_ALERT = b"\x15"


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Callable[..., subprocess.Popen[str]]]:
    """Starts `dynsplines batch` in the folder; whatever it leaves is ended."""
    begun: list[subprocess.Popen[str]] = []
    paths = os.pathsep.join([str(Path(__file__).parent), *sys.path])

    def start(*words: object, program: str = COMMAND) -> subprocess.Popen[str]:
        command = [sys.executable, "-W", "error", "-c", program, *map(str, words)]
        begun.append(
            subprocess.Popen(
                command,
                cwd=tmp_path,
                env={**os.environ, "PYTHONPATH": paths, "MUJOCO_GL": "disable"},
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
                start_new_session=True,
            )
        )
        return begun[-1]

    yield start
    for process in begun:
        for each in [*descendants(process.pid), process.pid]:
            if psutil.pid_exists(each):
                os.kill(each, signal.SIGKILL)
        process.communicate()


def descendants(number: int) -> list[int]:
    try:
        return [child.pid for child in psutil.Process(number).children(recursive=True)]
    except psutil.NoSuchProcess:
        return []


def alive(number: int) -> bool:
    try:
        return psutil.Process(number).status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def until(met: Callable[[], object], what: str) -> None:
    end = time.monotonic() + PATIENCE
    while not met():
        assert time.monotonic() < end, f"never came: {what}"
        time.sleep(0.01)


def journal(folder: Path) -> list[Entry]:
    """Every whole line of the manifest, oldest first."""
    path = folder / "manifest.jsonl"
    lines = path.read_bytes().split(b"\n")[:-1] if path.exists() else []
    return [ENTRY.validate_json(line) for line in lines]


def done(folder: Path) -> int:
    return len({entry.clip for entry in journal(folder) if entry.state == "done"})


def solvers(driver: int) -> list[int]:
    """The processes for clips, which are processes of Dask."""
    found = []
    for number in descendants(driver):
        with suppress(psutil.Error):
            found += [number] if any("spawn_main" in word for word in psutil.Process(number).cmdline()) else []
    return found


def clips(folder: Path, texts: dict[str, str]) -> None:
    folder.mkdir()
    for name, text in texts.items():
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")


def states(folder: Path) -> list[tuple[str, str]]:
    return [(entry.clip, entry.state) for entry in journal(folder)]


@pytest.fixture
def deeds_in_process(in_process: None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(dispatch.run, "__kwdefaults__", {"solve_task": deeds.perform})


@pytest.mark.slow
def test_each_clip_is_done_once_though_a_process_and_the_program_are_killed_or_stopped(
    tmp_path: Path, start, deeds_in_process: None, monkeypatch: pytest.MonkeyPatch
):
    scratch, out = tmp_path / "scratch", tmp_path / "out"
    scratch.mkdir()
    monkeypatch.setenv("TMPDIR", str(scratch))
    monkeypatch.setenv("DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES", "0")
    texts = {"a": "fine 1", "b": "fine 2", "c": "die", "d": "hang", "e": "fine 3", "f": "hang", "g": "fine 4"}
    clips(tmp_path / "clips", texts)
    words = ("batch", "clips", "-o", "out", "--workers", 1)

    killed = start(*words, program=DEEDS)
    until(lambda: len(journal(out)) == 3, "three clips")
    family = descendants(killed.pid)
    killed.kill()
    killed.communicate()
    until(lambda: not any(map(alive, family)), "the end of all processes")
    ended = "each worker that tried to solve it ended: a crash, or too little memory"
    assert [(entry.clip, entry.error) for entry in journal(out)] == [("a", ""), ("b", ""), ("c", ended)]
    stamps = {path: path.stat().st_mtime_ns for path in out.glob("*.npz")}
    assert len(stamps) == 2
    left = set(scratch.iterdir())

    for name in "cd":
        (tmp_path / "clips" / f"{name}.toml").write_text("fine 5", encoding="utf-8")
    stopped = start(*words, program=DEEDS)
    until(lambda: done(out) == 5, "three clips more")
    assert_closed_to_others([stopped.pid, *solvers(stopped.pid)])
    family = descendants(stopped.pid)
    os.killpg(stopped.pid, signal.SIGINT)
    asked = time.monotonic()
    _, said = stopped.communicate(timeout=PATIENCE)
    assert (stopped.returncode, time.monotonic() - asked < 60) == (130, True), said
    assert said.splitlines()[-1] == "dynsplines: stopped"
    assert "Traceback" not in said
    until(lambda: not any(map(alive, family)), "the end of all processes")
    assert states(out)[3:] == [("c", "done"), ("d", "done"), ("e", "done")]
    assert set(scratch.iterdir()) <= left

    (tmp_path / "clips" / "f.toml").write_text("fine 6", encoding="utf-8")
    tally = dispatch.run([str(tmp_path / "clips")], out, BatchOptions(workers=1), quiet())
    assert tally.line == "2 solved, 5 already there, 0 failed"
    assert states(out)[6:] == [("f", "done"), ("g", "done")]
    assert all(entry.is_intact(out) for entry in journal(out) if entry.state == "done")
    assert {path: path.stat().st_mtime_ns for path in stamps} == stamps
    assert names(out) == sorted(["manifest.jsonl", *(f"{name}.npz" for name in texts)])


def assert_closed_to_others(processes: list[int]) -> None:
    """They listen only on the loopback interface, and answer nothing without a certificate."""
    connections = [each for one in processes for each in psutil.Process(one).net_connections()]
    listening = [each.laddr for each in connections if each.status == psutil.CONN_LISTEN]
    assert {address.ip for address in listening} == {"127.0.0.1"}
    for address in listening:
        with socket.create_connection(address) as stranger:
            answer = b""
            with suppress(ConnectionError):  # it is refused
                stranger.sendall(b"GET / HTTP/1.0\r\n\r\n")
                answer = stranger.recv(100)
        assert answer[:1] in (b"", TLS_ALERT) or b" 404 " in answer, answer


def test_clips_that_fail_in_every_way_stop_nothing_and_are_reported(
    tmp_path: Path, deeds_in_process: None, monkeypatch: pytest.MonkeyPatch, command: Command
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back
    monkeypatch.setattr(solving, "GRACE_SECONDS", 0.2)
    monkeypatch.setattr(solving.os, "_exit", deeds.EXITS.append)
    texts = {
        "a_good": "fine 1",
        "b_hangs": "hang",
        "c_grabs": "grab",
        "d_wrong": "complain of its\nkeyframes",
        "e_odd": "stumble",
        "f_freezes": "freeze",
        "g_good": "fine 2",
    }
    clips(tmp_path / "clips", texts)
    ended = command("batch", "clips", "-o", "out", "--workers", 1, "--limit-time", 0.5)
    assert (ended.code, ended.out, deeds.EXITS) == (1, "", [1]), ended
    assert "batch 100% 2 done, 5 failed, 0 running of 7" in ended.err and ended.last == "out: 2 solved, 5 failed"
    failures = ended.err.splitlines()[-6:-1]
    assert failures[0] == "failed: b_hangs: it took longer than 0.5 s"
    assert failures[1].startswith("failed: c_grabs: it took more memory than there is")
    assert failures[2] == r"failed: d_wrong: of its\nkeyframes"
    assert failures[3].startswith("failed: e_odd: ZeroDivisionError: of nothing (deeds.py:")
    assert failures[4] == "failed: f_freezes: the process has ended"
    assert (tmp_path / "out" / "a_good.npz").read_bytes() == b"fine 1"
    assert sorted(entry.clip for entry in journal(tmp_path / "out")) == sorted(texts)


@pytest.mark.slow
def test_a_cluster_elsewhere_gets_all_it_needs_and_one_that_goes_away_costs_no_clip_anything(
    tmp_path: Path, start, monkeypatch: pytest.MonkeyPatch, command: Command
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back
    cluster = start(program=CLUSTER)
    assert cluster.stdout is not None
    address = cluster.stdout.readline().strip()
    clips(tmp_path / "clips", {"right": CLIP, "wrong": changed("joints.left_knee", "joints.knee")})
    (tmp_path / "clips" / "tiny.xml").write_text(FIGURE, encoding="utf-8")
    ended = command("batch", "clips", "-o", "out", "--cluster", address, "--to", "csv")
    assert ended.code == 1, ended
    lines = ended.err.splitlines()
    assert lines[0].startswith(f"Dask: {address}, 1 workers")
    assert lines[-2].startswith("failed: wrong: wrong.toml: keyframe 1 (t = 0 s): no joint 'knee'")
    assert lines[-1] == "out: 1 solved, 1 failed"
    assert any(line.startswith("1 of 1 clips has violations; worst: ") for line in lines)
    (entry,) = [entry for entry in journal(tmp_path / "out") if entry.state == "done"]
    assert [each["name"] for each in entry.violations] == ["root", "left_knee"]
    assert len((tmp_path / "out/right.csv").read_text(encoding="utf-8").splitlines()) == 10

    monkeypatch.setattr(dispatch.run, "__kwdefaults__", {"solve_task": deeds.perform})
    heavy = "fine " + 11_000_000 * "x"  # Dask warns of as much in a graph, and a warning is an error here
    clips(tmp_path / "others", {"a": heavy, "b": "die", "c": heavy})
    ended = command("batch", "others", "-o", "more", "--cluster", address)
    assert ended.code == 2
    assert ended.last.startswith("dynsplines: the Dask scheduler is gone; run the same command again")
    assert cluster.wait(PATIENCE) == -signal.SIGKILL
    assert states(tmp_path / "more") in ([], [("a", "done")])


MESHED = FIGURE.replace("<worldbody>", '<asset><mesh name="part" file="part.obj"/></asset><worldbody>').replace(
    '<geom name="shin"', '<geom name="part" type="mesh" mesh="part" mass=".1"/><geom name="shin"'
)
CORNERS = "v 0 0 0\nv {size} 0 0\nv 0 {size} 0\nv 0 0 {size}\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


@pytest.mark.slow
def test_a_mesh_comes_with_the_model_and_another_figures_is_not_written_over_it(
    in_process: None, tmp_path: Path
) -> None:
    clips, out = tmp_path / "clips", tmp_path / "out"
    for number, (name, size) in enumerate({"one": 0.1, "two": 0.2}.items()):
        (clips / name).mkdir(parents=True)
        (clips / name / "tiny.xml").write_text(MESHED, encoding="utf-8")
        (clips / name / "part.obj").write_text(CORNERS.format(size=size), encoding="utf-8")
        text = changed('"tiny.xml"', f'"{name}/tiny.xml"')
        (clips / f"{number}.toml").write_text(text, encoding="utf-8")

    def run(name: str = "") -> Tally:
        return dispatch.run([str(clips / name)], out, BatchOptions(workers=1, to="mjcf"), quiet())

    tally = run()
    (failed,) = tally.failed
    assert tally.solved == 1
    assert "'part.obj' already exists, where a file of this motion's figure would be written" in failed.error
    good = "1" if failed.clip == "0" else "0"
    assert mujoco.MjModel.from_xml_path(str(out / f"{good}.keys.xml")).nkey > 0
    assert list(Manifest.of(out).entries[good].files) == [f"{good}.keys.xml", "part.obj"]

    same = (clips / ("one" if good == "0" else "two") / "part.obj").read_bytes()
    for place in ("one", "two"):
        (clips / place / "part.obj").write_bytes(same)
    assert run().solved == 1
    (out / "part.obj").unlink()
    (clips / "1.toml").write_text((clips / "1.toml").read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert run("1.toml").solved == 1  # the other one stays done, and has the same mesh
    assert (out / "part.obj").read_bytes() == same


Refused = Callable[..., str]


@pytest.fixture
def refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: Command) -> Refused:
    """Runs the command beside the tiny clip and gives its one line."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back
    written(tmp_path)
    (tmp_path / "other").mkdir()
    written(tmp_path / "other", name="Tiny.toml")
    return lambda *words: refusal(command("batch", *words))


@pytest.mark.parametrize(("words", "line"), read_cases("batch_words.toml"))
def test_what_makes_no_sense_is_refused(refused: Refused, words: tuple[object, ...], line: str):
    pytest.importorskip("distributed")
    assert refused(*words).startswith(line)


def test_a_missing_package_is_named_with_how_to_install_it(refused: Refused, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    for name in ("dispatch", "solving"):
        monkeypatch.delitem(sys.modules, f"dynsplines.batch.{name}", raising=False)
        monkeypatch.delattr(dynsplines.batch, name, raising=False)
    line = "dynsplines batch needs 'distributed'; install it: pip install 'dynamic-splines[batch]'"
    assert refused("tiny.toml") == line


def test_a_scheduler_that_is_not_there_is_reported(refused: Refused, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    pytest.importorskip("distributed")
    from dynsplines.batch import dispatch

    monkeypatch.setattr(dispatch, "PATIENCE_SECONDS", 0.5)
    line = refused("tiny.toml", "--cluster", "tcp://127.0.0.1:9")
    assert line.startswith("no Dask scheduler answers at 'tcp://127.0.0.1:9': ")
    assert list((tmp_path / "batch").iterdir()) == []
    assert refused("tiny.toml", "--cluster", "nonsense://x").startswith("no Dask scheduler answers at 'nonsense://x'")
    gc.collect()  # pytest fails a test in which a finaliser does
