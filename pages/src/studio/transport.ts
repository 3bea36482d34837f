// Play, scrub, loop, speed; undo, redo, save; the state of the search.
import { $, el, PATHS, say, short, toast } from "./dom";
import { act, connection, edit } from "./link";
import { model, type KeyframeRow, type Which } from "./model";
import type { Stage } from "./stage";

const READ = 30; // [ms] that a number stays while it plays
const SPEEDS = [0.1, 0.25, 0.5, 1, 1.5, 2];
const STATES: Record<string, string> = {
  loading: "loading …", searching: "optimising", settled: "converged", refused: "refused", gone: "gone",
};
const ENDS: Record<string, string> = { INTERRUPTED: "stopped", paused: "paused", MAX_EVALUATIONS: "evaluation limit reached", NO_PROGRESS: "no progress", CONVERGED: "converged" };

export const play = (yes = !model.playing): void => {
  const [begin, end] = model.played;
  if (yes && (model.time < begin || model.time >= end - 1e-6)) model.seek(begin);
  model.playing = yes;
  model.tell("time");
};
export const step = (by: number): void => {
  play(false);
  model.seek(model.first + (Math.round((model.time - model.first) * model.fps) + by) / model.fps);
};
export const toKey = (way: number): void => {
  play(false);
  const times = (model.document?.keys ?? []).map((key) => key.time), near = 1e-4;
  const found = way > 0 ? times.find((time) => time > model.time + near) : times.findLast((time) => time < model.time - near);
  model.seek(found ?? (way > 0 ? model.last : model.first));
};
export const save = async (): Promise<void> => {
  if (model.document?.file) await act("save");
  else $("files").dispatchEvent(new CustomEvent("save-as"));
};
export const addKey = async (): Promise<void> => {
  await act("key", { time: model.moment, ...(model.partial && model.limb ? { limb: model.limb.joints } : {}) });
};
let copied: KeyframeRow[] = [];
/** Copies keyframes by their indices. */
export const copy = (keys: number[]): void => {
  if (!keys.length) return;
  copied = keys.map((i) => model.document!.keys[i]);
  toast(`copied ${keys.length} keyframe${keys.length > 1 ? "s" : ""}`);
};
export const paste = async (): Promise<void> => {
  const time = model.moment;
  if ((await edit("paste_keys", { copied, time })).ok) model.select(model.at(copied.map((key) => key.time - copied[0].time + time)));
};
/** Applies a saved pose, or without a name that of rest, at the present time. */
export const applyPose = (name: string): void => void act("pose", { time: model.moment, name: name || null, partial: model.partial });
export const remove = async (): Promise<void> => {
  if (model.bar) { const { kind, index } = model.bar; model.bar = null; await edit("remove", { at: [kind, index] }); return; }
  const keys = model.keys.size ? [...model.keys] : model.here === null ? [] : [model.here];
  if (!keys.length) return;
  await edit("delete_keys", { keys });
};

export const transport = (stage: Stage): void => {
  const icon = $("play").querySelector("path")!;
  const speed = $<HTMLSelectElement>("speed");
  for (const each of SPEEDS) speed.append(el("option", { value: each, text: `${each}×`, selected: each === 1 }));
  speed.addEventListener("change", () => { model.speed = Number(speed.value); });
  for (const [id, name] of [["loop", "loop"], ["follow", "follow"], ["trails", "trails"], ["partial", "partial"]] as const) {
    const box = $<HTMLInputElement>(id);
    box.checked = model[name];
    box.addEventListener("change", () => { model[name] = box.checked; model.tell("shown"); });
  }
  const ghosts = $<HTMLSelectElement>("ghosts");
  ghosts.addEventListener("change", () => { model.ghosts = ghosts.value; model.tell("shown"); });
  const which = $<HTMLSelectElement>("which");
  model.on("which", () => { $("sides").hidden = model.which !== "side"; });
  which.addEventListener("change", () => {
    if (which.value === "take") { model.snapshot = model.now; which.value = "snapshot"; }
    model.which = which.value as Which;
    model.tell("which");
  });
  $<HTMLSelectElement>("views").addEventListener("change", (event) => stage.aim((event.target as HTMLSelectElement).value));

  const now = el("b"), whole = el("span");
  $("clock").replaceChildren(now, whole);
  let told = -Infinity;
  model.on(["time", "path"], () => {
    const sign = PATHS[model.playing ? "pause" : "play"];
    if (icon.getAttribute("d") !== sign) icon.setAttribute("d", sign);
    else if (model.playing && performance.now() - told < READ) return;
    told = performance.now();
    say(now, model.time.toFixed(2));
    say(whole, ` / ${model.last.toFixed(2)} s`);
    say($("image"), `frame ${Math.round((model.time - model.first) * model.fps)}`);
  });
  const state = (): void => {
    const { status, course } = model;
    const label = status.state === "settled" ? ENDS[status.stop ?? ""] ?? "converged" : STATES[status.state] ?? status.state;
    say($("state"), connection === "open" ? label : "no connection to the studio");
    $("state").dataset.state = connection === "open" ? status.state : "gone";
    say($("energy"), course?.value === undefined ? "" : `E ${course.value >= 1000 ? course.value.toExponential(2) : short(course.value)}`);
    say($("go"), status.go ? "Stop" : "Continue");
    $("go").title = status.go ? "stop optimising, now and after edits (G)" : "optimise, now and after edits (G)";
  };
  model.on(["status", "path", "line"], state);
  model.on("document", () => {
    const { document } = model;
    if (!document) return;
    $("name").textContent = document.file ?? `${document.name} (no file yet)`;
    $("dirty").hidden = !document.dirty;
    window.document.title = `${document.dirty ? "• " : ""}${document.name} – dynsplines studio`;
    for (const [verb, keys] of [["undo", "Ctrl-Z"], ["redo", "Ctrl-Shift-Z"]] as const) {
      $<HTMLButtonElement>(verb).disabled = !document[verb];
      $(verb).title = document[verb] ? `${verb}: ${document[verb]} (${keys})` : `nothing to ${verb}`;
    }
  });
};
