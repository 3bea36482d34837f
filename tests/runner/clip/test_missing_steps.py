"""A note where a figure moves between keyframes without steps."""

from __future__ import annotations

import pytest

from dynsplines.clip import load as clips


def notes(keyframes: list[tuple[float, float, float]], more: str = "") -> list[str]:
    """Notes on steps for a human at rest that stands at (time [s], distance [m], height above the floor [m])."""
    text = 'figure = "human"\n' + "".join(
        f'[[keyframe]]\ntime = {t}\nroot.position = [{x}, 0, {0.93 + z}]\nothers = "rest"\n' for t, x, z in keyframes
    )
    return [note for note in clips.from_text(text + more, name="steps").notes if "steps" in note]


@pytest.mark.parametrize("distance", [0.5, -0.8, 2.0])
def test_a_figure_that_moves_on_both_feet_has_one(distance):
    (note,) = notes([(0, 0, 0), (0.5, 0, 0), (1.1, distance, 0), (1.6, distance, 0)])
    assert note.startswith("keyframes 2 and 3, 0.6 s apart, form no gait cycle")
    assert f"every foot moves {abs(distance):.2g} m;" in note


def test_several_pairs_of_keyframes_have_one_note_about_the_longest_way():
    (note,) = notes([(0, 0, 0), (0.6, 0.5, 0), (1.4, 1.3, 0)])
    assert note.startswith("keyframes 2 and 3")
    assert "0.8 m, as for 1 more pair of keyframes;" in note


@pytest.mark.parametrize(
    "keyframes",
    [
        [(0, 0, 0), (0.6, 0.2, 0)],  # less than a step
        [(0, 0, 0), (0.3, 0.5, 0)],  # no time for one
        [(0, 0, 0), (0.6, 0.5, 1.0), (1.2, 1.0, 0)],  # in the air
    ],
)
def test_others_have_none(keyframes):
    assert notes(keyframes) == []


def test_nor_has_a_clip_without_gaits():
    assert notes([(0, 0, 0), (0.6, 0.5, 0)], '[[penalty]]\nkind = "cycle"\nweight = 0\n') == []
