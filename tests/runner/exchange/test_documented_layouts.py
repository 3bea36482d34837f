"""The documented layout has precedence: others are read only where it is implausible, and doubts are refused."""

import pickle

import numpy as np
import pytest
import walking_biped as biped
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange.formats import recording
from dynsplines.solver.array import Array

XYZW, WXYZ = [4, 5, 6, 3], [3, 4, 5, 6]
KINDS = ("mjlab-csv", "gmr", "mimickit", "npz", "npy")


def saved(kind: str, qpos: Array, folder, *, swapped: bool = False):
    """A file without names and body poses; swapped: with quaternions in the order that the format does not have."""
    root, joints = qpos[:, :3], qpos[:, 7:]
    if kind in ("npz", "npy"):
        rows = np.hstack([root, qpos[:, XYZW if swapped else WXYZ], joints])
        path = folder / f"a.{kind}"
        np.savez(path, qpos=rows, fps=50.0) if kind == "npz" else np.save(path, rows)
        return path
    rotation = qpos[:, WXYZ if swapped else XYZW]
    if kind == "mjlab-csv":
        path = folder / "a.mjlab.csv"
        np.savetxt(path, np.hstack([root, rotation, joints]), delimiter=",", fmt="%.9f")
        return path
    entries = {"fps": 50, "root_pos": root, "root_rot": rotation, "dof_pos": joints}
    if kind == "mimickit":
        vector = Rotation.from_quat(qpos[:, WXYZ], scalar_first=True).as_rotvec()
        entries = {"fps": 50, "loop_mode": 0, "frames": np.hstack([root, vector, joints]).tolist()}
    path = folder / f"a.{kind}.pkl"
    path.write_bytes(pickle.dumps(entries))
    return path


def read(path, kind: str | None = None):
    return recording(path, kind, model=biped.model(), fps=50.0)


def check(qpos: Array, path, kind: str | None = None) -> str:
    """The file is read as qpos; returns its notes."""
    found = read(path, kind)
    biped.assert_same(found.qpos, qpos, 1e-7)
    return " ".join(found.notes)


def turned(qpos: Array, angles: Array, axis: tuple[float, float, float], height: Array | float = 0.0) -> Array:
    """The same turned by angles (T,) [rad] about an axis of the root, and raised by a height [m]."""
    rotation = Rotation.from_quat(qpos[:, WXYZ], scalar_first=True) * Rotation.from_rotvec(angles[:, None] * axis)
    out = qpos.copy()
    out[:, 3:7] = rotation.as_quat(scalar_first=True)
    out[:, 2] += height
    return out


def motions() -> dict[str, Array]:
    """What robots do besides walking upright on the floor."""
    walk, phase = biped.walk(heading=0.1), np.linspace(0, 1, 100)
    bump = np.clip(np.sin(np.pi * (phase - 0.3) / 0.4), 0, 1) * (abs(phase - 0.5) < 0.2)
    none, lies = np.zeros(100), np.where(phase < 0.4, np.pi / 2, 0.0)
    return {
        "hover at 0.5 m": turned(walk, none, (0, 0, 1), 0.5),
        "hover at 2 m": turned(walk, none, (0, 0, 1), 2.0),
        "jump": turned(walk, none, (0, 0, 1), 0.6 * bump),
        "fly with tilts": turned(walk, np.radians(50) * np.sin(2 * np.pi * phase), (1, 0, 0), 1.0),
        "pitch by 60 degrees": turned(walk, np.radians(60) * bump, (0, 1, 0)),
        "lie on a side": turned(walk, lies, (1, 0, 0), np.where(phase < 0.4, -0.6, 0.0)),
        "turn three times": turned(walk, 6 * np.pi * phase, (0, 0, 1)),
        "slide aside": biped.walk(heading=np.pi),
        "slide backwards": biped.walk(heading=np.pi) * np.array([-1, -1, *[1] * 12]),
        "hover, short": turned(walk, none, (0, 0, 1), 0.3)[:8],
        "slide, short": turned(walk, none + np.pi, (0, 0, 1))[::-1][:8] * np.array([-1, 1, 1, *[1] * 11]),
    }


@pytest.mark.parametrize(("kind", "name"), [*zip(2 * KINDS + KINDS[:1], motions(), strict=True), ("npy", "jump")])
def test_plausible_motions_in_the_documented_layout_are_read_without_question(kind: str, name: str, tmp_path) -> None:
    qpos = motions()[name]
    assert not check(qpos, saved(kind, qpos, tmp_path))


@pytest.mark.parametrize("name", ["jump", "pitch by 60 degrees", "lie on a side", "hover at 0.5 m"])
@pytest.mark.parametrize("kind", ["gmr"])
def test_the_other_order_of_quaternions_is_read_where_the_documented_one_falls(kind: str, name: str, tmp_path) -> None:
    qpos = motions()[name]
    notes = check(qpos, saved(kind, qpos, tmp_path, swapped=True))
    assert notes.startswith(f"read as {kind} with quaternions wxyz: tilt") and f"as {kind} it would be: tilt" in notes


@pytest.mark.parametrize("name", ["jump"])
@pytest.mark.parametrize("kind", KINDS)
def test_y_up_is_read_where_the_documented_layout_lies_down(kind: str, name: str, tmp_path) -> None:
    qpos = motions()[name]
    assert "with y up" in check(qpos, saved(kind, biped.y_up(qpos, with_frame=False), tmp_path))


def test_an_implausible_documented_layout_with_two_plausible_others_needs_a_format(tmp_path) -> None:
    qpos = np.tile(biped.walk(heading=0.0)[25], (40, 1))
    rows = biped.y_up(qpos, with_frame=True)
    path = saved("gmr", rows, tmp_path)
    with pytest.raises(
        UserError, match=r"as gmr it is implausible .*y up in .* and gmr with y up and z forward"
    ) as error:
        read(path)
    assert "are equally plausible" in str(error.value) and "--from" in str(error.value)
    notes = check(rows, path, "gmr")
    assert notes.startswith("read as gmr: tilt 0°") and "with y up in the world" in notes


def test_a_robot_that_flies_where_another_layout_stands_on_the_floor_needs_a_format(tmp_path) -> None:
    walk = biped.walk(heading=0.0)
    walk[:, 1] -= 1.6
    rows = biped.y_up(walk, with_frame=True)  # as documented it is 0.8 m above the floor, upright
    path = saved("npz", rows, tmp_path)
    with pytest.raises(UserError, match=r"as npz it is doubtful .* as npz with y up .* give --from"):
        read(path)
    assert "read as npz" in check(rows, path, "npz")


@pytest.mark.parametrize("kind", ["csv", "mjlab-csv"])
def test_sliding_decides_between_tables_over_enough_samples_alone(kind: str, tmp_path) -> None:
    qpos = biped.walk(heading=0.0 if kind == "mjlab-csv" else np.pi)
    rows = np.hstack([qpos[:, :3], qpos[:, WXYZ if kind == "csv" else XYZW], qpos[:, 7:]])
    np.savetxt(tmp_path / "a.csv", rows, delimiter=",", fmt="%.9f")
    assert check(qpos, tmp_path / "a.csv").startswith(f"read as {kind}: tilt")
    np.savetxt(tmp_path / "a.csv", rows[:12], delimiter=",", fmt="%.9f")
    with pytest.raises(UserError, match=r"csv and (mjlab-)?csv are equally plausible .* one of: "):
        read(tmp_path / "a.csv")
    check(qpos[:12], tmp_path / "a.csv", kind)
