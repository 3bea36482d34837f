"""Unlimited hinges that wrap at ±180° in a file are unwrapped, whatever the format; other joints are left alone."""

import numpy as np
import pytest
import wild
from rich.console import Console

from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import read_recording
from dynsplines.system.progress import Progress

ARM = """
<mujoco model="arm"><compiler angle="degree"/><worldbody><body name="base"><freejoint name="root"/>
  <geom type="box" size=".1 .1 .1" mass="5"/>
  <body name="turret" pos="0 0 .2"><joint name="turret" axis="0 0 1"/><geom size=".04" mass="1"/>
    <body name="upper" pos="0 0 .2"><joint name="shoulder" axis="0 1 0" range="-180 180"/><geom size=".04" mass="1"/>
      <body name="fore" pos="0 0 .2"><joint name="elbow" axis="0 1 0" range="-170 180"/><geom size=".04" mass="1"/>
        <body name="rail" pos="0 0 .2"><joint name="rail" type="slide" axis="1 0 0"/><geom size=".04" mass="1"/>
</body></body></body></body></body></worldbody></mujoco>
"""
TIME = np.linspace(0, 2, 61)


@pytest.fixture
def arm(tmp_path):
    (tmp_path / "arm.xml").write_text(ARM)
    return tmp_path / "arm.xml"


def wrapped(angle, low=-np.pi):
    return (angle - low) % (2 * np.pi) + low


def recording(**columns):
    """qpos (61, 11) at rest but for the columns named."""
    qpos = np.zeros((TIME.size, 11))
    qpos[:, 3] = 1
    for name, values in columns.items():
        qpos[:, 7 + ["turret", "shoulder", "elbow", "rail"].index(name)] = values
    return qpos


def read(arm, qpos):
    np.savetxt(arm.parent / "arm.csv", np.column_stack([TIME, qpos]), delimiter=",", fmt="%.9f")
    return read_recording(arm.parent / "arm.csv", "csv", figure=str(arm), progress=Progress(Console(width=200))).qpos


@pytest.mark.parametrize("low", [-np.pi, 0.0])
def test_a_hinge_without_range_or_with_a_whole_turn_is_unwrapped_and_named(arm, low, capsys):
    angle = low + 5.7 + 1.5 * TIME + np.sin(5 * TIME)
    start = wrapped(angle, low)[0] - angle[0]
    found = read(arm, recording(turret=wrapped(angle, low), shoulder=wrapped(-angle, low)))
    np.testing.assert_allclose(found[:, 7], angle + start, atol=1e-8)
    np.testing.assert_allclose(np.diff(found[:, 8]), -np.diff(angle), atol=1e-8)
    note = "note: 'turret', 'shoulder': angles wrap at a whole turn, first at "
    assert capsys.readouterr().out.startswith(note)


def test_limited_hinges_and_slides_and_turns_that_are_recorded_stay(arm):
    jumps = np.where(TIME < 1, 3.1, -3.1)
    fast = 3.5 * np.arange(TIME.size)  # more than half a turn a sample, over many turns
    qpos = recording(turret=fast, elbow=jumps * 0.9, rail=jumps)
    np.testing.assert_allclose(read(arm, qpos), qpos, atol=1e-8)


@pytest.mark.parametrize("kind", ["npz", "mjcf", "mjlab", "locomujoco", "gmr", "mimickit"])
def test_every_format_is_unwrapped(arm, kind, tmp_path):
    angle = np.linspace(2.8, 3.6, 5)
    text = ARM.replace('<joint name="rail" type="slide" axis="1 0 0"/>', "") if kind == "mimickit" else ARM
    arm.write_text(text)
    qpos = recording(turret=wrapped(2.8 + 0.8 * TIME / 2))[:, : 10 if kind == "mimickit" else 11]
    keys = np.tile(qpos[0], (5, 1))
    keys[:, 7] = wrapped(angle)
    saved = wild.through(str(arm), np.linspace(0, 2, 5), keys)
    target = formats.export(saved, kind, tmp_path / f"a{formats.writer(kind).ending}", fps=2.0)
    found = read_recording(target, figure=str(arm), fps=2.0)
    np.testing.assert_allclose(found.qpos[:, 7], angle, atol=1e-8)
