"""Figures and keyframes that many tests share, small enough to read."""

# isort: off
from shipped import Move
import environment  # before all that is ours
# isort: on

import gc
from collections.abc import Generator, Iterator
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import figures
import numpy as np
import problems
import pytest
import shipped
from figures import FIGURES, figure_named
from processes import Command, commanded, quiet

from dynsplines import motion, recordings, solving
from dynsplines.motion import Saved
from dynsplines.picture.graphics import Graphics
from dynsplines.solver.figure.figure import Figure

shipped.open_folder()
shipped.follow()
figures.share()


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect tests without garbage collections, which would take a third of the time, and have fewer of them later."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(20_000, 20, 20)
        gc.enable()


def pytest_unconfigure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput"):
        shipped.remove_folder()


@pytest.fixture(params=FIGURES)
def figure(request: pytest.FixtureRequest) -> Figure:
    return figure_named(request.param)


@pytest.fixture(scope="session")
def graphics() -> Graphics:
    """What this machine draws with."""
    return environment.GRAPHICS


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(7)


@pytest.fixture(scope="session")
def solved(tmp_path_factory: pytest.TempPathFactory) -> Move:
    """The tiny clip, solved."""
    path = problems.written(tmp_path_factory.mktemp("tiny"))
    return Move(clip := recordings.load(str(path)), solving.solve(clip, quiet()))


@pytest.fixture(scope="session")
def saved(solved: Move) -> Saved:
    """What goes into a motion file of it, report and all."""
    return solving.measure(solved.clip, solved.motion, quiet())


@pytest.fixture(scope="session")
def motion_file(saved: Saved, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Its motion file; to be read only."""
    path = tmp_path_factory.mktemp("motion") / "tiny.npz"
    motion.save(saved, path)
    return path


@pytest.fixture
def command(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    """The command `dynsplines`, run in the process of the tests in the present folder."""
    return commanded(monkeypatch, capsys)


@pytest.fixture(scope="session")
def dask_cluster() -> Iterator[Any]:
    """A Dask worker in the process of the tests, in place of processes that start in seconds."""
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=1,
        threads_per_worker=1,
        processes=False,
        dashboard_address="127.0.0.1:0",
        scheduler_kwargs={"dashboard": False},
        silence_logs=50,
    ) as cluster:
        yield cluster


@pytest.fixture
def in_process(dask_cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every batch of a test use the one worker of this process."""
    from dynsplines.batch import dispatch

    monkeypatch.setattr(dispatch, "_local", lambda _: nullcontext(dask_cluster))
