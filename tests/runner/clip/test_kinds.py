"""Penalties by name, joint ranges and obstacles."""

import io
import json
import re
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from problems import CLIP as TINY_CLIP
from problems import HINGE, written
from processes import quiet
from rich.console import Console
from texts import read_data

from dynsplines import Clip, Keyframe, Motion, UserError, build, inbetween, load, load_motion, recordings, solving
from dynsplines.cli import list_penalties
from dynsplines.clip import load as clip
from dynsplines.clip.kinds import KINDS, Kind, Part
from dynsplines.measure.bounds import BOUNDS
from dynsplines.measure.report import report, tables
from dynsplines.motion import save
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.wrenches import Wrenches, every_axis
from dynsplines.solver.penalty import Block, Normalization, Penalty
from dynsplines.solver.surface import Box, Capsule, Cylinder, Plane
from dynsplines.studio.stage import kinds, outline


@dataclass(frozen=True)
class Calm(Penalty):
    """The squared speed of all bodies' origins."""

    called: str = "calm"

    @property
    def name(self) -> str:
        return self.called

    @property
    def normalization(self) -> Normalization:
        return Normalization(1.0, time_power=2)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        links = np.arange(1, len(samples.figure.links))
        at, link, axes = every_axis(links, samples.count)
        yield Block(at, samples.links.x_d[:, links].ravel(), (Wrenches(at, link, force_d=axes),))


def swing(**more: object) -> Clip:
    poses = [np.array([0, 0, z, 1, 0, 0, 0.0]) for z in (1.0, 1.6, 1.0)]
    keys = [Keyframe(float(i), qpos=pose) for i, pose in enumerate(poses)]
    return build("spinner", keys, solve={"evaluations": 20}, **more)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def calm() -> Motion:
    return inbetween(swing(custom_penalties=[(Calm(), 30.0)]))


def speed(motion: Motion) -> float:
    velocity = motion.sampled(200).qvel[:, :3]
    return float(np.mean(np.sum(velocity**2, axis=1)))


def test_it_takes_part_in_the_search(calm: Motion) -> None:
    assert calm.clip.penalties[-1][0].name == "calm"
    assert calm.clip.custom_penalties == ((Calm(), 30.0),)
    assert speed(calm) < 0.99 * speed(inbetween(swing()))


def test_load_takes_it_too_and_none_of_weight_0(tmp_path: Path) -> None:
    clip = load(written(tmp_path), custom_penalties=[(Calm(), 0.1), (Calm("other"), 0.0)])
    assert clip.custom_penalties == clip.penalties[-1:] == ((Calm(), 0.1),)


@pytest.mark.parametrize(
    ("custom_penalties", "says"),
    [
        ([Calm()], "every entry is (penalty, weight)"),
        ([(Calm(), "much")], "the weight of 'calm' is a number from 0 on, not 'much'"),
        ([(Calm("torque"), 1.0)], "called 'torque' already exists"),
        ([(Calm(), 1.0), (Calm(), 2.0)], "called 'calm' already exists"),
    ],
)
def test_what_is_none_is_refused(custom_penalties: object, says: str) -> None:
    with pytest.raises(UserError) as error:
        swing(custom_penalties=custom_penalties)
    assert says in str(error.value)


def test_saving_and_loading_warn_that_no_file_holds_it(calm: Motion, tmp_path: Path) -> None:
    for name in ("up.npz", "up.toml"):
        not_stored = "custom penalties are not stored: calm; pass them again as custom_penalties="
        with pytest.warns(UserWarning, match=not_stored):
            calm.save(tmp_path / name)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = load_motion(tmp_path / "up.npz")
        np.testing.assert_array_equal(found.at(0.7), calm.at(0.7))
    with pytest.warns(UserWarning, match="also had the custom penalty 'calm'"):
        clip = found.clip
    assert clip.custom_penalties == ()


CLIP = """
figure = "human"
[[keyframe]]
time = 0
others = "rest"
[[keyframe]]
time = 1
others = "rest"
"""


ON = {"collision": "self = true", "limits": "speed = 300", "upright": 'bodies = ["chest"]'}


def weights(penalty: str = "") -> dict[str, float]:
    clip = load(CLIP + (f"[[penalty]]\n{penalty}\n" if penalty else ""))
    return {penalty.name: weight for penalty, weight in clip.penalties}


