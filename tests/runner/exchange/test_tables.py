"""Tables as other programs write them: separators, decimal commas, comments, names of columns, units."""

import numpy as np
import pytest
import walking_biped as biped

from dynsplines.errors import UserError
from dynsplines.exchange.formats import recording

QPOS = biped.walk(60)
TIME = np.arange(60) / biped.FPS
OURS = [*(f"root.{part}" for part in ("x", "y", "z", "qw", "qx", "qy", "qz")), "waist_yaw", *biped.JOINTS]


def written(path, names, rows, *, separator=",", decimal=".", head="", end="\n", encoding="utf-8"):
    """A table of strings, as a program with that locale writes it."""
    lines = [] if names is None else [separator.join(names)]
    lines += [separator.join(f"{number:.9f}".replace(".", decimal) for number in row) for row in rows]
    path.write_bytes((head + end.join(lines) + end).encode(encoding))
    return path


def read(path, fps=None, kind="csv"):
    found = recording(path, kind, model=biped.model(), fps=fps)
    return found, " | ".join(found.notes)


def is_walk(found, tolerance=1e-8):
    np.testing.assert_allclose(found.qpos, QPOS, atol=tolerance)
    np.testing.assert_allclose(found.time, TIME, atol=1e-9)


TIMED = np.column_stack([TIME, QPOS])


WRITTEN = [(separator, decimal) for decimal in ".," for separator in (",", ";", "\t", " ", "  ", ", ", "; ")]


@pytest.mark.parametrize(("separator", "decimal"), [each for each in WRITTEN if each[0][0] != each[1]])
@pytest.mark.parametrize("names", [["time", *OURS], None])
def test_separator_and_decimal_sign_are_detected(separator, decimal, names, tmp_path):
    found, notes = read(written(tmp_path / "a.csv", names, TIMED, separator=separator, decimal=decimal))
    is_walk(found)
    assert ("decimal commas" in notes) == (decimal == ",")


@pytest.mark.parametrize(
    "style",
    [
        {"end": "\r\n"},
        {"end": "\r\n", "encoding": "utf-8-sig"},
        {"encoding": "utf-16", "separator": "\t"},
        {"head": "sep=;\n", "separator": ";"},
        {"head": "# made by a robot\n# 2 s\n\n"},
        {"head": "// made by a robot\n"},
        {"head": "% made, by, a, robot\n"},
        {"end": ",\n"},
        {"end": "\n\n"},
    ],
)
@pytest.mark.parametrize("names", [["time", *OURS], None])
def test_line_ends_marks_and_comments(style, names, tmp_path):
    is_walk(read(written(tmp_path / "a.csv", names, TIMED, **style))[0])


@pytest.mark.parametrize("ending", ["csv", "tsv", "txt", "CSV"])
def test_endings_of_tables(ending, tmp_path):
    is_walk(read(written(tmp_path / f"a.{ending}", ["time", *OURS], TIMED, separator="\t"))[0])
    is_walk(read(written(tmp_path / f"b.{ending}", None, QPOS, separator=" "), 50.0)[0])


def test_names_in_a_comment_and_a_rate_in_a_comment(tmp_path):
    is_walk(read(written(tmp_path / "a.csv", None, TIMED, head=f"# {','.join(['time', *OURS])}\n"))[0])
    np.savetxt(tmp_path / "b.txt", TIMED, header=" ".join(["time", *OURS]))
    is_walk(read(tmp_path / "b.txt")[0])
    for comment in ("# fps: 50\n", "# frame_rate=50\n", "# Frequency (50 Hz)\n"):
        is_walk(read(written(tmp_path / "c.csv", None, QPOS, head=comment))[0])


VOCABULARIES = {
    "snake": ("root_pos_x root_pos_y root_pos_z root_quat_w root_quat_x root_quat_y root_quat_z", "{}"),
    "base": ("base_x base_y base_z base_qw base_qx base_qy base_qz", "{}_joint"),
    "body": ("pelvis.px pelvis.py pelvis.pz pelvis.rot.w pelvis.rot.x pelvis.rot.y pelvis.rot.z", "dof_{}"),
    "bare": ("x y z qw qx qy qz", "joint_{}"),
    "camel": ("RootPosX RootPosY RootPosZ RootRotW RootRotX RootRotY RootRotZ", "{}"),
    "units": ("root_x[m] root_y[m] root_z[m] quat_w quat_x quat_y quat_z", "{} (rad)"),
    "world": ("base_pos_w_x base_pos_w_y base_pos_w_z base_quat_w base_quat_x base_quat_y base_quat_z", "{}_pos"),
}


