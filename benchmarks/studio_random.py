"""Random work of a person in the studio, in a browser: what is lost, refused without words, or kept in memory.

python benchmarks/studio_random.py --minutes 30 --seed 1
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import argparse
import json
import re
import shutil
import subprocess
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from bench import dynsplines, peer

from dynsplines import models

FLAGS = [
    "--no-sandbox",
    "--disable-gpu-compositing",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
]
SIZE = {"width": 900, "height": 700}
READY = "window.studio !== undefined && [studio.model.stage, studio.model.now, studio.model.document].every(Boolean)"
SETTLED = "['settled', 'refused'].includes(studio.model.status.state)"
QUIET = "unanswered.size === 0 && studio.pending.size === 0 && !studio.hands.busy"
LISTEN = """window.unanswered = new Set(), window.refusals = [];
window.WebSocket = class extends WebSocket {
  constructor(...all) {
    super(...all);
    this.addEventListener('close', () => unanswered.clear());
    this.addEventListener('message', ({ data }) => {
      if (typeof data !== 'string' || !/^{"is": "(answer|refused|gone)"/.test(data)) return;
      const message = JSON.parse(data);
      unanswered.delete(message.id);
      if (!(message.ok ?? false)) refusals.push(message.words ?? '');
    });
  }
  send(text) { unanswered.add(JSON.parse(text).id); super.send(text); }
}"""
PLACE = """(body) => { const { stage, model } = studio, box = stage.canvas.getBoundingClientRect();
  const at = stage.placeOf(body, [0, 0, 0]).project(stage.camera);
  return [box.left + (at.x + 1) / 2 * box.width, box.top + (1 - at.y) / 2 * box.height]; }"""
HIT = "([clientX, clientY]) => studio.hands.hit({ clientX, clientY })?.body ?? null"
FIELDS = """async () => {
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))); // of the present panel
  return [...document.querySelectorAll('aside input.number')].filter((each) => each.offsetParent)
    .map((each) => each.getAttribute('aria-label'));
}"""
FIRST_VIEW = """() => {
  for (const menu of ['which', 'ghosts']) {
    document.getElementById(menu).selectedIndex = 0;
    document.getElementById(menu).dispatchEvent(new Event('change'));
  }
  for (const box of document.querySelectorAll('#trails:checked')) box.click();
  if (!document.getElementById('curves').hidden) document.getElementById('show-curves').click();
}"""
NOTHING_MOVED = "document.getElementById('toast').textContent.startsWith('nothing has moved')"
IMAGES_PER_PIXEL = "studio.model.fps * (studio.timeline.end - studio.timeline.begin) / studio.timeline.width"
VALUE = '(label) => document.querySelector(`aside input.number[aria-label="${label}"]`)?.value ?? null'
KEPT = "JSON.stringify(({ revision, undo, redo, is, ...rest } = studio.model.document, rest))"
WORDS = re.compile(r"Traceback|internal error|Error\b|undefined|\[object|the request failed")
KEYS = (
    *("Space", "ArrowLeft", "ArrowRight", "PageUp", "PageDown", "Home", "End", "Control+Home", "Control+End", "Escape"),
    *("Delete", "Alt+ArrowLeft", "Alt+ArrowRight", "Alt+ArrowUp", "Alt+ArrowDown"),
    *("Control+a", "Control+c", "Control+v", "Control+d", *"lf1234560bhtcuz[]knmgpowsjrx"),
)


def until(page: Any, condition: str, seconds: float = 120.0) -> None:
    """Wait for a condition of the page."""
    end = time.monotonic() + seconds
    while not page.evaluate(condition):
        if time.monotonic() > end:
            raise TimeoutError(f"{condition}; {page.evaluate('JSON.stringify(studio.model.status)')}")
        time.sleep(0.01)


@contextmanager
def served(folder: Path) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """The command on a clip in a folder."""
    file = folder / "run.toml"
    if not file.exists():
        file.write_text(models.clip_text("run_and_step"), encoding="utf-8")
    command = dynsplines("studio", "run.toml", "--no-browser")
    running = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    assert running.stdout is not None
    try:
        yield running, running.stdout.readline().strip()
    finally:
        running.terminate()
        running.wait(20)


def memory(running: subprocess.Popen[str], page: Any) -> tuple[float, float, float]:
    """[MB] of the server, the solver, and what the page's program holds."""
    psutil = peer("psutil")
    assert psutil is not None
    server = psutil.Process(running.pid)
    solvers = [child for child in server.children() if "spawn_main" in " ".join(child.cmdline())]
    session = page.context.new_cdp_session(page)
    session.send("HeapProfiler.collectGarbage")
    heap = session.send("Runtime.getHeapUsage")["usedSize"]
    session.detach()
    return server.memory_info().rss / 1e6, sum(s.memory_info().rss for s in solvers) / 1e6, heap / 1e6


