"""Runs the command many times under conditions that are against it, each in a fork of one process that has all imports.

A line of JSON in, one out: `words` of the command, `before`, Python that makes the conditions, and the `signal` that it
sends to itself `at` a call of one of our functions, or `calls`, to count them. Out come exit code, both streams, calls.
"""

import gc
import importlib
import json
import os
import pkgutil
import re
import signal
import sys
import tempfile
import threading
import time
import traceback
from functools import cache
from pathlib import Path

PATIENCE = 120.0  # [s]
OWN = ("/runner/", "/solver/")  # files whose functions count


def main() -> None:
    """Imports everything once, for all forks, but for batches and the studio."""
    import dynsplines

    for module in pkgutil.walk_packages(dynsplines.__path__, "dynsplines."):
        if not re.search(r"\.(__main__|batch|studio)\b", module.name):
            importlib.import_module(module.name)
    gc.freeze()  # forks share what no collection visits
    for line in sys.stdin:
        print(json.dumps(tried(json.loads(line))), flush=True)


def tried(case: dict) -> dict:
    """One run of the command, in a fork; its streams are pipes, which no limit on files counts."""
    with tempfile.TemporaryDirectory() as folder:
        calls, pipes = Path(folder) / "calls", [os.pipe(), os.pipe()]
        child = os.fork()
        if not child:
            for number, (reading, writing) in enumerate(pipes, 1):
                os.dup2(writing, number)
                os.close(writing)
                os.close(reading)
            sys.stdout, sys.stderr = (os.fdopen(number, "w", closefd=False) for number in (1, 2))
            _run(case, calls)
        heard = [b"", b""]
        listening = [threading.Thread(target=_read_pipe, args=(heard, i, pipe)) for i, pipe in enumerate(pipes)]
        for each in listening:
            each.start()
        end = time.monotonic() + PATIENCE
        while not (found := os.waitpid(child, os.WNOHANG))[0]:
            if time.monotonic() > end:
                os.kill(child, signal.SIGKILL)
            time.sleep(0.005)
        for each in listening:
            each.join()
        counted = int(calls.read_text()) if calls.exists() else 0
    out, said = (data.decode("utf-8", "replace") for data in heard)
    return {"code": os.waitstatus_to_exitcode(found[1]), "out": out, "err": said, "calls": counted}


def _read_pipe(outputs: list[bytes], number: int, pipe: tuple[int, int]) -> None:
    """All that comes out of a pipe."""
    os.close(pipe[1])
    with os.fdopen(pipe[0], "rb") as stream:
        outputs[number] = stream.read()


def _run(case: dict, calls: Path) -> None:
    """The command, to the process's end."""
    from dynsplines.__main__ import main as command

    code = 99
    try:
        sys.argv = ["dynsplines", *case["words"]]
        counted = _count(case)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        exec(case.get("before", ""), {})
        try:
            command()
        finally:
            sys.settrace(None)
            if "calls" in case:
                calls.write_text(str(counted[0]))
    except SystemExit as ended:
        code = ended.code if isinstance(ended.code, int) else 0 if ended.code is None else 1
    except BaseException:
        traceback.print_exc()
    finally:
        try:
            for stream in (sys.stdout, sys.stderr):
                if stream is not None:
                    stream.flush()
        except BaseException:
            code = code or 120  # as Python does
        os._exit(code)


def _count(case: dict) -> list[int]:
    """Counts calls of our own functions from now on, and sends the signal at the one that was asked for."""
    counted, wanted, is_own = [0], case.get("at"), cache(lambda name: any(part in name for part in OWN))

    def trace(frame, event, _):  # of calls of Python functions alone
        if is_own(frame.f_code.co_filename):
            counted[0] += 1
            if counted[0] == wanted:
                sys.settrace(None)
                os.kill(os.getpid(), case["signal"])

    if wanted is not None or "calls" in case:
        sys.settrace(trace)
    return counted


if __name__ == "__main__":
    main()
