"""Unsaved work of earlier sessions: it is offered until it is restored or discarded, and never overwritten."""

from __future__ import annotations

import asyncio
import os
import tomllib

import pytest
import tiny
from spoken import session_without_solver

from dynsplines.errors import UserError
from dynsplines.studio.files import Files
from dynsplines.studio.sources import opened

TEXT = "".join(f'[[keyframe]]\ntime = {time}\nothers = "rest"\n' for time in (0.0, 0.1, 0.2))
HOUR = 3600.0  # [s]


@pytest.fixture
def file(tmp_path):
    target = tmp_path / "clip.toml"
    target.write_text(TEXT)
    return target


@pytest.fixture
def start(file, monkeypatch):
    """Opens the clip in a new session."""
    return lambda: session_without_solver(opened(str(file)), monkeypatch)


def add_key(session, time):
    asyncio.run(session.edit("add_key", {"entries": {"time": time}}))


def times(session):
    return [row["time"] for row in tomllib.loads(session.document.text)["keyframe"]]


def leave_unsaved(start, time):
    """Edit the clip and end the session, an hour before whatever comes next."""
    session = start()
    add_key(session, time)
    session.close()
    for path in session.document.folder.glob(".*"):
        changed = path.stat().st_mtime - HOUR
        os.utime(path, (changed, changed))


def test_unsaved_work_is_restored(start, file):
    leave_unsaved(start, 0.15)
    session = start()
    assert times(session) == [0.0, 0.1, 0.2]
    asyncio.run(session.take_offer(yes=True))
    assert times(session) == [0.0, 0.1, 0.15, 0.2]
    session.close()
    again = start()
    asyncio.run(again.take_offer(yes=True))
    assert times(again) == [0.0, 0.1, 0.15, 0.2]
    asyncio.run(Files(again).save())
    again.close()
    assert tiny.names(file.parent) == ["clip.toml"]


def test_discarded_work_is_not_offered_again(start, file):
    leave_unsaved(start, 0.15)
    session = start()
    asyncio.run(session.take_offer(yes=False))
    with pytest.raises(UserError, match="there is no unsaved work"):
        asyncio.run(session.take_offer(yes=True))
    session.close()
    assert tiny.names(file.parent) == ["clip.toml"]


def test_an_offer_without_an_answer_is_repeated(start):
    leave_unsaved(start, 0.15)
    start().close()
    session = start()
    asyncio.run(session.take_offer(yes=True))
    assert times(session) == [0.0, 0.1, 0.15, 0.2]


def test_edits_do_not_overwrite_the_work_on_offer(start, file):
    leave_unsaved(start, 0.15)
    leave_unsaved(start, 0.16)
    leave_unsaved(start, 0.17)
    for time in (0.17, 0.16, 0.15):  # the latest first, one whenever the clip is opened
        session = start()
        asyncio.run(session.take_offer(yes=True))
        assert times(session) == [0.0, 0.1, time, 0.2]
        asyncio.run(session.undo())
        session.close()
    assert start().offer is None
    assert tiny.names(file.parent) == ["clip.toml"]


def test_saving_does_not_remove_the_work_on_offer(start):
    leave_unsaved(start, 0.15)
    session = start()
    add_key(session, 0.17)
    asyncio.run(Files(session).save())
    session.close()
    again = start()
    assert times(again) == [0.0, 0.1, 0.17, 0.2]
    asyncio.run(again.take_offer(yes=True))
    assert times(again) == [0.0, 0.1, 0.15, 0.2]
    asyncio.run(again.undo())
    assert times(again) == [0.0, 0.1, 0.17, 0.2]


def test_saving_under_another_name_does_not_overwrite_unsaved_work_of_that_name(start, file, monkeypatch):
    leave_unsaved(start, 0.15)
    other = file.with_name("other.toml")
    other.write_text(TEXT)
    session = session_without_solver(opened(str(other)), monkeypatch)
    asyncio.run(Files(session).save(name="clip", overwrite=True))
    add_key(session, 0.17)
    session.close()
    for time in (0.17, 0.15):
        again = start()
        asyncio.run(again.take_offer(yes=True))
        assert times(again) == [0.0, 0.1, time, 0.2]
        asyncio.run(again.undo())
        again.close()


def test_the_offer_stays_if_the_work_cannot_be_loaded(start, monkeypatch):
    leave_unsaved(start, 0.15)
    session = start()
    send = session.solver.send

    def refuse(message):
        refused = {"is": "refused", "revision": message["revision"], "words": "no figure"}
        asyncio.get_running_loop().call_soon(session._receive, refused)

    monkeypatch.setattr(session.solver, "send", refuse)
    with pytest.raises(UserError, match="no figure"):
        asyncio.run(session.take_offer(yes=True))
    assert times(session) == [0.0, 0.1, 0.2]
    monkeypatch.setattr(session.solver, "send", send)
    asyncio.run(session.take_offer(yes=True))
    assert times(session) == [0.0, 0.1, 0.15, 0.2]


def test_a_new_clip_without_edits_is_not_offered(tmp_path, monkeypatch):
    tiny.written(tmp_path)
    for _ in range(2):
        session = session_without_solver(opened(str(tmp_path / "tiny.xml")), monkeypatch)
        assert session.document.is_dirty  # it has no file yet
        assert session.offer is None
        session.close()
    assert [path.name for path in tmp_path.glob(".*")] == [".tiny.toml.unsaved"]
