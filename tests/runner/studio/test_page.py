"""The studio in a browser, driven as a person would: edits, live paths, files; tabs, losses, keys that cross."""

from __future__ import annotations

import re
import signal
import tomllib
from pathlib import Path

import browser as browsers
import figures
import problems
import psutil
import pytest
from browser import Studio, Tab
from texts import read_data

from dynsplines import models
from dynsplines.clip.starter import starter

pytestmark = [
    pytest.mark.slow,
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
]


@pytest.fixture(scope="module")
def browser():
    with browsers.opened() as found:
        yield found


CRATE = read_data("page_crate.toml")


def clip_with_crate():
    """The tiny clip with a crate that moves."""
    placed = "\nroots.crate = {position = [1, 0.5, 0], rotation = {rotvec = [0, 0, 90]}}"
    text = re.sub(r"\ntime = [0-9.]+", lambda found: found[0] + placed, problems.CLIP)
    return text.replace("[[keyframe]]", CRATE + "\n[[keyframe]]", 1)


def assert_part_of_a_thing_moves_in_its_axes(tab):
    tab.evaluate("void (studio.model.obstacle = {kind: 'box', index: 0}, studio.model.tell('joint'))")
    tab.until("studio.gizmo.controls.object !== undefined")
    tab.shown()  # bodies are where an image has put them
    assert tab.evaluate("studio.gizmo.handle.position.toArray()") == pytest.approx([1, 0.8, 0.1], abs=1e-3)
    tab.evaluate("void studio.gizmo.start()")
    tab.changes(lambda: tab.evaluate("void (studio.gizmo.handle.position.x += 0.1, studio.gizmo.end())"))
    assert tab.evaluate("studio.model.document.obstacles[0].position") == pytest.approx([0.3, -0.1, 0.1], abs=2e-3)


def test_work_survives_whatever_is_killed_and_a_part_of_a_thing_moves_in_its_axes(browser, tmp_path):
    file = problems.written(tmp_path, clip_with_crate())
    first = file.read_text(encoding="utf-8")
    running = Studio(tmp_path, "tiny.toml")
    tab = Tab(browser, running.address)
    tab.settled()

    # the solver process is killed: another one continues
    (solver,) = [
        child
        for child in psutil.Process(running.process.pid).children()
        if any("spawn_main" in word for word in child.cmdline())
    ]
    solver.kill()
    tab.until("document.getElementById('toast').textContent.includes('a new one')")
    tab.settled()
    tab.seek(0.3)
    tab.changes(lambda: tab.press("k"))

    # the server is killed: unsaved work is offered
    running.end(signal.SIGKILL)
    tab.until("document.getElementById('state').textContent.includes('no connection')")
    assert file.read_text(encoding="utf-8") == first
    tab.page.close()
    with browsers.studio(tmp_path, "tiny.toml") as again:
        tab = Tab(browser, again.address)
        assert tab.evaluate("studio.model.document.keys.length") == 3
        assert tab.page.locator("#offer").is_visible()
        tab.press("k")
        tab.until("document.getElementById('toast').textContent.includes('restore or discard')")
        tab.changes(tab.page.locator("#offer-take").click)
        tab.until("studio.model.document.keys.length === 4 && document.getElementById('offer').hidden")
        tab.press("Control+s")
        tab.until("!studio.model.document.dirty")
        tab.settled()
        assert_part_of_a_thing_moves_in_its_axes(tab)
        tab.changes(lambda: tab.press("Control+z"))
        tab.page.close()
    assert len(tomllib.loads(file.read_text(encoding="utf-8"))["keyframe"]) == 4
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]


@pytest.fixture(scope="module")
def tab(browser, tmp_path_factory):
    """A page of a studio that several tests share, each of which leaves the clip as it was."""
    folder = tmp_path_factory.mktemp("shared")
    text = models.clip_text("run_and_step").replace("[[keyframe]]", "[solve]\ntolerance = 0.1\n\n[[keyframe]]", 1)
    (folder / "run.toml").write_text(text, encoding="utf-8")
    with browsers.studio(folder, "run.toml") as studio:
        found = Tab(browser, studio.address)
        found.folder = str(folder)
        found.settled()
        yield found
        found.page.close()


