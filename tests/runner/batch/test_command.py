"""The command `batch` refuses in one line what it cannot do, before anything begins."""

import gc
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from problems import written
from processes import Command, refusal
from texts import read_cases

import dynsplines.batch

Refused = Callable[..., str]


@pytest.fixture
def refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: Command) -> Refused:
    """Runs the command beside the tiny clip and gives its one line."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back
    written(tmp_path)
    (tmp_path / "other").mkdir()
    written(tmp_path / "other", name="Tiny.toml")
    return lambda *words: refusal(command("batch", *words))


@pytest.mark.parametrize(("words", "line"), read_cases("batch_words.toml"))
def test_what_makes_no_sense_is_refused(refused: Refused, words: tuple[object, ...], line: str):
    pytest.importorskip("distributed")
    assert refused(*words).startswith(line)


def test_a_missing_package_is_named_with_how_to_install_it(refused: Refused, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    for name in ("dispatch", "cluster", "solving"):
        monkeypatch.delitem(sys.modules, f"dynsplines.batch.{name}", raising=False)
        monkeypatch.delattr(dynsplines.batch, name, raising=False)
    line = "dynsplines batch needs 'distributed'; install it: pip install 'dynamic-splines[batch]'"
    assert refused("tiny.toml") == line


def test_a_scheduler_that_is_not_there_is_reported(refused: Refused, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    pytest.importorskip("distributed")
    from dynsplines.batch import cluster

    monkeypatch.setattr(cluster, "PATIENCE_SECONDS", 0.5)
    line = refused("tiny.toml", "--cluster", "tcp://127.0.0.1:9")
    assert line.startswith("no Dask scheduler answers at 'tcp://127.0.0.1:9': ")
    assert list((tmp_path / "batch").iterdir()) == []
    assert refused("tiny.toml", "--cluster", "nonsense://x").startswith("no Dask scheduler answers at 'nonsense://x'")
    gc.collect()  # pytest fails a test in which a finaliser does
