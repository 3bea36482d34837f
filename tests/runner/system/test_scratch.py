"""Temporary folders: gone with their block or with the next program's, never while anybody uses them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from problems import names

from dynsplines.system import scratch as module
from dynsplines.system.scratch import PREFIX, scratch

POSIX = pytest.mark.skipif(os.name == "nt", reason="no file locks on Windows, so nothing is removed")
HOLDER = """
import sys
from dynsplines.system.scratch import scratch
with scratch() as folder:
    (folder / "inner").mkdir()
    (folder / "inner" / "file").write_text("in use")
    print(folder, flush=True)
    sys.stdin.read()
"""


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr(tempfile, "tempdir", None)
    return tmp_path


@pytest.fixture
def holder(place: Path) -> Iterator[Callable[[], tuple[subprocess.Popen[str], Path]]]:
    """Starts a process that holds a folder; tells which."""
    begun: list[subprocess.Popen[str]] = []

    def start() -> tuple[subprocess.Popen[str], Path]:
        command = [sys.executable, "-c", HOLDER]
        begun.append(subprocess.Popen(command, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE))
        assert begun[-1].stdout is not None
        return begun[-1], Path(begun[-1].stdout.readline().strip())

    yield start
    for process in begun:
        process.kill()
        process.communicate()


def test_a_folder_goes_with_its_block_however_that_ends(place: Path):
    with scratch() as folder:
        (folder / "inner").mkdir()
        (folder / "inner/file").write_text("x")
        assert folder.parent == place and names(place) == [folder.name]
        assert os.name == "nt" or folder.stat().st_mode & 0o777 == 0o700
    assert not names(place)
    with pytest.raises(KeyError), scratch():
        raise KeyError
    assert not names(place)


@POSIX
def test_what_a_killed_program_left_goes_with_the_next_folder_and_one_in_use_stays(place: Path, holder):
    killed, left = holder()
    _, used = holder()
    killed.send_signal(signal.SIGKILL)
    killed.wait()
    assert (left / "inner/file").exists()
    with scratch() as folder, scratch() as other:
        assert names(place) == sorted([used.name, folder.name, other.name])
    assert (used / "inner/file").read_text() == "in use"


@POSIX
def test_what_is_another_users_or_no_folder_of_ours_stays(place: Path, monkeypatch: pytest.MonkeyPatch):
    (place / "elsewhere").mkdir(mode=0o700)
    (place / f"{PREFIX}link").symlink_to(place / "elsewhere")
    (place / f"{PREFIX}file").write_text("x")
    (place / f"{PREFIX}open").mkdir(mode=0o777)
    (place / f"{PREFIX}open").chmod(0o777)
    (place / "dynsplines-other").mkdir(mode=0o700)
    before = names(place)
    with scratch():
        pass
    assert names(place) == before
    (place / f"{PREFIX}theirs").mkdir(mode=0o700)
    mine = os.geteuid()
    with monkeypatch.context() as patch:
        patch.setattr(module.os, "geteuid", lambda: mine + 1)  # seen from another user who may remove it, as root may
        with scratch():
            pass
    assert (place / f"{PREFIX}theirs").exists()
    with scratch():
        pass
    assert names(place) == before
