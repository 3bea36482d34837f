"""Two pages at one clip: what one of them says of the fourth keyframe is of that keyframe, whatever the other added."""

from __future__ import annotations

import asyncio
import json
import tomllib

import pytest
from spoken import session_without_solver

from dynsplines.errors import UserError
from dynsplines.studio.document import Document
from dynsplines.studio.revision_map import renumbered

TEXT = (
    "\n".join(f'[[keyframe]]\ntime = {time}\nothers = "rest"\n' for time in (0.0, 0.1, 0.2, 0.3, 0.4))
    + '\n[[contact]]\npoint = "heel"\nfrom = 0.1\nto = 0.2\n\n[[contact]]\npoint = "toe"\nfrom = 0.1\nto = 0.3\n'
)


@pytest.fixture
def session(tmp_path, monkeypatch):
    return session_without_solver(Document("clip", TEXT, tmp_path), monkeypatch)


def times(session):
    return [row["time"] for row in tomllib.loads(session.document.text)["keyframe"]]


def test_an_edit_of_a_keyframe_finds_it_where_another_page_has_put_it(session):
    async def both():
        seen = session.document.revision  # of both
        await session.edit("add_key", {"entries": {"time": 0.15}}, seen)
        await session.edit("delete_keys", {"keys": [0]}, seen)
        await session.edit("move_keys", {"moves": [[3, 0.33]]}, seen)

    asyncio.run(both())
    assert times(session) == [0.1, 0.15, 0.2, 0.33, 0.4]


def test_edits_that_come_at_once_are_each_of_what_their_page_saw(session):
    async def both():
        await asyncio.gather(
            session.edit("add_key", {"entries": {"time": 0.05}}, 0),
            session.edit("change", {"at": ["keyframe", 3], "entries": {"joints": {"knee": 10}}}, 0),
            session.edit("change", {"at": ["contact", 1], "entries": {"to": 0.4}}, 0),
            session.edit("remove", {"at": ["contact", 0]}, 0),
        )

    asyncio.run(both())
    table = tomllib.loads(session.document.text)
    assert [row["time"] for row in table["keyframe"] if "joints" in row] == [0.3]
    assert table["contact"] == [{"point": "toe", "from": 0.1, "to": 0.4}]


def test_what_is_gone_is_reported_and_nothing_else_is_changed(session):
    async def both():
        await session.edit("delete_keys", {"keys": [3]}, 0)
        before = session.document.text
        with pytest.raises(UserError, match=r"keyframe 4 was deleted or changed on another page; check and try again"):
            await session.edit("move_keys", {"moves": [[3, 0.33]]}, 0)
        assert session.document.text == before
        await session.undo()
        await session.edit("move_keys", {"moves": [[4, 0.5]]}, 0)  # known again

    asyncio.run(both())
    assert times(session) == [0.0, 0.1, 0.2, 0.3, 0.5]


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


def test_the_same_revision_and_none_are_taken_as_they_are(session):
    assert renumbered(session.document, None, {"key": 7}) == {"key": 7}
    assert renumbered(session.document, 0, {"keys": [1, 2]}) == {"keys": [1, 2]}


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
