"""The studio in a real browser without a GPU: how soon there is a figure, a posed one, a better path; what is lost."""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import os
import re
import shutil
import tempfile
import time
from importlib.resources import files
from pathlib import Path
from typing import Any

from bench import Effort, Section, Target, median, peer, worst
from studio_random import FLAGS, growth, served, until, work

SIZE = {"width": 1280, "height": 800}
SEEN = "window.studio !== undefined && studio.model.stage !== null && studio.model.now !== null"
READY = f"{SEEN} && studio.model.document !== null"
SHOWN = f"{SEEN} && studio.stage.images > 0"
ROUND = "new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))"  # an image that was drawn is seen
SETTLED = "studio.model.status.state === 'settled'"
KEY = 4  # the keyframe that is edited
PULLS = 200  # poses of a drag
PRESSES = 60
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
  const { model } = studio, began = performance.now();
  let path = null, better = null, done = false, frames = model.frames;
  model.on('settled', () => { done = true; });
  model.on('path', () => {
    if (done || model.frames === frames) return; // of the raw spline
    path ??= performance.now() - began;
    if (model.course.kind === 'best') better ??= performance.now() - began;
  });
  const answer = await studio.ask(name, entries);
  if (!answer.ok) throw new Error(answer.words);
  while (!done) await new Promise((r) => setTimeout(r, 5));
  return [path, better, performance.now() - began];
}"""
STILL = """async (seconds) => {
  const { model, stage } = studio;
  model.seek(0); model.playing = true; stage.draw();
  await new Promise((r) => setTimeout(r, 1500));
  const images = stage.images, began = performance.now();
  await new Promise((r) => setTimeout(r, 1000 * seconds));
  const rate = 1000 * (stage.images - images) / (performance.now() - began);
  model.playing = false;
  return rate;
}"""
PLAY = """async (seconds) => {
  const { model, stage } = studio;
  model.seek(0); model.playing = true; stage.draw();
  await new Promise((r) => setTimeout(r, 1500));
  const paths = model.frames, images = stage.images, began = performance.now();
  let searching = 0, last = began, longest = 0, seen = stage.images, drawn = began;
  const watch = (now) => {
    if (stage.images !== seen) { longest = Math.max(longest, now - drawn); seen = stage.images; drawn = now; }
    if (model.playing) requestAnimationFrame(watch);
  };
  requestAnimationFrame(watch);
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
  return [(model.frames - paths) / Math.max(1e-3, searching / 1000), longest,
          1000 * (stage.images - images) / (performance.now() - began)];
}"""


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
    names = ("server", "trip", "path", "better", "converged")
    times_by_name: dict[str, list[float]] = {name: [] for name in names}
    for i in range(repeats):
        page.evaluate(f"studio.model.seek(studio.model.document.keys[{KEY}].time)")
        body = page.evaluate("studio.model.stage.bodies.indexOf('left_foot')")
        share = SHARES[0] + (SHARES[1] - SHARES[0]) * i / max(1, repeats - 1)
        times, trips = page.evaluate(DRAG, [body, pulls, share])
        times_by_name["server"] += times
        times_by_name["trip"] += trips
        path, better, converged = page.evaluate(RELEASE, ["drop", {"time": page.evaluate("studio.model.time")}])
        for what, value in (("path", path), ("better", better), ("converged", converged)):
            times_by_name[what].append(converged if value is None else value)
        page.evaluate("studio.ask('undo')")
        time.sleep(0.2)
        until(page, SETTLED)
    return times_by_name


def presses(page: Any, count: int) -> tuple[int, int]:
    """How many presses of an arrow key, 20 ms apart, change a number, and how many of three fields, typed at once."""
    page.evaluate(f"studio.model.seek(studio.model.document.keys[{KEY}].time)")
    field = page.get_by_label("left_shoulder x [degrees]", exact=True)
    field.focus()
    before = float(field.input_value())
    begin = time.monotonic()
    for i in range(1, count + 1):
        page.keyboard.press("ArrowUp")
        time.sleep(max(0, begin + 0.02 * i - time.monotonic()))
    until(page, "studio.pending.size === 0")
    counted = round(float(field.input_value()) - before)
    field.select_text()
    for text in ("11", "12", "13"):
        page.keyboard.type(text)
        page.keyboard.press("Tab")
    until(page, "studio.pending.size === 0")
    typed = page.evaluate(f"studio.model.document.keys[{KEY}].joints.left_shoulder.rotvec")
    for _ in range(4):
        page.evaluate("studio.ask('undo')")
    until(page, SETTLED)
    return counted, sum(value == k for value, k in zip(typed, (11, 12, 13), strict=True))


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
            still = page.evaluate(STILL, effort.count(10, 3))
            rate, gap, images = page.evaluate(PLAY, effort.count(15, 5))
            until(page, SETTLED)
            counted, typed = presses(page, PRESSES)
            page.close()
        effort.report("random work")
        minutes = effort.count(int(MINUTES), 1)
        person = work(browser, folder, minutes, 1, effort.report)
        browser.close()
    built = files("dynsplines.studio") / "built"
    size = sum(len((built / part).read_bytes()) for part in ("index.html", "studio.js", "studio.css"))
    outside = [url for url in urls if not re.match(r"(http://127\.0\.0\.1:|data:|blob:)", url)]
    section.add("from the command to a figure", median(starts), worst(starts), "s")
    section.add("a pose of a drag, the server's time", median(times["server"]), worst(times["server"]), "ms")
    section.add("a pose of a drag, there and back", median(times["trip"]), worst(times["trip"]), "ms")
    section.add("from letting go to a path", median(times["path"]), worst(times["path"]), "ms")
    section.add("from letting go to a better path", median(times["better"]), worst(times["better"]), "ms")
    section.add("from letting go to the end of the search", median(times["converged"]), worst(times["converged"]), "ms")
    section.add("paths a second while it optimises", rate, rate, "1/s")
    section.add("images a second while it plays and optimises", images, images, "1/s")
    section.add("images a second while it plays", still, still, "1/s")
    section.add("gap between two images while it plays and optimises", gap, gap, "ms")
    section.add(f"of {PRESSES} presses of an arrow key, 20 ms apart", counted, counted, "")
    section.add("of 3 fields that are typed at once", typed, typed, "")
    section.add("deeds of random work", person.deeds.total(), person.deeds.total(), "")
    section.add("refused in words", person.refused, person.refused, "")
    section.add("lost, refused without words, or errors of the page", len(person.faults), len(person.faults), "")
    section.add("the page", size / 1e6, size / 1e6, "MB")
    section.add("requests outside", len(outside), len(outside), "")
    shares = [100 * growth([row[i] for row in person.memory]) for i in range(3)]
    for who, share in zip(("server", "solver", "page"), shares, strict=True):
        section.add(f"memory of the {who}, last quarter beside the first", share, share, "%")
    section.targets += [
        Target("figure", median(starts), 2.0, unit="s"),
        Target("pose, median", median(times["server"]), 50.0, unit="ms"),
        Target("pose, worst", worst(times["server"]), 100.0, unit="ms"),
        Target("path", median(times["path"]), 200.0, unit="ms"),
        Target("better path", median(times["better"]), 300.0, unit="ms"),
        Target("converged", median(times["converged"]), 1200.0, unit="ms"),
        Target("paths a second", rate, 8.0, least=True, unit="1/s"),
        Target("playback", still, 40.0, least=True, unit="1/s"),
        Target("presses", counted, PRESSES, least=True),
        Target("typed fields", typed, 3, least=True),
        Target("faults", len(person.faults), 0),
        Target("gap", gap, 200.0, unit="ms"),
        Target("page", size / 1e6, 1.5, unit="MB"),
        Target("memory of half an hour", max(shares) if minutes >= 30 else None, 5.0, unit="%"),
    ]
    section.notes.append(
        f"{SIZE['width']} × {SIZE['height']}, SwiftShader; random work for {minutes} minutes at another size"
    )
    section.data = {**times, "starts": starts, "memory": person.memory, "faults": person.faults}
    return section
