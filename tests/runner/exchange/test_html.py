"""The page that plays a motion: what it holds is MuJoCo's, it asks for nothing from outside, and its slider moves."""

import base64
import json
import re
from pathlib import Path

import browser as browsers
import motions
import mujoco
import numpy as np
import pytest
from oracles import kinematics

from dynsplines import models
from dynsplines.exchange import formats
from dynsplines.exchange.formats import html
from dynsplines.motion import Sampled

HUMAN = mujoco.MjModel.from_xml_string(models.figure_text("human"))
SOURCES = Path(__file__).parents[3] / "pages" / "src"


@pytest.fixture(scope="module")
def take():
    return Sampled.of(motions.moved(name="a < b & </script>"), 48.0)


@pytest.fixture(scope="module")
def text(take):
    return html.page(take)


@pytest.fixture(scope="module")
def content(text):
    _, _, rest = text.partition('<script type="application/json" id="motion">')
    return json.loads(rest.partition("</script>")[0])


def numbers(text, width, kind="<f4"):
    return np.frombuffer(base64.b64decode(text), kind).reshape(-1, width).astype(float)


@pytest.mark.slow
def test_its_poses_are_mujocos(take, content):
    model = take.model
    assert content["count"] == len(take.time)
    assert content["fps"] == take.fps
    position = numbers(content["after"]["position"], 3).reshape(-1, model.nbody, 3)
    rotation = numbers(content["after"]["rotation"], 4).reshape(-1, model.nbody, 4)
    assert content["extent"] == pytest.approx(np.ptp(take.bodies.position[:, 1:, :2].reshape(-1, 2), axis=0).max())
    for sample in (0, len(take.time) // 2, -1):
        data = kinematics(model, take.qpos[sample])
        np.testing.assert_allclose(position[sample], data.xpos, atol=1e-5)
        for body in range(model.nbody):
            x, y, z, w = rotation[sample, body]
            turn = np.zeros(9)
            mujoco.mju_quat2Mat(turn, [w, x, y, z])
            np.testing.assert_allclose(turn, data.xmat[body], atol=1e-5)


def test_its_pieces_are_the_visible_geoms_where_mujoco_has_them(take, content):
    model = take.model
    names = {piece["name"]: piece for piece in content["pieces"]}
    assert "ghost" not in names
    assert len(names) == sum(model.geom_group < 3)
    for piece in content["pieces"]:
        geom = model.geom(piece["name"]).id if piece["name"] in ("wrist", "thigh", "sleeve") else None
        if geom is not None:
            x, y, z, w = piece["rotation"]
            np.testing.assert_allclose([w, x, y, z], model.geom_quat[geom], atol=1e-5)
            np.testing.assert_allclose(piece["position"], model.geom_pos[geom], atol=1e-5)
            np.testing.assert_allclose(piece["size"], model.geom_size[geom], atol=1e-5)
    assert {piece["name"] for piece in content["pieces"] if piece["still"]} >= {"hills", "pillar", "floor"}
    bag = content["meshes"][names["bag"]["mesh"]]
    assert numbers(bag["faces"], 3, "<u4").max() < len(numbers(bag["points"], 3))


def test_the_floor_reaches_beyond_a_motion_far_away():
    far = motions.through("human", np.arange(2.0), np.array([[x, *HUMAN.qpos0[1:]] for x in (100, 101)]))
    (floor,) = [piece for piece in html.content(Sampled.of(far, 5.0))["pieces"] if piece["kind"] == "plane"]
    assert min(floor["size"][:2]) > 101 + 30


def test_before_is_there_only_where_it_differs(saved, content):
    assert content["before"] is None
    told = html.content(Sampled.of(saved))
    assert told["before"] is not None
    before, after = (numbers(side["position"], 3) for side in (told["before"], told["after"]))
    assert 1e-4 < np.abs(before - after).max() < 1
    assert [key["partial"] for key in told["keys"]] == [False, True, False]
    np.testing.assert_allclose([key["time"] for key in told["keys"]], [0, 0.2, 0.41], atol=1e-12)


def test_it_asks_for_nothing_from_outside_and_a_motions_name_cannot_break_out_of_it(text):
    assert "<title>a &lt; b &amp; &lt;/script&gt;</title>" in text
    assert text.count("</script>") == 2
    assert "default-src 'none'" in text
    before, _, rest = text.partition("<script>\n/*!\nthree ")
    frame = before + rest.partition("</script>")[2]
    assert rest
    own = [path for name in ("player", "scene") for path in sorted((SOURCES / name).glob("*.ts"))]
    frame += "".join(path.read_text(encoding="utf-8") for path in own)
    assert not re.search(r"(src|href)\s*=\s*[\"']?(https?:)?//", frame)
    assert not re.search(r"\b(fetch|import|XMLHttpRequest|WebSocket|eval)\s*\(", frame)
    assert "The MIT License" in text
    assert not re.search(r"</?script|<!--", rest.partition("</script>")[0])


def until(page, condition):
    """Whether it comes true within a minute; asked from outside, for the page forbids itself to evaluate text."""
    for _ in range(600):
        if page.evaluate(condition):
            return True
        page.wait_for_timeout(100)
    return False


@pytest.mark.slow
def test_in_a_browser_it_plays_and_its_slider_moves_the_figure(saved, tmp_path):
    target, heard = formats.export(saved, "html", tmp_path / "tiny.html"), list[str]()
    with browsers.opened() as browser:
        page = browser.new_page(viewport={"width": 640, "height": 360})
        page.set_default_timeout(120_000)
        page.on("request", lambda request: heard.append(request.url))
        page.on("pageerror", lambda error: heard.append(str(error)))
        page.on("console", lambda message: heard.append(message.text) if message.type == "error" else None)
        page.goto(target.as_uri())
        assert until(page, "window.player !== undefined")
        assert until(page, "player.time > 0.05")  # it plays without a click
        check_slider(page, saved)
    assert [url for url in heard if url != target.as_uri() and not url.startswith(("data:", "blob:"))] == []


def check_slider(page, saved):
    """The slider stops the motion and moves the body to MuJoCo's place, after and before solving."""
    take = Sampled.of(saved)
    at = 5
    page.evaluate(
        "share => { const s = document.getElementById('scrub'); s.value = share; s.dispatchEvent(new Event('input')) }",
        at / (len(take.time) - 1),
    )
    assert not page.evaluate("player.playing")
    assert page.evaluate("player.time") == pytest.approx(at / take.fps)
    assert until(page, "player.settled")
    body = take.model.body("left_shin").id
    np.testing.assert_allclose(page.evaluate("player.place('left_shin')"), take.bodies.position[at, body], atol=1e-5)
    page.keyboard.press("1")
    assert until(page, "player.which === 'before' && player.settled")
    before = html.content(take)["before"]
    assert before is not None
    raw = numbers(before["position"], 3).reshape(-1, take.model.nbody, 3)[at, body]
    np.testing.assert_allclose(page.evaluate("player.place('left_shin')"), raw, atol=1e-5)
