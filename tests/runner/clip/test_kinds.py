"""The records of soft constraints: options are known, and what is wrong is told."""

import tomllib

import pytest

from dynsplines import UserError, load
from dynsplines.clip.kinds import KINDS

CLIP = """
figure = "human"
[[keyframe]]
time = 0
others = "rest"
[[keyframe]]
time = 1
others = "rest"
[[penalty]]
"""
NEEDED = {"level": 'bodies = ["chest"]', "speed": "limit = 300"}


def test_every_option_says_what_it_is_given_in():
    assert all(text for kind in KINDS.values() for text in kind.choices().values())


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_made_or_is_nothing_to_look_at(kind):
    clip = load(CLIP + f'kind = "{kind}"\nweight = 0.5\n' + NEEDED.get(kind, ""))
    made = {penalty.name: weight for penalty, weight in clip.penalties}
    absent = {"placement", "upright", "resting", "hold", "equality", "range", "cycle", "steady"}
    assert made.get(kind, 0.5 if kind in absent else None) == 0.5


@pytest.mark.parametrize(
    ("said", "told"),
    [
        (
            'kind = "bend"\nsideway = 3',
            "penalty 1: no key 'sideway'; did you mean 'sideways'?",
        ),
        ('kind = "bend"\nsideways = "x"', "penalty 1: sideways must be a number, not 'x'"),
        ('kind = "bend"\nsideways = 0', "penalty 1: sideways must be above 0, not 0"),
        ('kind = "bend"\nweight = -1', "penalty 1: weight must be at least 0, not -1"),
        ('kind = "bend"\nmargin = 0', "penalty 1: 'margin' is not for kind 'bend', which takes: weight, joints, least"),
        ('kind = "bent"', "no penalty 'bent'"),
        ('kind = "closed"', "penalty 'closed' is called 'equality' now"),
        ('kind = "flight"\nintervals = [[0]]', "penalty 1: intervals must be a list of [from, to] in seconds"),
        ('kind = "speed"', "penalty 'speed' needs a limit = ..., in degrees a second"),
        ('kind = "level"\nbodies = "chest"', "penalty 1: bodies must be a list of names, not 'chest'"),
        ('kind = "level"\nbodies = ["chets"]', "no body 'chets'"),
        ('kind = "level"\nweight = 2', "penalty 'level' needs bodies = [...]"),
        ('kind = "level"\nbodies = ["chest"]\naxis = [0, 0, 0]', "axis is [0, 0, 0], which points nowhere"),
        (
            'kind = "level"\nbodies = ["chest"]\naxis = [0, 1]',
            "axis must be [x, y, z] in the body's own axes, not [0, 1]",
        ),
    ],
)
def test_what_is_wrong_names_table_key_and_value(said, told):
    with pytest.raises(UserError) as caught:
        load(CLIP + said)
    assert told in str(caught.value)
    assert tomllib.loads(CLIP + said)
