"""The camera follows without jolts and keeps the figure in the image."""

import numpy as np
import pytest

from dynsplines.picture.camera import ANGLES, View, axes, plan, smooth, still


def run_forward(seconds: float = 2.0, fps: float = 30.0, speed: float = 3.0) -> np.ndarray:
    """(T, 3) a root that runs along x and bobs."""
    t = np.arange(0, seconds, 1 / fps)
    return np.column_stack([speed * t, 0.02 * np.sin(9 * t), 0.95 + 0.04 * np.cos(18 * t)])


def on_screen(points: np.ndarray, view: View, aspect: float, fovy: float) -> np.ndarray:
    """(n, 2) where points are on the screen, each from -1 to 1."""
    rows = axes(view.azimuth, view.elevation)
    eye = np.asarray(view.lookat) - view.distance * rows[2]
    right, up, forward = rows @ (points - eye).T
    tan = np.tan(np.radians(fovy) / 2)
    return np.column_stack([right / forward / tan / aspect, up / forward / tan])


def test_running_goes_to_the_right_in_the_side_view_comes_in_the_front_view_and_goes_in_the_back_view():
    first, *_ = plan(run_forward(), 30, 16 / 9, "side")
    behind, ahead = on_screen(np.array([[-0.5, 0, 1], [0.5, 0, 1.0]]), first, 16 / 9, 45)
    assert ahead[0] > behind[0]
    assert axes(*ANGLES["front"])[2] @ [1, 0, 0] < -0.9
    assert axes(*ANGLES["back"])[2] @ [1, 0, 0] > 0.9


@pytest.mark.parametrize("view", sorted(ANGLES))
@pytest.mark.parametrize("aspect", [16 / 9, 0.5])
def test_head_feet_and_hands_are_in_every_image(view: str, aspect: float):
    path = run_forward()
    path[20:40, 2] += np.hanning(20)
    body = np.array([[0, 0, 0.85], [0, 0, -0.95], [0.65, 0.2, 0], [-0.65, -0.2, 0]])
    settings = plan(path, 30, aspect, view, fovy=40)
    assert len({(setting.lookat[2], setting.distance) for setting in settings}) == 1
    for root, setting in zip(path, settings, strict=True):
        assert np.abs(on_screen(root + body, setting, aspect, 40)).max() < 1


def test_a_figure_that_stands_fills_most_of_the_height():
    (view,) = plan([[0, 0, 0.95]], 30, 640 / 720)
    head, sole = on_screen(np.array([[0, 0, 1.8], [0, 0, 0.0]]), view, 640 / 720, 45)
    assert head[1] - sole[1] > 1.3


def test_uniform_motion_is_followed_exactly_up_to_its_ends_and_jolts_are_smoothed_away():
    path = np.column_stack([np.linspace(0, 5, 40), np.linspace(1, -1, 40)])
    np.testing.assert_allclose(smooth(path, 30), path, atol=1e-12)
    path = np.column_stack([np.linspace(0, 4, 120), 0.1 * np.sin(np.arange(120) * 1.5)])
    assert np.abs(smooth(path, 30)[20:-20, 1]).max() < 0.002


def test_figures_side_by_side_share_one_plan_that_fits_them_all():
    low, high = run_forward(), run_forward() + np.array([0.3, 0, 0.4])
    shared = plan(np.stack([low, high]), 30, 640 / 720)
    for path in (low, high):
        for root, setting in zip(path, shared, strict=True):
            points = root + np.array([[0, 0, 0.85], [0, 0, -0.93]])
            assert np.abs(on_screen(points, setting, 640 / 720, 45)).max() < 1


def test_a_still_view_shows_the_whole_path():
    path = run_forward()
    view = still(path, 16 / 9)
    points = (path[:, None] + np.array([[0.6, 0, 0.85], [-0.6, 0, -0.9]])).reshape(-1, 3)
    assert np.abs(on_screen(points, view, 16 / 9, 45)).max() < 1


def test_a_camera_of_the_model_is_used_as_it_is_and_a_clip_shorter_than_the_filter_works():
    settings = plan(run_forward(), 30, 1.5, "door", cameras=("door",))
    assert {view.fixed for view in settings} == {"door"}
    for count in (1, 3):
        assert len(plan(run_forward()[:count], 30, 1.5)) == count
