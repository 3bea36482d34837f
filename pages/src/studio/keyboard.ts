// Every command in one table, with its keys and its button; `?` shows it.
import { $, el, icon, PATHS, strokeOf } from "./dom";
import { act, moveKeys } from "./link";
import { model } from "./model";
import { toggleCurves } from "./curves";
import type { Hands } from "./hands";
import { showTab } from "./panels";
import type { Stage } from "./stage";
import type { Timeline } from "./timeline";
import { addKey, copy, paste, play, remove, save, step, toKey } from "./transport";

type Command = [keys: string, label: string, done: () => void, button?: string];

const click = (id: string) => () => $(id).click();
/** Chooses the next one of the first entries of a menu. */
const nextOf = (id: string, count: number): void => {
  const choice = $<HTMLSelectElement>(id);
  choice.selectedIndex = (choice.selectedIndex + 1) % count;
  choice.dispatchEvent(new Event("change"));
};
const selected = (): number[] => (model.keys.size ? [...model.keys].sort((a, b) => a - b) : model.here === null ? [] : [model.here]);
/** Moves the selected keyframes; repeats of a key are one edit. */
const move = (change: (time: number, first: number) => number): void => {
  const keys = selected(), times = keys.map((i) => model.document!.keys[i].time);
  if (keys.length) void moveKeys(keys.map((i, at) => [i, Math.round(change(times[at], times[0]) * 1e4) / 1e4]), undefined, strokeOf(`keyframes ${keys}`));
};
const nudge = (by: number): void => move((time) => time + by / model.fps);
const scaled = (factor: number): void => { if (selected().length > 1) move((time, first) => first + factor * (time - first)); };

const commands = (stage: Stage, timeline: Timeline, hands: Hands): Command[] => [
  ["Space", "play or pause", () => play(), "play"],
  ["ArrowLeft", "previous frame", () => step(-1)],
  ["ArrowRight", "next frame", () => step(1)],
  ["PageUp", "previous keyframe", () => toKey(-1), "previous"],
  ["PageDown", "next keyframe", () => toKey(1), "next"],
  ["Home", "first frame", () => model.seek(model.played[0])],
  ["End", "last frame", () => model.seek(model.played[1])],
  ["Ctrl-Home", "play from here; at the first frame: from the beginning", () => model.setRange(0, model.time)],
  ["Ctrl-End", "play up to here; at the last frame: to the end", () => model.setRange(1, model.time)],
  ["L", "loop", click("loop")],
  ["F", "camera follows the figure", click("follow")],
  ...[...$<HTMLSelectElement>("views").options].slice(0, -1).map(({ value, text }, i): Command => [String(i + 1), `view: ${text}`, () => stage.aim(value)]),
  ["0", "view: fit figure and obstacles", () => {
    const name = $<HTMLSelectElement>("views").value;
    stage.aim(name === "free" ? "quarter" : name, true);
  }],
  ["B", "before, both, side by side, after", () => nextOf("which", 4)],
  ["H", "onion skin: none, keyframes, every 5, every 10 frames", () => nextOf("ghosts", 4)],
  ["T", "motion paths", click("trails")],
  ["C", "curves", toggleCurves, "show-curves"],
  ["U", "limb rows on the timeline", () => { timeline.unfolded = !timeline.unfolded; timeline.draw(); }],
  ["Z", "show all of the timeline", () => timeline.fit(), "fit"],
  ["[", "timeline: zoom out", () => timeline.zoom(1.4), "zoom-out"],
  ["]", "timeline: zoom in", () => timeline.zoom(0.7), "zoom-in"],
  ["K", "insert a keyframe from the path", () => void addKey(), "key"],
  ["N", "new keyframes: of one limb, or of the whole figure", click("partial")],
  ["Delete", "delete keyframes, a contact or grasp", () => void remove(), "bin"],
  ["Alt-ArrowLeft", "move the keyframe one frame earlier", () => nudge(-1)],
  ["Alt-ArrowRight", "move the keyframe one frame later", () => nudge(1)],
  ["Alt-ArrowUp", "spread selected keyframes by 10 %", () => scaled(1.1)],
  ["Alt-ArrowDown", "compress selected keyframes by 10 %", () => scaled(1 / 1.1)],
  ["M", "mirror keyframes", () => { const keys = selected(); if (keys.length) void act("mirror", { keys }); }],
  ["Ctrl-A", "select all keyframes", () => model.select(model.document?.keys.keys() ?? [])],
  ["Ctrl-C", "copy keyframes", () => copy(selected())],
  ["Ctrl-V", "paste keyframes here, in place of those that are there", () => void paste()],
  ["Ctrl-D", "duplicate keyframes to here", () => { if (selected().length) { copy(selected()); void paste(); } }],
  ["Ctrl-Z", "undo", () => void act("undo"), "undo"],
  ["Ctrl-Shift-Z", "redo", () => void act("redo"), "redo"],
  ["Ctrl-S", "save", () => void save(), "save"],
  ["G", "stop or continue optimising", () => void act("search", { go: !model.status.go }), "go"],
  ...([["P", "pose"], ["O", "problems"], ["W", "weights"], ["S", "scene"]] as const).map(([keys, name]): Command => [keys, `panel: ${name}`, () => { showTab(name); $(`tab-${name}`).focus(); }]),
  ["J", "next joint, with rotation rings", () => {
    const joints = model.stage?.joints.map((joint) => joint.name) ?? [];
    model.choose(joints[(joints.indexOf(model.joint ?? "") + 1) % joints.length] ?? null);
  }],
  ["R", "arrows of an obstacle: move or resize it", () => { model.resizes = !model.resizes; model.tell("joint"); }],
  ["X", "lock or unlock the body at the pointer, or those of the selected joints", () => hands.lock()],
  ["Escape", "cancel a drag; deselect", () => {
    if (hands.busy) { void hands.cancel(); return; }
    if (model.joint !== null || model.obstacle !== null) model.pick(null); else model.select([]);
  }],
  ["?", "this list", () => help(stage, timeline, hands), "help"],
];

