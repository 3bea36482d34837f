// Curves over time beside the timeline, before and after, in step with it.
import uPlot from "uplot";
import { $, el } from "./dom";
import { ask, moveKeys } from "./link";
import { model, type Curves, type Joint, type Series } from "./model";
import { setNumbers, values } from "./panels";
import { PAD, type Timeline } from "./timeline";

const COLOURS = ["#58a6ff", "#f0883e", "#56d364", "#ff7b9c", "#bc8cff", "#e3b341", "#39c5cf", "#a5b1c2"];
const LABELLED = 14; // [px] of the unit's label
const AXIS = 56; // [px] of the numbers beside the plot
const MOST = 8; // series that are shown to begin with
const NEAR = 8; // [px] within which a dot is grabbed

type Group = Curves["groups"][number];
/** The value of a coordinate in a keyframe. */
interface Dot { key: number; joint: Joint; series: Series; time: number; value: number; }

let plot: uPlot | null = null;
let group = "angle";
let hidden = new Set<string>();
let shown = false;
let present: Series[] = []; // that are drawn
let held: Dot | null = null; // where a dot is dragged to
let span = (): [number, number] => [model.first, model.last];

export const toggleCurves = (): void => {
  shown = !shown;
  $("curves").hidden = !shown;
  $("show-curves").setAttribute("aria-pressed", String(shown));
  void ask("want_curves", { on: shown });
  if (shown) draw();
};

const style = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** The series of the selected joints. */
const own = (found: Group): Series[] => found.series.filter(({ joint }) => model.joints.includes(joint));

/** A series at a time [s]. */
const valueAt = ({ after }: Series, time: number): number => {
  const times = model.curves!.time, share = ((time - times[0]) / (times.at(-1)! - times[0])) * (after.length - 1);
  const i = Math.min(Math.max(Math.floor(share), 0), after.length - 2);
  return after[i] + (share - i) * (after[i + 1] - after[i]);
};

/** The values that keyframes fix, on their curves. */
export const dots = (): Dot[] => present.flatMap((series) => {
  const joint = model.stage?.joints.find(({ name }) => name === series.joint), { axis } = series;
  if (!joint || axis === null || !model.loaded) return [];
  const column = joint.qpos + (joint.kind !== "free" ? 0 : Math.min(axis, 3));
  const fixed = model.document!.keys.flatMap(({ time }, key) => (model.loaded!.keys[key]?.fixed[column] ? [{ key, joint, series, time, value: valueAt(series, time) }] : []));
  return fixed.map((dot) => (held?.key === dot.key && held.series === series ? held : dot));
});

/** [px] Where a dot is on the plot. */
export const onPlot = ({ time, value }: Dot): [number, number] => [plot!.valToPos(time, "x"), plot!.valToPos(value, "y")];

/** Writes a dot that was dragged to its keyframe: the value, and then the time. */
const drop = async (dot: Dot, from: Dot): Promise<void> => {
  const { key, joint, series, time, value } = dot, { revision } = model.document!, stroke = String(Math.random());
  const now = values(joint, model.poseOf(key)), isLength = series.axis! < 3 && joint.kind === "free";
  if (!isLength) for (const each of present.filter((other) => other.joint === joint.name)) now[each.axis!] = valueAt(each, from.time); // beyond half a turn, too
  now[series.axis!] = Number(value.toFixed(3));
  if (value !== from.value) await setNumbers(key, [[joint, now]], series.axis!, revision, stroke);
  if (time !== from.time) await moveKeys([[key, time]], model.document!.revision, stroke);
};

/** Drags the dot at the mouse, or else the playhead. */
const grab = (event: PointerEvent): void => {
  const at = ({ clientX, clientY }: PointerEvent) => { const { left, top } = plot!.over.getBoundingClientRect(); return [clientX - left, clientY - top]; };
  const [x, y] = at(event), away = (dot: Dot) => Math.hypot(onPlot(dot)[0] - x, onPlot(dot)[1] - y);
  const from = dots().sort((a, b) => away(a) - away(b))[0];
  model.playing = false;
  held = from && away(from) < NEAR ? { ...from } : null;
  const move = (e: PointerEvent) => {
    const [px, py] = at(e), time = plot!.posToVal(px, "x");
    if (!held) { model.seek(time); return; }
    if (Math.abs(px - x) > NEAR || held.time !== from.time) held.time = Math.round(Math.round(time * model.fps) / model.fps * 1e4) / 1e4;
    if (Math.abs(py - y) > 2 || held.value !== from.value) held.value = from.value + plot!.posToVal(py, "y") - plot!.posToVal(y, "y");
    plot!.redraw(false);
  };
  const up = () => {
    window.removeEventListener("pointermove", move);
    window.removeEventListener("pointerup", up);
    const dot = held;
    held = null;
    if (dot) void drop(dot, from);
  };
  if (!held) move(event);
  window.addEventListener("pointermove", move);
  window.addEventListener("pointerup", up);
};

