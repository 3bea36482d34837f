"""Files changed at random, in processes of their own, which may end in any way and are then started again.

python benchmarks/strange_files.py 300         some 140,000 files of all kinds, in one or two hours
python benchmarks/strange_files.py clip.toml 42      the file number 42 of a kind, and the error that it causes
"""

from __future__ import annotations

import os
import resource
import select
import subprocess
import sys
import tempfile
import time
import traceback
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO

TESTS = Path(__file__).parents[1] / "tests"
sys.path[:0] = [str(TESTS), str(TESTS / "support")]

from fuzz import strange  # noqa: E402
from fuzz.strange import READ, REFUSED, attempt  # noqa: E402

MOST_MEGABYTES = 1000.0  # of a process, at its peak
ROOM = 6 * 2**30  # [bytes] of addresses: a process that needs more fails, and the machine is spared
MOST_SECONDS = 60.0  # of one file, by the clock of a machine that others use as well
START_SECONDS = 120.0  # of a process, until it has its first file
EACH = 3000  # files that one process tries, so that what it leaves behind is counted to no file
ALL = 300  # of the short argument: all files of every kind


@dataclass
class Tally:
    """How many files were tried, what they ended in, and the seeds of those that ended badly, with what happened.

    slowest [s] of the processor, most [MB] of a process, with the seeds
    """

    ended: Counter[str] = field(default_factory=Counter)
    bad: dict[int, str] = field(default_factory=dict)
    slowest: tuple[float, int] = (0.0, -1)
    most: float = 0.0

    @property
    def tried(self) -> int:
        return sum(self.ended.values()) + len(self.bad)

    @property
    def line(self) -> str:
        said = f"{self.tried} tried, {self.ended[READ]} read, {self.ended[REFUSED]} refused, {len(self.bad)} bad"
        return f"{said}; slowest {self.slowest[0]:.2f} s (seed {self.slowest[1]}), most {self.most:.0f} MB"


def tried(kind: str, count: int, folder: Path, *, start: int = 0) -> Tally:
    """So many files of a kind, by processes; files that end badly stay in the folder."""
    tally, seed, stop = Tally(), start, start + count
    while seed < stop:
        seed = _batch(kind, seed, min(seed + EACH, stop), folder, tally)
    return tally


def _batch(kind: str, start: int, stop: int, folder: Path, tally: Tally) -> int:
    """By one process; the first seed that is left."""
    command = [sys.executable, __file__, kind, str(start), str(stop), str(folder)]
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    with (folder / "errors.txt").open("ab") as errors:
        process = subprocess.Popen(
            command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=errors, bufsize=0
        )
    assert process.stdout is not None
    seed = start
    try:
        while seed < stop:
            line = _line(process.stdout, MOST_SECONDS if seed > start else START_SECONDS + MOST_SECONDS)
            if line is None:
                process.kill()
                tally.bad[seed] = f"a hang: over {MOST_SECONDS:g} s"
                return seed + 1
            if not line:
                tally.bad[seed] = f"the process ended with {process.wait()}"
                return seed + 1
            seconds, megabytes, how = line.decode().rstrip("\n").split(" ", 2)
            tally.slowest = max(tally.slowest, (float(seconds), seed))
            tally.most = max(tally.most, float(megabytes))
            if how in (READ, REFUSED):
                tally.ended[how] += 1
            else:
                tally.bad[seed] = how
            seed += 1
            if float(megabytes) > MOST_MEGABYTES:
                tally.bad.setdefault(seed - 1, f"{megabytes} MB")
                return seed
        return seed
    finally:
        if seed < stop:
            process.kill()
        process.communicate()


def _line(stream: IO[bytes], seconds: float) -> bytes | None:
    """What the process says of a file; nothing if it has ended, None if it is at it for too long."""
    ready, _, _ = select.select([stream], [], [], seconds)
    return stream.readline() if ready else None


def _serve(name: str, start: int, stop: int, output_folder: Path) -> None:
    """A line a file, in a folder that goes; a process that dies leaves it."""
    talk = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    resource.setrlimit(resource.RLIMIT_AS, (ROOM, ROOM))
    kind = strange.KINDS[name]
    folder = Path(tempfile.mkdtemp(prefix=f"{name}.", dir=output_folder))
    for other, text in kind.beside:
        (folder / other).write_text(text, encoding="utf-8")
    os.chdir(folder)
    for seed in range(start, stop):
        begin = time.process_time()
        try:
            how = attempt(kind, seed, folder)
        except Exception as error:
            at = traceback.extract_tb(error.__traceback__)[-1]
            how = f"{type(error).__name__}: {' '.join(str(error).split())[:200]} ({Path(at.filename).name}:{at.lineno})"
            (output_folder / f"bad.{seed}.{name}").write_bytes((folder / name).read_bytes())
        peak = _peak()
        print(
            f"{time.process_time() - begin:.3f} {peak:.0f} {how.encode('ascii', 'backslashreplace').decode()}",
            file=talk,
        )
    for path in folder.iterdir():
        path.unlink()
    folder.rmdir()


def _peak() -> float:
    """The largest size of this process [MB]; its resource usage counts the process that started it as well."""
    status = Path("/proc/self/status")
    if not status.exists():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    (line,) = (line for line in status.read_text().splitlines() if line.startswith("VmHWM"))
    return float(line.split()[1]) / 1024


def main() -> None:
    words = sys.argv[1:]
    if len(words) == 4:
        _serve(words[0], int(words[1]), int(words[2]), Path(words[3]))
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if len(words) == 2:
            kind = strange.KINDS[words[0]]
            for other, text in kind.beside:
                (folder / other).write_text(text, encoding="utf-8")
            os.chdir(folder)
            print(attempt(kind, int(words[1]), folder))
            return
        tallies = {}
        for each in strange.KINDS.values():
            tallies[each.name] = tried(each.name, round(each.long * int(words[0]) / ALL), folder)
            print(f"{each.name}: {tallies[each.name].line}", *tallies[each.name].bad.items(), sep="\n  ", flush=True)
    if any(tally.bad for tally in tallies.values()):
        raise SystemExit(1)


if __name__ == "__main__":
    main()
