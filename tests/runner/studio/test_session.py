"""One clip in the studio: its edits, unsaved work of earlier sessions, and crashes of the solver process."""

import asyncio
import json
import tomllib

import problems
import pytest
from processes import session_without_solver

from dynsplines.errors import UserError
from dynsplines.studio import solver
from dynsplines.studio.document import Document, open_document
from dynsplines.studio.files import Files

TEXT = "".join(f'[[keyframe]]\ntime = {time}\nothers = "rest"\n' for time in (0.0, 0.1, 0.2))


@pytest.fixture
def file(tmp_path):
    target = tmp_path / "clip.toml"
    target.write_text(TEXT)
    return target


@pytest.fixture
def start(file, monkeypatch):
    """Opens the clip in a new session."""
    return lambda: session_without_solver(open_document(str(file)), monkeypatch)


def add_key(session, time):
    return asyncio.run(session.edit("add_key", {"entries": {"time": time}}))


def times(session):
    return [row["time"] for row in tomllib.loads(session.document.text)["keyframe"]]


EDITED = [0.0, 0.1, 0.15, 0.2]


@pytest.fixture
def unsaved(start, file):
    """The copy of unsaved work of an earlier session."""
    add_key(start(), 0.15)
    return file.with_name(".clip.toml.unsaved")


def test_unsaved_work_is_restored_and_removed_when_it_is_saved(start, unsaved, file):
    session = start()
    assert times(session) == [0.0, 0.1, 0.2]
    asyncio.run(session.take_offer(yes=True))
    assert times(session) == EDITED
    again = start()  # after a crash
    asyncio.run(again.take_offer(yes=True))
    assert times(again) == EDITED
    asyncio.run(Files(again).save())
    assert problems.names(file.parent) == ["clip.toml"]
    asyncio.run(again.undo())  # across a save
    assert times(again) == [0.0, 0.1, 0.2]
    assert unsaved.is_file()
    asyncio.run(again.redo())
    assert not unsaved.exists()


def test_discarded_work_is_removed(start, unsaved, file):
    session = start()
    asyncio.run(session.take_offer(yes=False))
    with pytest.raises(UserError, match="there is no unsaved work"):
        asyncio.run(session.take_offer(yes=True))
    assert start().offer is None
    assert problems.names(file.parent) == ["clip.toml"]


def test_nothing_changes_until_unsaved_work_is_restored_or_discarded(start, unsaved):
    before, session = unsaved.read_text(), start()
    for action in (
        session.edit("add_key", {"entries": {"time": 0.17}}), session.undo(), session.redo(),
        Files(session).save(), Files(session).save(name="other"),
    ):  # fmt: skip
        with pytest.raises(UserError, match="restore or discard the unsaved work first"):
            asyncio.run(action)
    session.close()
    assert unsaved.read_text() == before
    assert problems.names(unsaved.parent) == [".clip.toml.unsaved", "clip.toml"]
    asyncio.run(session.take_offer(yes=True))
    assert times(session) == EDITED


def test_unsaved_work_of_another_studio_is_not_replaced(start, unsaved, file, monkeypatch):
    one = start()
    asyncio.run(one.take_offer(yes=True))
    two = start()
    asyncio.run(two.take_offer(yes=True))
    add_key(two, 0.18)
    theirs = unsaved.read_text()
    assert add_key(one, 0.17) == (
        "add a keyframe at 0.17 s; unsaved work is not stored, save the clip: "
        ".clip.toml.unsaved belongs to another studio with this clip"
    )
    asyncio.run(Files(one).save(name="clip", overwrite=True))
    assert unsaved.read_text() == theirs
    other = session_without_solver(Document("other", TEXT, file.parent), monkeypatch)
    asyncio.run(Files(other).save(name="clip", overwrite=True))
    assert "unsaved work is not stored" in add_key(other, 0.19)
    assert unsaved.read_text() == theirs


def test_work_that_cannot_be_loaded_is_offered_again(start, unsaved, monkeypatch):
    session = start()
    with monkeypatch.context() as patch:
        answer = {"is": "refused", "id": 1, "words": "no figure"}
        patch.setattr(
            session.solver, "send", lambda _: asyncio.get_running_loop().call_soon(session.solver.answer, answer)
        )
        with pytest.raises(UserError, match="no figure"):
            asyncio.run(session.take_offer(yes=True))
    assert times(session) == [0.0, 0.1, 0.2]
    asyncio.run(session.take_offer(yes=True))
    assert times(session) == EDITED


def test_numbers_of_keyframes_are_those_of_a_revision(start):
    session = start()
    document = session.document
    asyncio.run(session.edit("change", {"at": ["keyframe", 0], "entries": {"joints": {"knee": 1}}}))
    document.check_numbers(0)  # no keyframe has another number
    for change in (session.edit("delete_keys", {"keys": [1]}), session.undo()):
        before = document.revision
        asyncio.run(change)
        document.check_numbers(document.revision)
        with pytest.raises(UserError, match="the clip has changed meanwhile"):
            document.check_numbers(before)