const MOUSE: [string, string][] = [
  ["drag the figure", "pose it: the limb bends, then the whole figure follows; planted soles stay (Alt: they may move; Ctrl: nearer or farther)"],
  ["click the figure", "select a joint and rotate it by its rings; Shift: select more, of which numbers, modes and locks change together"],
  ["select an obstacle in the panel Scene", "arrows move it, or resize it (R)"],
  ["right button on the figure", "lock a body: it stays where it is while others are posed; plant a foot; drag a limb by its joints (FK)"],
  ["drag the background", "orbit; right button or Shift: pan; wheel: zoom"],
  ["drag the ends of the bar above the keyframes", "playback range; double-click it to play all"],
  ["drag a pose of the panel Pose", "to a keyframe or another time on the timeline"],
  ["drag a diamond", "move keyframes; Shift or Ctrl: select more; Alt: do not snap"],
  ["drag over a point's row", "new contact; drag it or its ends; on a hand's row (select a joint of its arm): new grasp"],
  ["Ctrl-wheel, Shift-wheel", "zoom and move the timeline"],
];

const help = (stage: Stage, timeline: Timeline, hands: Hands): void => {
  const shown = (keys: string) => keys.replace("Arrow", "").replace("Left", "←").replace("Right", "→").replace("Up", "↑").replace("Down", "↓").replace("Page↑", "PgUp").replace("Page↓", "PgDn");
  const row = (keys: string, label: string) => el("div", {}, el("kbd", { text: keys }), el("span", { text: label }));
  const box = el("dialog", { class: "help", "aria-label": "keys" }, el("h2", { text: "Keys" }),
    el("div", { class: "columns" }, ...commands(stage, timeline, hands).map(([keys, label]) => row(shown(keys), label))),
    el("h2", { text: "Mouse" }), el("div", { class: "columns wide" }, ...MOUSE.map(([keys, label]) => row(keys, label))),
    el("form", { method: "dialog" }, el("div", { class: "buttons end" }, el("button", { type: "submit", class: "main", text: "Close" }))));
  box.addEventListener("close", () => box.remove());
  document.body.append(box);
  box.showModal();
  box.scrollTop = 0; // the focused button is at the end
};

export const beginKeyboard = (stage: Stage, timeline: Timeline, hands: Hands): void => {
  const table = new Map(commands(stage, timeline, hands).map(([keys, , done]) => [keys, done]));
  for (const [keys, label, done, name] of commands(stage, timeline, hands)) {
    if (!name) continue;
    const made = $(name);
    Object.assign(made, { title: `${label} (${keys})`, onclick: done });
    if (!made.textContent) made.setAttribute("aria-label", label);
    if (PATHS[name]) made.append(icon(name));
  }
  window.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    if (document.querySelector("dialog[open]")) return;
    const typing = target.matches("input[type=text], select, textarea"), sliding = target.matches("input[type=range]");
    const ctrl = event.ctrlKey || event.metaKey;
    if (typing && !(ctrl && "zs".includes(event.key.toLowerCase())) && event.key !== "Escape") return;
    if (sliding && event.key.startsWith("Arrow")) return;
    if (target.matches("button, summary, input[type=checkbox], [role=tab]") && (event.key === " " || event.key === "Enter")) return;
    if (target.matches("[role=tab]") && event.key.startsWith("Arrow")) return;
    const name = event.key === " " ? "Space" : event.key.length === 1 ? event.key.toUpperCase() : event.key === "Backspace" ? "Delete" : event.key;
    const shift = event.shiftKey && ctrl ? "Shift-" : "";
    const keys = `${ctrl ? "Ctrl-" : ""}${shift}${event.altKey ? "Alt-" : ""}${name}`;
    const done = table.get(keys === "Ctrl-Y" ? "Ctrl-Shift-Z" : keys);
    if (!done) return;
    if (ctrl && name === "C" && String(getSelection())) return;
    event.preventDefault();
    done();
  });
};