def test_an_animators_afternoon(tab):
    folder, page = Path(tab.folder), tab.page
    file = folder / "run.toml"
    first = file.read_text(encoding="utf-8")

    # the right foot's keyframe 10 cm up: the figure is taken by the foot and dragged
    time_of = tomllib.loads(first)["keyframe"][4]["time"]
    tab.seek(time_of)
    tab.press("2")
    tab.shown()
    was = tab.evaluate("studio.stage.placeOf(studio.model.stage.bodies.indexOf('left_foot'), [0,0,0]).toArray()")
    x, y = tab.on_screen("left_foot", (0.0, 0, 0))
    scale = y - tab.on_screen("left_foot", (0, 0, 0.1))[1]
    frames = tab.evaluate("studio.model.frames")
    tab.changes(lambda: tab.drag((x, y), (x, y - abs(scale))))
    tab.until(f"studio.model.frames > {frames + 2}")
    tab.settled()
    tab.shown()
    now = tab.evaluate("studio.stage.placeOf(studio.model.stage.bodies.indexOf('left_foot'), [0,0,0]).toArray()")
    assert now[2] - was[2] == pytest.approx(0.1, abs=0.04)
    lifted = tab.evaluate("JSON.stringify(studio.model.document.keys)")

    # a keyframe from the path; an arm of it freed on the timeline
    tab.seek(1.0)
    tab.changes(lambda: tab.press("k"))
    keys = tab.evaluate("studio.model.document.keys.map((key) => key.time)")
    assert 1.0 in keys
    tab.press("u")
    limb = page.locator(f"[data-id='limbleft arm{keys.index(1.0)}']")
    tab.changes(limb.dblclick)
    page.locator(f"[data-id='limbleft arm{keys.index(1.0)}'].none").wait_for()
    tab.press("u")

    # undo twice, redo once
    tab.changes(lambda: tab.press("Control+z"))
    tab.changes(lambda: tab.press("Control+z"))
    assert tab.evaluate("JSON.stringify(studio.model.document.keys)") == lifted
    tab.changes(lambda: tab.press("Control+Shift+z"))
    assert 1.0 in tab.evaluate("studio.model.document.keys.map((key) => key.time)")

    # a contact, drawn over the timeline
    row = page.locator("[data-point='left_toe']").bounding_box()
    at = [tab.on_timeline(t) for t in (1.7, 2.0)]
    tab.changes(lambda: tab.drag((at[0], row["y"] + 10), (at[1], row["y"] + 10)))
    (contact,) = tab.evaluate("studio.model.document.contacts")
    assert contact["point"] == "left_toe"
    assert contact["to"] - contact["from"] == pytest.approx(0.3, abs=0.05)

    # saved, and there again, at the same time and seen from the same side
    tab.press("Control+s")
    tab.until("!studio.model.document.dirty")
    saved = file.read_text(encoding="utf-8")
    assert saved != first
    assert [line for line in first.splitlines() if "#" in line and line not in saved] == []
    time, view = tab.evaluate("[studio.model.time, studio.stage.camera.position.toArray()]")
    page.reload()
    tab.begun()
    assert not tab.evaluate("studio.model.document.dirty")
    assert tab.evaluate("studio.model.time") == time
    assert tab.evaluate("studio.stage.camera.position.toArray()") == pytest.approx(view, abs=0.02)

    # what is wrong is found, and nothing is once the edits are taken back
    tab.press("o")
    tab.settled()
    if tab.evaluate("studio.model.violations.length"):
        page.locator("#panel-problems .violations button").first.click()
        assert tab.evaluate("studio.model.time") is not None
    for _ in range(3):
        tab.changes(lambda: tab.press("Control+z"))
    assert tab.evaluate("studio.model.document.keys.length") == len(tomllib.loads(first)["keyframe"])
    tab.settled()
    tab.until(page.locator("#nothing-wrong").is_visible)

    # exported and rendered: a refusal leaves the dialog open, and the page may be loaded again meanwhile
    page.set_viewport_size({"width": 800, "height": 600})
    page.locator("#files").click()
    page.get_by_role("menuitem", name="Export").click()
    form, name = page.locator("dialog form").bounding_box(), page.get_by_label("file name")
    assert page.locator("dialog button.main").bounding_box()["x"] < form["x"] + form["width"] <= 800
    page.locator("dialog select").select_option("bvh")
    name.fill("elsewhere/run.bvh")
    name.press("Enter")
    tab.until("document.getElementById('toast').textContent.includes('plain name')")
    name.fill("run.bvh")
    name.press("Enter")
    tab.until(lambda: (folder / "run.bvh").is_file())
    assert (folder / "run.bvh").read_text().startswith("HIERARCHY")
    tab.until("document.getElementById('toast').textContent.includes('exported')")
    tab.until(lambda: page.locator("dialog").count() == 0)
    page.locator("#files").click()
    page.get_by_role("menuitem", name="Render").click()
    page.locator("dialog input[aria-label='file name of the video']").fill("sheet.png")
    page.locator("dialog input[aria-label='size, pixels']").fill("32x18")
    page.locator("dialog button.main").click()
    tab.until(lambda: page.locator("dialog").count() == 0)
    page.reload()
    tab.begun()
    tab.until(lambda: (folder / "sheet.png").is_file(), 100)
    tab.until(page.locator("#task").is_hidden)
    assert [path.name for path in folder.iterdir() if "partial" in path.name] == []
    page.set_viewport_size({"width": 900, "height": 600})
    assert tab.errors == []
    assert all(url.startswith((page.url.split("?")[0], "data:", "blob:")) for url in tab.requested)
    tab.press("Control+s")
    tab.until("!studio.model.document.dirty")
    assert file.read_text(encoding="utf-8") == first
    tab.press("p")
    tab.press("g")  # what follows needs no search


