"""A hand that rests before it lets go: what it would come to is searched by then, and nobody sees anything of it."""

from __future__ import annotations

import asyncio

import numpy as np
import pytest
import tiny
from spoken import Line, load

from dynsplines.solver.curve.spline import path_of
from dynsplines.studio import actions
from dynsplines.studio.actions import Actions
from dynsplines.studio.document import Document
from dynsplines.studio.session import Session
from dynsplines.studio.solving.loop import SolverLoop

EDITED = tiny.CLIP.replace("[0, 40, 0]", "[0, 44, 0]")


@pytest.fixture
def work(tmp_path):
    tiny.written(tmp_path)
    found = SolverLoop(Line())
    load(found, tmp_path, tiny.CLIP, first=True)
    return found


def speculate(work, folder, text):
    work.do({"do": "speculate", "text": text, "name": "tiny", "place": "tiny.toml", "folder": str(folder)})
    return work.line.taken()


def ended(work):
    """E of the present path, and its states at some moments."""
    timeline = work.solution.timeline
    return work.clip.problem.objective.value(path_of(timeline)), path_of(timeline).at(np.linspace(0, 0.41, 9))


@pytest.fixture
def without(tmp_path):
    """Where the same edit ends that nobody foresaw."""
    tiny.written(tmp_path)
    found = SolverLoop(Line())
    load(found, tmp_path, tiny.CLIP, first=True)
    load(found, tmp_path, EDITED, 1)
    return ended(found)


def kinds(told):
    return [each["kind"] for each in told if each["is"] == "path"]


def test_a_speculative_result_is_used_as_soon_as_its_text_arrives(work, tmp_path, without):
    before = work.solution
    assert speculate(work, tmp_path, EDITED) == []
    assert work.solution is before
    told = load(work, tmp_path, EDITED, 1)
    assert [each["is"] for each in told][:2] == ["loaded", "path"]
    assert kinds(told)[0] == "best"
    assert told[-1]["is"] == "settled"
    assert told[-1]["stop"] == "CONVERGED"
    assert "searching" not in {each["is"] for each in told}
    value, states = ended(work)
    assert value == without[0]
    np.testing.assert_array_equal(states, without[1])


def test_another_text_ignores_the_speculation(work, tmp_path, without):
    speculate(work, tmp_path, tiny.CLIP.replace("[0, 40, 0]", "[0, 60, 0]"))
    told = load(work, tmp_path, EDITED, 1)
    assert kinds(told)[0] == "initial"
    np.testing.assert_array_equal(ended(work)[1], without[1])


@pytest.mark.parametrize("seen", [0, 1, 2])
def test_one_that_lets_go_in_the_middle_of_it_continues_from_there(work, tmp_path, without, seen):
    asked = iter([False] * seen)
    work.has_message = lambda: next(asked, True)
    speculate(work, tmp_path, EDITED)
    work.has_message = lambda: False
    told = load(work, tmp_path, EDITED, 1)
    assert kinds(told)[0] == ("best" if seen == 2 else "initial")
    assert told[-1]["stop"] == "CONVERGED"
    assert ended(work)[0] == pytest.approx(without[0], rel=0.01)  # its frames are split once more


def test_an_invalid_clip_is_rejected_when_it_is_sent_and_not_before(work, tmp_path):
    text = tiny.CLIP.replace("time = 0.2", "time = -1.0")
    assert text != tiny.CLIP
    assert speculate(work, tmp_path, text) == []
    assert load(work, tmp_path, text, 1)[-1]["is"] == "refused"


def test_clips_that_load_slowly_are_not_solved_speculatively(work, tmp_path, monkeypatch):
    """Whatever is said meanwhile would wait for it."""
    monkeypatch.setattr("dynsplines.studio.solving.loop.SPECULATION_LIMIT", 1e-6)
    load(work, tmp_path, tiny.CLIP + "\n", 1)
    speculate(work, tmp_path, EDITED)
    assert kinds(load(work, tmp_path, EDITED, 2))[0] == "initial"


def test_there_is_no_speculation_while_the_search_is_stopped(work, tmp_path):
    load(work, tmp_path, tiny.CLIP, go=False)
    speculate(work, tmp_path, EDITED)
    told = load(work, tmp_path, EDITED, 1, go=False)
    assert kinds(told)[0] == "initial"


