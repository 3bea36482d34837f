"""The tests pass however they are started: what they start hears Ctrl-C and hangups."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

DEAF = """
import signal, subprocess, sys
for each in (signal.SIGINT, signal.SIGHUP):
    signal.signal(each, signal.SIG_IGN)
{heard}
told = "import signal; print(signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGHUP) == signal.SIG_DFL)"
subprocess.run([sys.executable, "-c", told], check=True)
"""


@pytest.mark.skipif(os.name == "nt", reason="signals are another matter there")
def test_what_is_started_by_tests_that_are_deaf_hears():
    def said(heard: str) -> str:
        command = [sys.executable, "-c", DEAF.format(heard=heard)]
        support = str(Path(__file__).parents[1] / "support")
        environment = {**os.environ, "PYTHONPATH": support}
        return subprocess.run(command, env=environment, check=True, capture_output=True, text=True).stdout

    hearing, deaf = said("import signals_heard"), said("")
    assert "default_int_handler" in hearing and hearing.endswith(" True\n")
    assert "default_int_handler" not in deaf and deaf.endswith(" False\n")
