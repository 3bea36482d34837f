"""A note where a figure moves between keyframes without steps."""

from __future__ import annotations

import pytest

from dynsplines import recordings


def notes(keyframes: list[tuple[float, float, float]], more: str = "") -> list[str]:
    """Notes on steps for a human at rest that stands at (time [s], distance [m], height above the floor [m])."""
    text = 'figure = "human"\n' + "".join(
        f'[[keyframe]]\ntime = {t}\nroot.position = [{x}, 0, {0.93 + z}]\nothers = "rest"\n' for t, x, z in keyframes
    )
    return [note for note in recordings.from_text(text + more, name="steps").notes if "steps" in note]


def test_figures_that_move_on_both_feet_have_one_about_the_longest_way():
    (note,) = notes([(0, 0, 0), (0.5, 0, 0), (1.1, -0.8, 0), (1.6, -0.8, 0)])
    assert note.startswith("keyframes 2 and 3, 0.6 s apart, form no gait cycle")
    assert "every foot moves 0.8 m;" in note
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