REACH = """studio.ask('edit', { name: 'change', at: ['keyframe', 2], entries: { sites: { left_hand: [0, 0, 9] } } })"""


def test_what_makes_no_sense_is_refused_in_words_and_loses_nothing(tab):
    before, page = tab.evaluate("JSON.stringify(studio.model.document.keys)"), tab.page
    tab.seek(0.26)
    time_field = page.get_by_label("time [s]")
    for typed, words in (("0.5", "times must rise"), ("NaN", "finite"), ("", "finite"), ("-1", "times must rise")):
        time_field.fill(typed)
        time_field.press("Enter")
        tab.until(f"document.getElementById('toast').textContent.includes({words!r})")
        assert page.locator("#toast").get_attribute("role") == "alert"
        tab.evaluate("void (document.getElementById('toast').textContent = '')")
    field = page.get_by_label("left_knee x [degrees]")
    field.fill("a lot")
    field.press("Enter")
    tab.until("document.getElementById('toast').textContent.includes('must be three angles')")
    answer = tab.evaluate(REACH)
    assert not answer["ok"]
    assert "site 'left_hand' cannot move: every joint on the way to it is given" in answer["words"]
    assert tab.evaluate("JSON.stringify(studio.model.document.keys)") == before
    assert not tab.evaluate("studio.model.document.dirty")


def test_everything_has_a_name_and_is_reached_by_the_keyboard(tab):
    tab.seek(0.26)
    nameless = tab.evaluate(
        """[...document.querySelectorAll('button, input, select, [role=slider]')].filter((each) =>
        each.offsetParent && !(each.getAttribute('aria-label') || each.textContent.trim() || each.labels?.length ||
        each.title)).length"""
    )
    assert nameless == 0
    tab.page.bring_to_front()
    tab.evaluate("void document.getElementById('files').focus()")
    seen = {"files"}
    for _ in range(30):
        tab.press("Tab")
        seen.add(tab.evaluate("document.activeElement.id || document.activeElement.dataset.id || ''"))
    assert {"files", "go", "which", "views", "tab-pose"} <= seen
    tab.evaluate("void document.querySelector('[data-id=key3]').focus()")
    tab.press("Enter")
    assert tab.evaluate("[...studio.model.keys]") == [3]
    before = tab.evaluate("studio.model.document.keys[3].time")
    tab.changes(lambda: tab.press("Alt+ArrowRight"))
    assert tab.evaluate("studio.model.document.keys[3].time") == pytest.approx(before + 1 / 30, abs=1e-3)
    tab.changes(lambda: tab.press("Control+z"))
    tab.evaluate("void document.activeElement.blur()")
    tab.press("?")
    assert tab.page.locator("dialog.help").is_visible()
    tab.press("Escape")


