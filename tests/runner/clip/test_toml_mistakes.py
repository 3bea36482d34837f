"""Invalid TOML is reported with its line and what to write instead."""

from __future__ import annotations

import pytest

from dynsplines.clip.parse import parse
from dynsplines.errors import UserError

KEY = "[[keyframe]]\ntime = 0\n"  # lines 2 and 3, after the figure
SINGLE = "[keyframe] is a single table, and there are several; write [[keyframe]]"
MISTAKES = {
    "single tables": ("[keyframe]\ntime = 0\n\n[keyframe]\ntime = 1", f"line 2: {SINGLE}"),
    "a single table first": ("[keyframe]\ntime = 0\n\n[[keyframe]]\ntime = 1", f"line 2: {SINGLE}"),
    "a single table last": (f"{KEY}\n [ keyframe ] # the second\ntime = 1", f"line 5: {SINGLE}"),
    "single obstacles": ("[scene.box]\n[scene.box]", "line 2: [scene.box] is a single table"),
    "a table of which there is one": ("[scene]\n[solve]\n[scene]", "line 4: a second table [scene]; write its keys"),
    "a text without quotes": (f"{KEY}others = rest", "line 4: 'others = rest' is not valid TOML"),
    "which text": (f"{KEY}others = rest  # all", '; texts need quotes: "rest"'),
    "in a list": (f"{KEY}root.position = [0, free, 0]", '; texts need quotes: "free"'),
    "in an inline table": (f"{KEY}root = {{rotation = free}}", '; texts need quotes: "free"'),
    "a text of two words": (f"{KEY}name = my clip", '; texts need quotes: "my clip"'),
    "a capital truth": (f"{KEY}bodies.left_foot = {{flat = True}}", "invalid value; true and false are lower case"),
    "typographic quotes": ("name = “clip”", "; put texts in straight quotes"),
    "a text without an end": (f'{KEY}others = "rest\n', "; close the text with a quote"),
    "a decimal comma": ("[[keyframe]]\ntime = 0,5", "line 3: 'time = 0,5' is .*; numbers have a point, not a comma"),
    "no digit before the point": ("[[keyframe]]\ntime = .5", "; numbers have a digit before the point: 0.5"),
    "no value": (f"{KEY}others =  # rest", "; write a value after ="),
    "a key twice": (f"{KEY}time = 1", "line 4: 'time = 1' is .*: cannot overwrite a value; give each key once"),
    "a colon": ("[[keyframe]]\ntime: 0", "; write key = value"),
    "a list in parentheses": (f"{KEY}root.position = (0, 0, 1)", "; lists have square brackets"),
    "a list without commas": (f"{KEY}root.position = [0 0 1]", "; put commas between the values of a list"),
    "an inline table in two lines": (f"{KEY}joints = {{a = 1,\nb = 2}}", "line 4: .*; write {} tables in one line"),
    "a path of Windows": ('name = "C:\\Users"', "; write paths with /"),
    "the end of a text": ('name = """', "line 2: "),
}  # fmt: skip


ROTATIONS = {
    "joints.left_elbow = {}": "joints.left_elbow: give exactly one of rotvec, euler, quat, not none (",
    "root.rotation = {}": "root.rotation: give exactly one of rotvec, euler, quat, not none (a root, a body or",
    "joints.left_elbow = {rotvec = [0, 0, 0], quat = [1, 0, 0, 0]}": "joints.left_elbow: give exactly one of",
    "joints.left_elbow = {quat = [0, 0, 0, 0]}": "joints.left_elbow: the quaternion is zero",
    'root.rotation = {euler = [1, 2], order = "xyz"}': "root.rotation: euler has 2 angles",
    "joints.left_elbow = {rotvec = [0, 1]}": "joints.left_elbow.rotvec must be three angles",
    "joints.left_elbow = {rot = [0, 1]}": "joints.left_elbow: no key 'rot'",
    "sites.left_hand = {}": "'sites.left_hand.position' is missing",
}


@pytest.mark.parametrize("entry", ROTATIONS)
def test_an_error_names_the_keys_of_the_file_alone(entry):
    with pytest.raises(UserError) as caught:
        parse(f'figure = "human"\n{KEY}{entry}', "c", "c.toml")
    assert str(caught.value).startswith(f"c.toml: keyframe 1 (t = 0 s): {ROTATIONS[entry]}")


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
@pytest.mark.parametrize("mistake", MISTAKES)
def test_invalid_toml_is_reported_with_its_line_and_a_remedy(mistake, ending):
    text, words = MISTAKES[mistake]
    start, _, end = words.partition(".*")
    with pytest.raises(UserError) as caught:
        parse(f'figure = "human"\n{text}'.replace("\n", ending), "c", "c.toml")
    told = str(caught.value)
    assert told.startswith("c.toml: line ") and "\n" not in told
    assert start in told and end in told


def test_a_long_line_is_shortened():
    with pytest.raises(UserError, match=r"^c\.toml: line 1: 'name = x{50}\.\.\.' is not valid TOML"):
        parse(f"name = {'x' * 200}", "c", "c.toml")
