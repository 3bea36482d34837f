"""The manifest of a batch is right whatever ended the program, and one program at a time writes it."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest

from dynsplines.batch.manifest import Entry, Manifest, digest_of
from dynsplines.errors import UserError
from dynsplines.system.lock import locked

pytestmark = pytest.mark.skipif(os.name == "nt", reason="needs POSIX locks")

WALK = Entry(clip="walk", source="../clips/walk.toml", state="running", input="abc", attempts=1)
DONE = replace(WALK, state="done", seconds=0.5, files={"walk.npz": "0"})
RUN = Entry(
    clip="sub/run",
    source="../clips/sub/run.toml",
    state="failed",
    input="def",
    attempts=2,
    cause="time",
    bound=3.0,
    error="too 'long'",
)


def lines(folder: Path) -> list[dict[str, object]]:
    return [json.loads(line) for line in (folder / "manifest.jsonl").read_text(encoding="utf-8").splitlines()]


def test_the_last_line_about_a_clip_counts(tmp_path: Path):
    manifest = Manifest.of(tmp_path)
    manifest.record([WALK, RUN])
    manifest.record([DONE])
    assert [line.get("clip") for line in lines(tmp_path)] == [None, "walk", "sub/run", "walk"]
    assert Manifest.of(tmp_path).entries == {"walk": DONE, "sub/run": RUN} == manifest.entries
    manifest.rewrite()
    assert [line.get("clip") for line in lines(tmp_path)] == [None, "walk", "sub/run"]
    assert Manifest.of(tmp_path).entries == manifest.entries


def test_wherever_the_last_line_is_cut_what_came_before_it_stands(tmp_path: Path):
    manifest = Manifest.of(tmp_path)
    manifest.record([WALK, RUN])
    before = manifest.path.stat().st_size
    manifest.record([DONE])
    whole = manifest.path.read_bytes()
    for end in range(before, len(whole)):
        manifest.path.write_bytes(whole[:end])
        assert Manifest.of(tmp_path).entries == {"walk": WALK, "sub/run": RUN}
    Manifest.of(tmp_path).record([DONE])
    assert Manifest.of(tmp_path).entries == {"walk": DONE, "sub/run": RUN}


@pytest.mark.parametrize("line", ["nonsense", '{"clip": "a"}', '{"clip": "a", "source": "a", "state": "lost"}', "[]"])
def test_a_line_that_is_none_is_named(tmp_path: Path, line: str):
    (tmp_path / "manifest.jsonl").write_text(f'{{"dynsplines batch": 1}}\n{line}\n{WALK.line()}', encoding="utf-8")
    with pytest.raises(UserError, match=r"manifest\.jsonl: line 2 is not an entry of a clip"):
        Manifest.of(tmp_path)


def test_a_manifest_of_another_version_is_refused(tmp_path: Path):
    (tmp_path / "manifest.jsonl").write_text('{"dynsplines batch": 99}\n', encoding="utf-8")
    with pytest.raises(UserError, match="another version"):
        Manifest.of(tmp_path)


def test_a_manifest_with_former_names_is_read_without_its_files(tmp_path: Path):
    line = DONE.line().replace('"files"', '"companions"')
    assert '"companions"' in line
    (tmp_path / "manifest.jsonl").write_text(f'{{"dynsplines batch": 1}}\n{line}', encoding="utf-8")
    assert Manifest.of(tmp_path).entries["walk"] == replace(DONE, files={})


def test_an_output_counts_only_if_it_is_whole(tmp_path: Path):
    path = tmp_path / "walk.npz"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("time.npy", bytes(1000))
    entry = replace(DONE, files={"walk.npz": digest_of(path.read_bytes())})
    assert entry.is_intact(tmp_path)
    data = path.read_bytes()
    path.write_bytes(data[:-5])
    assert not entry.is_intact(tmp_path)
    path.write_bytes(data[:-40] + bytes(40))
    assert not entry.is_intact(tmp_path)
    path.unlink()
    assert not entry.is_intact(tmp_path)
    assert not replace(entry, files={}).is_intact(tmp_path)


def test_a_second_program_is_refused_and_the_other_process_is_named(tmp_path: Path):
    with locked(tmp_path):
        who = f"by process {os.getpid()} on {socket.gethostname()} since"
        with pytest.raises(UserError, match=who), locked(tmp_path):
            pass
        with pytest.raises(UserError, match="wait for it, or end it"), locked(tmp_path):
            pass
    with locked(tmp_path):
        pass
    assert list(tmp_path.iterdir()) == []


def test_the_lock_of_a_killed_program_is_taken_over(tmp_path: Path):
    code = (
        "import os, signal, sys; from pathlib import Path; from dynsplines.system.lock import locked\n"
        "with locked(Path(sys.argv[1])): os.kill(os.getpid(), signal.SIGKILL)"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    ended = subprocess.run([sys.executable, "-c", code, tmp_path], env=environment, check=False)
    assert ended.returncode == -signal.SIGKILL
    assert json.loads((tmp_path / "manifest.lock").read_text(encoding="utf-8"))["host"] == socket.gethostname()
    with locked(tmp_path):
        assert json.loads((tmp_path / "manifest.lock").read_text(encoding="utf-8"))["pid"] == os.getpid()


def test_the_lock_of_another_host_is_believed(tmp_path: Path):
    (tmp_path / "manifest.lock").write_text('{"pid": 7, "host": "elsewhere", "since": "noon"}', encoding="utf-8")
    with (
        pytest.raises(UserError, match="process 7 on elsewhere since noon; if that has ended, remove"),
        locked(tmp_path),
    ):
        pass
    (tmp_path / "manifest.lock").unlink()
    with locked(tmp_path):
        pass
