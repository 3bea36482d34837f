"""A browser without windows, and what a person does with it; tests that need it skip where there is none."""

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

GRAPHICS = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
FLAGS = ["--no-sandbox", "--disable-gpu-compositing", *GRAPHICS]  # only WebGL is drawn by the software GPU
SOCKETS = """window.sockets = [], window.WebSocket = class extends WebSocket {
  constructor(...all) { super(...all); sockets.push(this); } }"""
WATCH = """new Promise((done) => {{ const end = performance.now() + 1e3 * {seconds};
  const look = () => {{ const is = {condition}; is || performance.now() > end ? done(is) : setTimeout(look, 15); }};
  look(); }})"""
PATIENCE = 240.0  # [s] of a machine that may have much else to do
COMMAND = "import sys; from dynsplines.__main__ import main; sys.argv[0] = 'dynsplines'; main()"
MARKS = [
    pytest.mark.slow,
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
]


def chromium() -> str:
    """Debian's, or whatever is called so; skips the test where there is none."""
    pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    found = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if found is None:
        pytest.skip("no chromium on this machine")
    return found


@contextmanager
def opened() -> Iterator[Any]:
    """The browser."""
    from playwright.sync_api import sync_playwright

    where = chromium()
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=where, args=FLAGS)
        yield browser
        browser.close()