TIMES = "studio.model.document.keys.map((key) => key.time)"


def test_the_selection_follows_and_what_is_pasted_replaces_what_is_there(tab):
    times = tab.evaluate(TIMES)
    tab.seek(0.26)
    assert tab.evaluate("[...studio.model.keys]") == [2]
    tab.press("Control+c")
    tab.seek(1.0)
    assert tab.evaluate("[...studio.model.keys]") == []
    tab.changes(lambda: tab.press("Control+v"))
    tab.until("String([...studio.model.keys]) === '8' && studio.model.document.keys[8].time === 1")
    tab.changes(lambda: tab.press("Delete"))
    assert tab.evaluate(TIMES) == times
    tab.seek(0.37)
    tab.changes(lambda: tab.press("Control+v"))
    assert tab.evaluate(TIMES) == times
    assert tab.evaluate("studio.model.document.keys.slice(2, 4).map((key) => JSON.stringify(key.joints))[1]") == (
        tab.evaluate("JSON.stringify(studio.model.document.keys[2].joints)")
    )
    tab.changes(lambda: tab.press("Control+z"))

    # a keyframe after the last one; nothing before the beginning
    ruler = tab.page.locator(".ruler").bounding_box()
    tab.page.mouse.click(tab.on_timeline(2.3), ruler["y"] + 12)
    tab.changes(lambda: tab.press("k"))
    assert tab.evaluate(TIMES) == [*times, 2.3]
    tab.until(f"String([...studio.model.keys]) === '{len(times)}'")
    tab.changes(lambda: tab.press("Control+z"))
    for _ in range(5):
        tab.press("[")
    tab.drawn()
    assert tab.evaluate("studio.timeline.begin") == 0
    tab.page.mouse.click(tab.on_timeline(-0.2), ruler["y"] + 12)
    assert tab.evaluate("studio.model.time") >= 0
    tab.press("z")


DISTANCE = "studio.stage.camera.position.distanceTo(studio.stage.orbit.target)"
LOWEST_SEEN = """(() => { const s = studio.stage; return Math.min(...studio.model.stage.soles.map((sole) =>
  s.placeOf(sole.body, sole.offset).project(s.camera).y)); })()"""


def test_views_fit_and_what_lies_at_the_pointer_is_named_and_selected(tab):
    page, menu = tab.page, tab.page.locator("#views")
    tab.seek(0.26)
    for key, name in (("2", "side"), ("4", "front"), ("1", "quarter")):
        tab.press(key)
        tab.shown()
        assert menu.input_value() == name
        assert tab.evaluate(LOWEST_SEEN) > -0.95
    x, y = tab.middle("#view")
    away = tab.evaluate(DISTANCE)
    page.mouse.move(x - 200, y - 100)
    page.mouse.wheel(0, 300)
    tab.until(f"{DISTANCE} > {1.02 * away}")
    tab.press("2")
    tab.shown()
    assert menu.input_value() == "side"
    away = tab.evaluate(DISTANCE)
    tab.drag((x - 200, y - 100), (x - 200, y - 400))  # from below
    tab.until("document.getElementById('views').value === 'free'")
    assert tab.evaluate("studio.stage.camera.position.z") > 0.04
    tab.press("4")
    tab.shown()
    assert tab.evaluate(DISTANCE) == pytest.approx(away, rel=0.02)
    tab.press("0")
    tab.press("2")

    tab.seek(1.62)
    tab.shown()
    page.mouse.move(*tab.grip("left_forearm"))
    page.locator("#hover").wait_for()
    assert page.locator("#hover").inner_text() == "left_forearm"
    page.mouse.click(*tab.on_screen_at([4.2, 0.6, 0.35]))
    tab.until("studio.model.obstacle?.kind === 'step'")
    assert page.locator("#panel-scene").get_by_label("step height [m]").is_visible()
    tab.press("Escape")
    tab.press("p")


