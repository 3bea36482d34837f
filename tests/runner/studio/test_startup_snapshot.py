"""What a clip showed last is seen at once when it is opened again, and is gone where the clip says something else."""

from __future__ import annotations

import asyncio
import json

import numpy as np
import pytest

from dynsplines.studio import paths, startup_snapshot
from dynsplines.studio.document import Document
from dynsplines.studio.session import Session

STAGE = json.dumps({"bodies": ["world", "leg"]}).encode()


def path_of(kind="best", count=3, bodies=2):
    head = {"is": "path", "kind": kind, "count": count, "bodies": bodies}
    return paths.framed(head, np.zeros((count, bodies, 3)), np.zeros((count, bodies, 4)), np.zeros((count, 3)))


@pytest.fixture
def document(tmp_path, monkeypatch):
    monkeypatch.setenv("DYNSPLINES_CACHE", str(tmp_path / "cache"))
    return Document("clip", 'figure = "human"\n', tmp_path, saved='figure = "human"\n')


@pytest.fixture
def session(document, monkeypatch):
    """One whose clip was seen before; its process is never begun."""
    startup_snapshot.write(startup_snapshot.file_of(document), STAGE, path_of())
    found = Session(document)
    begun = []
    monkeypatch.setattr(found.solver, "start", lambda shows_view: begun.append(shows_view))
    monkeypatch.setattr(found.solver, "send", lambda message: None)
    found.start()
    assert begun == [True]  # it may take its time
    return found


def entered(session):
    told = []
    session.enter(1, told.append)
    return told


def test_what_was_kept_is_there_for_the_same_text_and_no_other(document):
    file = startup_snapshot.file_of(document)
    assert startup_snapshot.read(file) is None
    startup_snapshot.write(file, STAGE, path_of())
    assert startup_snapshot.read(file) == (STAGE, path_of())
    document.commit("another", "change")
    assert startup_snapshot.read(startup_snapshot.file_of(document)) is None


@pytest.mark.parametrize("at", [0, 9, 20, 60, -1])
def test_one_that_is_damaged_is_as_good_as_none(document, at):
    file = startup_snapshot.file_of(document)
    assert file is not None
    startup_snapshot.write(file, STAGE, path_of())
    data = bytearray(file.read_bytes())
    file.write_bytes(bytes(data[:at]))
    assert startup_snapshot.read(file) is None
    startup_snapshot.write(file, STAGE, path_of(bodies=5))
    assert startup_snapshot.read(file) is None  # of another figure


def test_nothing_is_kept_where_nothing_is_to_be(document, monkeypatch):
    monkeypatch.setenv("DYNSPLINES_CACHE", "off")
    assert startup_snapshot.file_of(document) is None
    startup_snapshot.write(None, STAGE, path_of())
    assert startup_snapshot.read(None) is None


def test_a_page_gets_it_before_anything_is_loaded_and_keeps_it_until_something_better_comes(session):
    told = entered(session)
    assert STAGE in told[0]
    assert told[1] == path_of()
    session._receive({"is": "stage", "stage": STAGE})
    session._receive({"is": "path", "kind": "initial", "revision": 0, "data": path_of("initial"), "timeline": b""})
    session._receive({"is": "path", "kind": "raw", "revision": 0, "data": path_of("raw")})
    assert [each for each in told[2:] if isinstance(each, bytes)] == [path_of("raw")]  # the rest is seen already
    session._receive({"is": "path", "kind": "best", "revision": 0, "data": path_of("best", 4), "timeline": b""})
    assert told[-1] == path_of("best", 4)


def test_a_figure_that_has_changed_takes_its_place(session):
    told, other = entered(session), json.dumps({"bodies": ["world", "arm"]}).encode()
    session._receive({"is": "stage", "stage": other})
    assert other in told[-1]
    session._receive({"is": "path", "kind": "initial", "revision": 0, "data": path_of("initial"), "timeline": b""})
    assert told[-1] == path_of("initial")


def test_where_nothing_is_searched_the_clip_s_own_path_takes_its_place(session):
    told = entered(session)

    async def heard():
        session._receive({"is": "stage", "stage": STAGE})
        session._receive({"is": "path", "kind": "initial", "revision": 0, "data": path_of("initial"), "timeline": b""})
        session._receive({"is": "settled", "stop": "paused", "violations": []})

    asyncio.run(heard())
    assert path_of("initial") in told
    assert path_of() not in entered(session)
    assert startup_snapshot.read(startup_snapshot.file_of(session.document)) == (STAGE, path_of("initial"))
