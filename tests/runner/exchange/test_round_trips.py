"""A motion that is written in a format and read again has the same qpos, of robots drawn at random."""

import mujoco
import numpy as np
import pytest
import wild

from dynsplines.exchange import formats, layouts
from dynsplines.exchange.imported import imported, taken
from dynsplines.solver import quaternion as quat

EXACT = 1e-6
HINGES = ("mjlab", "mjlab-csv", "locomujoco", "gmr")
EVERY = ("csv", "npz", "mjcf")
LAST, ANY = "zyxwvutsrqponmlkjihgfedcba", "abcdefghijklmnopqrstuvwxyz"


def drawn(seed: int, *, balls: bool, apart: bool = False, single: bool = False) -> str:
    """MJCF of a robot: a tree on a free root, joints with references, turned frames and names in no order.

    balls   some joints are balls; apart  a hinge of another tree, and a static body, precede the root
    single  a hinge or ball a body and no slides, as MimicKit has them
    """
    rng = np.random.default_rng(seed)
    names = iter(rng.permutation(list(ANY + ANY.upper())))

    def joint(*, alone: bool) -> str:
        kinds = ["hinge", "hinge", "hinge", "ball" if balls and alone else "hinge", "hinge" if single else "slide"]
        kind = rng.choice(kinds)
        axis, ref = " ".join(map(str, rng.normal(size=3).round(3))), 0.1 * float(rng.integers(-3, 4))
        more = "" if kind == "ball" else f'axis="{axis}" ref="{ref:.1f}"'
        return f'<joint name="{next(names)}" type="{kind}" pos="{rng.uniform(0, 0.1):.2f} 0 0" {more}/>'

    def body(depth: int) -> str:
        count = 1 if single else int(rng.integers(1, 3))
        joints = "".join(joint(alone=count == 1) for _ in range(count))
        below = "".join(body(depth + 1) for _ in range(rng.integers(1, 3))) if depth < 2 else ""
        place, turn = rng.uniform(-0.3, 0.3, 3).round(3), rng.normal(size=4).round(3)
        frame = f'pos="{" ".join(map(str, place))}" quat="{" ".join(map(str, turn))}"'
        return f'<body name="body {next(names)}" {frame}>{joints}<geom size=".05"/>{below}</body>'

    before = '<body name="static"><geom size=".1"/></body>' + (
        '<body name="door"><joint name="swing" axis="0 0 1"/><geom size=".1"/></body>' if apart else ""
    )
    root = f'<body name="root body" pos=".1 0 1"><freejoint name="free"/><geom size=".1"/>{body(0)}{body(1)}</body>'
    return f'<mujoco><compiler angle="radian"/><worldbody>{before}{root}</worldbody></mujoco>'


def moving(figure: str, seed: int):
    """A random motion, continuous over 1.2 s."""
    model = mujoco.MjModel.from_xml_path(figure)
    rng = np.random.default_rng(seed)
    qpos = np.tile(model.qpos0, (5, 1)) + 0.7 * rng.uniform(-1, 1, (5, model.nq))
    for joint in range(model.njnt):
        start = int(model.jnt_qposadr[joint]) + {0: 3, 1: 0}.get(int(model.jnt_type[joint]), -1)
        if model.jnt_type[joint] < 2:
            qpos[:, start : start + 4] = quat.from_rotation_vector(rng.uniform(-1, 1, (5, 3)))
    return wild.through(figure, 0.3 * np.arange(5), qpos)


def comes_back(saved, kind, folder, figure):
    target = formats.export(saved, kind, folder / f"out{formats.writer(kind).ending}")
    before, model = wild.samples(saved), saved.figure.model
    found = taken(target, kind, figure=figure, fps=saved.fps)
    after = found.qpos.copy()
    assert after.shape == before.qpos.shape
    for columns in layouts.quaternions(model):
        after[:, columns] *= np.sign(np.sum(after[:, columns] * before.qpos[:, columns], axis=1, keepdims=True))
    np.testing.assert_allclose(after, before.qpos, atol=EXACT)
    np.testing.assert_allclose(found.time - found.time[0], before.time - before.time[0], atol=1e-9)


CASES = [(kind, balls, apart) for kind in EVERY for balls in (False, True) for apart in (False, True)]
CASES += [(kind, balls, False) for kind in HINGES for balls in (False, True)]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(("kind", "balls", "apart"), CASES)
def test_robots_drawn_at_random_come_back(kind, balls, apart, seed, tmp_path):
    (tmp_path / "robot.xml").write_text(drawn(seed, balls=balls, apart=apart))
    comes_back(moving(str(tmp_path / "robot.xml"), seed), kind, tmp_path, str(tmp_path / "robot.xml"))


@pytest.mark.parametrize("seed", range(3))
def test_characters_of_mimickit_come_back(seed, tmp_path):
    (tmp_path / "robot.xml").write_text(drawn(seed, balls=True, single=True))
    comes_back(moving(str(tmp_path / "robot.xml"), seed), "mimickit", tmp_path, str(tmp_path / "robot.xml"))


@pytest.mark.slow
def test_the_humanoid_of_deepmimic_and_the_skeleton_of_a_bvh_file_come_back(tmp_path):
    knees = wild.with_hinges(wild.motion_of("human", spread=0.8), "knee", "elbow")
    comes_back(knees, "deepmimic", tmp_path, "human")
    first = formats.export(wild.motion_of("human"), "bvh", tmp_path / "first.bvh")
    comes_back(imported(first), "bvh", tmp_path, None)
