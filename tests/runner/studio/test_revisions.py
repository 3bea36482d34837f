"""Two pages with one clip: an edit by index is rejected if the other page has inserted or deleted such tables."""

from __future__ import annotations

import asyncio
import json
import tomllib

import pytest

from dynsplines.errors import UserError
from dynsplines.studio.actions import Actions
from dynsplines.studio.document import Document
from dynsplines.studio.session import Session

TEXT = (
    "\n".join(f'[[keyframe]]\ntime = {time}\nothers = "rest"\n' for time in (0.0, 0.1, 0.2, 0.3, 0.4))
    + '\n[[contact]]\npoint = "heel"\nfrom = 0.1\nto = 0.2\n\n[[contact]]\npoint = "toe"\nfrom = 0.1\nto = 0.3\n'
)


@pytest.fixture
def session(tmp_path, monkeypatch):
    """One whose solver takes every text."""
    found = Session(Document("clip", TEXT, tmp_path))

    def loaded(message):
        if message["do"] == "load":
            told = {"is": "loaded", "revision": message["revision"], "outline": {}, "keys": []}
            asyncio.get_running_loop().call_soon(found._receive, told)

    monkeypatch.setattr(found.solver, "send", loaded)
    return found


def times(session):
    return [row["time"] for row in tomllib.loads(session.document.text)["keyframe"]]


def test_an_edit_by_an_outdated_index_is_rejected_and_changes_nothing(session):
    async def both():
        seen = session.document.revision  # of both
        await session.edit("add_key", {"entries": {"time": 0.15}}, seen)
        before = session.document.text
        for name, arguments in (
            ("move_keys", {"moves": [[3, 0.33]]}),
            ("delete_keys", {"keys": [0]}),
            ("set_joint", {"key": 3, "joint": "knee", "value": 10}),
        ):
            with pytest.raises(UserError, match="a keyframe was inserted or deleted meanwhile; check and try again"):
                await session.edit(name, arguments, seen)
        with pytest.raises(UserError, match="inserted or deleted"):
            await Actions(session, 2).copy(keys=[3], revision=seen)
        assert session.document.text == before
        await session.edit("move_keys", {"moves": [[4, 0.33]]}, session.document.revision)
        await session.undo()
        await session.undo()  # as seen before, but a page may have followed
        with pytest.raises(UserError, match="inserted or deleted"):
            await session.edit("move_keys", {"moves": [[3, 0.33]]}, seen)

    asyncio.run(both())
    assert times(session) == [0.0, 0.1, 0.2, 0.3, 0.4]


def test_edits_that_come_at_once_apply_if_no_such_table_comes_or_goes(session):
    async def both():
        await asyncio.gather(
            session.edit("move_keys", {"moves": [[2, 0.22]]}, 0),
            session.edit("set_joint", {"key": 3, "joint": "knee", "value": 10}, 0),
            session.edit("set_contact", {"point": "toe", "begin": 0.1, "end": 0.4, "index": 1}, 0),
            session.edit("add_key", {"entries": {"time": 0.05}}, 0),
            session.edit("delete_bar", {"kind": "contact", "index": 0}, 0),
        )
        with pytest.raises(UserError, match="a contact was inserted or deleted"):
            await session.edit("delete_bar", {"kind": "contact", "index": 0}, 4)

    asyncio.run(both())
    table = tomllib.loads(session.document.text)
    assert [row["time"] for row in table["keyframe"]] == [0.0, 0.05, 0.1, 0.22, 0.3, 0.4]
    assert [row["time"] for row in table["keyframe"] if "joints" in row] == [0.3]
    assert table["contact"] == [{"point": "toe", "from": 0.1, "to": 0.4}]


def test_a_revision_that_is_not_of_this_clip_is_refused(session, tmp_path):
    other = Document("other", TEXT.replace("0.1\n", "0.12\n"), tmp_path)

    async def opened():
        await session.edit("move_keys", {"moves": [[3, 0.33]]}, 0)
        seen = session.document.revision
        await session.reopen(other)
        with pytest.raises(UserError, match="another clip is open now"):
            await session.edit("delete_keys", {"keys": [1]}, seen)

    asyncio.run(opened())
    assert len(times(session)) == 5


def test_the_present_revision_and_none_are_accepted(session):
    session.document.check_indices(None, "keyframe")
    session.document.check_indices(0, "keyframe")


def test_what_a_new_process_says_of_the_text_before_is_no_answer_to_an_edit(session, monkeypatch):
    """It hears that text once more; both its answers may come at once."""
    told = []
    session.enter(1, told.append)

    def heard(message):
        if message["do"] == "load":
            loop = asyncio.get_running_loop()
            for revision in (message["revision"] - 1, message["revision"]):
                message = {"is": "loaded", "revision": revision, "outline": {"of": revision}, "keys": []}
                loop.call_soon(session._receive, message)

    monkeypatch.setattr(session.solver, "send", heard)
    asyncio.run(session.edit("add_key", {"entries": {"time": 0.15}}))
    messages = [json.loads(each) for each in told]
    documents = [each for each in messages if each["is"] == "document"]
    loaded = [each["revision"] for each in messages if each["is"] == "loaded"]
    assert (documents[-1]["revision"], documents[-1]["of"]) == (1, 1)
    assert loaded[-1] == 1
    assert all(each["of"] <= each["revision"] for each in documents)
    assert times(session) == [0.0, 0.1, 0.15, 0.2, 0.3, 0.4]


def test_a_process_that_is_lost_during_an_edit_hears_the_text_before_whose_verdict_is_not_the_edits(
    session, monkeypatch
):
    """The former is a clip, the edit is none."""
    heard = []

    def lost(message):
        heard.append(message.get("revision"))
        loop = asyncio.get_running_loop()
        if len(heard) == 1:
            loop.call_soon(session._resume, "the process that solves was ended by signal 9")
        elif message["revision"] == 0:
            loop.call_soon(session._receive, {"is": "loaded", "revision": 0, "outline": {}, "keys": []})
        else:
            loop.call_soon(session._receive, {"is": "refused", "revision": message["revision"], "words": "no clip"})

    monkeypatch.setattr(session.solver, "send", lost)
    with pytest.raises(UserError, match="no clip"):
        asyncio.run(session.edit("add_key", {"entries": {"time": 0.15}}))
    assert heard == [1, 0, 1]
    assert session.document.text == TEXT


def test_a_clip_that_takes_too_long_to_load_is_not_the_one_that_is_shown_later(session, monkeypatch, tmp_path):
    from dynsplines.studio import session as sessions

    began = []
    monkeypatch.setattr(sessions, "LOAD_TIMEOUT", 0.05)
    monkeypatch.setattr(session.solver, "send", lambda message: None)
    monkeypatch.setattr(session.solver, "restart", lambda: began.append(session.document.name))
    with pytest.raises(UserError, match="took longer than"):
        asyncio.run(session.reopen(Document("slow", TEXT, tmp_path)))
    assert began
    assert session.document.name == "clip"
