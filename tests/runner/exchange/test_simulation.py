"""Scenes to simulate: mj_step plays them, whatever a model specifies for its own actuators and simulation."""

import re
import tomllib

import motions
import mujoco
import numpy as np
import pytest
import shipped
from motions import between, clip_file, played
from motions import exported_scene as exported
from texts import read_data

from dynsplines import inbetween, load, recordings, solving
from dynsplines.exchange.formats.simulate import note, simulate
from dynsplines.exchange.simulation import Simulation
from dynsplines.motion import Sampled

LASTS = 1.0  # [s] of simulation
FALLEN = 0.03  # [m]
RIG = read_data("rig.xml")
KEYS = ('time = 0\nothers = "rest"', 'time = 1\njoints.lift = 0.2\nothers = "rest"')
SLIDER = read_data("slider_root.xml")
LIMB = read_data("limb_in_itself.xml")

HAND = read_data("hand_of_spring.xml")
ARMS = read_data("arms_of_siblings.xml")


def simulated(tmp_path, text, qpos, step=0.5):
    """The scene of the motion through poses some time apart [s], how it follows it, and the line on that."""
    (tmp_path / "model.xml").write_text(text)
    take = Sampled.of(motions.through(str(tmp_path / "model.xml"), step * np.arange(len(qpos)), np.array(qpos, float)))
    simulation = Simulation.of(take)
    tracking = simulate(simulation, take)
    return simulation, tracking, note(tracking, simulation.model)


def test_joints_of_a_root_have_actuators_and_that_is_noted(tmp_path):
    qpos = [[0, 0, 0, 0], [0.1, 0.05, 0.1, 0.3], [0, 0, 0, 0]]
    simulation, tracking, _ = simulated(tmp_path, SLIDER, qpos)
    assert tracking.is_within
    assert any("which carry it: rootx, rootz, rooty" in line for line in simulation.notes)


@pytest.mark.parametrize("top", [0.0, 0.02])
def test_limbs_that_the_model_has_in_each_other_do_not_collide(top, tmp_path):
    """The thigh and what is beyond the knee are in each other at rest."""
    qpos = [[0, 0, 0], [0.2, 0.4, 0.1], [0, 0, 0]]
    simulation, tracking, _ = simulated(tmp_path, LIMB.format(top=top, joint=""), qpos)
    assert tracking.is_within
    assert any("do not collide in the scene to simulate: thigh-shank" in line for line in simulation.notes)
    assert simulation.model.nexclude == 1


def test_siblings_that_only_the_motion_puts_in_each_other_still_collide(tmp_path):
    simulation, tracking, _ = simulated(tmp_path, ARMS, [[0, 0, 0], [0, -0.6, 0.6], [0, 0, 0]])
    assert simulation.model.nexclude == 0 and not tracking.is_within


def test_the_base_of_an_arm_collides_as_the_model_has_it(tmp_path):
    """The base is around the first link, which its geoms are not to meet; a table that nothing hangs on is solid."""
    text = """<mujoco><worldbody><body name="base" pos="0 0 1"><geom size=".2" contype="2" conaffinity="4"/>
      <body name="link" pos="0 0 .1"><joint name="turn" axis="0 1 0"/>
        <geom name="link" size=".05" mass="1" pos="0 0 .02" conaffinity="0" solref=".03 1"/>
        <body name="tip" pos="0 0 .05"><joint name="bend" axis="0 1 0"/>
          <geom size=".05" mass="1" pos="0 0 .02" conaffinity="0"/></body>
      </body></body><body name="table" pos="1 0 1"><geom name="table" size=".1"/></body></worldbody>
      <contact><exclude body1="base" body2="tip"/></contact></mujoco>"""
    simulation, tracking, _ = simulated(tmp_path, text, [[0, 0], [0.2, 0.4], [0, 0]])
    assert tracking.is_within
    assert simulation.model.nexclude >= 1
    assert (simulation.model.geom_contype[simulation.model.geom("table").id] & 1) == 1
    np.testing.assert_allclose(simulation.model.geom("link").solref, [0.03, 1])


def test_a_light_ball_joint_with_a_strong_spring_has_targets_within_half_a_turn(tmp_path):
    """MuJoCo wraps the error of a position actuator on a ball joint at half a turn, in newer versions."""
    text = HAND.format(arm="", hand='type="ball" stiffness="2"')
    qpos = [[0, 1, 0, 0, 0], [0.3, 0.9, 0.3, -0.3, 0.1], [0, 1, 0, 0, 0]]
    simulation, tracking, _ = simulated(tmp_path, text, qpos, 0.25)
    assert np.abs(simulation.control).max() < np.pi
    assert tracking.is_within


@pytest.mark.slow
def test_the_human_follows_its_motion_and_falls_through_nothing(tmp_path):
    saved = shipped.solved("walk_loop")
    model, _ = exported(saved, tmp_path)
    end = played(model, LASTS)
    assert np.linalg.norm(end.last[:3]) < 0.2
    assert np.degrees(np.linalg.norm(end.last[3:6])) < 16
    assert np.degrees(np.abs(end.last[6:]).max()) < 5
    assert end.deepest < FALLEN
    assert end.data.xpos[1, 2] == pytest.approx(between(model, model.key_qpos, end.data.time)[2], abs=FALLEN)


@pytest.fixture(scope="module")
def rig(tmp_path_factory):
    folder = tmp_path_factory.mktemp("rig")
    (folder / "rig.xml").write_text(RIG)
    problem = recordings.load(str(clip_file(folder, folder / "rig.xml", *KEYS)))
    saved = solving.raw_spline(problem)
    return saved, exported(saved, folder)[0]


