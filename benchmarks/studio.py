"""The studio in a real browser without a GPU: how soon there is a figure, a posed one, a better path; what stays flat.

python benchmarks/studio.py --minutes 30     the long run of edits alone, with its memory
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import argparse
import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.resources import files
from pathlib import Path
from typing import Any

from bench import Effort, Section, Target, dynsplines, median, peer, worst

from dynsplines import models

FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
SIZE = {"width": 1280, "height": 800}
SEEN = "window.studio !== undefined && studio.model.stage !== null && studio.model.now !== null"
READY = f"{SEEN} && studio.model.document !== null"
SHOWN = f"{SEEN} && studio.stage.images > 0"
ROUND = "new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))"  # an image that was drawn is seen
SETTLED = "studio.model.status.state === 'settled'"
KEY = 4  # the keyframe that is edited
PULLS = 200  # poses of a drag
SHARES = (0.3, 0.8)  # of a loop of 16 by 20 cm that a drag goes: each ends elsewhere, or a path would be remembered
MINUTES = float(os.environ.get("STUDIO_MINUTES", "30"))  # of the long run, which is part of its results
DRAG = """async ([body, count, share]) => {
  const place = studio.stage.placeOf(body, [0, 0, 0]).toArray(), times = [], trips = [];
  await studio.ask('grip', { time: studio.model.time, body, offset: [0, 0, 0] });
  for (let i = 0; i < count; i++) {
    const a = 2 * Math.PI * share * i / count, asked = performance.now();
    const at = [place[0] + 0.08 * (Math.cos(a) - 1), place[1] + 0.05 * Math.sin(2 * a), place[2] + 0.1 * Math.sin(a)];
    const answer = await studio.ask('drag', { position: at });
    times.push(answer.ms);
    trips.push(performance.now() - asked);
  }
  return [times, trips];
}"""
RELEASE = """async ([name, entries]) => {
  const { model } = studio, began = performance.now(), seen = [];
  let heard = 0, first = null, done = false;
  model.on('path', () => {
    if (done || model.course?.kind !== 'best') return;
    heard += 1;
    seen.push(model.course.value);
    if (first === null) first = performance.now() - began;
  });
  const answer = await studio.ask(name, entries);
  if (!answer.ok) throw new Error(answer.words);
  const revision = model.document.revision;
  const isDone = () => model.status.state === 'settled' && model.loaded.revision === revision;
  while (!isDone()) await new Promise((r) => setTimeout(r, 5));
  done = true;
  return [first, performance.now() - began, heard];
}"""
PLAY = """async (seconds) => {
  const { model, stage } = studio;
  model.seek(0); model.playing = true; stage.draw();
  await new Promise((r) => setTimeout(r, 1500));
  stage.longest = 0;
  const paths = model.frames, images = stage.images, began = performance.now();
  let searching = 0, last = began;
  const change = (k) => studio.ask('edit', { name: 'change', at: ['solve'], entries: { tolerance: 1e-3 + 1e-6 * k } });
  let edits = 1;
  await change(edits);
  while (performance.now() - began < 1000 * seconds) {
    await new Promise((r) => setTimeout(r, 20));
    const now = performance.now();
    if (model.status.state === 'searching') searching += now - last;
    else if (model.status.state === 'settled') await change(edits += 1);
    last = now;
  }
  model.playing = false;
  return [(model.frames - paths) / Math.max(1e-3, searching / 1000), stage.longest,
          1000 * (stage.images - images) / (performance.now() - began)];
}"""


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


def until(page: Any, condition: str, seconds: float = 120.0) -> None:
    end = time.monotonic() + seconds
    while not page.evaluate(condition):
        if time.monotonic() > end:
            raise TimeoutError(condition)
        time.sleep(0.01)


def first_figure(browser: Any, folder: Path) -> float:
    """[s] from the command to a figure on the page."""
    begin = time.perf_counter()
    with served(folder) as (_, address):
        page = browser.new_page(viewport=SIZE)
        page.goto(address, wait_until="commit")
        until(page, SHOWN)
        page.evaluate(ROUND)
        spent = time.perf_counter() - begin
        page.close()
    return spent


def edits(page: Any, repeats: int, pulls: int) -> dict[str, list[float]]:
    """Poses of a drag, and the paths after it ends."""
    times_by_name: dict[str, list[float]] = {"server": [], "trip": [], "first": [], "converged": []}
    for i in range(repeats):
        page.evaluate(f"studio.model.seek(studio.model.document.keys[{KEY}].time)")
        body = page.evaluate("studio.model.stage.bodies.indexOf('left_foot')")
        share = SHARES[0] + (SHARES[1] - SHARES[0]) * i / max(1, repeats - 1)
        times, trips = page.evaluate(DRAG, [body, pulls, share])
        times_by_name["server"] += times
        times_by_name["trip"] += trips
        first, converged, _ = page.evaluate(RELEASE, ["drop", {"time": page.evaluate("studio.model.time")}])
        times_by_name["first"].append(first if first is not None else converged)
        times_by_name["converged"].append(converged)
        page.evaluate("studio.ask('undo')")
        time.sleep(0.2)
        until(page, SETTLED)
    return times_by_name


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


def long_run(browser: Any, folder: Path, minutes: float, report: Any) -> tuple[list[tuple[float, float, float]], int]:
    """Edits, undo, solves and saves for so long; memory after every round, and how many edits there were."""
    sizes: list[tuple[float, float, float]] = []
    count = 0
    with served(folder) as (running, address):
        page = browser.new_page(viewport=SIZE)
        page.goto(address)
        until(page, READY)
        until(page, SETTLED)
        end = time.monotonic() + 60 * minutes
        while time.monotonic() < end:
            time_of = page.evaluate(f"studio.model.document.keys[{KEY}].time")
            for request in (
                {"name": "move_keys", "moves": [[KEY, round(time_of + 0.01, 4)]]},
                {
                    "name": "change",
                    "at": ["keyframe", KEY],
                    "entries": {"joints": {"left_elbow": {"rotvec": [0, -70.5 - count % 7, 0]}}},
                },
                {"name": "set_weight", "kind": "torque", "weight": 1.4},
            ):
                answer = page.evaluate("(request) => studio.ask('edit', request)", request)
                assert answer["ok"], answer
                count += 1
            until(page, SETTLED)
            for _ in range(3):
                assert page.evaluate("studio.ask('undo')")["ok"]
            assert page.evaluate("studio.ask('save')")["ok"]
            until(page, SETTLED)
            assert (folder / "run.toml").read_text(encoding="utf-8") == models.clip_text("run_and_step")
            sizes.append(memory(running, page))
            report(f"{count} edits, server {sizes[-1][0]:.0f}, solver {sizes[-1][1]:.0f}, page {sizes[-1][2]:.1f} MB")
        page.close()
    return sizes, count


def growth(values: list[float]) -> float:
    """By which share the mean of the last quarter is above that of the first, the first eighth left out to warm up."""
    warm = values[len(values) // 8 :]
    quarter = max(1, len(warm) // 4)
    first, last = sum(warm[:quarter]) / quarter, sum(warm[-quarter:]) / quarter
    return last / first - 1


def measure(effort: Effort) -> Section:
    section = Section("The studio, in a browser without a GPU", ("what", "median", "worst", "unit"))
    playwright = peer("playwright.sync_api")
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    if playwright is None or chromium is None:
        section.notes.append("playwright or chromium is not installed: nothing was measured")
        return section
    with playwright.sync_playwright() as play, tempfile.TemporaryDirectory() as name:
        browser, folder = play.chromium.launch(executable_path=chromium, args=FLAGS), Path(name)
        effort.report("first figure")
        first_figure(browser, folder)
        starts = [first_figure(browser, folder) for _ in range(effort.repeats)]
        with served(folder) as (_, address):
            page = browser.new_page(viewport=SIZE)
            urls: list[str] = []
            page.on("request", lambda request: urls.append(request.url))
            page.goto(address)
            until(page, READY)
            until(page, SETTLED)
            effort.report("drags")
            times = edits(page, effort.repeats, effort.count(PULLS, 40))
            effort.report("playing")
            rate, gap, images = page.evaluate(PLAY, effort.count(15, 5))
            page.close()
        effort.report("a long run")
        minutes = effort.count(int(MINUTES), 1)
        grown, count = long_run(browser, folder, minutes, effort.report)
        browser.close()
    built = files("dynsplines.studio") / "built"
    size = sum(len((built / part).read_bytes()) for part in ("index.html", "studio.js", "studio.css"))
    outside = [url for url in urls if not re.match(r"(http://127\.0\.0\.1:|data:|blob:)", url)]
    section.add("from the command to a figure", median(starts), worst(starts), "s")
    section.add("a pose of a drag, the server's time", median(times["server"]), worst(times["server"]), "ms")
    section.add("a pose of a drag, there and back", median(times["trip"]), worst(times["trip"]), "ms")
    section.add("from letting go to a better path", median(times["first"]), worst(times["first"]), "ms")
    section.add("from letting go to the end of the search", median(times["converged"]), worst(times["converged"]), "ms")
    section.add("paths a second while it optimises", rate, rate, "1/s")
    section.add("images a second while it plays and optimises", images, images, "1/s")
    section.add("gap between two images meanwhile", gap, gap, "ms")
    section.add("the page", size / 1e6, size / 1e6, "MB")
    section.add("requests outside", len(outside), len(outside), "")
    shares = [100 * growth([row[i] for row in grown]) for i in range(3)]
    for who, share in zip(("server", "solver", "page"), shares, strict=True):
        section.add(f"memory of the {who}, last quarter beside the first", share, share, "%")
    section.targets += [
        Target("figure", median(starts), 3.0, unit="s"),
        Target("pose, median", median(times["server"]), 50.0, unit="ms"),
        Target("pose, worst", worst(times["server"]), 100.0, unit="ms"),
        Target("better path", median(times["first"]), 400.0, unit="ms"),
        Target("converged", median(times["converged"]), 1200.0, unit="ms"),
        Target("paths a second", rate, 8.0, least=True, unit="1/s"),
        Target("gap", gap, 200.0, unit="ms"),
        Target("page", size / 1e6, 1.5, unit="MB"),
        Target("memory of half an hour", max(shares) if minutes >= 30 else None, 5.0, unit="%"),
    ]
    section.notes.append(
        f"{SIZE['width']} × {SIZE['height']}, SwiftShader; {count} edits in a long run of {minutes} minutes"
    )
    section.data = {**times, "starts": starts, "memory": grown}
    return section


def main() -> None:
    parser = argparse.ArgumentParser(description="the long run alone")
    parser.add_argument("--minutes", type=float, default=30)
    minutes = parser.parse_args().minutes
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play, tempfile.TemporaryDirectory() as name:
        browser = play.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        memories, count = long_run(browser, Path(name), minutes, print)
        browser.close()
    for i, who in enumerate(("server", "solver", "page")):
        print(f"{who}: {100 * growth([row[i] for row in memories]):+.1f} % after {count} edits")


if __name__ == "__main__":
    main()
