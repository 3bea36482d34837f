"""Batches end to end: each clip once, whatever is killed; a clip that fails stops nothing."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import mujoco
import pytest
from problems import CLIP, FIGURE, changed, written
from processes import Command, quiet

pytest.importorskip("distributed")

import psutil

from dynsplines import motion
from dynsplines.batch import dispatch
from dynsplines.batch.manifest import ENTRY, Entry, Manifest
from dynsplines.batch.tally import Tally
from dynsplines.batch.task import BatchOptions

pytestmark = pytest.mark.skipif(os.name == "nt", reason="needs POSIX limits and signals")

COMMAND = "from dynsplines.cli import main; main()"
DEEDS = (
    "import deeds; from dynsplines.batch import dispatch; dispatch.run.__kwdefaults__['solve_task'] = deeds.perform; "
    + COMMAND
)
FORKED = """
import dask
from distributed import utils, versions
dask.config.set({"distributed.worker.multiprocessing-method": "forkserver"})
versions.optional_packages.append("dynsplines.solving")  # imported once, before workers are forked
utils.get_mp_context()
versions.optional_packages.pop()
"""  # workers that start in a moment
CLUSTER = f"""{FORKED}
from distributed import LocalCluster
if __name__ == "__main__":
    with LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address="127.0.0.1:0",
                      scheduler_kwargs={{"dashboard": False}}, silence_logs=50) as cluster:
        print(cluster.scheduler_address, flush=True)
        input()
