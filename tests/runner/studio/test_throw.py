"""An animator's job in a browser, by mouse and keyboard: from an empty clip to a throw with a step on to a box."""

import os
from time import monotonic

import browser as browsers
import numpy as np
from browser import Tab
from texts import read_data

pytestmark = browsers.MARKS

MOST_EDITS = 18
MOST_SECONDS = 420
THINKING = 15  # [s] that a person looks and thinks before an edit
HAND = (0.0, 0.0, -0.31)  # [m] in the axes of a forearm
PATH = "(({ position, rotation }) => [...position, ...rotation])(studio.model.now)"


class Animator:
    """What an animator does on a page, and how many edits and undos it takes."""

    def __init__(self, tab: Tab) -> None:
        self.tab, self.page, self.edits = tab, tab.page, 0

    def edit(self, deed) -> None:
        before = self.tab.revision
        self.tab.changes(deed)
        self.edits += self.tab.revision - before
        self.tab.shown()

    def look(self, key: str) -> None:
        self.tab.press(key)
        self.tab.shown()

    def seek(self, time: float) -> None:
        """Click on the ruler, after zooming out until the time is on it."""
        while self.tab.evaluate("studio.timeline.end") < time + 0.1:
            self.tab.press("[")
            self.tab.drawn()
        box = self.page.locator(".ruler").bounding_box()
        self.page.mouse.click(self.tab.on_timeline(time), box["y"] + 8)
        self.tab.shown()

    def type(self, label: str, value: float) -> None:
        field = self.page.get_by_label(label, exact=True)
        field.fill(str(value))
        self.edit(lambda: field.press("Enter"))

    def pull(self, body: str, offset=(0.0, 0.0, 0.0), **place: float) -> None:
        """Drag a point of a body in the plane of the view; `place` are its new coordinates in the world [m]."""
        at = f"studio.stage.placeOf(studio.model.stage.bodies.indexOf('{body}'), {list(offset)}).toArray()"
        self.tab.until(lambda: self.tab.seen(body, offset) is not None)
        begin, here = self.tab.seen(body, offset), self.tab.evaluate(at)
        there = [place.get(axis, value) for axis, value in zip("xyz", here, strict=True)]
        by = np.subtract(self.tab.on_screen_at(there), self.tab.on_screen(body, offset))
        assert begin is not None
        end = begin[0] + by[0], begin[1] + by[1]
        self.edit(lambda: self.tab.drag(begin, end, steps=12))

    def choose(self, entry: str) -> None:
        self.page.locator("#files").click()
        self.page.get_by_role("menuitem", name=entry).click()


def throw(animator: Animator) -> None:
    """Pose a throw with a step on to a box of 20 cm."""
    page, pull = animator.page, animator.pull
    page.locator("#tab-scene").click()
    animator.edit(page.get_by_role("button", name="+ box").click)
    animator.type("box 1 size z [m]", 0.2)
    animator.tab.press("p")
    animator.look("2")
    page.locator("[data-id='key1']").click()  # wound up
    pull("right_forearm", HAND, x=-0.3, z=1.45)
    animator.type("spine z [degrees]", -35)
    pull("left_forearm", HAND, x=0.45, z=1.35)
    pull("pelvis", x=-0.07, z=0.9)
    animator.seek(0.93)  # the left foot on the box
    pull("left_foot", x=0.78, z=0.285)
    animator.seek(1.2)  # released
    animator.edit(lambda: animator.tab.press("k"))
    animator.type("spine z [degrees]", 25)
    pull("right_forearm", HAND, x=0.85, z=1.7)
    animator.seek(1.5)  # followed through
    pull("right_forearm", HAND, x=0.85, z=0.75)
    animator.look("4")
    pull("right_forearm", HAND, y=0.12, z=0.8)
    animator.look("2")
    animator.seek(2.1)  # standing on the box
    pull("right_foot", x=0.8, z=0.285)
    pull("pelvis", x=0.78, z=1.12)
    animator.look("4")
    pull("right_forearm", HAND, y=-0.25, z=1.05)
    pull("left_forearm", HAND, y=0.33, z=1.05)


def test_a_throw_is_posed_retimed_compared_saved_exported_and_opened_again(tmp_path):
    (tmp_path / "dancer.toml").write_text(read_data("dancer.toml"), encoding="utf-8")
    (tmp_path / "dancer.xml").write_text(read_data("dancer.xml"), encoding="utf-8")
    with browsers.opened() as browser:
        begin = monotonic()
        with browsers.studio(tmp_path, "dancer.toml") as studio:
            tab = Tab(browser, studio.address, 1280, 800)
            animator, page = Animator(tab), tab.page
            animator.choose("New")
            page.get_by_label("figure", exact=True).select_option("human")
            page.keyboard.press("Enter")
            tab.until("studio.model.document.name === 'human' && studio.model.loaded.keys.length === 2")
            tab.settled()
            throw(animator)
            tab.settled()
            page.get_by_label("displayed motion").select_option("take")
            diamond = tab.middle("[data-id='key5']")
            animator.edit(lambda: tab.drag(diamond, (tab.on_timeline(2.3), diamond[1])))
            page.get_by_label("displayed motion").select_option("snapshot")
            tab.settled()
            page.locator("#nothing-wrong").wait_for(state="attached")  # also in the panel that is not shown
            assert tab.evaluate("studio.model.violations") == []
            page.get_by_label("displayed motion").select_option("after")
            tab.press("Control+s")
            page.get_by_label("file name", exact=True).fill("throw.toml")
            page.keyboard.press("Enter")
            tab.until("studio.model.document.file === 'throw.toml' && !studio.model.document.dirty")
            animator.choose("Export")
            page.get_by_label("format", exact=True).select_option("bvh")
            page.keyboard.press("Enter")
            tab.until((tmp_path / "throw.bvh").is_file)
            tab.until("document.getElementById('task').hidden")
            before = np.array(tab.evaluate(PATH))
            steps = tab.evaluate("studio.model.document.undo")
            page.close()
            errors = tab.errors
        with browsers.studio(tmp_path, "throw.toml") as studio:
            again = Tab(browser, studio.address, 1280, 800)
            again.settled()
            after = np.array(again.evaluate(PATH))
            again.page.close()
    programs = max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))  # that share a processor
    seconds = (monotonic() - begin) / programs
    print(f"{animator.edits} edits, {seconds:.0f} s, {seconds + THINKING * animator.edits:.0f} s as a person")
    assert [*errors, *again.errors] == []
    assert steps == "move a keyframe"  # nothing was undone
    assert animator.edits <= MOST_EDITS
    assert seconds + THINKING * animator.edits <= MOST_SECONDS
    np.testing.assert_allclose(after, before, atol=1e-3)