@pytest.fixture
def lost(start, monkeypatch):
    """A session whose solver process ends as soon as it gets a request, with the messages that it got."""
    session, sent = start(), []
    session.sent = sent
    for name in ("start", "listen"):
        monkeypatch.setattr(session.solver, name, lambda: None)

    def send(message):
        sent.append(message)
        if message.get("id") is not None:
            asyncio.get_running_loop().call_soon(session.solver._recover, -9)

    monkeypatch.setattr(session.solver, "send", send)
    return session


def test_an_edit_during_which_the_solver_process_crashes_is_rejected_and_the_present_text_is_loaded(lost):
    shown = []
    lost.enter(shown.append)
    words = "the solver process was ended by signal 9; a new one solves the clip again"
    with pytest.raises(UserError, match=words):
        add_key(lost, 0.15)
    assert [message["revision"] for message in lost.sent] == [1, 0]
    assert lost.sent[1]["text"] == lost.document.text == TEXT
    assert [message["words"] for message in map(json.loads, shown) if message["is"] == "note"] == [words]


def test_a_solver_that_crashes_again_and_again_is_not_started_again(lost):
    for _ in range(solver.MOST_LOSSES):
        with pytest.raises(UserError, match="a new one solves"):
            add_key(lost, 0.15)
    with pytest.raises(UserError, match="was ended by signal 9 repeatedly"):
        add_key(lost, 0.15)
    assert lost._state == "gone"


def test_an_edit_that_takes_too_long_to_load_is_rejected_and_the_solver_restarted(start, monkeypatch):
    session, restarted = start(), []
    monkeypatch.setattr(solver, "ANSWER_TIMEOUT", 0.05)
    monkeypatch.setattr(session.solver, "send", lambda message: None)
    monkeypatch.setattr(session.solver, "restart", lambda: restarted.append(True))
    with pytest.raises(UserError, match="took longer than"):
        add_key(session, 0.15)
    assert restarted == [True]
    assert session.document.text == TEXT


def test_a_page_shows_what_an_earlier_one_has_shown(start):
    session, shown, again = start(), [], []
    session.enter(shown.append)
    add_key(session, 0.15)
    session._receive({"is": "path", "kind": "initial", "revision": 1, "data": b"initial", "timeline": b""})
    session._receive({"is": "path", "kind": "best", "revision": 1, "data": b"best", "timeline": b""})
    session._receive({"is": "settled", "stop": "CONVERGED", "violations": []})
    session.leave(shown.append)
    session.enter(again.append)
    kinds = [message.decode() if isinstance(message, bytes) else json.loads(message)["is"] for message in again]
    assert kinds == ["initial", "best", "document", "loaded", "settled", "status", "offer"]
    assert all(message in shown for message in again)


def test_a_file_that_another_program_changed_is_loaded_or_its_change_is_passed_over(start, file):
    session = start()
    add_key(session, 0.15)
    changed = TEXT.replace("0.2", "0.3")
    file.write_text(changed)
    with pytest.raises(UserError, match="changed by another program"):
        asyncio.run(Files(session).save())
    asyncio.run(session.reload())
    assert (session.document.text, session.document.is_dirty) == (changed, False)
    with pytest.raises(UserError, match="has not changed"):
        asyncio.run(session.reload())
    asyncio.run(session.undo())
    assert times(session) == EDITED
    file.write_text("nothing = [")
    asyncio.run(session.keep())
    asyncio.run(Files(session).save())
    assert [row["time"] for row in tomllib.loads(file.read_text())["keyframe"]] == EDITED


def test_a_new_clip_of_a_figure_takes_the_place_of_a_saved_one_only(start, monkeypatch):
    session = start()
    revision = session.document.revision
    asyncio.run(Files(session).new(figure="human"))
    assert (session.document.place, session.document.file, session.document.is_dirty) == ("human.toml", None, False)
    assert session.document.revision > revision
    add_key(session, 0.25)
    with pytest.raises(UserError, match="not saved"):
        asyncio.run(Files(session).new(figure="human"))
    with pytest.raises(UserError, match="plain name"):
        asyncio.run(Files(start()).new(figure="../secret.xml"))


def test_what_is_pasted_replaces_keyframes_at_its_times(start):
    session = start()
    copied = [{"time": 0.0, "others": "previous"}, {"time": 0.1}]
    asyncio.run(session.edit("paste_keys", {"copied": copied, "time": 0.1}))
    assert times(session) == [0.0, 0.1, 0.2]
    assert tomllib.loads(session.document.text)["keyframe"][1] == {"time": 0.1, "others": "previous"}