def test_actuators_of_the_model_are_replaced_and_what_has_no_name_gets_one(rig):
    model = rig[1]
    assert [model.actuator(i).name for i in range(model.nu)] == ["lift", "joint2"]
    assert model.nsensor == 1


BIPED = read_data("optional_biped.xml")
LEG = read_data("optional_leg.xml")
REST = 'others = "rest"'
SQUAT, LEAN = "root.position = [0, 0, 0.72]", "root.position = [0.3, 0, 0.72]"
EXTRAS = tomllib.loads(read_data("biped_extras.toml"))
OPTIONS, NOTED = EXTRAS["options"], EXTRAS["noted"]  # most of them alone let the figure fall


def biped(folder, **changes):
    """The path of a biped that stands on its feet."""
    words = dict.fromkeys(("compiler", "option", "flags", "default", "world", "child", "geom", "joint", "rest"), "")
    words |= changes
    legs = "".join(LEG.format(side, y, **words) for side, y in (("left", 0.1), ("right", -0.1)))
    (folder / "robot.xml").write_text(BIPED.format(legs=legs, **words))
    return folder / "robot.xml"


def solved(path, folder, middle=SQUAT, lasts=1.0):
    """The motion of a biped from rest to rest in some time [s]."""
    keyframes = (f"time = 0\n{REST}", f"time = {lasts / 2}\n{middle}", f"time = {lasts}\n{REST}")
    return inbetween(load(clip_file(folder, path, *keyframes)))


@pytest.fixture(scope="module")
def squat(tmp_path_factory):
    """Times and poses of a squat of a plain biped."""
    folder = tmp_path_factory.mktemp("squat")
    samples = motions.samples(solved(biped(folder), folder).saved, 30.0)
    return samples.time, samples.qpos


def squatting(folder, squat, **changes):
    """The scene of a squat of a biped, and the notes of its export."""
    return exported(motions.through(str(biped(folder, **changes)), *squat), folder)


def assert_plain(model):
    """All that a model holds of its actuators is as in a model without defaults, of the same gains."""
    root = "".join(
        f'<position joint="{model.joint(int(model.actuator_trnid[i, 0])).name}" kp="{model.actuator_gainprm[i, 0]}" '
        f'kv="{-model.actuator_biasprm[i, 2]}"/>'
        for i in range(model.nu)
    )
    legs = "".join(LEG.format(side, y, geom="", joint="") for side, y in (("left", 0.1), ("right", -0.1)))
    words = dict.fromkeys(("compiler", "option", "flags", "default", "world", "child", "geom"), "")
    text = BIPED.format(legs=legs, rest=f"<actuator>{root}</actuator>", **words)
    plain = mujoco.MjModel.from_xml_string(text)
    names = [name for name in dir(plain) if name.startswith("actuator_") and not name.endswith(("acc0", "length0"))]
    assert len(names) > 15
    for name in names:
        np.testing.assert_array_equal(getattr(model, name), getattr(plain, name), err_msg=name)
    assert not model.jnt_actfrclimited.any() and not model.jnt_actgravcomp.any()


@pytest.mark.parametrize("name", EXTRAS["defaults"])
def test_no_default_of_the_models_actuators_is_inherited(name, squat, tmp_path):
    nested = {"child": 'childclass="limb"'} if name == "nested" else {}
    rest = EXTRAS["own"] if name == "nested" else ""
    model, lines = squatting(tmp_path, squat, default=EXTRAS["defaults"][name], rest=rest, **nested)
    assert_plain(model)
    assert (model.nkey, model.na, model.nsensor, model.ntuple) == (51, 0, int(bool(rest)), 0)
    assert any("stays within" in line for line in lines)


@pytest.mark.parametrize(("options", "is_noted"), [(OPTIONS, False), (NOTED, True)], ids=["options", "noted"])
def test_options_of_the_model_do_not_let_the_figure_fall(options, is_noted, squat, tmp_path):
    _, lines = squatting(tmp_path, squat, **options)
    for words in ("coefficient of friction", "collide"):
        assert any(words in line for line in lines) == is_noted
    assert any("stays within" in line for line in lines)


def test_tiny_steps_few_iterations_and_soft_friction_are_replaced(squat, tmp_path):
    option = 'timestep="1e-6" iterations="1" ls_iterations="1" noslip_iterations="3" tolerance="1e-2" impratio="2"'
    model, _ = squatting(tmp_path, [rows[:2] for rows in squat], option=option)
    of = model.opt
    assert (of.timestep, of.iterations, of.ls_iterations, of.noslip_iterations) == (1e-4, 100, 50, 0)
    assert (of.tolerance, of.impratio, of.disableactuator) == (1e-8, 10, 0)


def test_gravity_that_the_model_turns_off_stays_off(squat, tmp_path):
    model, _ = squatting(tmp_path, [rows[:4] for rows in squat], flags='<flag gravity="disable"/>')
    assert model.opt.disableflags == int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)


def test_a_deviation_from_the_motion_is_reported(tmp_path):
    """The keyframes lean until the centre of mass is beyond the toes."""
    _, lines = exported(solved(biped(tmp_path), tmp_path, LEAN).saved, tmp_path)
    assert any(
        re.search(r"leaves the motion: '\w+' by .* after 0\.\d+ s, it falls or drifts, 10 cm off after [01]\.\d+ s$", x)
        for x in lines
    )
