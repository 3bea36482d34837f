"""The manifest of a batch is right whatever ended the program, and decides what is left to do."""

import json
import os
from dataclasses import replace
from pathlib import Path

import pytest
from problems import CLIP, FIGURE, changed, written
from processes import quiet

pytest.importorskip("distributed")

from dynsplines.batch.dispatch import Batch
from dynsplines.batch.inputs import sources, task_of
from dynsplines.batch.manifest import Entry, Manifest, digest_of
from dynsplines.batch.solving import solve
from dynsplines.batch.task import BatchOptions
from dynsplines.errors import UserError

WALK = Entry(clip="walk", source="../clips/walk.toml", state="failed", input="abc", error="too 'long'")
DONE = replace(WALK, state="done", error="", seconds=0.5, files={"walk.npz": "0"})
RUN = replace(WALK, clip="sub/run", source="../clips/sub/run.toml")


def test_wherever_the_last_line_is_cut_what_came_before_it_stands(tmp_path: Path):
    manifest = Manifest.of(tmp_path)
    manifest.record(WALK)
    manifest.record(RUN)
    before = manifest.path.stat().st_size
    manifest.record(DONE)
    assert manifest.entries == {"walk": DONE, "sub/run": RUN}
    whole = manifest.path.read_bytes()
    assert [json.loads(line)["clip"] for line in whole.splitlines()] == ["walk", "sub/run", "walk"]
    for end in range(before, len(whole)):
        manifest.path.write_bytes(whole[:end])
        assert Manifest.of(tmp_path).entries == {"walk": WALK, "sub/run": RUN}
        assert manifest.path.read_bytes() == whole[:before]
    Manifest.of(tmp_path).record(DONE)
    assert Manifest.of(tmp_path).entries == {"walk": DONE, "sub/run": RUN}


@pytest.mark.parametrize(
    "line",
    ["nonsense", '{"clip": "a"}', '{"clip": "a", "source": "a", "state": "queued"}', "[]", '{"dynsplines batch": 1}'],
)
def test_a_line_that_is_none_is_named(tmp_path: Path, line: str):
    (tmp_path / "manifest.jsonl").write_text(f"{WALK.line()}{line}\n", encoding="utf-8")
    with pytest.raises(UserError, match=r"manifest\.jsonl: line 2 is not an entry of a clip.*; give another -o"):
        Manifest.of(tmp_path)


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """A folder for the results of the clips tiny.toml and other.toml."""
    written(tmp_path)
    written(tmp_path, changed("fps = 20", "fps = 30"), "other.toml")
    (tmp_path / "out").mkdir()
    return tmp_path / "out"


def left(out: Path, options: BatchOptions = BatchOptions()) -> list[str]:  # noqa: B008
    """The clips that a command has left to do, by a program that starts anew."""
    batch = Batch(Manifest.of(out), options, quiet(), solve)
    batch.plan(sources([str(out.parent / "tiny.toml"), str(out.parent / "other.toml")]))
    return [str(source.name) for source in batch.waiting]


def end(out: Path, name: str, error: str = "", options: BatchOptions = BatchOptions()) -> None:  # noqa: B008
    """A clip's end is written down."""
    (out / f"{name}.csv").write_bytes(b"data")
    (source,) = sources([str(out.parent / f"{name}.toml")])
    digest = task_of(source, {}, options).digest
    files = {} if error else {f"{name}.csv": digest_of(b"data")}
    state = "failed" if error else "done"
    Manifest.of(out).record(
        Entry(clip=name, source=f"../{name}.toml", state=state, input=digest, error=error, files=files)
    )


def test_what_is_done_and_whole_is_left_alone(out: Path):
    assert left(out) == ["tiny", "other"]
    end(out, "other")
    assert left(out) == ["tiny"]
    for harm in (lambda path: path.write_bytes(b"d\0ta"), lambda path: path.write_bytes(b"dat"), Path.unlink):
        harm(out / "other.csv")
        assert left(out) == ["tiny", "other"]


def test_a_clip_a_figure_or_an_option_that_changes_is_done_again(out: Path):
    end(out, "tiny")
    end(out, "other")
    assert left(out) == []
    for other in (BatchOptions(report=True), BatchOptions(fps=7.0), BatchOptions(to="csv")):
        assert left(out, other) == ["tiny", "other"]
    (out.parent / "tiny.toml").write_text(CLIP.replace("fps = 20", "fps = 21"), encoding="utf-8")
    assert left(out) == ["tiny"]
    end(out, "tiny")
    (out.parent / "tiny.xml").write_text(FIGURE.replace('mass="4"', 'mass="5"'), encoding="utf-8")
    assert left(out) == ["tiny", "other"]


def test_what_failed_is_done_again_on_request(out: Path):
    end(out, "other")
    end(out, "tiny", error="it did not work")
    assert left(out) == []
    assert left(out, BatchOptions(retry_failed=True)) == ["tiny"]
    manifest = Manifest.of(out)
    manifest.record(replace(manifest.entries["tiny"], input=""))  # as of a clip whose workers ended
    assert left(out) == ["tiny"]


def test_a_result_of_another_clip_is_not_written_over(out: Path):
    Manifest.of(out).record(replace(DONE, clip="TINY", source="../elsewhere/TINY.toml"))
    with pytest.raises(UserError, match=r"'\.\./elsewhere/TINY\.toml' and '\.\./tiny\.toml' have the same output"):
        left(out)


def test_a_clip_that_cannot_be_read_waits_for_its_turn(out: Path, monkeypatch: pytest.MonkeyPatch):
    def gone(path: Path) -> bytes:
        raise FileNotFoundError(2, "No such file or directory", str(path))

    monkeypatch.setattr(Path, "read_bytes", gone)
    assert left(out) == ["tiny", "other"]


@pytest.mark.skipif(os.name == "nt", reason="links need administrator rights on Windows")
@pytest.mark.parametrize("name", ["../prey", "/dev/zero", "link"])
def test_a_manifest_makes_a_batch_read_nothing_outside_its_folder(out: Path, name: str):
    (out.parent / "prey").write_bytes(b"data")
    (out / "link").symlink_to(out.parent / "prey")
    assert not replace(DONE, files={name: digest_of(b"data")}).is_intact(out)
