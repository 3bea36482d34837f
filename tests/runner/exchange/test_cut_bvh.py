"""BVH files that are cut short or lack numbers: cleaning uses what there is, importing refuses them."""

import numpy as np
import pytest

from dynsplines.errors import UserError
from dynsplines.exchange import gaps
from dynsplines.exchange.skeleton import bvh_file
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton

CHANNELS = "CHANNELS 3 Zrotation Xrotation Yrotation"


def text(rows, declared=None, end="\n"):
    """A file of hips, legs and a thumb that hangs on the hips."""
    lines = ["HIERARCHY", "ROOT Hips", "{", "OFFSET 0 0 0", "CHANNELS 6 Xposition Yposition Zposition" + CHANNELS[10:]]
    for side in ("Left", "Right"):
        lines += [f"JOINT {side}UpLeg", "{", f"OFFSET {'-' * (side == 'Right')}9 0 0", CHANNELS, f"JOINT {side}Leg",
                  "{", "OFFSET 0 -40 0", CHANNELS, "End Site", "{", "OFFSET 0 -40 0", "}", "}", "}"]  # fmt: skip
    lines += ["JOINT LeftHandThumb1", "{", "OFFSET 3 0 0", CHANNELS, "End Site", "{", "OFFSET 2 0 0", "}", "}", "}"]
    lines += ["MOTION", f"Frames: {declared or len(rows)}", "Frame Time: 0.02", *rows]
    return "\n".join(lines) + end


def rows(count=8):
    return [" ".join(f"{value:g}" for value in (0.1 * i, 80, 2 * i, *np.arange(18) + i)) for i in range(count)]


def lenient(path, content):
    path.write_text(content, encoding="utf-8")
    with pytest.raises(UserError, match=r"line \d+: "):
        bvh_file.read(path)
    with gaps.allowed():
        return bvh_file.read(path)


@pytest.mark.parametrize(
    ("content", "count", "note"),
    [
        (text(rows(), declared=12), 8, "8 of the 12 frames"),
        (text(rows(), declared=5), 8, "declares 5: all are used"),
        (text([*rows()[:-1], "0.7 80 14 7"], end=""), 7, "7 of the 8 frames"),
        (text([*rows(7), "0.7 80 1-"], declared=8, end=""), 7, "7 of the 8 frames"),
        (text(rows(), declared=9, end=""), 7, "7 of the 9 frames"),  # the last number may be cut
    ],
)
def test_complete_frames_of_a_cut_file_are_used(content, count, note, tmp_path):
    skeleton = lenient(tmp_path / "cut.bvh", content)
    with pytest.raises(UserError, match=r"cut\.bvh: line \d+: .*`dynsplines clean` uses"):
        bvh_file.read(tmp_path / "cut.bvh")
    assert len(skeleton.values) == count
    expected = [[float(word) for word in row.split()] for row in rows()[:count]]
    np.testing.assert_allclose(skeleton.values, expected)
    assert any(note in each for each in CapturedSkeleton.of(skeleton, 0.01).notes), skeleton.notes


@pytest.mark.parametrize("word", ["nan", "1.#QNAN", "null"])
def test_a_joint_without_numbers_that_no_part_of_the_body_needs_stays_at_rest(word, tmp_path):
    without = [" ".join([*row.split()[:-3], word, word, word]) for row in rows()]
    skeleton = lenient(tmp_path / "nan.bvh", text(without))
    expected = np.array([[float(value) for value in row.split()] for row in rows()])
    expected[:, -3:] = 0
    np.testing.assert_allclose(skeleton.values, expected)
    assert skeleton.notes == ("without numbers, held where they are or at rest: LeftHandThumb1",)


def test_a_joint_that_lacks_some_numbers_stays_where_it_was(tmp_path):
    some = rows()
    some[3] = " ".join([*some[3].split()[:-1], "nan"])
    assert lenient(tmp_path / "nan.bvh", text(some)).values[:5, -1].tolist() == [17, 18, 19, 19, 21]


def test_a_leg_without_numbers_makes_a_gap_and_one_without_any_is_refused(tmp_path):
    some = rows()
    some[3] = some[3].replace("80", "nan")
    with gaps.allowed():
        (tmp_path / "a.bvh").write_text(text(some))
        assert len(bvh_file.read(tmp_path / "a.bvh").values) == 8
        none = [" ".join([*row.split()[:6], "nan", *row.split()[7:]]) for row in rows()]
        (tmp_path / "b.bvh").write_text(text(none))
        with pytest.raises(UserError, match="no sample has numbers for all parts of the body; 'LeftUpLeg' lacks some"):
            bvh_file.read(tmp_path / "b.bvh")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (text([*rows(3), "1 2 3", *rows(3)]), "3 numbers for the 21 channels"),
        (text(rows(1), declared=12), "the file ends after 1 images; 'Frames:' declares 12"),
    ],
)
def test_a_line_of_another_width_in_the_middle_and_a_single_frame_are_refused(content, message, tmp_path):
    (tmp_path / "a.bvh").write_text(content)
    with gaps.allowed(), pytest.raises(UserError, match=message):
        bvh_file.read(tmp_path / "a.bvh")


def test_names_in_shift_jis_are_read(tmp_path):
    (tmp_path / "a.bvh").write_bytes(text(rows()).replace("LeftUpLeg", "左足").encode("cp932"))
    assert "左足" in bvh_file.read(tmp_path / "a.bvh").names


@pytest.mark.parametrize(("last", "count"), [("24.500000", 8), ("24.50", 7), ("2", 7)])
def test_the_last_number_of_a_file_without_an_end_of_line_may_be_cut(last, count, tmp_path):
    some = [f"{row.rpartition(' ')[0]} {17.5 + i:.6f}" for i, row in enumerate(rows())]
    (tmp_path / "a.bvh").write_text(text([*some[:-1], f"{some[-1].rpartition(' ')[0]} {last}"], end=""))
    with gaps.allowed():
        assert len(bvh_file.read(tmp_path / "a.bvh").values) == count
    if count == 8:
        assert len(bvh_file.read(tmp_path / "a.bvh").values) == 8
    else:
        with pytest.raises(UserError, match=f"the file ends within the number {last}; `dynsplines clean` uses"):
            bvh_file.read(tmp_path / "a.bvh")
