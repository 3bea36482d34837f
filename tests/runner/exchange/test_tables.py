"""Tables of other programs: separators, comments, units in headings, and wrong tables."""

import motions
import numpy as np
import pytest
from texts import read_cases

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


NO_TEXT = [(b"time,x\n\xff\xfe1", "not a table of text"), (b"1,2\n\x001,2\n", "not a table of text")]


@pytest.mark.parametrize(("text", "message"), [*read_cases("wrong_tables.toml"), *NO_TEXT])
def test_wrong_tables_are_refused_in_one_line(text, message, tmp_path):
    (tmp_path / "a.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(UserError, match=message) as error:
        read(tmp_path / "a.csv", 50.0)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("names", [["time", *OURS], None])
def test_a_table_cut_anywhere_is_refused_or_has_its_first_rows(names, tmp_path):
    text = written(tmp_path / "a.csv", names, TIMED[:3]).read_text()
    breaks = np.flatnonzero(np.array(list(text)) == "\n")
    for end in sorted({*range(1, len(text), 23), *(i + k for i in breaks[:-1].tolist() for k in (-1, 0, 1, 2))}):
        (tmp_path / "a.csv").write_text(text[:end])
        try:
            found = read(tmp_path / "a.csv")
        except UserError:
            continue
        assert text[end - 1] == "\n"
        np.testing.assert_allclose(found.qpos, QPOS[: len(found.qpos)], atol=1e-8)