def test_a_file_that_another_program_changes_is_noticed_at_once(tab):
    file, notice = Path(tab.folder) / "run.toml", tab.page.locator("#outside")
    first = file.read_text(encoding="utf-8")
    file.write_text(first.replace("time = 2.2", "time = 2.3"), encoding="utf-8")
    tab.until(notice.is_visible)
    tab.changes(tab.page.locator("#outside-reload").click)
    assert tab.evaluate(TIMES)[-1] == 2.3
    assert not tab.evaluate("studio.model.document.dirty")
    file.write_text("nothing = [", encoding="utf-8")
    tab.until(notice.is_visible)
    assert "run.toml: line 1" in notice.inner_text()
    assert tab.page.locator("#outside-reload").is_hidden()
    tab.page.locator("#outside-keep").click()
    tab.until(notice.is_hidden)
    tab.changes(lambda: tab.press("Control+z"))
    tab.press("Control+s")
    tab.until("!studio.model.document.dirty")
    assert file.read_text(encoding="utf-8") == first


CONFIRMED = "!studio.pending.size"


def test_no_press_and_no_typed_number_is_lost_and_a_run_of_presses_is_one_undo(tab):
    keyboard, field = tab.page.keyboard, tab.page.get_by_label("left_knee x [degrees]")
    knee = "studio.model.document.keys[2].joints.left_knee"
    tab.seek(0.26)
    field.focus()
    before, undo = tab.evaluate(knee), tab.evaluate("studio.model.document.undo")
    for i in range(60):
        tab.press("ArrowUp")
        tab.page.wait_for_timeout(20)
        assert float(field.input_value()) == i + 1  # it never returns to an earlier value
    tab.until(CONFIRMED)
    assert tab.evaluate(knee)["rotvec"][0] == 60
    tab.changes(lambda: tab.press("Control+z"))
    assert (tab.evaluate(knee), tab.evaluate("studio.model.document.undo")) == (before, undo)

    field.focus()
    field.select_text()
    for text in ("11", "12", "13"):
        keyboard.type(text)
        keyboard.press("Tab")
    tab.until(CONFIRMED)
    assert tab.evaluate(knee) == {"rotvec": [11, 12, 13]}

    # what is being typed survives what the studio answers
    field.focus()
    field.select_text()
    keyboard.type("4")
    tab.changes(lambda: tab.evaluate("void studio.ask('undo')"))
    keyboard.type("2")
    tab.changes(lambda: keyboard.press("Enter"))
    assert tab.evaluate(knee)["rotvec"][:2] == [42, 12]
    x, y = tab.middle("[aria-label='left_knee x [degrees]']")
    tab.changes(lambda: tab.drag((x, y), (x + 41, y)))
    tab.until(CONFIRMED)
    assert tab.evaluate(knee)["rotvec"][0] == 52

    # the foot on the ground stays when the root is typed lower
    height, leg = tab.page.get_by_label("root z [m]"), "studio.model.document.keys[2].joints.right_knee"
    stood, lower = tab.evaluate(leg), round(float(height.input_value()) - 0.05, 3)
    height.fill(str(lower))
    tab.changes(lambda: height.press("Enter"))
    assert tab.evaluate("studio.model.document.keys[2].root.position[2]") == lower
    assert tab.evaluate(leg) != stood
    while tab.evaluate("studio.model.document.undo") != undo:
        tab.changes(lambda: tab.press("Control+z"))
    assert tab.evaluate(knee) == before


NUDGES = (("ArrowRight", 10), ("ArrowLeft", -14))