class Beside:
    """What solves, in this process: it has answered before anything else goes on. Keeps what it is asked."""

    def __init__(self, session):
        self.is_started, self.asked, self.session = True, [], session
        self.work = SolverLoop(self)

    def start(self, *, shows_view=False):
        """It is there."""

    def send(self, message):
        if "do" in message:
            self.asked.append(message)
            self.work.do(message)
        else:
            self.session._receive(message)

    def last(self, do):
        return next((each for each in reversed(self.asked) if each["do"] == do), None)


@pytest.fixture
def session(tmp_path, monkeypatch):
    tiny.written(tmp_path)
    monkeypatch.setattr(actions, "PAUSE", 0.02)
    found = Session(Document("tiny", tiny.CLIP, tmp_path))
    monkeypatch.setattr(found, "solver", Beside(found))
    return found


async def dragged(session, *, height=0.3, rests=0.2, partial=False, time=0.2):
    """A shin that is pulled, and rests for so long [s] before it is let go, or not at all."""
    session.start()
    hand = Actions(session, 1)
    body = session.figure[0].model().body("left_shin").id
    await hand.grip(time=time, body=body, offset=[0, 0, 0], partial=partial)
    data = await hand.drag(position=[0.1, 0, height + 0.02])
    data = await hand.drag(position=[0.1, 0, height])
    assert len(data["position"]) == 3 * session.figure[0].model().nbody
    if rests:
        await asyncio.sleep(rests)
    return hand


def test_a_hand_that_rests_has_searched_what_it_says_when_it_lets_go(session, monkeypatch):
    async def told():
        hand = await dragged(session)
        speculation, document = session.solver.last("speculate"), session.document.text
        assert speculation is not None
        assert document == tiny.CLIP
        assert session.document.revision == 0
        monkeypatch.setattr(session, "_edited", None)  # nothing is to be taken apart again
        await hand.drop(time=0.2)
        assert session.document.text == speculation["text"] == session.solver.last("load")["text"]
        assert session.solver.last("wait") is None

    asyncio.run(told())


def test_what_somebody_else_says_meanwhile_is_kept(session):
    async def told():
        hand = await dragged(session)
        await session.edit("set_joint", {"key": 2, "joint": "left_knee", "value": {"rotvec": [0, 7, 0]}})
        await hand.drop(time=0.2)
        rows = session.document.tree_rows()
        assert rows[2]["joints"]["left_knee"]["rotvec"] == [0, 7, 0]
        assert rows[1]["root"]["position"] != [0.1, 0, "free"]
        assert session.document.text != session.solver.last("speculate")["text"]

    asyncio.run(told())


@pytest.mark.parametrize("partial", [False, True])
def test_a_new_keyframe_is_solved_speculatively_as_the_edit_will_write_it(session, partial):
    async def told():
        hand = await dragged(session, partial=partial, time=0.1)
        await hand.drop(time=0.1, partial=partial)
        assert session.document.text == session.solver.last("speculate")["text"]

    asyncio.run(told())


def test_a_drag_that_continues_ends_the_search_and_an_immediate_release_starts_none(session):
    async def told():
        hand = await dragged(session)
        await hand.drag(position=[0.1, 0, 0.25])
        assert session.solver.asked[-1]["do"] == "wait"
        await hand.drop(time=0.2)
        assert [each["do"] for each in session.solver.asked].count("speculate") == 1
        await asyncio.sleep(0.1)
        assert [each["do"] for each in session.solver.asked].count("speculate") == 1

    asyncio.run(told())


def test_a_cancelled_drag_leaves_everything_unchanged(session):
    async def told():
        hand = await dragged(session, rests=0)
        path = session.solver.work.solution
        await asyncio.sleep(0.2)
        assert session.solver.asked[-1]["do"] == "speculate"
        await hand.cancel()
        assert session.solver.asked[-1]["do"] == "wait"
        assert session.solver.work.solution is path
        assert session.document.text == tiny.CLIP

    asyncio.run(told())


def test_there_is_no_speculation_while_the_last_edit_is_searched(session):
    async def told():
        hand = await dragged(session, rests=0)
        session.status = {**session.status, "state": "searching"}
        await asyncio.sleep(0.2)
        await hand.cancel()
        assert session.solver.last("speculate") is None

    asyncio.run(told())
