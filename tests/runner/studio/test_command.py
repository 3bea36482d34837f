"""The command `studio`: what it refuses, what it prints, and how it ends."""

import sys

import browser as browsers
import problems
import pytest
from processes import refusal


def test_what_cannot_be_is_one_line_and_exit_code_2(command):
    assert "65535" in refusal(command("studio", "--port", "70000", "--no-browser"))


def test_without_its_packages_it_says_which_command_brings_them(command, monkeypatch):
    monkeypatch.setitem(sys.modules, "tomlkit", None)
    assert "pip install 'dynamic-splines[studio]'" in refusal(command("studio"))


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
