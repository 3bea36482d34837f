"""What is left to do when a batch is begun again."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from quiet import quiet
from tiny import CLIP, FIGURE, changed, written

pytest.importorskip("psutil")

from dynsplines.batch.dispatch import Batch
from dynsplines.batch.inputs import sources
from dynsplines.batch.manifest import Entry, Manifest, digest_of
from dynsplines.batch.solving import solved
from dynsplines.batch.task import Options


@pytest.fixture
def manifest(tmp_path: Path) -> Manifest:
    """Of a folder beside the clips tiny.toml and other.toml."""
    written(tmp_path)
    written(tmp_path, changed("fps = 20", "fps = 30"), "other.toml")
    (tmp_path / "out").mkdir()
    return Manifest.of(tmp_path / "out")


def left(manifest: Manifest, options: Options = Options()) -> list[str]:  # noqa: B008
    """The clips that a command has left to do, by a program that starts anew."""
    manifest = Manifest.of(manifest.path.parent)
    folder = manifest.path.parent.parent
    found = sources([str(folder / "tiny.toml"), str(folder / "other.toml")])
    batch = Batch(manifest, options, quiet(), solved)
    assert batch.plan(found) == ["tiny", "other"]
    return [name for name, _ in batch.waiting]


def end(manifest: Manifest, name: str, **changes: Any) -> Entry:
    """A clip's end is written down."""
    entry = replace(Manifest.of(manifest.path.parent).entries[name], **changes)
    again = Manifest.of(manifest.path.parent)
    again.record([entry])
    return entry


def finish(manifest: Manifest, name: str) -> None:
    (manifest.path.parent / f"{name}.csv").write_bytes(b"data")
    end(manifest, name, state="done", attempts=1, files={f"{name}.csv": digest_of(b"data")})


def test_all_is_queued_at_first_and_what_is_done_and_there_is_left_alone(manifest: Manifest):
    assert left(manifest) == ["tiny", "other"]
    assert {entry.state for entry in Manifest.of(manifest.path.parent).entries.values()} == {"queued"}
    finish(manifest, "other")
    assert left(manifest) == ["tiny"]
    (manifest.path.parent / "other.csv").write_bytes(b"d\0ta")
    assert left(manifest) == ["tiny", "other"]
    (manifest.path.parent / "other.csv").unlink()
    assert left(manifest) == ["tiny", "other"]


def test_what_was_running_when_the_program_was_killed_is_queued(manifest: Manifest):
    left(manifest)
    end(manifest, "tiny", state="running", attempts=2, worker="tcp://a")
    assert left(manifest) == ["tiny", "other"]
    again = Manifest.of(manifest.path.parent).entries["tiny"]
    assert (again.state, again.attempts) == ("queued", 0)


def test_a_clip_a_figure_or_an_option_that_changes_is_done_again(manifest: Manifest):
    folder = manifest.path.parent.parent
    left(manifest)
    finish(manifest, "tiny")
    finish(manifest, "other")
    assert left(manifest) == []
    assert left(manifest, Options(report=True)) == ["tiny", "other"]
    assert left(manifest, Options(fps=7.0)) == ["tiny", "other"]
    left(manifest)
    finish(manifest, "tiny")
    finish(manifest, "other")
    (folder / "tiny.toml").write_text(CLIP.replace("fps = 20", "fps = 21"), encoding="utf-8")
    assert left(manifest) == ["tiny"]
    assert Manifest.of(manifest.path.parent).entries["tiny"].attempts == 0
    finish(manifest, "tiny")
    (folder / "tiny.xml").write_text(FIGURE.replace('mass="4"', 'mass="5"'), encoding="utf-8")
    assert left(manifest) == ["tiny", "other"]


@pytest.mark.parametrize(
    ("cause", "bound", "options", "again"),
    [
        ("error", None, Options(), False),
        ("error", None, Options(retry_failed=True), True),
        ("lost", None, Options(), True),
        ("time", 3.0, Options(limit_time=3.0), False),
        ("time", 3.0, Options(limit_time=5.0), True),
        ("memory", 500.0, Options(limit_time=3.0, limit_memory=500.0), False),
        ("memory", 500.0, Options(limit_time=3.0), False),
        ("memory", 500.0, Options(limit_time=3.0, limit_memory=700.0), True),
    ],
)
def test_what_failed_is_done_again_if_it_may_go_better(manifest: Manifest, cause, bound, options, again: bool):
    left(manifest)
    finish(manifest, "other")
    end(manifest, "tiny", state="failed", attempts=1, cause=cause, bound=bound, error="it did not work")
    assert left(manifest, options) == (["tiny"] if again else [])
    entry = Manifest.of(manifest.path.parent).entries["tiny"]
    assert (entry.state, entry.error) == (("queued", "") if again else ("failed", "it did not work"))


def test_a_clip_that_cannot_be_read_waits_for_its_turn(manifest: Manifest, monkeypatch: pytest.MonkeyPatch):
    def gone(path: Path) -> bytes:
        raise FileNotFoundError(2, "No such file or directory", str(path))

    monkeypatch.setattr(Path, "read_bytes", gone)
    found = sources([str(manifest.path.parent.parent / "tiny.toml")])
    batch = Batch(manifest, Options(), quiet(), solved)
    batch.plan(found)
    assert [name for name, _ in batch.waiting] == ["tiny"]
    assert manifest.entries["tiny"].input == ""
