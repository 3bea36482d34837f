"""What a page does to keyframes whose feet are given by place, and to free bodies beside the figure."""

import asyncio
import json
import tomllib

import figures
import numpy as np
import pytest
from oracles import kinematics
from texts import read_data

from dynsplines.clip.starter import starter
from dynsplines.errors import UserError
from dynsplines.studio.actions import Actions
from dynsplines.studio.document import Document
from dynsplines.studio.loop import SolverLoop
from dynsplines.studio.session import Session

FIGURE = read_data("leg.xml")

CLIP = read_data("leg.toml")
COLUMNS = {"root": slice(0, 7), "hip": slice(7, 8), "knee": slice(8, 9), "ankle": slice(9, 10), "crate": slice(10, 17)}


def here(session):
    """Return the `send` of a solver in this process."""

    def answer(message):
        wait = 0.05 if message["is"] == "path" and message["revision"] else 0.0  # after an edit
        asyncio.get_running_loop().call_later(wait, session.solver.answer, dict(message))

    return SolverLoop(answer, lambda: False).do


@pytest.fixture
def session(tmp_path, monkeypatch):
    (tmp_path / "leg.xml").write_text(FIGURE)
    found = Session(Document("leg", CLIP, tmp_path), go=False)
    monkeypatch.setattr(found.solver, "send", here(found))
    return found


def live(session, deed):
    """The second keyframe of the loaded clip, before a page does something: deed(actions)."""

    async def life():
        session.solver.send(session._load_request(session.document.text, 0))
        await asyncio.sleep(0.01)
        before = session.loaded["keys"][1]
        await deed(Actions(session))
        return before

    return asyncio.run(life())


def done(session, *deeds):
    """What actions of one page leave of the second keyframe: as it was and is told, and what the text says of it."""

    async def deed(actions):
        for name, said in deeds:
            await getattr(actions, name)(**said)

    before = live(session, deed)
    return before, session.loaded["keys"][1], tomllib.loads(session.document.text)["keyframe"][1]


def test_a_drag_that_begins_during_the_preparation_waits_for_it(session):
    async def deed(actions):
        assert len(set(await asyncio.gather(*(actions.poser() for _ in range(4))))) == 1

    live(session, deed)


def fixed(key):
    return {name for name, columns in COLUMNS.items() if np.all(key["fixed"][columns])}


def same(before, after, names):
    for name in names:
        np.testing.assert_allclose(after["qpos"][COLUMNS[name]], before["qpos"][COLUMNS[name]], atol=1e-4)


@pytest.mark.parametrize("joints", [["knee"], ["crate"], list(COLUMNS)], ids=["limb", "crate", "all"])
def test_joints_are_freed_alone_and_pinned_as_they_are(session, joints):
    """The toe's target is replaced by the joints that it has determined if one of them is freed or all are pinned."""
    before, after, row = done(session, ("free", {"key": 1, "joints": joints}))
    assert fixed(before) == set(COLUMNS)
    assert fixed(after) == set(COLUMNS) - set(joints)
    same(before, after, set(COLUMNS) - set(joints))
    assert ("sites" in row) == (joints == ["crate"])
    assert row["joints"]["ankle"] == ("free" if "ankle" in joints else -15)  # as the clip has it
    session.document.text = CLIP
    before, after, row = done(session, ("pin", {"key": 1, "joints": joints}))
    assert fixed(after) == set(COLUMNS)
    same(before, after, COLUMNS)
    assert ("sites" in row) == (joints != list(COLUMNS))


@pytest.mark.parametrize("joint", ["knee", "ankle"])
def test_a_joint_that_is_turned_goes_where_it_was_shown_and_takes_no_other_along(session, joint):
    turn = [np.cos(0.1), 0, np.sin(0.1), 0]
    before, after, row = done(session, ("turn", {"time": 0.5, "joint": joint, "turn": turn}), ("drop", {"time": 0.5}))
    assert fixed(after) == set(COLUMNS)
    same(before, after, set(COLUMNS) - {joint})
    assert after["qpos"][COLUMNS[joint]][0] == pytest.approx(before["qpos"][COLUMNS[joint]][0] + 0.2, abs=1e-4)
    assert "sites" not in row


