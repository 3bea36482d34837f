"""Tables of other programs: separators, comments, units in headings, and wrong tables."""

import motions
import numpy as np
import pytest

from dynsplines.errors import UserError
from dynsplines.exchange.formats import recording

QPOS = motions.biped_walk(60)
TIME = np.arange(60) / motions.BIPED_FPS
OURS = [*(f"root.{part}" for part in ("x", "y", "z", "qw", "qx", "qy", "qz")), "waist_yaw", *motions.JOINTS]
TIMED = np.column_stack([TIME, QPOS])


def written(path, names, rows, *, separator=",", head="", end="\n", encoding="utf-8"):
    """A table of strings, as a program with that locale writes it."""
    lines = [] if names is None else [separator.join(names)]
    lines += [separator.join(f"{number:.9f}" for number in row) for row in rows]
    path.write_bytes((head + end.join(lines) + end).encode(encoding))
    return path


def read(path, fps=None, kind="csv"):
    return recording(path, kind, model=motions.model(), fps=fps)


def is_walk(found, tolerance=1e-8):
    np.testing.assert_allclose(found.qpos, QPOS, atol=tolerance)
    np.testing.assert_allclose(found.time, TIME, atol=1e-9)


SEPARATED = [{"separator": separator} for separator in (",", ";", "\t", " ", "  ", ", ", "; ")]
STYLES = [
    {"end": "\r\n"},
    {"end": "\r\n", "encoding": "utf-8-sig"},
    {"head": "# made by a robot\n# 2 s\n\n"},
    {"head": "// made by a robot\n"},
    {"head": "% made, by, a, robot\n"},
    {"end": ",\n"},
    {"end": "\n\n"},
]


@pytest.mark.parametrize("style", [*SEPARATED, *STYLES], ids=repr)
@pytest.mark.parametrize("names", [["time", *OURS], None])
def test_separators_ends_and_comments(style, names, tmp_path):
    is_walk(read(written(tmp_path / "a.csv", names, TIMED, **style)))


@pytest.mark.parametrize("ending", ["csv", "tsv", "txt", "CSV"])
def test_a_heading_states_the_format_and_the_order_of_columns(ending, tmp_path):
    names, order = ["time", *OURS], np.random.default_rng(2).permutation(15)
    path = written(tmp_path / f"a.{ending}", [names[i] for i in order], TIMED[:, order], separator="\t")
    is_walk(read(path, kind=None))


def test_names_in_a_comment(tmp_path):
    is_walk(read(written(tmp_path / "a.csv", None, TIMED, head=f"# {','.join(['time', *OURS])}\n"), kind=None))
    np.savetxt(tmp_path / "b.txt", TIMED, header=" ".join(["time", *OURS]))
    is_walk(read(tmp_path / "b.txt", kind=None))


def test_a_column_that_counts_samples_is_no_time(tmp_path):
    path = written(tmp_path / "a.csv", None, np.column_stack([np.arange(60), QPOS]))
    is_walk(read(path, 50.0))
    with pytest.raises(UserError, match="give the rate"):
        read(path)


def test_units_in_headings(tmp_path):
    names = ["time [ms]", *(f"{name} [cm]" for name in OURS[:3]), *OURS[3:7], *(f"{name} (deg)" for name in OURS[7:])]
    rows = TIMED * [1000, *[100] * 3, *[1] * 4, *[180 / np.pi] * 7]
    is_walk(read(written(tmp_path / "a.csv", names, rows)), 1e-7)


def test_two_columns_of_one_name_must_agree(tmp_path):
    for name in ("root.x", "time"):
        names = ["time", *OURS, name]
        column = TIMED[:, [names.index(name)]]
        is_walk(read(written(tmp_path / "a.csv", names, np.hstack([TIMED, column]))))
        with pytest.raises(UserError, match=rf"a\.csv: two columns '{name}' with different numbers; remove"):
            read(written(tmp_path / "a.csv", names, np.hstack([TIMED, 2 * column + 1])))


HEADING = ",".join(["time", *OURS])
ROW = ",".join("0" * 15)
WRONG = {
    "": "the file is empty",
    "# nothing\n": "the file is empty",
    "time;root\na;b\n": "no table of numbers, with one heading",
    "time,x\ns,m\n1,2\n": "no table of numbers, with one heading",
    "1;2;3\n4;5\n6;7;8\n": "line 2 does not hold 3 numbers, separated by semicolons; complete or delete it$",
    "1;2;3\n\n4;5\n6;7\n": "line 3 does not hold 3 numbers, .*; complete or delete it and 1 more such$",
    "time;x\n1,5;2,5\n1,6;2,5\n": "no table of numbers, .* and with decimal points",
    "1,5\t2,5\n1,6\t2,5\n": "no table of numbers, .* and with decimal points",
    "1,2,3\n1,2,3\n1,2": "line 3, the last, has no end: the file may be cut short",
    "1,2,3\n1,2,3\n1,2,4.5": "line 3, the last, has no end: the file may be cut short; if not, end the line",
    "1,2,3\n1,2,3\n1,2\n": "line 3 does not hold 3 numbers",
    "a,b\n1,2,3\n1,2,3\n": "2 names for 3 columns, separated by commas",
    "1|2|3\n4|5|6\n": "separated by commas, semicolons, tabs or spaces",
    b"time,x\n\xff\xfe1": "not a table of text",
    b"1,2\n\x001,2\n": "not a table of text",
    "1,2,3\n4,5,6\n": "3 columns without a heading; the figure's qpos has 14",
    f"{HEADING.replace('knee', 'kn')}\n{ROW}\n": "no column 'left_knee' and 1 more; the figure's columns: root.x",
    f"{HEADING.replace('root.x', 'root_pos_x')}\n{ROW}\n": "no column 'root.x'; .* the file's: time, root_pos_x",
    f"{HEADING.replace('left_knee', 'left_knee [°]')}\n{ROW}\n": r"'left_knee \[°\]': no unit '°'; units: m, cm, .*deg",
}


@pytest.mark.parametrize(("text", "message"), WRONG.items())
def test_wrong_tables_are_refused_in_one_line(text, message, tmp_path):
    (tmp_path / "a.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(UserError, match=message) as error:
        read(tmp_path / "a.csv", 50.0)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("names", [["time", *OURS], None])
def test_a_table_cut_at_any_byte_is_refused_or_has_its_first_rows(names, tmp_path):
    text = written(tmp_path / "a.csv", names, TIMED[:3]).read_text()
    for end in range(1, len(text)):
        (tmp_path / "a.csv").write_text(text[:end])
        try:
            found = read(tmp_path / "a.csv")
        except UserError:
            continue
        assert text[end - 1] == "\n"
        np.testing.assert_allclose(found.qpos, QPOS[: len(found.qpos)], atol=1e-8)
