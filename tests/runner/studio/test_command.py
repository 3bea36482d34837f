"""The command `studio`: what it refuses, what it prints, and how it ends."""

from __future__ import annotations

import subprocess
import sys

import browser as browsers
import problems
import pytest

COMMAND = [sys.executable, "-c", browsers.COMMAND, "studio"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "told"), [(["--host", "0.0.0.0"], "add --allow-remote to allow it"), (["--port", "70000"], "65535")]
)
def test_what_cannot_be_is_one_line_and_exit_code_2(tmp_path, words, told):
    done = subprocess.run([*COMMAND, *words, "--no-browser"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert told in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert done.stdout == ""


@pytest.mark.slow
def test_without_its_packages_it_says_which_command_brings_them(tmp_path):
    hidden = "import sys; sys.modules['tomlkit'] = None; " + browsers.COMMAND.removeprefix("import sys; ")
    done = subprocess.run(
        [sys.executable, "-c", hidden, "studio"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert "pip install 'dynamic-splines[studio]'" in done.stderr


@pytest.mark.slow
def test_ctrl_c_ends_it_with_no_process_left(tmp_path):
    import psutil

    problems.written(tmp_path)
    running = browsers.Studio(tmp_path, "tiny.toml")
    children = psutil.Process(running.process.pid).children(recursive=True)
    said = running.end()
    assert "Traceback" not in said
    _, alive = psutil.wait_procs(children, timeout=10)
    assert alive == []
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]