const draw = (): void => {
  const { curves } = model;
  if (!shown || !curves) return;
  const box = $("plot"), found = curves.groups.find((each) => each.name === group) ?? curves.groups[0];
  present = own(found).length ? own(found) : found.series.filter(({ name }) => !hidden.has(`${group}|${name}`));
  const before = model.which !== "after" || ($<HTMLInputElement>("curves-before").checked);
  const data: any[] = [curves.time];
  const series: uPlot.Series[] = [{ label: "time" }];
  for (const each of present) {
    const stroke = colourOf(found, each);
    data.push(each.after);
    series.push({ label: each.name, stroke, width: 1.5, points: { show: false } });
    if (before && each.before) {
      data.push(each.before);
      series.push({ label: `${each.name}, before`, stroke, width: 1, dash: [4, 4], points: { show: false } });
    }
  }
  const ink = style("--soft"), line = style("--line");
  const axis = { stroke: ink, grid: { stroke: line, width: 1 }, ticks: { stroke: line }, font: "11px system-ui" };
  plot?.destroy();
  plot = new uPlot({
    width: Math.max(200, box.clientWidth), height: Math.max(90, box.clientHeight), series, padding: [10, PAD, 0, 0],
    scales: { x: { time: false, range: () => span() } },
    axes: [{ ...axis, size: 26 }, { ...axis, size: AXIS - LABELLED, label: found.unit, labelSize: LABELLED, labelFont: "11px system-ui" }],
    legend: { show: false },
    cursor: { drag: { x: false, y: false } },
    hooks: { draw: [(drawn) => mark(drawn, found)] },
  }, data as uPlot.AlignedData, box);
  plot.over.addEventListener("pointerdown", grab);
  names(found);
};

const colourOf = (found: Group, each: Series): string => COLOURS[found.series.indexOf(each) % COLOURS.length];

/** The present moment, and the keyframes. */
const mark = (drawn: uPlot, found: Group): void => {
  const x = drawn.valToPos(model.time, "x", true), { ctx, bbox } = drawn, dot = 4 * devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = style("--accent");
  ctx.lineWidth = 1.5;
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  for (const { series, time, value } of dots()) {
    ctx.fillStyle = colourOf(found, series);
    ctx.beginPath();
    ctx.arc(drawn.valToPos(time, "x", true), drawn.valToPos(value, "y", true), dot, 0, 2 * Math.PI);
    ctx.fill();
  }
  ctx.restore();
};

const names = (found: Group): void => {
  const only = own(found).length > 0;
  $("curve-names").replaceChildren(...(only ? present : found.series).map((each) => {
    const key = `${group}|${each.name}`, on = only || !hidden.has(key);
    const box = el("input", { type: "checkbox", checked: on, disabled: only, onchange: () => { on ? hidden.add(key) : hidden.delete(key); draw(); } });
    const dot = el("i", { class: "dot" });
    dot.style.background = colourOf(found, each);
    return el("label", {}, box, dot, each.name);
  }));
};

export const beginCurves = (timeline: Timeline): void => {
  span = () => [timeline.begin, timeline.end];
  model.on("zoom", () => { if (shown && plot) plot.setScale("x", { min: timeline.begin, max: timeline.end }); });
  const choice = $<HTMLSelectElement>("curve-group");
  choice.addEventListener("change", () => { group = choice.value; draw(); });
  $("curves-before").addEventListener("change", draw);
  let first = true;
  model.on("curves", () => {
    const { curves } = model;
    if (first && curves) {
      first = false;
      choice.replaceChildren(...curves.groups.map((each) => el("option", { value: each.name, text: each.name })));
      for (const each of curves.groups) each.series.slice(MOST).forEach((one) => hidden.add(`${each.name}|${one.name}`));
    }
    draw();
  });
  model.on("time", () => { if (shown) plot?.redraw(false); });
  model.on("document", () => { if (shown) plot?.redraw(false); });
  model.on(["theme", "which", "joint"], draw);
  new ResizeObserver(() => { if (shown) plot?.setSize({ width: Math.max(200, $("plot").clientWidth), height: Math.max(90, $("plot").clientHeight) }); }).observe($("plot"));
  model.on("line", () => { if (shown) void ask("want_curves", { on: true }); });
};