"""
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
                env={**os.environ, "PYTHONPATH": paths},
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


def clips(folder: Path, count: int, text: str = CLIP) -> None:
    """Clips of one figure, half of them with the names of the other half in another folder."""
    for side in ("left", "right"):
        (folder / side).mkdir(parents=True)
        (folder / side / "tiny.xml").write_text(FIGURE, encoding="utf-8")
        for i in range(count // 2):
            (folder / side / f"clip{i:03}.toml").write_text(text, encoding="utf-8")


def assert_complete(folder: Path, count: int) -> None:
    """Every clip is in the manifest once and done, and its file is whole; there is nothing else."""
    written_down = journal(folder)
    assert len(written_down) == len({entry.clip for entry in written_down}) == count
    assert {entry.state for entry in written_down} == {"done"}
    assert sorted(name for entry in written_down for name in entry.files) == sorted(
        path.relative_to(folder).as_posix() for path in folder.rglob("*.npz")
    )
    for entry in written_down:
        assert entry.is_intact(folder)
        (name,) = entry.files
        assert motion.load(folder / name).name == Path(entry.clip).name
    assert [path.name for path in folder.iterdir() if path.is_file()] == ["manifest.jsonl"]


@pytest.mark.slow
def test_each_clip_is_done_once_though_a_process_and_the_program_are_killed(
    tmp_path: Path, start, monkeypatch: pytest.MonkeyPatch
):
    count, out, scratch = 10, tmp_path / "out", tmp_path / "scratch"
    scratch.mkdir()
    monkeypatch.setenv("TMPDIR", str(scratch))
    clips(tmp_path / "clips", count)
    words = ("batch", "clips", "-o", "out", "--workers", 2)
    first = start(*words)
    until(lambda: done(out) >= 2, "two clips")
    until(lambda: solvers(first.pid), "a process for clips")
    os.kill(solvers(first.pid)[0], signal.SIGKILL)
    so_far = done(out)
    until(lambda: done(out) >= so_far + 2, "two clips more")
    family = descendants(first.pid)
    first.kill()
    first.communicate()
    until(lambda: not any(map(alive, family)), "the end of all processes")
    before = journal(out)
    finished = Counter(entry.clip for entry in before if entry.state == "done")
    assert 4 <= len(finished) < count
    assert set(finished.values()) == {1}
    there = set(finished)
    stamps = {name: (out / f"{name}.npz").stat().st_mtime_ns for name in there}
    assert list(scratch.iterdir())

    second = start(*words[:-1], 1)
    _, said = second.communicate(timeout=PATIENCE)
    assert second.returncode == 0, said
    assert said.splitlines()[-1] == f"out: {count - len(there)} solved, {len(there)} already there, 0 failed"
    assert_complete(out, count)
    assert {name: (out / f"{name}.npz").stat().st_mtime_ns for name in there} == stamps
    assert not list(scratch.iterdir())


@pytest.mark.slow
def test_clips_that_fail_in_every_way_stop_nothing_and_are_reported(
    tmp_path: Path, start, monkeypatch: pytest.MonkeyPatch
):
    deeds = {
        "a_good": "fine 1",
        "b_hangs": "hang",
        "c_grabs": "grab",
        "d_dies": "die",
        "e_wrong": "complain of its\nkeyframes",
        "f_once": f"once {tmp_path / 'mark'}",
        "g_grows": "grow",
        "h_odd": "stumble",
        "i_freezes": "freeze",
        "j_good": "fine 2",
    }
    (tmp_path / "clips").mkdir()
    for name, text in deeds.items():
        (tmp_path / "clips" / f"{name}.toml").write_text(text, encoding="utf-8")
    share = 600e6 / (psutil.virtual_memory().total / 2)
    monkeypatch.setenv("DASK_DISTRIBUTED__WORKER__MEMORY__TERMINATE", f"{share:.6f}")
    monkeypatch.setenv("DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES", "1")
    words = ("batch", "clips", "-o", "out", "--workers", 2, "--limit-time", 4)
    process = start(*words, program=FORKED + DEEDS)
    out, said = process.communicate(timeout=PATIENCE)
    assert (process.returncode, out) == (1, ""), said
    assert "batch 100% 3 done, 7 failed, 0 running of 10" in said and said.splitlines()[-1] == "out: 3 solved, 7 failed"
    failures = said.splitlines()[-8:-1]
    ended = "each worker that tried to solve it ended: a crash, or too little memory"
    assert failures[:1] + failures[2:6] == [
        "failed: b_hangs: it took longer than 4 s",
        f"failed: d_dies: {ended}",
        r"failed: e_wrong: of its\nkeyframes",
        f"failed: g_grows: {ended}",
        failures[5],
    ]
    assert failures[1].startswith("failed: c_grabs: it took more memory than there is")
    assert failures[5].startswith("failed: h_odd: ZeroDivisionError: of nothing (deeds.py:")
    assert failures[6].startswith("failed: i_freezes: ")
    assert (tmp_path / "out" / "a_good.npz").read_bytes() == b"fine 1"
    assert (tmp_path / "out" / "f_once.npz").exists()
    assert sorted(entry.clip for entry in journal(tmp_path / "out")) == sorted(deeds)
    assert {entry.clip for entry in journal(tmp_path / "out") if not entry.input} == {"d_dies", "g_grows", "i_freezes"}


@pytest.mark.slow
def test_ctrl_c_stops_and_only_this_user_can_reach_the_workers(tmp_path: Path, start):
    (tmp_path / "clips").mkdir()
    for name, text in {"a": "fine", "b": "hang", "c": "hang", "d": "fine"}.items():
        (tmp_path / "clips" / f"{name}.toml").write_text(text, encoding="utf-8")
    words = ("batch", "clips", "-o", "out", "--workers", 1)
    process = start(*words, program=DEEDS)
    out = tmp_path / "out"
    until(lambda: done(out) == 1 and len(solvers(process.pid)) == 1, "one that is done")
    found = [psutil.Process(each) for each in [process.pid, *solvers(process.pid)]]
    listening = [each.laddr for one in found for each in one.net_connections() if each.status == psutil.CONN_LISTEN]
    assert {address.ip for address in listening} == {"127.0.0.1"}
    for address in listening:
        with socket.create_connection(address) as stranger:
            answer = b""
            with suppress(ConnectionError):  # it is refused
                stranger.sendall(b"GET / HTTP/1.0\r\n\r\n")
                answer = stranger.recv(100)
        assert answer[:1] in (b"", TLS_ALERT) or b" 404 " in answer, answer
    family = descendants(process.pid)
    os.killpg(process.pid, signal.SIGINT)
    asked = time.monotonic()
    _, said = process.communicate(timeout=PATIENCE)
    assert (process.returncode, time.monotonic() - asked < 60) == (130, True), said
    assert said.splitlines()[-1] == "dynsplines: stopped"
    assert "Traceback" not in said
    until(lambda: not any(map(alive, family)), "the end of all processes")
    assert [(entry.clip, entry.state) for entry in journal(out)] == [("a", "done")]
    assert sorted(path.name for path in tmp_path.rglob("*") if path.is_file() and path.suffix != ".toml") == [
        "a.npz", "manifest.jsonl"
    ]  # fmt: skip


@pytest.mark.slow
def test_a_cluster_elsewhere_gets_all_it_needs_and_one_that_goes_away_costs_no_clip_anything(tmp_path: Path, start):
    cluster = start(program=CLUSTER)
    assert cluster.stdout is not None
    address = cluster.stdout.readline().strip()
    clips(tmp_path / "clips", 2, changed("fps = 20", "fps = 25"))
    (tmp_path / "clips" / "wrong.toml").write_text(changed("joints.left_knee", "joints.knee"), encoding="utf-8")
    (tmp_path / "clips" / "tiny.xml").write_text(FIGURE, encoding="utf-8")
    process = start("batch", "clips", "-o", "out", "--cluster", address, "--to", "csv")
    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 1, said
    assert said.splitlines()[0].startswith(f"Dask: {address}, 2 workers")
    assert said.splitlines()[-2].startswith("failed: wrong: wrong.toml: keyframe 1 (t = 0 s): no joint 'knee'")
    assert said.splitlines()[-1] == "out: 2 solved, 1 failed"
    assert any(line.startswith("2 of 2 clips have violations; worst: ") for line in said.splitlines())
    solved = [entry for entry in journal(tmp_path / "out") if entry.state == "done"]
    assert [[each["name"] for each in entry.violations] for entry in solved] == [["root", "left_knee"]] * 2
    assert len((tmp_path / "out/left/clip000.csv").read_text(encoding="utf-8").splitlines()) == 12

    (tmp_path / "others").mkdir()
    for i in range(6):
        heavy = "fine " + 11_000_000 * "x"  # Dask warns of as much in a graph, and a warning is an error here
        (tmp_path / "others" / f"{i}.toml").write_text("hang" if i % 2 else heavy, encoding="utf-8")
    process = start("batch", "others", "-o", "more", "--cluster", address, program=DEEDS)
    out = tmp_path / "more"
    until(lambda: done(out) >= 1, "one that is done")
    family = descendants(cluster.pid)
    cluster.kill()
    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 2
    assert said.splitlines()[-1].startswith("dynsplines: the Dask scheduler is gone; run the same command again")
    until(lambda: not any(map(alive, family)), "the end of all processes")
    assert {(entry.clip, entry.state) for entry in journal(out)} <= {("0", "done"), ("2", "done"), ("4", "done")}


@pytest.mark.slow
def test_what_a_killed_program_had_begun_to_write_is_removed_whatever_the_ending(
    in_process: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: Command
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back
    written(tmp_path)
    (tmp_path / "out").mkdir()
    (tmp_path / "out/.tiny.keys.xml.0123456789abcdef.partial.xml").write_text("<mujo", encoding="utf-8")
    words = ("batch", "tiny.toml", "-o", "out", "--workers", 1, "--to", "mjcf")
    ended = command(*words)
    assert ended.code == 0, ended
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == ["manifest.jsonl", "tiny.keys.xml"]
    problem = "1 of 1 clips has violations; worst: tiny: keyframe 1 itself: the figure never comes down"
    assert ended.err.splitlines()[-2].startswith(problem)
    again = command(*words, "--strict")
    assert (again.code, again.last) == (3, "out: 0 solved, 1 already there, 0 failed")
    assert again.err.splitlines()[-2].startswith(problem)


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
