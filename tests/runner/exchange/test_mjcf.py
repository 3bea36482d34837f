"""MJCF with keys: MuJoCo itself reads what is written, and other people's models with keys become motions."""

import mujoco
import numpy as np
import pytest
import tiny
import wild

from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording


def test_mujoco_reads_every_key_to_the_last_digit(human, tmp_path):
    target = formats.export(human, "mjcf", tmp_path / "out.keys.xml")
    model, before = mujoco.MjModel.from_xml_path(str(target)), wild.samples(human)
    np.testing.assert_array_equal(model.key_time, before.time)
    np.testing.assert_allclose(model.key_qpos, before.qpos, atol=1e-15)  # quaternions are made unit once more
    np.testing.assert_array_equal(model.key_qvel, before.qvel)
    assert [model.key(i).name for i in (0, 60)] == ["wild_0", "wild_60"]
    for name in ("body_pos", "body_mass", "geom_size", "site_pos", "jnt_range"):
        np.testing.assert_array_equal(getattr(model, name), getattr(human.figure.model, name))
    wild.same_poses(model, before.qpos, model.key_qpos)


def test_keys_of_others_are_read_with_their_figure_and_faults_are_reported(tmp_path):
    def written(keys):
        (tmp_path / "own.xml").write_text(tiny.HINGE.format(keys=keys))
        return tmp_path / "own.xml"

    good = '<keyframe><key time="0" qpos="0 0"/><key time="0.5" qpos="0.1 1.2"/></keyframe>'
    back = import_recording(written(good))
    np.testing.assert_allclose(wild.samples(back).qpos[-1], [0.1, 1.2])
    with pytest.raises(UserError, match="no <key> elements; a motion needs two or more"):
        import_recording(written(""))
    with pytest.raises(UserError, match="all its keys are of the time 0"):
        import_recording(written(good.replace("0.5", "0")))
    with pytest.raises(UserError, match="its qpos has 2 numbers; the figure's 51"):
        import_recording(written(good), figure="human")
    with pytest.raises(UserError, match="MuJoCo cannot"):
        import_recording(written("<keyframe><key nonsense='1'/></keyframe>"))