def test_every_part_is_a_term_of_its_name_or_there_is_nothing_to_penalise():
    absent = {
        "attach.contact", "attach.grasp", "limits.range", "limits.overshoot", "equality", "flight",
        "cycle", "prior",
    }  # fmt: skip
    tables, terms = [], {}
    for i, (kind, record) in enumerate(KINDS.items()):
        given = {part.name: 0.5 + i + 0.01 * k for k, part in enumerate(record.parts)}
        listed = ", ".join(f"{name} = {weight}" for name, weight in given.items())
        weight = given.get("", f"{{{listed}}}")
        tables.append(f'kind = "{kind}"\nweight = {weight}\n' + ON.get(kind, ""))
        terms |= {record.term(part): given[part.name] for part in record.parts}
    found = weights("\n[[penalty]]\n".join(tables))
    assert {term: found.get(term, weight) for term, weight in terms.items()} == terms
    assert set(terms) - set(found) <= absent
    assert set(found) <= set(terms)


def test_a_number_scales_all_parts_a_table_sets_some_and_options_alone_leave_the_defaults():
    default = weights()
    assert (default["collision.soles"], default["collision.body"]) == (30, 30)
    assert (default["limits.bend"], default["attach.stance"]) != (3, 0)
    found = weights(
        'kind = "collision"\nweight = 60\nself = true\n[[penalty]]\nkind = "limits"\nweight = 3\nspeed = 300\n'
        '[[penalty]]\nkind = "torque"\n[[penalty]]\nkind = "attach"\nweight = 0'
    )
    assert [found[f"collision.{part}"] for part in ("soles", "body", "self")] == [60, 60, 60]
    assert (found["limits.bend"], found["limits.speed"], found["torque"]) == (3, 300, 1)
    assert "attach.stance" not in found
    some = weights(
        'kind = "collision"\nweight = {body = 7}\n[[penalty]]\nkind = "limits"\nleast_bend = 4\n'
        '[[penalty]]\nkind = "upright"\nbodies = ["chest"]'
    )
    assert some == default | {"collision.body": 7, "upright": 30}


def test_every_kind_of_violation_measures_a_part_except_that_of_the_search():
    named = {each for kind in KINDS.values() for part in kind.parts for each in part.violations}
    assert named | {"search"} == set(BOUNDS)


def test_a_custom_penalty_becomes_a_kind_by_one_record(monkeypatch, capsys):
    record = Kind("calm", (Part(0.2, "speed of all links", (), lambda context, options: Calm()),))
    monkeypatch.setitem(KINDS, "calm", record)
    assert weights()["calm"] == 0.2
    assert weights('kind = "calm"\nweight = 3')["calm"] == 3
    assert "calm" not in weights('kind = "calm"\nweight = 0')
    with pytest.raises(UserError, match="no key 'wieght'; did you mean 'weight'"):
        load(CLIP + '[[penalty]]\nkind = "calm"\nwieght = 3')
    with pytest.raises(UserError, match="no penalty 'clam'; did you mean 'calm'"):
        load(CLIP + '[[penalty]]\nkind = "clam"')
    made = build("human", [Keyframe(0, others="rest"), Keyframe(1, others="rest")], penalties={"calm": 4})
    assert {penalty.name: weight for penalty, weight in made.penalties}["calm"] == 4
    list_penalties()
    assert "calm           0.2  speed of all links" in capsys.readouterr().out
    assert kinds()[-1]["term"] == "calm"
    assert outline(CLIP + '[[penalty]]\nkind = "calm"\nweight = 3', "clip")["weights"] == {"calm": 3}


def test_a_motion_whose_text_another_version_wrote_has_the_penalties_of_its_keyframes(tmp_path):
    saved = inbetween(load(CLIP + "[solve]\nevaluations = 1\nframes = 0\n")).saved
    search: Any = {"stop": "STUCK", "own penalties": ["calm"]}  # names of version 0.2
    save(replace(saved, text=CLIP + '[[penalty]]\nkind = "clearance"\n', search=search), tmp_path / "old.npz")
    read = load_motion(tmp_path / "old.npz")
    assert read.clip.penalties
    assert read.mirrored().duration == 1


def test_a_listed_kind_without_effect_is_noted():
    text = 'figure = "human"\n' + "".join(f'[[keyframe]]\ntime = {t}\nothers = "rest"\n' for t in (0, 1))
    listed = recordings.from_text(text + '[[penalty]]\nkind = "equality"\n', name="c")
    assert any(note.startswith("penalty 'equality' has no effect in this clip; it measures: ") for note in listed.notes)
    off = recordings.from_text(text + '[[penalty]]\nkind = "equality"\nweight = 0\n', name="c")
    assert not any("no effect" in note for note in (*off.notes, *recordings.from_text(text, name="c").notes))


