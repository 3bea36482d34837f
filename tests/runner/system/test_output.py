"""Every file is written one way: whole or not at all, through links, to plain files alone, with the right mode."""

import os
import signal
import stat
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from problems import names

from dynsplines import motion
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.motion import Saved
from dynsplines.picture import film
from dynsplines.system.output import Replacement, check_target

POSIX = pytest.mark.skipif(os.name == "nt", reason="needs POSIX modes, links and pipes")
RUNNER = Path(motion.__file__).parent
Write = Callable[[Saved, Path], object]


def filmed(_: Saved, target: Path) -> None:
    film.write(target, [np.full((48, 64, 3), shade, np.uint8) for shade in range(3)], 30)


def exported(saved: Saved, target: Path) -> None:
    formats.export(saved, formats.choose(None, target).name, target)


WRITERS: dict[str, Write] = {".npz": motion.save, ".gif": filmed, ".mp4": filmed, ".csv": exported}


@pytest.fixture
def umask() -> Iterator[None]:
    before = os.umask(0o077)
    yield
    os.umask(before)


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


@POSIX
@pytest.mark.usefixtures("umask")
@pytest.mark.parametrize("ending", WRITERS)
def test_links_and_modes_stay_and_pipes_and_devices_are_refused(saved, tmp_path, ending):
    write = WRITERS[ending]
    (tmp_path / "real").mkdir()
    new, real, link = tmp_path / f"new{ending}", tmp_path / "real" / "file.old", tmp_path / f"link{ending}"
    pipe, device = tmp_path / f"pipe{ending}", tmp_path / f"device{ending}"
    real.write_bytes(b"before")
    real.chmod(0o640)
    link.symlink_to(real)
    os.mkfifo(pipe)
    device.symlink_to("/dev/null")
    write(saved, link)
    assert link.is_symlink() and len(real.read_bytes()) > 20
    write(saved, new)
    assert (mode(new), mode(real)) == (0o600, 0o640)
    for target, words in ((pipe, "it is a pipe"), (device, "it is a device")):
        with pytest.raises(UserError, match=words):
            write(saved, target)
    assert stat.S_ISFIFO(pipe.stat().st_mode) and device.is_symlink()
    assert names(tmp_path) == sorted(["real", *(each.name for each in (new, link, pipe, device))])
    assert names(tmp_path / "real") == ["file.old"]


@POSIX
def test_the_rest_of_the_world_reads_no_half_of_a_file_that_it_may_not_read(tmp_path):
    target = tmp_path / "mine.npz"
    target.write_bytes(b"before")
    target.chmod(0o600)
    with Replacement(target) as temporary:
        assert mode(temporary) == 0o600


@POSIX
def test_links_planted_under_the_names_of_another_time_are_not_followed(saved, tmp_path):
    prey = tmp_path / "prey"
    prey.write_bytes(b"before")
    planted = tmp_path / f".film.{os.getpid()}.partial.gif"
    planted.symlink_to(prey)
    filmed(saved, tmp_path / "film.gif")
    assert prey.read_bytes() == b"before"
    used: set[str] = set()
    for _ in range(3):
        with Replacement(tmp_path / "film.gif") as temporary:
            used.add(temporary.name)
            temporary.write_bytes(b"film")
    assert len(used) == 3


def test_a_link_that_leads_to_itself_is_reported(tmp_path):
    link = tmp_path / "round.npz"
    link.symlink_to(link)
    with pytest.raises(UserError, match=r"cannot write '.*round\.npz'"):
        check_target(link)


def test_the_disk_has_file_and_folder_before_the_writer_continues(tmp_path, monkeypatch):
    synchronised: list[str] = []
    real = os.fsync

    def noted(handle: int) -> None:
        synchronised.append("folder" if stat.S_ISDIR(os.fstat(handle).st_mode) else "file")
        assert (tmp_path / "a.csv").exists() is (synchronised[-1] == "folder")
        real(handle)

    monkeypatch.setattr(os, "fsync", noted)
    with Replacement(tmp_path / "a.csv") as temporary:
        temporary.write_bytes(b"all of it")
    assert synchronised == ["file", "folder"][: 1 if os.name == "nt" else 2]


@POSIX
def test_what_a_killed_program_left_goes_with_the_next_writer_of_that_file_and_nothing_else(tmp_path):
    script = (
        "import os, signal, sys; from pathlib import Path; from dynsplines.system.output import Replacement\n"
        "with Replacement(Path(sys.argv[1])) as path:\n"
        "    path.write_bytes(b'half')\n"
        "    os.kill(os.getpid(), signal.SIGKILL)"
    )
    for name in ("film.gif", "other.gif"):
        ended = subprocess.run([sys.executable, "-c", script, tmp_path / name], cwd=RUNNER.parent, check=False)
        assert ended.returncode == -signal.SIGKILL
    assert len(names(tmp_path)) == 2
    with Replacement(tmp_path / "film.gif") as being_written:
        with Replacement(tmp_path / "film.gif") as temporary:
            temporary.write_bytes(b"whole")
        assert being_written.exists()
        being_written.write_bytes(b"later")
    left = names(tmp_path)
    assert [name.split(".")[1] for name in left if name.startswith(".")] == ["other"]
    assert (tmp_path / "film.gif").read_bytes() == b"later"