@pytest.mark.parametrize(("selected", "presses"), [([], NUDGES), ([10], NUDGES), ([9, 10], (("ArrowUp", 5),))])
def test_every_repeat_of_a_key_moves_or_spreads_the_keyframes(tab, selected, presses):
    """The keyboard repeats a key faster than the studio answers."""
    keyboard, place = tab.page.keyboard, "studio.model.document.keys[10].time"
    before, time = tab.evaluate("studio.model.document.keys.slice(9, 11).map((key) => key.time)")
    tab.seek(time)
    tab.evaluate(f"studio.model.select({selected})")
    keyboard.down("Alt")
    for key, count in presses:
        for _ in range(abs(count)):
            keyboard.down(key)
        keyboard.up(key)
        time = before + 1.1**count * (time - before) if key == "ArrowUp" else time + count / 30
        tab.until(f"Math.abs({place} - {time}) < 2e-3")
    keyboard.up("Alt")
    tab.until(f"studio.model.time === {place}")
    while tab.evaluate("studio.model.document.undo") is not None:
        tab.changes(lambda: tab.press("Control+z"))
    tab.evaluate("studio.model.select([])")


def test_a_second_tab_may_take_over(browser, tab):
    page = browser.new_page(viewport={"width": 900, "height": 600})
    page.goto(tab.page.url)
    page.locator("#elsewhere").wait_for()
    assert tab.page.locator("#elsewhere").is_hidden()
    page.locator("#take-over").click()
    tab.page.locator("#elsewhere").wait_for()
    assert page.evaluate("studio.ask('key', { time: 1.7 })")["ok"]
    tab.page.locator("#take-over").click()
    page.locator("#elsewhere").wait_for()
    tab.until("studio.model.document.keys.some((key) => key.time === 1.7)")
    tab.changes(lambda: tab.press("Control+z"))
    page.close()


LOST = "(() => { const answer = studio.ask('key', { time: 1.7 }); sockets.at(-1).close(); return answer; })()"


def test_the_page_reconnects_after_a_loss_in_the_middle_of_an_edit_which_is_applied_once(tab):
    times = "studio.model.document.keys.map((key) => key.time)"
    before, count = tab.evaluate(times), tab.evaluate("sockets.length")
    answer = tab.evaluate(LOST)
    assert not answer["ok"]
    assert "connection to the studio lost" in answer["words"]
    tab.until("document.getElementById('state').textContent === 'no connection to the studio'")
    tab.until("document.getElementById('state').textContent !== 'no connection to the studio'")
    tab.until(f"studio.model.document.keys.length === {len(before) + 1}")
    assert tab.evaluate("sockets.length") == count + 1
    tab.changes(lambda: tab.press("Control+z"))
    assert tab.evaluate(times) == before


def test_things_are_made_larger_by_hand(tab):
    before, page = tab.evaluate("JSON.stringify(studio.model.document.obstacles)"), tab.page
    tab.press("s")
    tab.seek(1.62)
    tab.press("2")
    tab.changes(page.get_by_role("button", name="+ box").click)
    page.get_by_role("button", name="box", exact=True).click()
    tab.shown()
    box = tab.evaluate("studio.model.document.obstacles.at(-1)")
    top = tab.evaluate("studio.handles.places()")[4]
    tab.changes(lambda: tab.drag((top[0], top[1]), (top[0], top[1] - 30)))
    now = tab.evaluate("studio.model.document.obstacles.at(-1)")
    grown = now["size"][2] - box["size"][2]
    assert grown > 0.05
    assert now["size"][:2] == box["size"][:2]
    assert now["position"] == pytest.approx([*box["position"][:2], box["position"][2] + grown / 2], abs=2e-3)
    assert page.locator("#panel-scene").get_by_label("box size z [m]").input_value() == str(now["size"][2])
    tab.changes(lambda: tab.press("Control+z"))
    assert tab.evaluate("studio.model.document.obstacles.at(-1)") == box
    tab.changes(lambda: tab.press("Control+z"))
    assert tab.evaluate("JSON.stringify(studio.model.document.obstacles)") == before
    tab.press("Escape")


