"""Ctrl-C, SIGTERM and a hangup end a command in one way, at any time, and what has been found by then is kept."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from problems import ENDLESS, names, written

pytestmark = pytest.mark.skipif(os.name == "nt", reason="needs POSIX signals")

DEFAULT = "import signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
COMMAND = DEFAULT + "sys.argv = sys.argv[1:]; from dynsplines.__main__ import main; main()"
INTERRUPTED = (
    DEFAULT
    + """
import importlib.abc, os
number, wanted = int(sys.argv[1]), sys.argv[2]
class Interrupting(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path, target=None):
        if name == wanted:
            sys.meta_path.remove(self)
            os.kill(os.getpid(), number)
sys.meta_path.insert(0, Interrupting())
sys.argv = sys.argv[3:]
from dynsplines.__main__ import main; main()"""
)
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143}
Start = Callable[..., "subprocess.Popen[str]"]


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Start]:
    """Starts the command in the test's folder, beside the tiny clip and one that takes for ever."""
    written(tmp_path)
    written(tmp_path, ENDLESS, "long.toml")
    begun: list[subprocess.Popen[str]] = []

    def start(script: str, *words: object) -> subprocess.Popen[str]:
        command = [sys.executable, "-c", script, *map(str, words)]
        begun.append(subprocess.Popen(command, cwd=tmp_path, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE))
        return begun[-1]

    yield start
    for process in begun:
        process.kill()
        process.communicate()


@pytest.mark.slow
@pytest.mark.parametrize(("number", "module"), [(signal.SIGINT, "mujoco"), (signal.SIGTERM, "typer")])
def test_a_signal_in_the_first_imports_ends_in_one_line(start: Start, number: signal.Signals, module: str):
    process = start(INTERRUPTED, int(number), module, "dynsplines", "solve", "tiny.toml")
    out, said = process.communicate(timeout=60)
    assert (process.returncode, out, said) == (CODES[number], "", "dynsplines: stopped\n")


@pytest.mark.slow
def test_a_termination_while_solving_keeps_the_best_path_and_reports_it_in_the_exit_code(start: Start, tmp_path: Path):
    """And a hangup that the command is started to ignore stays ignored."""
    script = COMMAND.replace(DEFAULT, DEFAULT + "signal.signal(signal.SIGHUP, signal.SIG_IGN)\n")
    process = start(script, "dynsplines", "solve", "long.toml")
    assert process.stderr is not None
    assert "solving" in process.stderr.readline()
    process.send_signal(signal.SIGHUP)
    time.sleep(0.3)
    assert process.poll() is None
    process.send_signal(signal.SIGTERM)
    _, said = process.communicate(timeout=60)
    assert process.returncode == CODES[signal.SIGTERM]
    assert "the best path so far is kept" in said
    assert "Traceback" not in said
    with np.load(tmp_path / "long.npz") as data:
        assert "interrupted" in json.loads(str(data["search"]))["stopped because"]
    assert not [path.name for path in tmp_path.iterdir() if path.name.startswith(".")]


@pytest.mark.slow
def test_a_termination_while_solving_draws_no_video(start: Start, tmp_path: Path):
    process = start(COMMAND, "dynsplines", "render", "long.toml", "-o", "long.mp4")
    assert process.stderr is not None
    assert any("solving" in line for line in process.stderr)
    process.send_signal(signal.SIGTERM)
    _, said = process.communicate(timeout=60)
    assert process.returncode == CODES[signal.SIGTERM]
    assert said.endswith("nothing is drawn after this signal\ndynsplines: stopped\n")
    assert not (tmp_path / "long.mp4").exists()


@pytest.mark.slow
def test_a_second_ctrl_c_only_cuts_the_measuring_short(start: Start, tmp_path: Path):
    process = start(COMMAND, "dynsplines", "report", "long.toml", "--json")
    assert process.stderr is not None
    assert "solving" in process.stderr.readline()
    process.send_signal(signal.SIGINT)
    assert any("the best path so far is kept" in line for line in process.stderr)
    process.send_signal(signal.SIGINT)
    out, said = process.communicate(timeout=60)
    assert process.returncode == 0
    assert "Traceback" not in said
    assert json.loads(out)["after"]["keyframe error"] < 1e-12
    assert names(tmp_path) == ["hinge.xml", "long.toml", "tiny.toml", "tiny.xml"]
