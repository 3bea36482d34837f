"""What is asked for again: answers by what they depend on, and poses that are not searched twice."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
import shared_figures
from figures import figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import kinematics
from site_goal import SiteGoal

from dynsplines import models, recordings
from dynsplines.clip import load
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.cache import Cache, cache_key
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.posing import PointGoal, Posed, PoseSearch, inverse_kinematics, posed, reached


@dataclass(frozen=True, eq=False)
class Told:
    name: str
    values: Array


VALUES = st.lists(st.sampled_from([0.0, -0.0, 1.0, np.nextafter(1, 2), np.nan]), min_size=2, max_size=2).map(np.array)


def human() -> Figure:
    return figure_of(models.figure_text("human"))


def test_an_answer_is_found_once_and_the_one_that_is_requested_longest_ago_goes():
    found: list[int] = []

    def find(n: int) -> int:
        found.append(n)
        return 10 * n

    some: Cache[int] = Cache(2)
    assert [some.get(n, lambda n=n: find(n)) for n in (1, 2, 1, 3, 1, 2)] == [10, 20, 10, 30, 10, 20]
    assert found == [1, 2, 3, 2]
    assert len(some) == 2


def test_an_exception_is_no_answer():
    some: Cache[int] = Cache(2)
    with pytest.raises(ZeroDivisionError):
        some.get("a", lambda: 1 // 0)
    assert some.get("a", lambda: 7) == 7


@settings(deadline=None, max_examples=25)
@given(VALUES, VALUES, st.sampled_from("ab"), st.sampled_from("ab"))
def test_content_is_the_same_where_every_bit_is(a, b, one, other):
    are_alike = a.tobytes() == b.tobytes() and one == other
    assert (cache_key(Told(one, a)) == cache_key(Told(other, b))) == are_alike
    assert (cache_key([one, (a,)]) == cache_key([other, (b,)])) == are_alike
    assert hash(cache_key([Told(one, a), None, 1.5])) == hash(cache_key([Told(one, a.copy()), None, 1.5]))


def test_content_tells_kinds_and_shapes_apart():
    values = np.arange(4.0)
    assert cache_key(values) != cache_key(values.reshape(2, 2))
    assert cache_key(values) != cache_key(values.astype(np.float32))
    assert cache_key((1.0, 2.0)) != cache_key([1.0, 2.0])
    place = np.zeros(3)
    assert cache_key(SiteGoal("a", place)) != cache_key(PointGoal("a", 1, place, place))


def test_a_pose_is_searched_once_for_a_figure_and_depends_on_what_its_goals_do_alone(monkeypatch):
    figure, rng = human(), np.random.default_rng(1)
    data = kinematics(figure.model)
    goals = [SiteGoal("left_hand", data.site("left_hand").xpos + np.array([0.2, 0, 0.3]))]
    home, free = np.array(figure.model.qpos0), np.ones(figure.width, bool)
    free[:7] = False
    first = posed(figure, home, free, goals)
    assert first.is_met
    other = np.array(home)
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None and not reached(figure, goals)[columns].any():
            other[columns] = quat.normalised(rng.normal(size=4))
    fresh = posed(human(), other, free, goals)

    def never(*_: object) -> None:
        pytest.fail("searched again")

    monkeypatch.setattr(inverse_kinematics, "_posed", never)
    again = posed(figure, other, free, goals)
    own = reached(figure, goals)
    assert np.array_equal(again.qpos, fresh.qpos)
    assert np.array_equal(again.qpos[own], first.qpos[own])
    assert np.array_equal(again.qpos[~own], other[~own])


def test_a_pose_that_anything_it_depends_on_differs_for_is_another():
    figure = human()
    data = kinematics(figure.model)
    place = data.site("left_hand").xpos + np.array([0.2, 0, 0.3])
    goals, home, free = [SiteGoal("left_hand", place)], np.array(figure.model.qpos0), np.ones(figure.width, bool)
    free[:7] = False
    first = posed(figure, home, free, goals).qpos
    assert not np.array_equal(posed(figure, home, free, [SiteGoal("left_hand", place + 1e-3)]).qpos, first)
    elbow = next(i for i, link in enumerate(figure.links) if link.name == "left_elbow")
    held = np.array(free)
    held[figure.links[elbow].columns] = False
    assert not np.array_equal(posed(figure, home, held, goals).qpos, first)
    bent = np.array(home)
    columns = quaternion_columns(figure.links[elbow])
    bent[columns] = quat.from_rotation_vector(np.array([0, -0.5, 0]))
    assert not np.array_equal(posed(figure, bent, free, goals).qpos, first)


REACH = """
[[keyframe]]
time = {}
others = "rest"
sites.left_hand = [0.2, 0.3, {}]
"""


@pytest.mark.slow
def test_an_edit_of_a_clip_keyed_by_places_searches_few_of_its_poses_and_gives_what_the_text_alone_does(monkeypatch):
    monkeypatch.setattr(load, "scene_and_figure", shared_figures.COMPOSED)  # no other test has searched these poses
    places = "".join(REACH.format(time, height) for time, height in enumerate((1.1, 1.2, 1.4)))
    clip = recordings.from_text(f'figure = "human"\n{places}', name="reach")
    text = clip.text.replace("0.3, 1.4]", "0.3, 1.39]", 1)
    assert text != clip.text
    searched: list[int] = []
    search = inverse_kinematics._posed

    def counted(asked: PoseSearch, starts: int) -> Posed:
        searched.append(1)
        return search(asked, starts)

    monkeypatch.setattr(inverse_kinematics, "_posed", counted)
    edited = recordings.from_text(text, name="reach", like=clip)
    few, _ = len(searched), searched.clear()
    recordings.from_text(text + '[[penalty]]\nkind = "torque"\n', name="reach", like=edited)
    assert not searched
    fresh = recordings.from_text(text, name="reach")
    assert 0 < few < len(searched) / 2
    for one, other in zip(edited.keys, fresh.keys, strict=True):
        assert np.array_equal(one.state, other.state)