def growth(values: list[float]) -> float:
    """By which share the mean of the last quarter is above that of the first, the first eighth left out to warm up."""
    warm = values[len(values) // 8 :]
    quarter = max(1, len(warm) // 4)
    first, last = sum(warm[:quarter]) / quarter, sum(warm[-quarter:]) / quarter
    return last / first - 1


@dataclass
class Result:
    """What random work has shown: numbers of deeds by name, faults in words, and memory [MB] after every round."""

    deeds: Counter[str] = field(default_factory=Counter)
    refused: int = 0
    faults: list[str] = field(default_factory=list)
    memory: list[tuple[float, float, float]] = field(default_factory=list)


class Person:
    """Random deeds on a page by mouse and keyboard."""

    def __init__(self, page: Any, folder: Path, seed: int, result: Result) -> None:
        self.page, self.folder, self.result = page, folder, result
        self.random = np.random.default_rng(seed)
        playwright = peer("playwright.sync_api")
        assert playwright is not None
        self.errors = playwright.Error, TimeoutError
        self.deeds: dict[Callable[[], str | None], float] = {
            self.press_key: 20, self.drag_body: 12, self.type_number: 12, self.press_arrows: 5, self.undo: 8,
            self.redo: 4, self.drag_diamond: 6, self.click_timeline: 6, self.draw_bar: 3, self.drag_bar: 2,
            self.click_stage: 5, self.open_menu: 4, self.save: 2, self.change_file: 1, self.reload: 1, self.pose: 3,
            self.edit_scene: 2, self.choose: 3, self.type_nonsense: 1, self.drag_ring: 2,
        }  # fmt: skip
        page.on("pageerror", lambda error: result.faults.append(f"page error: {error}"))
        page.on("console", lambda m: result.faults.append(f"console: {m.text}") if m.type == "error" else None)

    def act(self) -> None:
        """Do something, and report what has been lost."""
        weights = np.array(list(self.deeds.values()))
        deed = list(self.deeds)[self.random.choice(len(weights), p=weights / weights.sum())]
        name, before = deed.__name__, self.page.evaluate("refusals.length")
        self.result.deeds[name] += 1
        try:
            fault = deed()
        except self.errors as error:
            fault = " ".join(str(error).split())[:300]
        if self.random.random() < 0.8 or fault is not None:
            self.quiet()
        self.dismiss()
        refusals = self.page.evaluate(f"refusals.slice({before if before <= self.refusals() else 0})")
        self.result.refused += len(refusals)
        self.result.faults += [f"{name}: refused: {words!r}" for words in refusals if not words or WORDS.search(words)]
        if fault is not None and not refusals:
            self.result.faults.append(f"{name}: {fault}; {self.state()}")

    def refusals(self) -> int:
        return int(self.page.evaluate("refusals.length"))

    def state(self) -> str:
        toast = self.page.evaluate("document.getElementById('toast').textContent")
        return f"{toast!r} at {self.page.evaluate('studio.model.time'):.3f} s, revision {self.revision}"

    def quiet(self) -> None:
        until(self.page, QUIET)

    @property
    def revision(self) -> int:
        return int(self.page.evaluate("studio.model.document.revision"))

    def integer(self, low: int, high: int) -> int:
        return int(self.random.integers(low, high))

    def one_of(self, entries: Any) -> Any:
        return entries[self.integer(0, len(entries))]

    def drag(self, begin: tuple[float, float], end: tuple[float, float], holds: str = "true") -> bool:
        """Drag the mouse, unless what it should hold has moved away meanwhile; return whether it holds it."""
        mouse = self.page.mouse
        mouse.move(*begin)
        mouse.down()
        is_held = bool(self.page.evaluate(holds))
        for share in np.linspace(0, 1, self.integer(3, 9))[1:]:
            mouse.move(*(begin[k] + share * (end[k] - begin[k]) for k in (0, 1)))
            time.sleep(0.015)
        mouse.up()
        return is_held

    def until_changed(self, before: int, what: str) -> str | None:
        """Wait for an edit; its name if it has changed nothing."""
        self.quiet()
        return None if self.revision != before else what

    # ---- deeds: each returns what was lost, unless it is refused in words

    def press_key(self) -> None:
        self.page.keyboard.press(self.one_of(KEYS))

    def undo(self) -> str | None:
        self.quiet()
        before, step = self.revision, self.page.evaluate("studio.model.document.undo")
        self.page.keyboard.press("Control+z")
        return self.until_changed(before, f"undo of {step!r} changed nothing") if step else None

    def redo(self) -> str | None:
        self.quiet()
        before, step = self.revision, self.page.evaluate("studio.model.document.redo")
        self.page.keyboard.press("Control+Shift+z")
        return self.until_changed(before, f"redo of {step!r} changed nothing") if step else None

    def drag_body(self) -> str | None:
        self.quiet()
        body = self.integer(1, self.page.evaluate("studio.model.stage.bodies.length"))
        place = self.page.evaluate(PLACE, body)
        if not self.on_stage(place) or self.page.evaluate(HIT, place) is None:
            return None
        before, modifier = self.revision, self.one_of([None, None, None, "Alt", "Control"])
        self.page.mouse.move(*place)
        if self.page.evaluate("studio.stage.canvas.dataset.gizmo === 'on'"):
            return None
        if modifier:
            self.page.keyboard.down(modifier)
        by = self.random.normal(scale=40, size=2)
        is_held = self.drag(place, (place[0] + by[0], place[1] + by[1]), "studio.hands.busy")
        if modifier:
            self.page.keyboard.up(modifier)
        if not is_held or np.hypot(*by) < 8 or self.random.random() < 0.3:
            return None
        fault = self.until_changed(before, f"a drag of body {body} by {by.round()} px with {modifier} changed nothing")
        return None if self.page.evaluate(NOTHING_MOVED) else fault

    def on_stage(self, place: list[float]) -> bool:
        return bool(self.page.evaluate("([x, y]) => document.elementFromPoint(x, y)?.id === 'view'", place))

    def type_number(self) -> str | None:
        self.quiet()
        fields = self.page.evaluate(FIELDS)
        if not fields:
            return None
        label = self.one_of(fields)
        old = float(self.page.evaluate(VALUE, label) or "nan")
        new = round(old + float(self.random.normal(scale=0.02 if "[m]" in label or "[s]" in label else 6)), 3)
        if "weight" in label or "tolerance" in label:
            new = abs(new)
        element = self.page.locator(f'aside input.number[aria-label="{label}"]')
        element.fill(f"{new:g}")
        self.page.keyboard.press(self.one_of(["Enter", "Tab"]))
        self.quiet()
        value = self.page.evaluate(VALUE, label)
        digits = 0.051 if "degrees" in label else 2e-3
        if value is None or "time" in label or "weight" in label or not np.isfinite(old):
            return None
        is_whole_turn = "degrees" in label and abs(float(value) - new) > 90
        return None if abs(float(value) - new) <= digits or is_whole_turn else f"{label}: typed {new:g}, shows {value}"

    def press_arrows(self) -> str | None:
        self.quiet()
        fields = [entry for entry in self.page.evaluate(FIELDS) if "degrees" in entry]
        if not fields:
            return None
        label, count = self.one_of(fields), self.integer(2, 40)
        element = self.page.locator(f'aside input.number[aria-label="{label}"]')
        element.focus()
        begin, key = float(element.input_value()), self.one_of(["ArrowUp", "ArrowDown"])
        for _ in range(count):
            self.page.keyboard.press(key)
            time.sleep(0.02)
        end = begin + (count if key == "ArrowUp" else -count)
        shown = float(element.input_value())
        self.quiet()
        later = float(self.page.evaluate(VALUE, label) or "nan")
        self.page.keyboard.press("Escape")
        is_whole_turn = abs(end) > 120 or abs(later - end) > 180
        if abs(shown - end) > 0.06:
            return f"{label}: {count} presses from {begin:g} show {shown:g}"
        return (
            None
            if abs(later - end) < 0.11 or is_whole_turn
            else f"{label}: {count} presses from {begin:g} end at {later:g}"
        )

    def type_nonsense(self) -> None:
        self.quiet()
        fields = self.page.evaluate(FIELDS)
        if not fields:
            return
        label = self.one_of(fields)
        element = self.page.locator(f'aside input.number[aria-label="{label}"]')
        element.fill(self.one_of(["", "a lot", "1e99", "--3", "NaN", "9" * 40]))
        self.page.keyboard.press("Enter")
        self.quiet()

    def diamonds(self) -> list[dict[str, float]]:
        return list(self.page.evaluate(
            """() => [...document.querySelectorAll('#timeline .keys .diamond')].map((each) => {
            const { x, y, width, height } = each.getBoundingClientRect();
            return { x: x + width / 2, y: y + height / 2 }; })"""
        ))  # fmt: skip

    def drag_diamond(self) -> str | None:
        self.quiet()
        diamonds = self.diamonds()
        if not diamonds:
            return None
        at, before = self.one_of(diamonds), self.revision
        if self.random.random() < 0.15:  # to the poses, and then not saved
            panel = self.page.locator("aside").bounding_box()
            self.drag((at["x"], at["y"]), (panel["x"] + 100, panel["y"] + 200))
            self.dismiss()
            return None
        by = float(self.random.normal(scale=40))
        self.drag((at["x"], at["y"]), (at["x"] + by, at["y"] + 3))
        self.quiet()
        is_short = abs(by) < max(25, 2 / self.page.evaluate(IMAGES_PER_PIXEL))
        if is_short or (by < 0 and self.page.evaluate("studio.model.time") == 0):
            return None
        return self.until_changed(before, f"a diamond dragged by {by:.0f} px stayed")

    def dismiss(self) -> None:
        if self.page.evaluate("document.querySelector('dialog[open]') !== null"):
            self.page.keyboard.press("Escape")
        until(self.page, "document.querySelector('dialog') === null")

    def click_timeline(self) -> None:
        box = self.page.locator("#timeline").bounding_box()
        modifiers = self.one_of([[], [], ["Shift"], ["Control"]])
        for key in modifiers:
            self.page.keyboard.down(key)
        self.page.mouse.click(
            box["x"] + 200 + self.random.random() * (box["width"] - 230), box["y"] + self.one_of([10, 40])
        )
        for key in modifiers:
            self.page.keyboard.up(key)

    def rows(self) -> list[list[float]]:
        return list(self.page.evaluate(
            """() => [...document.querySelectorAll('#timeline [data-point], #timeline [data-hand]')].map((each) => {
            const { x, y, width, height } = each.getBoundingClientRect(); return [x, y, width, height]; })
            .filter(([, y]) => y < innerHeight - 20)"""
        ))  # fmt: skip

    def draw_bar(self) -> None:
        rows = self.rows()
        if not rows:
            return
        x, y, width, height = self.one_of(rows)
        begin = x + 200 + self.random.random() * (width - 300)
        self.drag((begin, y + height / 2), (begin + float(self.random.normal(scale=120)), y + height / 2))
        self.quiet()
        if self.page.evaluate("document.querySelector('dialog.menu') !== null"):
            self.page.locator("dialog.menu button").first.click()

    def drag_bar(self) -> None:
        bars = self.page.evaluate(
            """() => [...document.querySelectorAll('#timeline [data-bar]')].map((each) => {
            const { x, y, width, height } = each.getBoundingClientRect(); return [x, y + height / 2, width]; })
            .filter(([, y]) => y < innerHeight - 10)"""
        )
        if bars:
            x, y, width = self.one_of(bars)
            begin = x + self.one_of([3, width / 2, width - 3])
            self.drag((begin, y), (begin + float(self.random.normal(scale=60)), y))

    def somewhere(self) -> tuple[float, float]:
        box = self.page.locator("#view").bounding_box()
        along, down = 0.2 + 0.6 * self.random.random(), 0.1 + 0.8 * self.random.random()
        return box["x"] + along * box["width"], box["y"] + down * box["height"]

    def click_stage(self) -> None:
        self.page.mouse.click(*self.somewhere())

    def drag_ring(self) -> None:
        place = self.somewhere()
        self.drag(place, (place[0] + float(self.random.normal(scale=60)), place[1]))

    def open_menu(self) -> None:
        self.quiet()
        place = self.page.evaluate(PLACE, self.integer(1, self.page.evaluate("studio.model.stage.bodies.length")))
        if not self.on_stage(place):
            return
        self.page.mouse.click(*place, button="right")
        entries = self.page.locator("dialog.menu button")
        if entries.count() and self.random.random() < 0.8:
            entries.nth(self.integer(0, entries.count())).click()
        else:
            self.dismiss()

    def save(self) -> str | None:
        self.quiet()
        self.page.keyboard.press("Control+s")
        self.quiet()
        is_dirty, before = self.page.evaluate("studio.model.document.dirty"), self.refusals()
        return "saved, and is dirty" if is_dirty and not before else None

    def change_file(self) -> str | None:
        """As another program does; the page notices, and reloads it or keeps its own."""
        self.quiet()
        file = self.folder / "run.toml"
        text = models.clip_text("run_and_step").replace("fps = 30", f"fps = {self.integer(24, 61)}")
        file.write_text(self.one_of([f"{text}# {time.time()}\n", f"broken = [ # {time.time()}\n"]), encoding="utf-8")
        until(self.page, "!document.getElementById('outside').hidden")
        reload = self.page.locator("#outside-reload")
        (reload if reload.is_visible() and self.random.random() < 0.5 else self.page.locator("#outside-keep")).click()
        until(self.page, "document.getElementById('outside').hidden")
        return None

    def reload(self) -> str | None:
        self.quiet()
        before = self.page.evaluate(KEPT)
        self.page.reload()
        until(self.page, READY)
        self.quiet()
        after = self.page.evaluate(KEPT)
        return None if before == after else f"another clip after a reload: {_difference(before, after)}"

    def pose(self) -> str | None:
        self.quiet()
        self.page.locator("#tab-pose").click()
        buttons = self.page.locator("#panel-pose button.pose")
        names = buttons.count()
        if names < 4 and self.random.random() < 0.5:
            self.page.get_by_role("button", name="save pose").click()
            name = f"pose {self.integer(0, 10**6)}"
            self.page.get_by_label("name of the pose").fill(name)
            self.page.keyboard.press("Enter")
            until(self.page, f"studio.model.poses.includes({name!r})")
            until(self.page, "document.querySelector('dialog') === null")
            return None
        buttons.nth(self.integer(0, names)).click()
        self.quiet()
        return None

    def edit_scene(self) -> str | None:
        self.quiet()
        self.page.locator("#tab-scene").click()
        before = self.revision
        delete = self.page.locator("#panel-scene button.axis")
        if delete.count() > 2:
            delete.nth(self.integer(0, delete.count())).click()
        else:
            add = self.page.locator("#panel-scene .buttons button:enabled")
            add.first.wait_for()
            add.nth(self.integer(0, add.count())).click()
        return self.until_changed(before, "an obstacle was neither added nor deleted")

    def choose(self) -> None:
        """An entry of a menu of the page, or a box that is ticked."""
        selector = self.one_of(["#which", "#views", "#speed", "#ghosts", "select.mode", "#trails", "#loop", "#follow"])
        element = self.page.locator(selector)
        visible = [i for i in range(element.count()) if element.nth(i).is_visible()]
        if not visible:
            return
        one = element.nth(self.one_of(visible))
        if selector in ("#trails", "#loop", "#follow"):
            one.click()
        else:
            values = one.locator("option:not([hidden])").evaluate_all("(all) => all.map((each) => each.value)")
            one.select_option(self.one_of(values))
            one.evaluate("(each) => each.blur()")


def _difference(before: str, after: str) -> str:
    old, new = json.loads(before), json.loads(after)
    return "; ".join(f"{key}: {old[key]!s:.200} -> {new.get(key)!s:.200}" for key in old if old[key] != new.get(key))


def restored(page: Any, folder: Path) -> None:
    """The initial clip, by its file, in the initial view; what has been undone is forgotten."""
    file = folder / "run.toml"
    page.keyboard.press("Escape")
    until(page, QUIET)
    file.write_text(f"{models.clip_text('run_and_step')}# {time.time()}\n", encoding="utf-8")
    until(page, "!document.getElementById('outside').hidden")
    page.locator("#outside-reload").click()
    until(page, "document.getElementById('outside').hidden")
    if not page.evaluate("studio.model.status.go"):
        page.keyboard.press("g")
    page.evaluate("void (studio.model.playing = false, document.activeElement?.blur())")
    page.evaluate(FIRST_VIEW)
    until(page, QUIET)
    until(page, SETTLED)
    for pose in (folder / "poses").glob("*.toml"):
        pose.unlink()


def work(browser: Any, folder: Path, minutes: float, seed: int, report: Callable[[str], object] = print) -> Result:
    """Random work for so long; memory is measured every minute, with the initial clip."""
    result = Result()
    with served(folder) as (running, address):
        page = browser.new_page(viewport=SIZE)
        page.set_default_timeout(60000)
        page.add_init_script(LISTEN)
        page.goto(address)
        until(page, READY)
        person = Person(page, folder, seed, result)
        end = time.monotonic() + 60 * minutes
        while time.monotonic() < end:
            round_end, reported = min(end, time.monotonic() + 60), len(result.faults)
            while time.monotonic() < round_end:
                person.act()
                for fault in result.faults[reported:]:
                    report(f"fault: {fault}")
                reported = len(result.faults)
            restored(page, folder)
            result.memory.append(memory(running, page))
            sizes = " ".join(f"{size:.1f}" for size in result.memory[-1])
            report(f"{result.deeds.total()} deeds, {result.refused} refused, {len(result.faults)} faults; {sizes} MB")
        page.close()
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=30)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play, tempfile.TemporaryDirectory() as name:
        browser = play.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        result = work(browser, Path(name), options.minutes, options.seed, lambda line: print(line, flush=True))
        browser.close()
    print(dict(result.deeds.most_common()))
    for i, who in enumerate(("server", "solver", "page")):
        print(f"{who}: {100 * growth([row[i] for row in result.memory]):+.1f} %")
    print(f"{result.deeds.total()} deeds, {result.refused} refused in words, {len(result.faults)} faults")
    raise SystemExit(1 if result.faults else 0)


if __name__ == "__main__":
    main()