def ring(tab):
    """[px] where a ring about the chosen joint can be taken."""
    tab.shown()
    tab.until("studio.gizmo.controls.object !== undefined")
    x, y = tab.evaluate(
        """(() => { const b = studio.stage.canvas.getBoundingClientRect(), p = studio.gizmo.handle.position.clone();
        p.project(studio.stage.camera);
        return [b.left + (p.x + 1) / 2 * b.width, b.top + (1 - p.y) / 2 * b.height]; })()"""
    )
    for away in range(12, 60):
        tab.page.mouse.move(x + away, y)
        if tab.evaluate("studio.gizmo.controls.axis") in ("X", "Y", "Z", "E"):
            return x + away, y
    raise AssertionError("no ring there")


def test_a_turn_is_let_go_by_escape_and_the_camera_and_the_next_one_go_on(tab):
    tab.seek(0.26)
    tab.press("2")
    choose = "void (studio.model.joint = 'left_knee', studio.model.tell('joint'))"
    tab.evaluate(choose)
    x, y = ring(tab)
    tab.page.mouse.down()
    tab.page.mouse.move(x, y - 30, steps=4)
    tab.until("studio.stage.override !== null")
    before = tab.revision
    tab.press("Escape")
    tab.page.mouse.up()
    tab.until("studio.stage.override === null && studio.stage.orbit.enabled")
    assert tab.revision == before
    tab.evaluate(choose)
    x, y = ring(tab)
    tab.changes(lambda: tab.drag((x, y), (x, y - 30)))
    tab.changes(lambda: tab.press("Control+z"))
    tab.press("Escape")


def test_arrows_go_when_what_they_move_is_gone(tab):
    tab.press("s")
    tab.changes(tab.page.get_by_role("button", name="+ capsule").click)
    tab.evaluate("void (studio.model.obstacle = {kind: 'capsule', index: 0}, studio.model.tell('joint'))")
    tab.until("studio.gizmo.controls.object !== undefined")
    tab.changes(lambda: tab.press("Control+z"))
    tab.until("studio.model.obstacle === null && studio.gizmo.controls.object === undefined")
    tab.press("p")


FAILING = """void (sockets.at(-1).send = function(text) {
  WebSocket.prototype.send.call(this, text.includes('"do":"drag"') ? text.replace("position", "nowhere") : text); })"""


def test_a_partial_keyframe_specifies_only_the_dragged_limb(tab):
    tab.press("n")
    tab.seek(1.0)
    tab.press("3")
    tab.shown()
    x, y = tab.grip("left_forearm")
    tab.evaluate(FAILING)
    tab.drag((x, y), (x + 12, y - 12))
    tab.until("document.getElementById('toast').textContent.includes('invalid request')")
    tab.until("!studio.hands.busy && studio.stage.override === null && studio.stage.orbit.enabled")
    assert tab.evaluate("delete sockets.at(-1).send")
    tab.changes(lambda: tab.drag((x, y), (x + 12, y - 12)))
    (key,) = [key for key in tab.evaluate("studio.model.document.keys") if abs(key["time"] - 1.0) < 1e-6]
    assert set(key["joints"]) == {"left_shoulder", "left_elbow"}
    assert "root" not in key
    assert key["others"] == "free"
    tab.changes(lambda: tab.press("Control+z"))
    tab.shown()
    x, y = tab.grip("left_forearm")
    tab.drag((x, y), (x + 12, y - 12))
    tab.drag((x + 12, y - 12), (x + 24, y - 24))  # the studio need not have answered to the first
    tab.until("studio.model.document.undo === 'pose the figure'")
    tab.changes(lambda: tab.press("Control+z"))
    tab.changes(lambda: tab.press("Control+z"))
    assert tab.evaluate("studio.model.document.undo") is None
    tab.press("n")


