"""Installed beside the programs that it exports to: their own loaders read its files, their own robots replay them.

`pip install mjlab` (a torch for the processor alone is enough), or `pip install loco-mujoco`, into the environment of
this package; a test is skipped where its program is not there.
"""

from __future__ import annotations

import importlib
import importlib.util
from pathlib import Path

import motions
import mujoco
import numpy as np
import pytest
from processes import quiet
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.exchange import formats
from dynsplines.motion import Saved

SQUAT = read_data("squat.toml")


def motion_of(text: str) -> Saved:
    return solving.solve(recordings.from_text(text, name="squat"), quiet()).motion


@pytest.mark.filterwarnings("ignore:.*torch.jit:DeprecationWarning")
def test_mjlab_loads_a_motion_and_its_g1_replays_it(tmp_path):
    torch = pytest.importorskip("torch")
    if importlib.util.find_spec("mjlab") is None:
        pytest.skip("no package mjlab")
    mjlab = importlib.import_module
    simulation, robots = mjlab("mjlab.sim.sim"), mjlab("mjlab.asset_zoo.robots.unitree_g1.g1_constants")
    config = mjlab("mjlab.tasks.tracking.config.g1.env_cfgs").unitree_g1_flat_tracking_env_cfg()
    loader = mjlab("mjlab.tasks.tracking.mdp.commands").MotionLoader

    saved = motion_of(SQUAT.format(file=robots.G1_XML))
    target = formats.export(saved, "mjlab", tmp_path / "squat.mjlab.npz", fps=50)
    scene = mjlab("mjlab.scene").Scene(config.scene, device="cpu")
    sim = simulation.Simulation(num_envs=1, cfg=simulation.SimulationCfg(), model=scene.compile(), device="cpu")
    scene.initialize(sim.mj_model, sim.model, sim.data)
    robot = scene["robot"]
    held = np.load(target)
    assert list(held["joint_names"]) == list(robot.joint_names)
    assert list(held["body_names"]) == list(robot.body_names)
    found = loader(str(target), torch.arange(len(robot.body_names)))
    assert found.time_step_total == 51
    for step in range(0, found.time_step_total, 10):
        root = torch.cat(
            [getattr(found, f"body_{part}_w")[step, :1] for part in ("pos", "quat", "lin_vel", "ang_vel")], dim=1
        )
        robot.write_root_state_to_sim(root)
        robot.write_joint_state_to_sim(found.joint_pos[step : step + 1], found.joint_vel[step : step + 1])
        sim.forward()
        scene.update(0.02)
        for theirs, ours in (
            (robot.data.body_link_pos_w, found.body_pos_w),
            (robot.data.body_link_lin_vel_w, found.body_lin_vel_w),
            (robot.data.body_link_ang_vel_w, found.body_ang_vel_w),
        ):
            torch.testing.assert_close(theirs[0], ours[step], atol=2e-4, rtol=1e-4)
    assert float(held["body_pos_w"][25, 0, 2]) < float(held["body_pos_w"][0, 0, 2]) - 0.05


def test_locomujoco_loads_a_trajectory_and_its_model_replays_it(tmp_path, monkeypatch):
    if importlib.util.find_spec("loco_mujoco") is None:
        pytest.skip("no package loco_mujoco")
    trajectory = importlib.import_module("loco_mujoco.trajectory").Trajectory
    monkeypatch.chdir(tmp_path)
    Path("robot.xml").write_text(motions.ROBOT)
    saved = motions.motion_of("robot.xml")
    target = formats.export(saved, "locomujoco", tmp_path / "a.loco.npz")
    found = trajectory.load(str(target), backend=np)
    at = motions.samples(saved)
    model, data = saved.figure.model, mujoco.MjData(saved.figure.model)
    assert found.info.frequency == motions.FPS
    assert found.info.joint_names == [model.joint(i).name for i in range(model.njnt)]
    np.testing.assert_array_equal(np.asarray(found.data.split_points), [0, len(at.time)])
    for i in (0, len(at.time) // 2, len(at.time) - 1):
        data.qpos[:], data.qvel[:] = np.asarray(found.data.qpos)[i], np.asarray(found.data.qvel)[i]
        mujoco.mj_forward(model, data)
        np.testing.assert_allclose(np.asarray(found.data.xpos)[i], data.xpos, atol=1e-9)
        np.testing.assert_allclose(np.asarray(found.data.cvel)[i], data.cvel, atol=1e-8)
        np.testing.assert_allclose(data.site_xpos, np.asarray(found.data.site_xpos)[i], atol=1e-9)
