"""A clip's text while it is edited: undo gives the first bytes again, comments stay, nonsense changes nothing."""

import tomllib
from pathlib import Path

import problems
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from texts import read_data

from dynsplines import models
from dynsplines.clip.parse import table_of
from dynsplines.errors import UserError
from dynsplines.studio.document import Document, open_document
from dynsplines.studio.edits import EDITS
from dynsplines.studio.stage import weights

TEXT = read_data("remarks.toml")

times = st.one_of(st.floats(-1, 3).map(lambda x: round(x, 3)), st.just(float("nan")))
angles = st.one_of(st.floats(-180, 180), st.sampled_from([float("nan"), None, "free", "much"]))
keys = st.integers(-1, 5)
keyframe = st.tuples(st.just("keyframe"), keys)
contact = st.fixed_dictionaries({"point": st.just("left_heel"), "from": times, "to": times})


def edits(name, **arguments):
    return st.tuples(st.just(name), st.fixed_dictionaries(arguments))


def changes(at, **entries):
    return edits("change", at=at, entries=st.fixed_dictionaries(entries))


deeds = st.one_of(
    edits("move_keys", moves=st.lists(st.tuples(keys, times), min_size=1, max_size=3)),
    edits("add_key", entries=st.fixed_dictionaries({"time": times})),
    edits("delete_keys", keys=st.lists(keys, min_size=1, max_size=3)),
    changes(keyframe, joints=st.dictionaries(st.sampled_from(["left_hip", "spine"]), angles, min_size=1)),
    changes(keyframe, joints=st.just({"left_hip": {"rotvec": [1.0, -20.5, 0.25]}})),
    changes(keyframe, root=st.fixed_dictionaries({"position": st.sampled_from([[0.1, 0, "free"], "free", [1, 2]])})),
    changes(keyframe, others=st.sampled_from([None, "previous", "key:home"])),
    changes(st.just(("scene",)), step=st.just({"x": 1.5, "height": 0.2})),
    changes(st.just(("solve",)), frames=st.just(12)),
    edits("add", at=st.just(["contact"]), entries=contact),
    edits("add", at=st.sampled_from([["scene", "box"], ["scene", "sphere"]]), entries=st.just({"radius": 0.2})),
    edits("remove", at=st.tuples(st.just("contact"), st.integers(0, 2))),
    edits("remove", at=st.sampled_from([("scene", "step"), ("scene", "box", 0)])),
    edits("set_weight", kind=st.sampled_from(["limits", "torque"]), weight=st.sampled_from([None, 2.5, 0])),
)


def document(text=TEXT):
    return Document("clip", text, Path())


def edited(found, name, entries):
    """An edit as a session does it."""
    tree = found.tree()
    words = EDITS[name](tree, **entries)
    found.commit(tree.as_string(), words)


def change(found, *at, **entries):
    edited(found, "change", {"at": at, "entries": entries})


def rows(found, name="keyframe"):
    return tomllib.loads(found.text).get(name, [])


@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(deeds, min_size=1, max_size=12))
def test_undo_after_any_edits_gives_the_first_text_byte_for_byte(some):
    found = document()
    for name, entries in some:
        before = found.text
        try:
            edited(found, name, entries)
        except UserError:
            assert found.text == before
        tomllib.loads(found.text)
    last = found.text
    count = 0
    while found.steps["undo"]:
        found.step("undo")
        count += 1
    assert found.text == TEXT
    for _ in range(count):
        found.step("redo")
    assert found.text == last
    assert not found.steps["redo"]


def test_a_stroke_of_edits_is_undone_at_once_unless_something_comes_between():
    found = Document("clip", "x = 0", Path())
    for value, stroke in ((1, "a"), (2, "a"), (3, None), (4, "b"), (5, "b"), (3, "b"), (6, "c")):
        found.commit(f"x = {value}", f"to {value}", stroke)
    assert [step.words for step in found.steps["undo"]] == ["to 1", "to 3", "to 6"]
    found.step("undo")
    assert found.text == "x = 3"
    found.commit("x = 7", "to 7", "c")
    assert [step.words for step in found.steps["undo"]] == ["to 1", "to 3", "to 7"]
    for before in ("x = 3", "x = 2", "x = 0"):
        found.step("undo")
        assert found.text == before