def test_a_grasp_is_drawn_for_the_hand_of_the_arm_that_is_chosen(tab):
    page = tab.page
    assert page.locator("[data-hand]").count() == 0
    tab.evaluate("void (studio.model.joint = 'left_elbow', studio.model.tell('joint'))")
    row = page.locator("[data-hand='left_hand']")
    row.wait_for()
    row.scroll_into_view_if_needed()
    tab.drawn()
    box = row.bounding_box()
    at = [tab.on_timeline(t) for t in (0.92, 1.15)]
    tab.drag((at[0], box["y"] + 8), (at[1], box["y"] + 8))
    menu = page.locator("dialog.menu")
    menu.wait_for()
    names = menu.locator("button").all_inner_texts()
    assert not {"left_forearm", "left_upper_arm"} & set(names)
    tab.changes(menu.locator("button").first.click)
    (grasp,) = tab.evaluate("studio.model.document.grasps")
    assert (grasp["hand"], grasp["body"]) == ("left_hand", names[0])
    assert (grasp["from"], grasp["to"]) == (pytest.approx(0.92, abs=0.04), pytest.approx(1.15, abs=0.04))
    tab.changes(lambda: tab.press("Control+z"))
    tab.press("Escape")
    page.locator("[data-hand]").first.wait_for(state="detached")


def test_it_fits_windows_of_any_size(tab):
    for width, height in ((1280, 800), (2560, 1440), (420, 800), (900, 600)):
        tab.page.set_viewport_size({"width": width, "height": height})
        assert tab.evaluate("document.documentElement.scrollWidth") <= width
        assert tab.page.locator("#play").is_visible()


def test_words_stand_out_from_what_is_behind_them_dark_and_light(tab):
    """WCAG's AA: 4.5 : 1 between the colours of text and of what it stands on, 3 : 1 of marks."""
    for _ in range(2):
        tab.page.locator("#theme").click()
        for low in ("panel", "raised", "back"):
            for high in ("ink", "soft", "accent", "key", "bad", "good"):
                assert tab.evaluate(contrast(f"--{high}", f"--{low}")) >= (4.5 if high in ("ink", "soft") else 3.0), (
                    high
                )
        assert tab.evaluate(contrast("--on-accent", "--accent")) >= 4.5


def test_a_robot_crouches_and_reaches_in_two_drags(browser, tmp_path):
    (tmp_path / "android.xml").write_text(figures.ANDROID)
    text = starter(str(tmp_path / "android.xml"), tmp_path / "robot.toml")
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    with browsers.studio(tmp_path, "robot.toml") as studio:
        tab = Tab(browser, studio.address)
        middle = tab.evaluate("0.5 * (studio.model.first + studio.model.last)")
        hand, pelvis = (
            "left_wrist_roll_link",
            tab.evaluate("studio.model.stage.bodies[studio.model.stage.joints[0].body]"),
        )
        place = "studio.stage.placeOf(studio.model.stage.bodies.indexOf('{}'), [0, 0, 0]).toArray()"
        tab.seek(middle)
        tab.press("3")
        tab.shown()
        low, far = tab.evaluate(place.format(pelvis)), tab.evaluate(place.format(hand))
        x, y = tab.grip(pelvis)
        down = tab.on_screen_at([low[0], low[1], low[2] - 0.12])[1] - tab.on_screen(pelvis)[1]
        tab.changes(lambda: tab.drag((x, y), (x, y + down)))
        tab.shown()
        x, y = tab.grip(hand)
        tab.changes(lambda: tab.drag((x, y), (x - 1.5 * down, y - 0.5 * down)))
        tab.settled()
        tab.seek(middle)
        assert tab.evaluate(place.format(pelvis))[2] < low[2] - 0.04
        assert tab.evaluate(place.format(hand))[0] > far[0] + 0.08
        found = tab.evaluate("studio.model.violations")
        # keyframe 3 is like the one before, with a leg stretched
        assert [each for each in found if each["kind"] == "penetration" and each["keyframe"] != 3] == []
        tab.page.close()


def contrast(high: str, low: str) -> str:
    return f"""(() => {{ const s = getComputedStyle(document.documentElement);
      const l = (name) => {{ const hex = s.getPropertyValue(name).trim().slice(1);
        const c = [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)
          .map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }};
      const [a, b] = [l('{high}'), l('{low}')].sort((x, y) => y - x); return (a + 0.05) / (b + 0.05); }})()"""
