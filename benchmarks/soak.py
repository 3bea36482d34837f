"""A long batch that is not let alone: processes and the program killed at random, the disk full in the middle.

By itself: python benchmarks/soak.py [CLIPS]; with the others as a section of run.py.
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bench import Effort, Section, Target, dynsplines, median, peer

FIGURE = """<mujoco model="tiny"><worldbody>
  <body name="pelvis" pos="0 0 1"><freejoint name="root"/><geom type="sphere" size=".1" mass="4"/>
    <body name="shin" pos="0 0 -.2"><joint name="knee" type="ball"/>
      <geom type="capsule" size=".04" fromto="0 0 0 0 0 -.3" mass="1"/></body></body>
</worldbody></mujoco>
"""
CLIP = """figure = "tiny.xml"
fps = 20
solve = {{evaluations = 2, frames = 0, variable = 1}}
[[keyframe]]
time = 0
root.position = [0, 0, 1]
root.rotation = {{rotvec = [0, 0, 0]}}
joints.knee = {{rotvec = [0, 0, 0]}}
[[keyframe]]
time = 0.4
root.position = [0.3, 0, 1]
root.rotation = {{rotvec = [0, 10, {turn}]}}
joints.knee = {{rotvec = [0, {bend}, 0]}}
"""
WORKERS = 2
SEED = 7
MOMENT = 0.3  # [s] at most, from the last of a few clips to the next kill: it hits anything
SHARE_OF_WORKERS = 0.6  # of the kills; the others hit the program
QUIET = 0.5  # of the clips are solved before the kills end; memory is watched while the others are
FULL = 0.25  # of the clips are solved when the disk fills up
ROOM = 200  # [kB] that a full disk has left
LOOK = 0.25  # [s] between two looks at memory
PATIENCE = 900.0  # [s] without a clip
STARTING = 0.05  # of the clips that are watched come before memory counts: imports, first allocations


@dataclass
class Soak:
    """A batch under way in a folder, and what was done to it.

    memory  (clips done, driver [MB], worker [MB]) at every look
    stamps  when each output was written; one that is solved twice has two
    """

    clips: Path
    out: Path
    count: int
    rng: random.Random = field(default_factory=lambda: random.Random(SEED))
    done_to_it: dict[str, int] = field(default_factory=lambda: {"workers killed": 0, "programs killed": 0, "disk": 0})
    memory: list[tuple[int, float, float]] = field(default_factory=list)
    stamps: dict[str, int] = field(default_factory=dict)
    twice: int = 0

    def started(self, stderr: Any = subprocess.DEVNULL) -> subprocess.Popen[bytes]:
        words = ("batch", str(self.clips), "-o", str(self.out), "--workers", str(WORKERS), "--no-report")
        return subprocess.Popen(dynsplines(*words), stdout=subprocess.DEVNULL, stderr=stderr)

    @property
    def done(self) -> int:
        return sum(1 for _ in self.out.glob("*.npz"))

    def check_finished(self) -> None:
        """At what is finished: whether any of it was written again."""
        for path in self.out.glob("*.npz"):
            stamp = path.stat().st_mtime_ns
            self.twice += self.stamps.setdefault(path.name, stamp) != stamp
            self.stamps[path.name] = stamp

    def disturbed(self, until: int, report: Any) -> None:
        """Kills a worker process or the program after every few clips, until so many are done."""
        while self.done < until:
            program = self.started()
            while self._goes_on(program, until):
                workers = solvers(program.pid)
                if workers and self.rng.random() < SHARE_OF_WORKERS:
                    with suppress(ProcessLookupError):
                        os.kill(self.rng.choice(workers), signal.SIGKILL)
                    self.done_to_it["workers killed"] += 1
                    continue
                number = self.rng.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM])
                self.done_to_it["programs killed"] += 1
                ended(program, number)
            if program.poll() is None:
                ended(program, signal.SIGTERM)
            self.check_finished()
            report(f"{self.done} of {self.count}: {self.done_to_it}")

    def _goes_on(self, program: subprocess.Popen[bytes], until: int) -> bool:
        """Waits for a few clips and a moment more; whether the program is still there, and clips are left."""
        aim = min(until, self.done + self.rng.randint(1, max(2, self.count // 40)))
        end = time.monotonic() + PATIENCE
        while program.poll() is None and self.done < aim:
            if time.monotonic() > end:
                raise TimeoutError("the batch does not go on")
            time.sleep(0.05)
        time.sleep(self.rng.uniform(0, MOMENT))
        return program.poll() is None and self.done < until

    def on_full_disk(self) -> str:
        """Run the same command while the disk fills up; its last line."""
        ballast = self.out / "ballast"
        program = self.started(subprocess.PIPE)
        before = self.done
        while self.done < before + 5 and program.poll() is None:
            time.sleep(0.1)
        free = shutil.disk_usage(self.out).free
        with ballast.open("wb") as stream, suppress(OSError):
            for _ in range(max(0, free // 1000 - ROOM)):
                stream.write(bytes(1000))
        try:
            _, stderr = program.communicate(timeout=PATIENCE)
        finally:
            ballast.unlink()
        self.done_to_it["disk"] += 1
        self.check_finished()
        return (stderr.decode().splitlines() or [""])[-1]

    def watched(self) -> float:
        """The rest, undisturbed but for looks at memory; how long it took [s]."""
        begin = time.monotonic()
        program = self.started()
        while program.poll() is None:
            workers = [resident(pid) for pid in solvers(program.pid)]
            if workers:
                self.memory.append((self.done, resident(program.pid), max(workers)))
            time.sleep(LOOK)
        if program.returncode:
            raise RuntimeError(f"the last run ended with {program.returncode}")
        self.check_finished()
        return time.monotonic() - begin

    def grown(self, column: int) -> float:
        """The growth of memory from the first quarter of the watched clips to the last, in percent."""
        first = self.memory[0][0]
        part = [(row[0] - first) / max(self.count - first, 1) for row in self.memory]
        early = [row[column] for row, at in zip(self.memory, part, strict=True) if STARTING < at < 0.25]
        late = [row[column] for row, at in zip(self.memory, part, strict=True) if at > 0.75]
        return 100 * (median(late) / median(early) - 1)

    def verdict(self) -> dict[str, int]:
        """The number of missing, duplicate, damaged and foreign outputs."""
        from dynsplines import motion

        lines = (self.out / "manifest.jsonl").read_bytes().splitlines()
        entries = [json.loads(line) for line in lines]
        finished = {entry["clip"]: entry for entry in entries if entry["state"] == "done"}
        damaged = 0
        for name, entry in finished.items():
            ((output, digest),) = entry["files"].items()
            path = self.out / output
            try:
                same = hashlib.sha256(path.read_bytes()).hexdigest() == digest
                damaged += not same or motion.load(path).name != name
            except Exception:
                damaged += 1
        others = {path.name for path in self.out.iterdir()} - {
            file for entry in finished.values() for file in entry["files"]
        }
        return {
            "missing": self.count - len(finished),
            "twice": sum(entry["state"] == "done" for entry in entries) - len(finished) + self.twice,
            "damaged": damaged,
            "other files": len(others - {"manifest.jsonl"}),
        }


def written(folder: Path, count: int) -> Path:
    """So many clips, no two alike."""
    folder.mkdir()
    (folder / "tiny.xml").write_text(FIGURE, encoding="utf-8")
    for i in range(count):
        text = CLIP.format(turn=round(90 + 0.03 * i, 2), bend=round(20 + 0.02 * i, 2))
        (folder / f"clip{i:04}.toml").write_text(text, encoding="utf-8")
    return folder


def solvers(driver: int) -> list[int]:
    """The processes that solve."""
    import psutil

    pids = []
    with suppress(psutil.Error):
        for child in psutil.Process(driver).children(recursive=True):
            with suppress(psutil.Error):
                pids += [child.pid] if any("spawn_main" in word for word in child.cmdline()) else []
    return pids


def resident(number: int) -> float:
    """[MB]"""
    import psutil

    with suppress(psutil.Error):
        return psutil.Process(number).memory_info().rss / 1e6
    return 0.0


def ended(program: subprocess.Popen[bytes], number: int) -> None:
    """The program and, once it has gone, all of its processes."""
    import psutil

    family = []
    with suppress(psutil.Error):
        family = psutil.Process(program.pid).children(recursive=True)
    program.send_signal(number)
    program.wait(PATIENCE)
    _, alive = psutil.wait_procs(family, timeout=60)
    if alive:
        raise RuntimeError(f"{len(alive)} processes outlived their program")


@contextmanager
def disk(folder: Path, megabytes: int) -> Iterator[Path]:
    """A disk of its own, in memory, where that may be mounted; otherwise just the folder."""
    place = folder / "disk"
    place.mkdir()
    words = ["mount", "-t", "tmpfs", "-o", f"size={megabytes}m", "tmpfs", str(place)]
    mounted = sys.platform == "linux" and subprocess.run(words, capture_output=True, check=False).returncode == 0
    try:
        yield place if mounted else folder
    finally:
        if mounted:
            subprocess.run(["umount", str(place)], check=False)


def measure(effort: Effort) -> Section:
    section = Section("A batch that is not let alone", ("what", "count"))
    if peer("psutil") is None:
        section.add("skipped: not installed (pip install '.[batch]')", "–")
        return section
    count = effort.count(2000, 60)
    with tempfile.TemporaryDirectory() as folder, disk(Path(folder), 20 + count // 10) as place:
        soak = Soak(written(Path(folder) / "clips", count), place / "out", count)
        soak.out.mkdir()
        soak.disturbed(int(FULL * count), effort.report)
        full_disk = soak.on_full_disk() if place.name == "disk" else "not tried: no disk may be mounted here"
        effort.report(full_disk)
        soak.disturbed(int(QUIET * count), effort.report)
        before = soak.done
        spent = soak.watched()
        verdict = soak.verdict()
    for name, number in {"clips": count, **soak.done_to_it, **verdict}.items():
        section.add(name, number)
    grown = {who: soak.grown(column) for column, who in ((1, "the program"), (2, "its largest worker process"))}
    section.targets = [
        Target("clips missing, twice or damaged, and other files", float(sum(verdict.values())), 0.0),
        *(Target(f"memory of {who}, last quarter over first", more, 5.0, unit="%") for who, more in grown.items()),
    ]
    section.notes = [
        f"`dynsplines batch --no-report --workers {WORKERS}`: until half of the clips are done a worker process or the "
        "program is killed after every few (SIGKILL, SIGTERM), and given again; SHA-256 of every file against the "
        "manifest, and every file is read",
        f"the disk was full once, where one may be mounted for it: {full_disk}",
        f"memory: medians over the last {count - before} clips, undisturbed, in {spent:.0f} s",
    ]
    section.data = {"done": soak.done_to_it, "found": verdict, "memory": soak.memory, "grown": grown, "full": full_disk}
    return section


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that its disk goes with it
    clip_count = int(sys.argv[1]) if len(sys.argv) > 1 else 2000

    class FixedEffort(Effort):
        def count(self, full: int, quick: int) -> int:
            return clip_count

    result = measure(FixedEffort(report=lambda line: print(line, flush=True)))
    for row in result.rows:
        print(*row)
    for target in result.targets:
        print(target.what, target.value, "met" if target.met else "missed")
    print(*result.notes, sep="\n")
