"""`from dynsplines import ...`: what users of Python get, as they would use it."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from figures import EVERY_JOINT
from problems import names, written
from scipy.spatial.transform import Rotation
from texts import read_data

import dynsplines
from dynsplines import Clip, Keyframe, Motion, UserError, build, clips, figures, import_motion, inbetween, load
from dynsplines.clip.table import ClipTable, KeyframeTable

ARM = read_data("waving_arm.xml")
WAVE = (
    Keyframe(0.0, qpos=[1, 0, 0, 0, 0.2]),
    Keyframe(0.5, joints={"shoulder": Rotation.from_euler("y", -60, degrees=True), "elbow": -45.0}),
    Keyframe(1.0, qpos=np.array([1, 0, 0, 0, 0.2])),
)


def wave(**more: Any) -> Clip:
    return build(mujoco.MjSpec.from_string(ARM), WAVE, name="wave", **more)


@pytest.fixture(scope="module")
def motion() -> Motion:
    return inbetween(wave())


def run(code: str, folder: Path) -> str:
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_importing_the_package_loads_nothing_heavy(tmp_path):
    heavy = run("import sys, dynsplines; print(*sys.modules)", tmp_path).split()
    assert not {"numpy", "scipy", "mujoco", "rich", "pydantic", "matplotlib", "typer"} & set(heavy)


def test_every_name_is_there_and_listed():
    assert set(dynsplines.__all__) <= set(dir(dynsplines))
    for name in dynsplines.__all__:
        assert getattr(dynsplines, name).__doc__
    with pytest.raises(AttributeError, match=r"no attribute 'lod'; it has: Clip, Keyframe"):
        _ = dynsplines.lod  # type: ignore[attr-defined]


def test_what_ships_is_listed_and_loads():
    assert "run_and_step" in clips()
    assert "human" in figures()
    assert repr(load("run_and_step")) == "<Clip run_and_step: 2.20 s, 13 keyframes (10 partial), 17 penalties, 39 DOF>"


@pytest.mark.slow
def test_a_clip_is_loaded_from_a_path_and_from_text(tmp_path):
    path = written(tmp_path)
    found = load(path)
    assert isinstance(found, Clip)
    assert [key.time for key in found.keys] == [0, 0.2, 0.41]
    assert load(str(path), fps=50).fps == 50
    with pytest.raises(UserError, match="fps = 0: give a finite number above 0"):
        load(str(path), fps=0)
    text = 'figure = "human"\n[[keyframe]]\ntime = 0\nothers = "rest"\n[[keyframe]]\ntime = 1\nothers = "previous"\n'
    assert repr(load(text)) == "<Clip clip: 1.00 s, 2 keyframes, 12 penalties, 39 DOF>"
    with pytest.raises(UserError, match=r"^clip: keyframe 1: time must be a number"):
        load(text.replace("time = 0", 'time = "now"'))
    with pytest.raises(UserError, match=r"'x\.npz' is a motion.*load_motion"):
        load("x.npz")


@pytest.mark.slow
def test_a_clip_built_is_the_clip_written():
    text = read_data("built.toml")
    made = build(
        "human",
        [
            Keyframe(0, others="rest"),
            Keyframe(
                0.8,
                root={"position": [np.float64(0.1), "free", 0.93]},
                joints={"left_hip": {"rotvec": np.array([0, -70, 0])}, "left_knee": {"euler": (70, 0), "order": "yx"}},
                sites={"right_heel": np.array([-0.05, -0.09, 0.05])},
                bodies={"right_foot": {"flat": True}},
                others="previous",
            ),
        ],
        fps=60,
        scene={"step": {"x": 0.3, "height": 0.27}},
        contacts=[{"point": "right_heel", "from": 0.0, "to": 0.5}],
        penalties={"torque": 0.1, "collision": {"margin": 0.002}},
        solve={"variable": 1},
    )
    told = load(text)
    assert made.mjcf == told.mjcf
    assert (made.fps, made.settings, made.ends) == (told.fps, told.settings, told.ends)
    assert [(p.name, w) for p, w in made.penalties] == [(p.name, w) for p, w in told.penalties]
    assert [rest.point.name for rest in made.context.schedule.on_ground] == ["right_heel"]
    for one, other in zip(made.keys, told.keys, strict=True):
        np.testing.assert_array_equal(one.fixed, other.fixed)
        np.testing.assert_allclose(one.state, other.state, atol=1e-9)


def test_keyframes_specify_all_that_a_file_can():
    assert {*KeyframeTable.model_fields, "qpos"} == set(Keyframe.__dataclass_fields__)
    tables = {"figure", "fps", "scene", "contact", "grasp", "penalty", "solve", "recording", "mirror", "keyframe"}
    assert set(ClipTable.model_fields) == tables


def test_scipys_rotations_and_whole_configurations_are_keyframes(motion):
    half = np.radians(60) / 2
    np.testing.assert_allclose(motion.at(0.5), [np.cos(half), 0, -np.sin(half), 0, -np.pi / 4], atol=1e-9)
    np.testing.assert_allclose(motion.at(0.0), [1, 0, 0, 0, 0.2], atol=1e-9)
    spec = mujoco.MjSpec.from_string(ARM)
    over = build(spec, [Keyframe(0, qpos=[1, 0, 0, 0, 0.2], joints={"elbow": 90.0}), WAVE[1]])
    assert over.keys[0].state[-1] == pytest.approx(np.pi / 2)
    assert over.keys[0].fixed.all()
    assert [body.name for body in spec.bodies] == ["world", "upper", "lower"]  # as it was


def test_a_whole_configuration_says_all_of_further_free_bodies_and_what_is_given_goes_over_it():
    text = "".join(
        f'<body name="{n}"><freejoint name="{n}"/><geom size=".1"/></body>' for n in ("man", "crate", "ball")
    )
    qpos = np.arange(21.0).reshape(3, 7)
    qpos[:, 3:] = np.array([0.5, 0.5, -0.5, 0.5])
    keys = [Keyframe(t, qpos=qpos.ravel(), roots={"crate": {"position": [1, 0, 2]}}) for t in (0, 1)]
    made = build(mujoco.MjSpec.from_string(f"<mujoco><worldbody>{text}</worldbody></mujoco>"), keys)
    assert made.keys[0].fixed.all()
    qpos[1, :3] = [1, 0, 2]
    np.testing.assert_allclose(made.keys[0].state, qpos.ravel(), atol=1e-12)


def test_any_kind_of_joint_is_built(rng):
    model = mujoco.MjModel.from_xml_string(EVERY_JOINT)
    qpos = [model.qpos0.copy(), model.qpos0.copy()]
    mujoco.mj_integratePos(model, qpos[1], 0.3 * rng.normal(size=model.nv), 1.0)
    made = build(mujoco.MjSpec.from_string(EVERY_JOINT), [Keyframe(i, qpos=q) for i, q in enumerate(qpos)])
    np.testing.assert_allclose(made.keys[1].state, qpos[1], atol=1e-12)


@pytest.mark.parametrize(
    ("keyframes", "complaint"),
    [
        ([], "no keyframes"),
        ([Keyframe(0, others="rest")], "at least two"),
        ([Keyframe(0), Keyframe(1, joints={"elbw": 1.0})], r"keyframe 2 \(t = 1 s\): no joint 'elbw'; did you mean"),
        ([Keyframe(0), Keyframe(1, qpos=[1, 0, 0])], r"t = 1 s\): qpos is \(5,\) .*; it is \(3,\)"),
        ([Keyframe(0), Keyframe(1, qpos=[1, 0, 0, 0, np.nan])], "not a finite number"),
        ([Keyframe(0), Keyframe(1, qpos=np.zeros(5))], r"t = 1 s\): qpos: the quaternion of '\w+' is zero; give"),
        ([Keyframe(0), Keyframe(1, sites={"hand": [0, 0, 9]})], "no pose found that puts site 'hand'"),
        ([Keyframe(0), Keyframe("soon")], "time must be a number"),  # type: ignore[arg-type]
    ],
)
def test_what_does_not_fit_is_reported_in_one_line(keyframes, complaint):
    with pytest.raises(UserError, match=complaint) as raised:
        build(mujoco.MjSpec.from_string(ARM), keyframes, name="wave")
    assert "\n" not in str(raised.value)


def test_times_are_one_or_several(motion):
    for times, shape in ((0.3, (5,)), ([0.3], (1, 5)), (np.linspace(0, 1, 7), (7, 5)), ([], (0, 5))):
        assert motion.at(times).shape == shape
        np.testing.assert_allclose(np.linalg.norm(motion.at(times)[..., :4], axis=-1), 1)
    for outside in (-0.1, 1.1, [0.5, 2.0], np.nan):
        with pytest.raises(UserError, match="runs from 0 to 1 s"):
            motion.at(outside)
    with pytest.raises(UserError, match="one number or a list"):
        motion.at(np.zeros((2, 2)))


def test_samples_at_given_times_are_those_at_equal_ones(motion):
    equal = motion.sampled(20)
    chosen = motion.sampled(times=equal.time[[3, 0, 7]])
    for name in ("time", "qpos", "qvel", "qacc", "phase"):
        np.testing.assert_allclose(np.abs(getattr(chosen, name)), np.abs(getattr(equal, name)[[3, 0, 7]]), atol=1e-12)
    np.testing.assert_allclose(chosen.phase, chosen.time)
    for times, fps, complaint in (
        ([0.1], 20, "fps or times, not both"),
        ([], None, "at least one"),
        ([2], None, "to 1 s"),
    ):
        with pytest.raises(UserError, match=complaint):
            motion.sampled(fps, times=times)


STAND = 'figure = "human"\n' + "".join(f'[[keyframe]]\ntime = {t}\nothers = "rest"\n' for t in (0, 1))


def test_the_ground_carries_who_stands_and_the_torques_are_those_of_mujoco_under_its_forces():
    """`mj_inverse` with the forces of the feet applied at their centres of pressure."""
    forces = inbetween(load(STAND)).forces(times=[0.2, 0.7])
    model, data = forces.sampled.model, mujoco.MjData(forces.sampled.model)
    weight = 9.81 * model.body_subtreemass[1]
    assert forces.has_known_support.all()
    assert {foot.name for foot in forces.feet} >= {"left_foot", "right_foot"}
    np.testing.assert_allclose(sum(foot.force for foot in forces.feet), [[0, 0, weight]] * 2, atol=0.02 * weight)
    np.testing.assert_allclose(forces.torques[:, :6], forces.rest, atol=0.02 * weight)
    data.qpos[:], data.qvel[:], data.qacc[:] = (
        each[1] for each in (forces.sampled.qpos, forces.sampled.qvel, forces.sampled.qacc)
    )
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    mujoco.mj_inverse(model, data)
    expected = data.qfrc_inverse.copy()
    for foot in forces.feet:
        if foot.has_contact[1]:
            body = model.body(foot.name).id
            mujoco.mj_applyFT(model, data, -foot.force[1], -foot.moment[1], foot.centre[1], body, expected)
    np.testing.assert_allclose(forces.torques[1, 6:], expected[6:], atol=1e-6)


def test_feet_carry_before_they_leave_and_after_they_land_between_keyframes():
    """A step of the left foot, which has a stance in neither keyframe. When it leaves, the weight is on both feet."""
    step = STAND + 'root.position = "free"\n'
    for foot, place in (("left", [0.2, 0.09, 0]), ("right", [-0.055, -0.09, 0])):
        step += f"sites.{foot}_heel = {place}\nbodies.{foot}_foot.flat = true\n"
    motion = inbetween(load(step))
    forces = motion.forces(times=[0, 0.5, 1])
    left, right = forces.feet
    assert forces.has_known_support.all()
    np.testing.assert_array_equal(left.has_contact, [True, False, True])
    assert right.has_contact.all()
    weight = 9.81 * motion.model.body_subtreemass[1]
    assert 0.2 * weight < left.force[0, 2] < 0.8 * weight
    left, right = motion.forces(100).feet  # contacts do not flicker
    assert np.count_nonzero(np.diff(left.has_contact)) == 2 and right.has_contact.all()


def test_forces_without_a_known_contact_are_not_numbers():
    """Of a figure that hovers over the floor: what holds it is unknown."""
    raised = STAND.replace('"rest"', '"rest"\nroot.position = [0, 0, 1.5]')
    forces = inbetween(load(raised)).forces()
    assert not forces.has_known_support.any()
    assert np.isnan(forces.torques).all()


def test_before_is_the_raw_spline(motion):
    assert motion.before.saved.timeline.variable_count == 0
    far = motion.difference(motion.before)
    assert 0 < far.distance < 0.3
    assert 0 <= far.time <= 1
    assert far.where in ("hand", "lower", "upper")
    assert motion.difference(motion).distance < 1e-12
    assert str(far).startswith("at most ")


def test_other_figures_and_shorter_motions_are_not_compared(motion):
    with pytest.raises(UserError, match="different figures"):
        motion.difference(inbetween(build("spinner", [Keyframe(0, others="rest"), Keyframe(1, others="previous")])))
    with pytest.raises(UserError, match="not all of"):
        motion.difference(motion.trimmed(0.2, 0.8))


@pytest.mark.parametrize(
    ("attempt", "complaint"),
    [
        (lambda m: m.retimed(), "one of them"),
        (lambda m: m.retimed(duration=0), "above 0"),
        (lambda m: m.thinned("2 feet"), "max_error = 2 feet"),
        (lambda m: m.thinned(0.02, max_angle=0), "max_angle = 0"),
        (lambda m: m.save("m.txt"), r"\.npz, or as a clip, \.toml"),
        (lambda m: m.export("m.txt"), "its ending is of no known format"),
        (lambda m: m.export("m.csv", fps=0), "fps = 0: give a finite number above 0"),
        (lambda m: m.render("m.mp4", only="middle"), "not one of before, after, keys"),
        (lambda m: m.render("m.gif", fps=-1), "fps -1: give a finite number above 0"),
        (lambda m: m.render("m.gif", slow=float("nan")), "slow nan: give"),
        (lambda m: m.render("m.png", size=(64,)), r"size = \(64,\): give width and height"),
        (lambda m: m.render("m.png", size=(0, 0)), "size 0x0: give whole numbers of pixels from 16 on"),
    ],
)
def test_what_cannot_be_done_is_reported(motion, attempt, complaint, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UserError, match=complaint):
        attempt(motion)
    assert names(tmp_path) == []


@pytest.mark.slow
def test_a_recording_is_saved_as_a_clip_of_its_instants(motion, tmp_path):
    (tmp_path / "arm.xml").write_text(ARM)
    motion.export(tmp_path / "m.csv", fps=20)
    with pytest.raises(UserError, match="name the figure: --figure, or figure= in Python"):
        import_motion(tmp_path / "m.csv")
    with pytest.raises(UserError, match="--scale does not apply"):
        import_motion(tmp_path / "m.csv", tmp_path / "arm.xml", scale=0.01)
    with pytest.raises(UserError, match="scale = 0: give a finite number above 0"):
        import_motion(tmp_path / "m.bvh", scale=0)
    with pytest.raises(UserError, match="fps = -1: give a finite number above 0"):
        import_motion(tmp_path / "m.csv", tmp_path / "arm.xml", fps=-1)
    recorded = import_motion(tmp_path / "m.csv", tmp_path / "arm.xml")
    recorded.save(tmp_path / "m.toml")
    again = inbetween(load(tmp_path / "m.toml"))
    assert again.key_times.size == 21
    assert recorded.difference(again).distance < 1e-9


@pytest.mark.slow
def test_solving_is_silent_unless_asked(capfd):
    inbetween(wave())
    assert capfd.readouterr() == ("", "")
    inbetween(wave(), progress=True)
    assert "solving" in capfd.readouterr().err


def test_a_motion_shows_itself_as_a_page_of_its_own(motion):
    shown = motion._repr_html_()
    assert shown.startswith("<iframe")
    assert shown.count("<") == 2  # the page itself is escaped
    assert "&lt;script" in shown
    assert 'src="http' not in shown.replace("&quot;", '"')