@pytest.mark.parametrize("vocabulary", VOCABULARIES)
def test_names_of_other_programs(vocabulary, tmp_path):
    root, joint = VOCABULARIES[vocabulary]
    names = ["Time", *root.split(), "WAIST_YAW", *(joint.format(name) for name in biped.JOINTS)]
    order = np.random.default_rng(2).permutation(15)
    table = written(tmp_path / "a.csv", [names[i] for i in order], TIMED[:, order])
    found, notes = read(table)
    is_walk(found)
    assert "columns by other names" in notes


def test_columns_that_are_numbered_are_taken_in_their_order(tmp_path):
    names = ["frame", "x", "y", "z", "qw", "qx", "qy", "qz", *(f"dof_{i}" for i in range(7))]
    rows = np.column_stack([np.arange(60), QPOS])
    is_walk(read(written(tmp_path / "a.csv", names, rows), 50.0)[0])


def test_a_column_that_counts_samples_is_no_time(tmp_path):
    rows = np.column_stack([np.arange(60), QPOS])
    is_walk(read(written(tmp_path / "a.csv", None, rows), 50.0)[0])
    with pytest.raises(UserError, match="give the rate"):
        read(written(tmp_path / "a.csv", None, rows))


def test_milliseconds_centimetres_and_degrees_by_the_names_of_columns(tmp_path):
    names = ["time [ms]", *(f"{name} [cm]" for name in OURS[:3]), *OURS[3:7], *(f"{name} [deg]" for name in OURS[7:])]
    rows = TIMED * [1000, *[100] * 3, *[1] * 4, *[180 / np.pi] * 7]
    found, notes = read(written(tmp_path / "a.csv", names, rows))
    is_walk(found, 1e-7)
    assert "angles in degrees, by their columns' names" in notes
    lines = (tmp_path / "a.csv").read_text().splitlines()
    units = ["ms", "cm", "cm", "cm", "", "", "", "", *["deg"] * 7]
    (tmp_path / "b.csv").write_text("\n".join([",".join(["time", *OURS]), ",".join(units), *lines[1:]]))
    is_walk(read(tmp_path / "b.csv")[0], 1e-7)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the file is empty"),
        ("# nothing\n", "the file is empty"),
        ("time;root\na;b\n", "a table with no numbers"),
        ("1;2;3\n4;5\n6;7;8\n", "row 2 does not hold 3 numbers, separated by semicolons"),
        ("1,5;2,5\n1,5;x\n", "row 2 does not hold 2 numbers, separated by semicolons, with decimal commas"),
        ("a,b\n1,2,3\n1,2,3\n", "2 names for 3 columns, separated by commas"),
        ("1|2|3\n4|5|6\n", "whose cells commas, semicolons, tabs or spaces separate"),
        (b"time,x\n\xff\xfe1", "not a table of text"),
        ("1,2,3\n4,5,6\n", "3 columns without a heading; the figure's qpos has 14"),
    ],
)
def test_tables_that_cannot_be_read_are_refused_in_one_line(text, message, tmp_path):
    (tmp_path / "a.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(UserError, match=message) as error:
        read(tmp_path / "a.csv", 50.0)
    assert "\n" not in str(error.value)


def test_columns_that_are_missing_or_could_both_be_one_are_named(tmp_path):
    with pytest.raises(UserError, match=r"no column 'left_knee'; the figure's columns: root.x, .* the file's: time"):
        read(written(tmp_path / "a.csv", ["time", *OURS[:9], "kn", *OURS[10:]], TIMED))
    names = ["time", "root_x", "base_x", "y", "z", *OURS[3:]]
    with pytest.raises(UserError, match=r"the columns 'root_x' and 'base_x' could both be 'root.x'"):
        read(written(tmp_path / "a.csv", names, np.insert(TIMED, 1, 0, axis=1)))


@pytest.mark.parametrize("name", ["root.x", "time"])
def test_two_columns_of_one_name_must_agree(name, tmp_path):
    names = ["time", *OURS, name]
    column = TIMED[:, [names.index(name)]]
    is_walk(read(written(tmp_path / "a.csv", names, np.hstack([TIMED, column])))[0])
    message = rf"a\.csv: columns {names.index(name) + 1} and 16 are both '{name}', with different numbers; remove"
    with pytest.raises(UserError, match=message):
        read(written(tmp_path / "a.csv", names, np.hstack([TIMED, 2 * column + 1])))
