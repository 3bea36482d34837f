"""Batches: clips per second with one worker process and with two, and recovery after processes are killed."""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import json
import os
import signal
import subprocess
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from bench import Effort, Section, Target, dynsplines, median, peer, seconds

CLIP = """figure = "human"
[[keyframe]]
time = 0.0
others = "rest"
[[keyframe]]
time = 0.5
joints.left_hip = {{rotvec = [0, {hip}, 0]}}
joints.left_knee = {{euler = [0, {knee}, 0]}}
joints.right_elbow = {{rotvec = [0, {elbow}, 0]}}
others = "previous"
[[keyframe]]
time = 1.0
others = "rest"
"""
PATIENCE = 600.0


def written(folder: Path, count: int) -> Path:
    """So many clips of the human lifting a knee, no two alike."""
    folder.mkdir()
    for i in range(count):
        text = CLIP.format(hip=-30 - 0.1 * i, knee=40 + 0.1 * i, elbow=-20 - 0.05 * i)
        (folder / f"clip{i:04}.toml").write_text(text, encoding="utf-8")
    return folder


def command(clips: Path, out: Path, workers: int) -> list[str]:
    return dynsplines("batch", str(clips), "-o", str(out), "--workers", str(workers), "--no-report")


def journal(out: Path) -> list[dict[str, Any]]:
    """Every whole line of the manifest about a clip."""
    path = out / "manifest.jsonl"
    lines = path.read_bytes().split(b"\n")[:-1] if path.exists() else []
    return [json.loads(line) for line in lines]


def whole_batch(clips: Path, out: Path, workers: int) -> float:
    """Seconds of the whole command."""
    spent, done = seconds(lambda: subprocess.run(command(clips, out, workers), capture_output=True, check=False))
    if done.returncode != 0:
        raise RuntimeError(done.stderr.decode()[-300:])
    return spent


def killed(clips: Path, out: Path, count: int) -> dict[str, int]:
    """A worker is killed after a quarter, the program after half of the clips; then the command is given again."""
    import psutil

    program = subprocess.Popen(command(clips, out, 2), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def done() -> Counter[str]:
        return Counter(entry["clip"] for entry in journal(out) if entry["state"] == "done")

    try:
        _until(lambda: len(done()) >= count // 4)
        workers: set[int] = set()
        for child in psutil.Process(program.pid).children(recursive=True):
            with suppress(psutil.Error):
                workers |= {child.pid} if any("spawn_main" in word for word in child.cmdline()) else set()
        os.kill(min(workers), signal.SIGKILL)
        _until(lambda: len(done()) >= count // 2)
    finally:
        program.kill()
        program.wait()
    before = done()
    whole_batch(clips, out, 2)
    from dynsplines import motion

    entries = journal(out)
    names = {entry["clip"] for entry in entries if entry["state"] == "done"}
    damaged = 0
    for name in names:
        try:
            motion.load(out / f"{name}.npz")
        except Exception:
            damaged += 1
    return {
        "done before": len(before),
        "missing": count - len(names),
        "twice": len(entries) - len({entry["clip"] for entry in entries}) + sum(n - 1 for n in before.values()),
        "damaged": damaged,
        "other files": len(list(out.iterdir())) - len(names) - 1,
    }


def measure(effort: Effort) -> Section:
    section = Section("Batches of small clips of the human", ("what", "clips", "seconds", "clips a second", "× one"))
    if peer("psutil") is None:
        section.add("skipped: not installed (pip install '.[batch]')", "–", "–", "–", "–")
        return section
    count = effort.count(200, 12)
    spent: dict[int, list[float]] = {1: [], 2: []}
    with tempfile.TemporaryDirectory() as folder:
        clips = written(Path(folder) / "clips", count)
        few = written(Path(folder) / "few", 1)
        start = [whole_batch(few, Path(folder) / f"start{i}", 1) for i in range(2)]
        for i in range(effort.count(3, 1)):
            for workers, times in spent.items():
                effort.report(f"{workers} workers, run {i + 1}")
                times.append(whole_batch(clips, Path(folder) / f"out{workers}{i}", workers))
        effort.report("a worker and the program are killed")
        kill = killed(clips, Path(folder) / "killed", count)
    one, two = median(spent[1]), median(spent[2])
    section.add("one worker process", count, one, count / one, 1.0)
    section.add("two", count, two, count / two, one / two)
    section.add("one clip alone, the start of everything", 1, min(start), 1 / min(start), "–")
    wrong = sum(kill[name] for name in ("missing", "twice", "damaged", "other files"))
    section.targets = [
        Target("two worker processes / one, the whole command", one / two, 1.8, least=True),
        Target("clips missing, twice or damaged after a worker and the program were killed", float(wrong), 0.0),
    ]
    section.notes = [
        "`dynsplines batch --no-report` as a command, starting and imports included; medians; three keyframes a clip, "
        f"no two alike; this machine has {os.cpu_count()} cores and the program itself needs some of one",
        f"killed: one process that solves, by SIGKILL, after a quarter of {count} clips, the program after half "
        f"({kill['done before']} were done), then the same command again; every file is read",
    ]
    section.data = {"seconds": spent, "start": start, "killed": kill}
    return section


def _until(met: Callable[[], bool]) -> None:
    end = time.monotonic() + PATIENCE
    while not met():
        if time.monotonic() > end:
            raise TimeoutError("the batch does not go on")
        time.sleep(0.02)