def test_a_shin_is_dragged_where_its_foot_is_given_by_place(session):
    grip = {"time": 0.5, "body": 3, "offset": [0, 0, -0.2]}
    drag = {"position": [0.25, 0, 0.35]}
    before, after, _ = done(session, ("grip", grip), ("drag", drag), ("drop", {"time": 0.5}))
    assert fixed(after) == set(COLUMNS)
    same(before, after, {"root", "ankle", "crate"})


def test_what_is_free_next_to_the_figure_is_dragged_at_a_keyframe_and_between_two(session):
    body, deeds = 5, []
    for time in (0.5, 0.75):
        deeds += [("grip", {"time": time, "body": body, "offset": [0, 0, 0]}), ("drag", {"position": [1, 0.3, 0.4]})]
        deeds.append(("drop", {"time": time}))
    before, after, row = done(session, *deeds)
    assert row["roots"]["crate"]["position"] == pytest.approx([1, 0.3, 0.4], abs=1e-3)
    assert row["sites"] == {"toe": [0.16, 0, 0.05]}
    same(before, after, set(COLUMNS) - {"crate"})
    new = tomllib.loads(session.document.text)["keyframe"][2]
    assert new["time"] == 0.75
    assert new["roots"]["crate"]["position"] == pytest.approx([1, 0.3, 0.4], abs=1e-3)


def test_a_keyframe_at_rest_is_where_its_places_had_it(session):
    said = "root.position = [0.1, 0, 0.85]          # forward\nroot.rotation = {rotvec = [0, 0, 0]}\n"
    session.document.text = CLIP.replace(said, "", 1)
    before, after, _ = done(session, ("pose", {"time": 0.5}))
    assert fixed(before) == fixed(after) == set(COLUMNS)
    same(before, after, {"root", "crate"})
    np.testing.assert_allclose(after["qpos"][7:10], 0, atol=1e-6)


def test_a_saved_pose_stays_at_the_place_and_heading_of_where_it_is_applied(session):
    turned = "{rotvec = [0, 0, 90]}"
    session.document.text = CLIP.replace("{rotvec = [0, 0, 0]}", turned, 1).replace(
        "position = [0, 0,", "position = [0.3, 0.2,", 1
    )
    before, after, row = done(
        session, ("save_pose", {"time": 0, "name": "stand"}), ("pose", {"time": 0.5, "name": "stand"})
    )
    first = session.loaded["keys"][0]
    assert "sites" not in row
    same(first, after, {"hip", "knee", "ankle"})
    same(before, after, {"crate"})
    np.testing.assert_allclose(after["qpos"][:2], before["qpos"][:2], atol=1e-4)
    np.testing.assert_allclose(after["qpos"][2], first["qpos"][2], atol=1e-4)
    np.testing.assert_allclose(after["qpos"][3:7], before["qpos"][3:7], atol=1e-4)


@pytest.mark.parametrize(
    ("name", "said", "words"),
    [
        ("save_pose", {"time": 0, "name": "../stand"}, "plain name"),
        ("pose", {"time": 0, "name": "none"}, "the pose 'none': "),
        ("pose", {"time": 0, "name": "other"}, "the pose 'other': no joint 'tail'"),
        ("pose", {"time": 0, "name": "empty"}, "the pose 'empty' has no joints"),
        ("pose", {"time": 0, "name": "wordy"}, "the pose 'wordy': joints.hip must be "),
    ],
)
def test_what_is_no_pose_of_the_figure_is_refused(session, name, said, words):
    poses = session.document.folder / "poses"
    poses.mkdir()
    for pose, text in (("other", "tail = 3"), ("empty", ""), ("wordy", "hip = 'bent'")):
        (poses / f"{pose}.toml").write_text(f"[joints]\n{text}\n")
    with pytest.raises(UserError) as error:
        done(session, (name, said))
    assert words in str(error.value)
    assert session.document.text == CLIP