def test_undo_stores_only_the_part_that_an_edit_changes():
    found, rest = Document("clip", "x = 0\n" + "# a comment\n" * 1000, Path()), "\n" + "# a comment\n" * 1000
    for value in range(1, 100):
        found.commit(f"x = {value}{rest}", "to", str(value // 2))
    found.step("undo")
    assert sum(len(step.part) for step in [*found.steps["undo"], *found.steps["redo"]]) < 200


def test_comments_and_order_stay():
    found = document()
    edited(found, "move_keys", {"moves": [[1, 0.6]]})
    change(found, "keyframe", 0, joints={"left_hip": {"rotvec": [0, -60, 0]}})
    change(found, "keyframe", 0, root={"position": [0.0, 0, 0.9]})
    edited(found, "set_weight", {"kind": "limits", "weight": 3})
    edited(found, "add_key", {"entries": {"time": 0.8, "joints": {"spine": {"rotvec": [0, 5, 0]}}}})
    wanted, got = ([line.partition("#")[2] for line in text.splitlines() if "#" in line] for text in (TEXT, found.text))
    assert got == wanted
    assert [row["time"] for row in rows(found)] == [0.0, 0.6, 0.8, 1.0]
    assert rows(found)[0]["joints"]["left_hip"] == {"rotvec": [0, -60, 0]}
    assert rows(found)[2]["joints"]["spine"] == {"rotvec": [0, 5, 0]}
    assert rows(found, "penalty") == [{"kind": "limits", "weight": 3}]


def test_weights_of_parts_are_one_table():
    found = document()
    for change, expected in (
        (
            {"kind": "limits", "part": "range", "weight": 3},
            [{"kind": "limits", "weight": {"bend": 1, "range": 3, "overshoot": 10}}],
        ),
        (
            {"kind": "limits", "part": "bend", "weight": None},
            [{"kind": "limits", "weight": {"range": 3, "overshoot": 10}}],
        ),
        ({"kind": "limits", "weight": None}, []),
        (
            {"kind": "collision", "part": "self", "weight": 7},
            [{"kind": "collision", "self": True, "weight": {"self": 7}}],
        ),
        ({"kind": "collision", "part": "self", "weight": None}, []),
        ({"kind": "flight", "part": "", "weight": 7}, [{"kind": "flight", "weight": 7}]),
    ):
        edited(found, "set_weight", change)
        assert rows(found, "penalty") == expected
        assert weights(table_of(found.text, "clip"), "clip") == {
            f"{row['kind']}.{part}" if part else row["kind"]: weight
            for row in expected
            for part, weight in (row["weight"] if isinstance(row["weight"], dict) else {"": row["weight"]}).items()
        }
    with pytest.raises(UserError, match="'limits' has no part 'rnge'"):
        edited(found, "set_weight", {"kind": "limits", "part": "rnge", "weight": 3})


def test_a_keyframe_that_says_something_else_keeps_its_remarks_and_the_lines_that_stay():
    found = document()
    entries = {"time": 0.0, "root": {"position": [0.0, 0, 0.93]}, "joints": {"right_hip": {"rotvec": [0, -70, 0]}}}
    edited(found, "replace_keys", {"keys": {"0": {**entries, "others": "rest"}}, "words": "mirror a keyframe"})
    assert "root.position = [0.0, 0, 0.93]        # stands\n" in found.text
    assert rows(found)[0] == {**entries, "others": "rest"}
    moved = {**entries, "root": {"position": [0.0, 0.1, 0.93]}}
    edited(found, "replace_keys", {"keys": {"0": moved}, "words": "mirror a keyframe"})
    assert "root.position = [0.0, 0.1, 0.93]        # stands\n" in found.text
    assert rows(found)[0] == moved


@pytest.mark.parametrize(
    ("name", "entries", "words"),
    [
        ("move_keys", {"moves": [[0, float("nan")]]}, "finite number"),
        ("move_keys", {"moves": [[7, 0.1]]}, "there is no keyframe 8 any more"),
        ("add_key", {"entries": {"time": 0.5}}, "already: keyframe 2"),
        ("delete_keys", {"keys": [3]}, "there is no keyframe 4 any more"),
        ("change", {"at": ["keyframe", 0], "entries": {"joints": {"spine": float("nan")}}}, "finite number"),
        ("change", {"at": ["keyframe", 3], "entries": {}}, "there is no keyframe 4 any more"),
        ("change", {"at": ["recording"], "entries": {"file": "/x"}}, "not a table that can be edited here"),
        ("change", {"at": [], "entries": {"figure": "/x"}}, "not a table that can be edited here"),
        ("remove", {"at": ["contact", 0]}, "there is no contact 1 any more"),
        ("remove", {"at": ["scene", "cone"]}, "there is no cone any more"),
        ("paste_keys", {"copied": [], "time": 0.3}, "nothing has been copied"),
    ],
)
def test_nonsense_is_refused_in_words_and_changes_nothing(name, entries, words):
    found = document()
    with pytest.raises(UserError) as error:
        edited(found, name, entries)
    assert words in str(error.value)
    assert found.text == TEXT
    edited(found, "move_keys", {"moves": [[1, 0.7]]})
    assert "time = 0.7" in found.text


def test_keyframes_can_be_1_ms_apart_in_spite_of_rounding():
    found = document()
    for time in (0.009, 0.008):
        edited(found, "add_key", {"entries": {"time": time}})
    edited(found, "move_keys", {"moves": [[1, 0.016], [2, 0.017]]})
    assert [key["time"] for key in rows(found)[1:3]] == [0.016, 0.017]


def test_contacts_go_along_with_the_keyframes_that_they_end_at():
    found = document()
    edited(found, "add", {"at": ["contact"], "entries": {"point": "left_heel", "from": 0.5, "to": 1.0}})
    edited(found, "move_keys", {"moves": [[1, 0.4]]})
    assert rows(found, "contact") == [{"point": "left_heel", "from": 0.4, "to": 1.0}]


def test_every_shipped_clip_is_split_into_blocks_and_joined_again():
    texts = [*map(models.clip_text, models.clips())]
    for text in texts:
        assert document(text).tree().as_string() == text
    found = document(texts[-1])
    time = found.tree_rows()[0]["time"] - 0.01
    edited(found, "move_keys", {"moves": [[0, time]]})
    assert rows(found)[0]["time"] == pytest.approx(time)
    assert len(found.text.splitlines()) == len(texts[-1].splitlines())


WITH_HEADERS = read_data("headers.toml")


def test_tables_under_headers_of_their_own_belong_to_their_keyframe():
    found = document(WITH_HEADERS)
    change(found, "keyframe", 1, joints={"spine": {"rotvec": [1.0, 2.0, 3.0]}})
    change(found, "keyframe", 1, joints={"left_hip": "free"})
    change(found, "keyframe", 0, others=None)
    edited(found, "add_key", {"entries": {"time": 0.75, "root": {"position": [0.2, 0, 0.93]}}})
    after = rows(found)
    assert [row["time"] for row in after] == [0.0, 0.5, 0.75, 1.0]
    assert after[1]["joints"] == {"spine": {"rotvec": [1.0, 2.0, 3.0]}, "left_hip": "free"}
    assert [row.get("root", {}).get("position") for row in after[1:3]] == [[0.1, 0, 0.93], [0.2, 0, 0.93]]
    assert after[0].get("others", "free") == "free"
    edited(found, "delete_keys", {"keys": [1]})
    assert [row["time"] for row in rows(found)] == [0.0, 0.75, 1.0]
    assert rows(found)[0]["joints"] == {"left_hip": {"rotvec": [0, -70, 0]}}
    assert "# lifted" in found.text
    while found.steps["undo"]:
        found.step("undo")
    assert found.text == WITH_HEADERS


def test_lines_that_end_as_on_windows_are_edited_and_end_so_again(tmp_path):
    file = tmp_path / "clip.toml"
    file.write_bytes(TEXT.replace("\n", "\r\n").encode())
    found = open_document(str(file))
    assert not found.is_dirty
    edited(found, "move_keys", {"moves": [[1, 0.6]]})
    found.save(file)
    assert file.read_bytes() == TEXT.replace("time = 0.50", "time = 0.6").replace("\n", "\r\n").encode()


def test_a_clip_file_and_a_shipped_clip_are_opened(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    file = problems.written(tmp_path)
    found = open_document(file.name)
    assert (found.text, found.file, found.folder) == (problems.CLIP, file.resolve(), tmp_path.resolve())
    shipped = open_document("run_and_step")
    assert (shipped.text, shipped.file, shipped.folder) == (models.clip_text("run_and_step"), None, tmp_path)
    assert not found.is_dirty
    assert not shipped.is_dirty


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("nowhere.toml", "no file 'nowhere.toml'"),
        ("run_and_stp", "run_and_step"),
        (".", "is a folder; open a clip"),
        ("tiny.xml", "'tiny.xml' is a model; write a clip for it: dynsplines new tiny.xml"),
        ("walk.npz", "open the clip of this motion, or write one: dynsplines thin walk.npz"),
        ("walk.bvh", "open the clip of this motion, or write one: dynsplines thin walk.bvh"),
    ],
)
def test_other_files_are_rejected_with_the_command_that_writes_a_clip(tmp_path, monkeypatch, name, words):
    monkeypatch.chdir(tmp_path)
    problems.written(tmp_path)
    for file in ("walk.npz", "walk.bvh"):
        (tmp_path / file).write_bytes(b"")
    with pytest.raises(UserError) as error:
        open_document(name)
    assert words in str(error.value)
