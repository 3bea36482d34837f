// Curves over time beside the timeline, before and after, in step with it.
import uPlot from "uplot";
import { $, el } from "./dom";
import { ask } from "./link";
import { model } from "./model";
import { PAD, type Timeline } from "./timeline";

const COLOURS = ["#58a6ff", "#f0883e", "#56d364", "#ff7b9c", "#bc8cff", "#e3b341", "#39c5cf", "#a5b1c2"];
const LABELLED = 14; // [px] of the unit's label
const AXIS = 56; // [px] of the numbers beside the plot
const MOST = 8; // series that are shown to begin with

let plot: uPlot | null = null;
let group = "angle";
let hidden = new Set<string>();
let shown = false;
let span = (): [number, number] => [model.first, model.last];

export const toggleCurves = (): void => {
  shown = !shown;
  $("curves").hidden = !shown;
  $("show-curves").setAttribute("aria-pressed", String(shown));
  void ask("want_curves", { on: shown });
  if (shown) draw();
};

const style = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const draw = (): void => {
  const { curves } = model;
  if (!shown || !curves) return;
  const box = $("plot"), found = curves.groups.find((each) => each.name === group) ?? curves.groups[0];
  const chosen = found.series.filter((each: any) => !hidden.has(`${group}|${each.name}`));
  const before = model.which !== "after" || ($<HTMLInputElement>("curves-before").checked);
  const data: any[] = [curves.time];
  const series: uPlot.Series[] = [{ label: "time" }];
  chosen.forEach((each: any) => {
    const colour = COLOURS[found.series.indexOf(each) % COLOURS.length];
    data.push(each.after);
    series.push({ label: each.name, stroke: colour, width: 1.5, points: { show: false } });
    if (before && each.before?.length) {
      data.push(each.before);
      series.push({ label: `${each.name}, before`, stroke: colour, width: 1, dash: [4, 4], points: { show: false } });
    }
  });
  const ink = style("--soft"), line = style("--line");
  const axis = { stroke: ink, grid: { stroke: line, width: 1 }, ticks: { stroke: line }, font: "11px system-ui" };
  plot?.destroy();
  plot = new uPlot({
    width: Math.max(200, box.clientWidth), height: Math.max(90, box.clientHeight), series, padding: [10, PAD, 0, 0],
    scales: { x: { time: false, range: () => span() } },
    axes: [{ ...axis, size: 26 }, { ...axis, size: AXIS - LABELLED, label: found.unit, labelSize: LABELLED, labelFont: "11px system-ui" }],
    legend: { show: false },
    cursor: { drag: { x: false, y: false } },
    hooks: { draw: [mark] },
  }, data as uPlot.AlignedData, box);
  plot.over.addEventListener("pointerdown", (event) => {
    model.playing = false;
    const seek = (e: PointerEvent) => model.seek(plot!.posToVal(e.clientX - plot!.over.getBoundingClientRect().left, "x"));
    seek(event);
    const move = (e: PointerEvent) => seek(e);
    const up = () => { window.removeEventListener("pointermove", move); window.removeEventListener("pointerup", up); };
    window.addEventListener("pointermove", move);
    window.addEventListener("pointerup", up);
  });
  names(found);
};

/** The present moment. */
const mark = (drawn: uPlot): void => {
  const x = drawn.valToPos(model.time, "x", true), { ctx, bbox } = drawn;
  ctx.save();
  ctx.strokeStyle = style("--accent");
  ctx.lineWidth = 1.5;
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
};

const names = (found: any): void => {
  const list = $("curve-names");
  list.replaceChildren(...found.series.map((each: any, i: number) => {
    const key = `${group}|${each.name}`, on = !hidden.has(key);
    const box = el("input", { type: "checkbox", checked: on, onchange: () => { on ? hidden.add(key) : hidden.delete(key); draw(); } });
    const dot = el("i", { class: "dot" });
    dot.style.background = COLOURS[i % COLOURS.length];
    return el("label", {}, box, dot, each.name);
  }));
};

export const beginCurves = (timeline: Timeline): void => {
  span = () => [timeline.begin, timeline.end];
  model.on("zoom", () => { if (shown && plot) plot.setScale("x", { min: timeline.begin, max: timeline.end }); });
  const choice = $<HTMLSelectElement>("curve-group");
  choice.addEventListener("change", () => { group = choice.value; draw(); });
  $("curves-before").addEventListener("change", draw);
  $("show-curves").addEventListener("click", toggleCurves);
  let first = true;
  model.on("curves", () => {
    const { curves } = model;
    if (first && curves) {
      first = false;
      choice.replaceChildren(...curves.groups.map((each: any) => el("option", { value: each.name, text: each.name })));
      for (const each of curves.groups) each.series.slice(MOST).forEach((one: any) => hidden.add(`${each.name}|${one.name}`));
    }
    draw();
  });
  model.on("time", () => { if (shown) plot?.redraw(false); });
  model.on(["theme", "which"], draw);
  new ResizeObserver(() => { if (shown) plot?.setSize({ width: Math.max(200, $("plot").clientWidth), height: Math.max(90, $("plot").clientHeight) }); }).observe($("plot"));
  model.on("line", () => { if (shown) void ask("want_curves", { on: true }); });
};
