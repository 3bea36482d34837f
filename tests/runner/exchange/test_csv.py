"""CSV of qpos: out and back, and tables that others write."""

import csv

import mujoco
import numpy as np
import pytest

from dynsplines import models, motion, solving
from dynsplines.clip import load as clip
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.format import csv_table
from dynsplines.exchange.motion_import import import_recording
from dynsplines.system.progress import Progress


@pytest.fixture(scope="module")
def saved():
    return solving.unsolved(clip.load("sit_down")).saved(Progress(), with_report=False)


@pytest.mark.slow
def test_a_motion_comes_back_from_its_table_to_the_last_digit(saved, tmp_path):
    target = formats.export(saved, "csv", tmp_path / "sit.csv")
    back = import_recording(target, figure="human")
    before, after = (motion.sampled(m.figure, m.timeline, m.fps) for m in (saved, back))
    np.testing.assert_array_equal(before.time, after.time)
    np.testing.assert_allclose(before.qpos, after.qpos, atol=1e-12)


def test_a_table_without_a_heading_needs_a_rate_or_times(tmp_path):
    model = mujoco.MjModel.from_xml_string(models.figure_text("human"))
    path = tmp_path / "raw.csv"
    np.savetxt(path, np.tile(model.qpos0, (4, 1)), delimiter=",")
    with pytest.raises(UserError, match="give the rate: --fps, or fps= in Python"):
        csv_table.read(path, model, None)
    np.testing.assert_allclose(csv_table.read(path, model, 50.0).time, [0, 0.02, 0.04, 0.06])
    np.savetxt(path, np.column_stack([[0.5, 0.75], np.tile(model.qpos0, (2, 1))]), delimiter=",")
    np.testing.assert_allclose(csv_table.read(path, model, None).time, [0.5, 0.75])


@pytest.mark.slow
def test_columns_may_stand_in_any_order_and_a_missing_one_is_named(saved, tmp_path):
    target = formats.export(saved, "csv", tmp_path / "sit.csv")
    with target.open(newline="") as stream:
        rows = list(csv.reader(stream))
    with target.open("w", newline="") as stream:
        csv.writer(stream).writerows(row[::-1] for row in rows)
    np.testing.assert_array_equal(csv_table.read(target, saved.figure.model, None).qpos[0], _first(saved))
    with target.open("w", newline="") as stream:
        csv.writer(stream).writerows(row[:-1] for row in rows)
    with pytest.raises(UserError, match=f"no column '{rows[0][-1]}'"):
        csv_table.read(target, saved.figure.model, None)


def _first(saved):
    return motion.sampled(saved.figure, saved.timeline, saved.fps).qpos[0]


@pytest.mark.slow
def test_a_row_cut_short_and_an_unknown_format_are_reported(saved, tmp_path):
    path = tmp_path / "cut.csv"
    path.write_text("0,1,2\n0,1\n0,1,2\n")
    with pytest.raises(UserError, match="row 2 does not hold 3 numbers"):
        csv_table.read(path, saved.figure.model, None)
    path.write_bytes(b"time,x\n\xff\xfe1")
    with pytest.raises(UserError, match="not a table of text"):
        csv_table.read(path, saved.figure.model, None)
    with pytest.raises(UserError, match="did you mean 'csv'"):
        formats.export(saved, "cvs", tmp_path / "a")
    with pytest.raises(UserError, match="give --from, or format= in Python, one of"):
        formats.recording(tmp_path / "a.foo")