class Studio:
    """The command, running in a folder."""

    def __init__(self, folder: Path, *words: str) -> None:
        self.folder, self.words = folder, words
        command = [sys.executable, "-c", COMMAND, "studio", *words, "--no-browser"]
        environment = {**os.environ, "OMP_NUM_THREADS": "1"}
        self.process = subprocess.Popen(
            command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        assert self.process.stdout is not None
        self.address = self.process.stdout.readline().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/\?token=\S+", self.address), self.address

    def end(self, number: int = signal.SIGINT) -> str:
        """Stopped, as by Ctrl-C; what it says on its way."""
        if self.process.poll() is None:
            self.process.send_signal(number)
        try:
            _, said = self.process.communicate(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            _, said = self.process.communicate()
            raise
        return said


@contextmanager
def studio(folder: Path, *words: str) -> Iterator[Studio]:
    """The command, ended with the block."""
    running = Studio(folder, *words)
    try:
        yield running
    except BaseException as error:
        error.add_note(running.end())
        raise
    running.end()


class Tab:
    """A page of the studio, and what it asked for or complained of."""

    def __init__(self, browser: Any, address: str, width: int = 800, height: int = 600) -> None:
        self.page, self.folder = browser.new_page(viewport={"width": width, "height": height}), ""
        self.process: Any = None  # the command that serves the page
        self.page.set_default_timeout(1e3 * PATIENCE)
        self.errors: list[str] = []
        self.requested: list[str] = []
        self.page.on("request", lambda request: self.requested.append(request.url))
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("console", lambda message: self.errors.append(message.text) if message.type == "error" else None)
        self.page.add_init_script(SOCKETS)
        self.page.goto(address)
        self.begun()

    def begun(self) -> None:
        """Until the page shows the figure and the clip."""
        self.until("window.studio !== undefined && studio.model.stage !== null && studio.model.now !== null")
        self.until("studio.model.document !== null && studio.model.loaded !== null")

    def evaluate(self, what: str) -> Any:
        return self.page.evaluate(what)

    def until(self, condition: str | Callable[[], bool], seconds: float = PATIENCE) -> None:
        """Wait until a condition holds; the page itself looks at one that is given as text."""
        if not callable(condition):
            look = WATCH.format(condition=condition, seconds=seconds)
            assert self.evaluate(look), f"never: {condition}; {self.state()}"
            return
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, f"never: {condition}; {self.state()}"
            time.sleep(0.03)

    def state(self) -> str:
        return f"{self.evaluate('JSON.stringify(studio.model.status)')} {self.words()!r} {self.errors}"

    def settled(self, revision: int | None = None) -> None:
        """Until the search has come to its end."""
        at = "" if revision is None else f" && studio.model.document.revision === {revision}"
        self.until(f"studio.model.status.state === 'settled'{at}")

    @property
    def revision(self) -> int:
        return int(self.evaluate("studio.model.document.revision"))

    def changes(self, deed: Callable[[], object], seconds: float = PATIENCE) -> None:
        """Does something, and waits until the document has changed, its path is on the page and the timeline drawn."""
        before = self.revision
        deed()
        now = "studio.model.document.revision"
        self.until(f"{now} !== {before} && studio.model.loaded.revision === {now}", seconds)
        self.drawn()

    def drawn(self) -> None:
        """Until the page has drawn what it knows by now: rows of the timeline are made anew, once an image."""
        self.evaluate(
            """new Promise((done, fail) => {
              setTimeout(() => fail(new Error("nothing was drawn for 240 s")), 240000);
              requestAnimationFrame(() => requestAnimationFrame(() => done(null))); })"""
        )

    def press(self, keys: str) -> None:
        self.page.keyboard.press(keys)

    def seek(self, time: float) -> None:
        self.evaluate(f"studio.model.seek({time})")
        self.shown()

    def shown(self) -> None:
        """Until an image has been drawn since."""
        images = int(self.evaluate("(studio.stage.draw(), studio.stage.images)"))
        self.until(f"studio.stage.images > {images}")

    def words(self) -> str:
        return str(self.page.locator("#toast").inner_text())

    def on_screen(self, body: str, offset: tuple[float, float, float] = (0, 0, 0)) -> tuple[float, float]:
        """[px] where a point of a body is seen."""
        x, y = self.evaluate(
            f"""(() => {{ const s = studio.stage, i = studio.model.stage.bodies.indexOf('{body}');
            const p = s.placeOf(i, {list(offset)}).project(s.camera), b = s.canvas.getBoundingClientRect();
            return [b.left + (p.x + 1) / 2 * b.width, b.top + (1 - p.y) / 2 * b.height]; }})()"""
        )
        return float(x), float(y)

    def grip(self, body: str) -> tuple[float, float]:
        """[px] where a body is seen and can be taken hold of, as near to its origin as that is."""
        found = self.seen(body)
        assert found is not None, f"{body} is not seen"
        return found

    def seen(self, body: str, offset: tuple[float, float, float] = (0, 0, 0)) -> tuple[float, float] | None:
        """[px] where a body is seen and can be taken hold of near a point of it; None where it is not."""
        x, y = self.on_screen(body, offset)
        found = self.evaluate(
            f"""(() => {{ const s = studio.stage, body = studio.model.stage.bodies.indexOf('{body}'), near = [];
            for (let i = -40; i <= 40; i += 2) for (let j = -40; j <= 40; j += 2)
              near.push([{x} + i, {y} + j, i * i + j * j]);
            near.sort((a, b) => a[2] - b[2]);
            return near.find(([clientX, clientY]) => studio.hands.hit({{ clientX, clientY }})?.body === body); }})()"""
        )
        return None if found is None else (float(found[0]), float(found[1]))

    def on_screen_at(self, place: list[float]) -> tuple[float, float]:
        """[px] where a place in the world is seen."""
        x, y = self.evaluate(
            f"""(() => {{ const s = studio.stage, b = s.canvas.getBoundingClientRect();
            const p = s.placeOf(0, {place}).project(s.camera);
            return [b.left + (p.x + 1) / 2 * b.width, b.top + (1 - p.y) / 2 * b.height]; }})()"""
        )
        return float(x), float(y)

    def on_timeline(self, time: float) -> float:
        """[px] from the left, where a time is on the timeline."""
        return float(
            self.evaluate(
                f"document.getElementById('timeline').getBoundingClientRect().left + studio.timeline.x({time})"
            )
        )

    def middle(self, selector: str) -> tuple[float, float]:
        """[px] of an element's middle."""
        self.drawn()
        x, y, width, height = self.box(selector)
        return x + width / 2, y + height / 2

    def box(self, selector: str) -> list[float]:
        """[px] the left and upper edge of an element, its width and height; rows of the timeline may be made anew."""
        return self.page.evaluate(
            """(selector) => { const box = document.querySelector(selector).getBoundingClientRect();
            return [box.x, box.y, box.width, box.height]; }""",
            selector,
        )

    def drag(self, begin: tuple[float, float], end: tuple[float, float], steps: int = 6) -> None:
        mouse = self.page.mouse
        mouse.move(*begin)
        mouse.down()
        for i in range(1, steps + 1):
            share = i / steps
            mouse.move(begin[0] + share * (end[0] - begin[0]), begin[1] + share * (end[1] - begin[1]))
            time.sleep(0.03)
        mouse.up()