SWING = read_data("swing.toml")


def solved(problem: clip.Clip) -> dict:
    return report(problem, solving.solve(problem, quiet()))


@pytest.mark.slow
@pytest.mark.parametrize("joint", ["hinge", "ball"])
def test_a_motion_that_overshoots_a_range_is_kept_within_and_the_report_contains_it(tmp_path, joint):
    text = SWING
    if joint == "ball":
        text = SWING.replace("swing = 0", "swing = {rotvec = [0, 0, 0]}").replace(
            "swing = 40", "swing = {rotvec = [0, 40, 0]}"
        )
    limit = 'range="-5 40.2"' if joint == "hinge" else 'range="0 40.2"'
    figure = HINGE.format(keys="")
    if joint == "ball":
        figure = figure.replace('type="hinge" axis="0 1 0"', 'type="ball"')
    figure = figure.replace('name="swing"', f'name="swing" limited="true" {limit}')
    path = written(tmp_path, text)
    (tmp_path / "hinge.xml").write_text(figure, encoding="utf-8")
    data = solved(recordings.load(str(path)))
    json.dumps(data, allow_nan=False)
    out = io.StringIO()
    Console(file=out, width=160).print(tables(data))
    assert re.search(r"largest range .* swing at 1\.\d\d s", out.getvalue())
    before, after = (data[side]["largest"]["range"] for side in ("before", "after"))
    assert before["amount"] > 0.6
    assert after["amount"] < 0.1
    assert (before["name"], before["unit"]) == ("swing", "degrees")
    assert 1 < before["at, s"] < 1.3


def test_a_slide_beyond_its_range_is_reported_in_metres(tmp_path):
    path = written(
        tmp_path, SWING.replace("slide = 0}\n[[keyframe]]\ntime = 1.3", "slide = 0.3}\n[[keyframe]]\ntime = 1.3")
    )
    text = HINGE.format(keys="").replace('name="slide"', 'name="slide" limited="true" range="-.1 .2"')
    (tmp_path / "hinge.xml").write_text(text, encoding="utf-8")
    clip = recordings.load(str(path))
    data = report(clip, solving.raw_spline(clip))["after"]["largest"]["travel"]
    assert data["unit"] == "m"
    assert 0.1 <= data["amount"] < 0.3


SCENE = read_data("obstacles.toml")


def loaded(folder, scene: str) -> clip.Clip:
    return recordings.load(str(written(folder, TINY_CLIP + scene)))


def geom(problem: clip.Clip, name: str) -> tuple[mujoco.MjModel, np.ndarray, np.ndarray]:
    """The model compiled from the clip's MJCF text, and a geom's place and axes."""
    model = mujoco.MjModel.from_xml_string(problem.mjcf)
    data = kinematics(model)
    return model, data.geom(name).xpos, data.geom(name).xmat.reshape(3, 3)


def test_obstacles_are_where_the_clip_specifies_and_as_large(tmp_path):
    problem = loaded(tmp_path, SCENE)
    model, place, axes = geom(problem, "table")
    np.testing.assert_allclose(place, [1, 0, 0.75])
    np.testing.assert_allclose(model.geom("table").size, [0.6, 0.4, 0.02])
    np.testing.assert_allclose(axes[:, 0], [0, 1, 0], atol=1e-12)
    np.testing.assert_allclose(model.geom("table").rgba, [0.2, 0.4, 0.6, 0.5], atol=1e-6)
    assert model.geom("box 2").matid[0] == model.material("stage_step").id
    np.testing.assert_allclose(model.geom("ball").size[0], 0.2)
    _, place, axes = geom(problem, "rail")
    np.testing.assert_allclose(place, [1, 1, 1.25], atol=1e-6)
    np.testing.assert_allclose(model.geom("rail").size[:2], [0.03, np.hypot(2, 0.5) / 2], atol=1e-5)
    np.testing.assert_allclose(np.abs(axes[:, 2] @ [2, 0, 0.5]), np.hypot(2, 0.5), atol=1e-6)
    _, _, axes = geom(problem, "post")
    np.testing.assert_allclose(np.abs(axes[:, 2]), [0, 1, 0], atol=1e-6)
    np.testing.assert_allclose(model.geom("post").size[:2], [0.05, 0.5], atol=1e-6)
    kinds = {surface.name: type(surface) for surface in problem.context.surfaces}
    assert kinds == {
        "floor": Plane, "table": Box, "box 2": Box, "ball": Capsule, "rail": Capsule, "post": Cylinder,
    }  # fmt: skip
    assert not any(model.geom(name).contype[0] for name in kinds)