def test_a_new_keyframe_of_one_limb_says_the_limb_that_was_turned(session):
    turn = [np.cos(0.1), 0, np.sin(0.1), 0]
    grip = ("grip", {"time": 0.25, "body": 5, "offset": [0, 0, 0]})
    deeds = (grip, ("cancel", {}), ("turn", {"time": 0.25, "joint": "knee", "turn": turn}))
    done(session, *deeds, ("drop", {"time": 0.25, "partial": True}))
    assert set(tomllib.loads(session.document.text)["keyframe"][1]["joints"]) == {"hip", "knee"}


def test_a_cancelled_drag_changes_nothing(session):
    grip = ("grip", {"time": 0.5, "body": 4, "offset": [0, 0, 0]})
    done(session, grip, ("drag", {"position": [0.2, 0, 0.2]}), ("cancel", {}), ("drop", {"time": 0.5}))
    assert (session.document.text, session.document.revision) == (CLIP, 0)


def test_a_turn_that_was_let_go_leaves_nothing_to_the_next_one(session):
    turn = [np.cos(0.2), 0, np.sin(0.2), 0]
    some = ("turn", {"time": 0, "joint": "hip", "turn": turn})
    other = ("turn", {"time": 0.5, "joint": "knee", "turn": turn})
    before, after, _ = done(session, some, other, ("drop", {"time": 0.5}))
    same(before, after, set(COLUMNS) - {"knee"})


def test_a_figure_that_has_other_joints_by_now_is_not_posed_as_the_one_that_was_held(session):
    box = {"body": "box", "position": [2.0, 0, 0.1], "size": [0.1, 0.1, 0.1], "mass": 1.0}

    async def deed(actions):
        await actions.grip(time=0.5, body=5, offset=[0, 0, 0])
        await session.edit("add", {"at": ["scene", "box"], "entries": box})
        with pytest.raises(UserError, match="the figure has changed"):
            await actions.drag(position=[1, 0, 1])
        assert await actions.drop(time=0.5) == ""

    live(session, deed)


def test_a_robot_crouches_and_reaches_in_two_drags(tmp_path, monkeypatch):
    (tmp_path / "android.xml").write_text(figures.ANDROID)
    text = starter(str(tmp_path / "android.xml"), tmp_path / "robot.toml")
    text = text.replace("[[keyframe]]", "[solve]\nevaluations = 10\n\n[[keyframe]]", 1)
    session = Session(Document("robot", text, tmp_path))
    monkeypatch.setattr(session.solver, "send", here(session))
    moved = {}

    async def deed(actions):
        poser = await actions.poser()
        time, model = 0.5 * session.loaded["keys"][-1]["time"], poser.figure.model
        for name, by in (("pelvis", [0, 0, -0.12]), ("left_wrist_roll_link", [0.18, 0, 0.06])):
            body = model.body(name).id
            place = kinematics(model, actions.at(time, poser)).xpos[body].copy()
            await actions.grip(time=time, body=body, offset=[0, 0, 0])
            for share in (0.3, 0.6, 1):
                await actions.drag(position=place + share * np.array(by))
            await actions.drop(time=time)
            await asyncio.sleep(0.1)
            moved[name] = kinematics(model, actions.at(time, poser)).xpos[body] - place

    live(session, deed)
    assert moved["pelvis"] == pytest.approx([0, 0, -0.12], abs=5e-3)
    assert moved["left_wrist_roll_link"] == pytest.approx([0.18, 0, 0.06], abs=5e-3)
    assert json.loads(session._shown["settled"])["violations"] == []
