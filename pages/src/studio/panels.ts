// The side panel: joints of a keyframe, problems, weights, obstacles.
import { $, el, fill, numberField, short, soon, strokeOf, toast } from "./dom";
import { act, addressOf, change, edit, moveKeys } from "./link";
import { savePose } from "./files";
import { model, type Joint } from "./model";
import { POSE } from "./timeline";
import { applyPose } from "./transport";

const tabs = ["pose", "problems", "weights", "scene"] as const;

export const showTab = (name: (typeof tabs)[number]): void => {
  for (const each of tabs) {
    const on = each === name;
    $(`tab-${each}`).setAttribute("aria-selected", String(on));
    $(`tab-${each}`).tabIndex = on ? 0 : -1;
    $(`panel-${each}`).hidden = !on;
  }
  if (name === "weights" || name === "scene") panels[name](); // they are made only where they are seen
};

/** The quaternion's angle about its axis, as three numbers in degrees. */
const rotvec = ([w, x, y, z]: number[]): number[] => {
  const sign = w < 0 ? -1 : 1, sine = Math.hypot(x, y, z);
  const angle = 2 * Math.atan2(sine, Math.abs(w)) * (180 / Math.PI);
  return [x, y, z].map((value) => (sine > 1e-12 ? (sign * value * angle) / sine : 0));
};

/** A joint's numbers: positions [m] and rotations [degrees], those of a free joint in this order. */
export const values = (joint: Joint, qpos: number[]): number[] => {
  if (joint.kind === "free") return [...qpos.slice(joint.qpos, joint.qpos + 3), ...rotvec(qpos.slice(joint.qpos + 3, joint.qpos + 7))];
  if (joint.kind === "ball") return rotvec(qpos.slice(joint.qpos, joint.qpos + 4));
  return [joint.kind === "hinge" ? (qpos[joint.qpos] * 180) / Math.PI : qpos[joint.qpos]];
};

const isRoot = (joint: Joint): boolean => joint === model.stage!.joints.find((each) => each.kind === "free"); // or another free body
const rooted = (joint: Joint, part: object): object => (isRoot(joint) ? { root: part } : { roots: { [joint.name]: part } });

/** The selected joints of a kind, if a joint is one of them; else it alone. */
const together = (joint: Joint, isMeant = (_: Joint): boolean => true): Joint[] => [joint, ...model.stage!.joints.filter((each) =>
  each !== joint && [joint, each].every(({ kind, name }) => kind !== "free" && model.joints.includes(name)) && isMeant(each))];

/** Sets one of the numbers of joints of one kind in a keyframe. Feet on the ground and locked bodies stay where they are. */
export const setNumbers = (key: number, sets: [Joint, number[]][], i: number, revision: number, stroke?: string): Promise<unknown> => {
  const [[joint, now]] = sets;
  const isFree = (k: number): boolean => k !== i && !model.loaded!.keys[key].fixed[joint.qpos + k];
  let entries: object = { joints: Object.fromEntries(sets.map(([each, to]) => [each.name, each.kind === "ball" ? { rotvec: to } : to[i]])) };
  if (joint.kind === "free") entries = rooted(joint, i >= 3 ? { rotation: { rotvec: now.slice(3) } } : { position: now.slice(0, 3).map((each, k) => (isFree(k) ? "free" : each)) });
  return edit("change", { at: ["keyframe", key], entries, revision, plant: isRoot(joint), locks: model.locked }, stroke);
};

const poseRow = (key: number, joint: Joint): HTMLElement => {
  const { loaded, document } = model, revision = document!.revision;
  const state = loaded!.keys[key], authored = document!.keys[key];
  const start = joint.kind === "free" ? joint.qpos + 3 : joint.qpos;
  const fixed = state.fixed[start];
  const numbers = values(joint, model.poseOf(key));
  const at = ["keyframe", key];
  const explicit = joint.kind === "free" || authored.joints?.[joint.name] !== undefined;
  const mode = fixed ? "pin" : "free";
  const choice = el("select", {
    class: "mode", "aria-label": `${joint.name}: pinned, free, or by the keyframe's rule for other joints`,
    title: "pinned: fixed at this value; free: chosen by the optimiser; others: by the keyframe's rule for other joints",
    onchange: ({ currentTarget }) => {
      const { value } = currentTarget as HTMLSelectElement, joints = together(joint).map(({ name }) => name);
      if (value === "none") void change(at, { joints: Object.fromEntries(joints.map((name) => [name, null])) }, revision);
      else void act(value, { key, revision, joints });
    },
  });
  for (const [value, text] of [["pin", "pinned"], ["free", "free"], ...(joint.kind === "free" ? [] : [["none", `others (${authored.others})`]])]) {
    choice.append(el("option", { value, text, selected: value === (explicit ? mode : "none") }));
  }
  const row = el("div", { "data-id": joint.name, class: `joint${model.joints.includes(joint.name) ? " selected" : ""}${fixed ? "" : " free"}` },
    el("button", { type: "button", class: "name", text: joint.name, title: joint.range ? `range ${joint.range.map((x) => short(x, 1)).join(" to ")}` : joint.kind, onclick: (event) => { const { shiftKey } = event as MouseEvent; model.choose(!shiftKey && String(model.joints) === joint.name ? null : joint.name, shiftKey); } }),
    choice);
  const line = el("div", { class: "numbers" });
  /** Sets one of its numbers; the others are those of now, not of when the field was drawn. Other selected joints get what is typed, or change as much. */
  const send = (i: number, value: number, stroke?: string): void => {
    const before = model.poseOf(key), by = value - values(joint, before)[i];
    void setNumbers(key, together(joint, ({ kind }) => kind === joint.kind).map((each) => {
      const now = values(each, before);
      now[i] = each === joint || !stroke ? value : now[i] + by;
      return [each, now];
    }), i, revision, stroke);
  };
  const names = joint.kind === "free" ? ["x", "y", "z", "turn x", "turn y", "turn z"] : joint.kind === "ball" ? ["x", "y", "z"] : [""];
  const pins: HTMLElement[] = [];
  numbers.forEach((value, i) => {
    const isAxis = joint.kind === "free" && i < 3, metres = joint.kind === "slide" || isAxis, label = `${joint.name} ${names[i]}`.trim();
    const entry = numberField(label, value, metres ? "m" : "degrees", (now, stroke) => send(i, now, stroke), ...(metres ? [0.01, 3] : [1, 1]));
    const axisFixed = isAxis ? state.fixed[joint.qpos + i] : fixed;
    entry.classList.toggle("loose", !axisFixed);
    const named = el("label", { class: "axis-name", "data-unit": metres ? "m" : "°" }, names[i].replace("turn ", ""), entry);
    named.style.order = String(2 * i);
    line.append(named);
    if (isAxis) pins.push(el("button", {
      type: "button", class: "axis", text: axisFixed ? "•" : "○", "aria-pressed": String(!axisFixed), "data-id": label,
      "aria-label": `${label}: ${axisFixed ? "pinned; press to free it" : "free; press to pin it"}`, title: axisFixed ? "free this axis" : "pin this axis",
      onclick: () => {
        const axes = numbers.slice(0, 3).map((each, k) => ((k === i ? axisFixed : !state.fixed[joint.qpos + k]) ? "free" : each));
        void change(at, rooted(joint, { position: axes }), revision);
      },
    }));
  });
  pins.forEach((pin, i) => { pin.style.order = String(2 * i + 1); }); // seen beside the fields, but after them in the order of Tab
  line.append(...pins);
  row.append(line);
  return row;
};

/** The poses that can be applied. */
const library = (): HTMLElement => el("div", { class: "buttons" },
  ...["", ...model.poses].map((name) => el("button", {
    type: "button", class: "pose", text: name || "rest", "data-id": `pose ${name}`, draggable: "true", title: "apply this pose here; or drag it to a time",
    onclick: () => applyPose(name), ondragstart: (event) => (event as DragEvent).dataTransfer!.setData(POSE, name),
  })),
  el("button", { type: "button", text: "save pose …", title: "save the present pose as a file; or drag a keyframe here", onclick: () => savePose() }));

let chosen: string | null = null; // the joint that was scrolled to last
let time = 0; // [s] of what the panel shows

const pose = (): void => {
  if (model.playing) return; // what is being typed stays
  time = model.time;
  const box = $("panel-pose"), { stage, loaded, document } = model, key = model.here;
  if (!stage || !loaded || !document || loaded.revision !== document.revision) return; // the rest of what was edited follows at once
  if (key === null || !loaded.keys[key]) {
    fill(box, el("p", { class: "hint" }, "No keyframe here. Drag any point of the figure, or press ", el("kbd", { text: "K" }), ", to make one from the path, or apply a pose."), library());
    return;
  }
  const authored = document.keys[key], { revision } = document, joints = stage.joints.map((joint) => joint.name);
  const others = el("select", {
    "aria-label": "joints that this keyframe does not name",
    onchange: ({ currentTarget }) => {
      const { value } = currentTarget as HTMLSelectElement;
      void change(["keyframe", key], { others: value === "free" ? null : value }, revision);
    },
  });
  for (const value of new Set(["free", "rest", "previous", authored.others])) others.append(el("option", { value, text: value, selected: value === authored.others }));
  const moment = numberField("time", authored.time, "s", (value, stroke) => void moveKeys([[key, value]], revision, stroke), 1 / model.fps, 4);
  const doing = (text: string, title: string, what: string, args: object) => el("button", { type: "button", text, title, onclick: () => void act(what, { key, revision, ...args }) });
  fill(box,
    el("div", { class: "heading" }, el("h2", { text: `Keyframe ${key + 1}` }), el("label", {}, "at ", moment, " s")),
    el("div", { class: "buttons" },
      el("button", { type: "button", text: "mirror", title: "mirror left and right (M)", onclick: () => void act("mirror", { keys: [key], revision }) }),
      doing("pin all", "pin every joint", "pin", { joints }), doing("free all", "free every joint", "free", { joints })),
    library(),
    el("label", { class: "line" }, "other joints: ", others),
    ...["sites", "bodies"].flatMap((group) => Object.entries((authored as any)[group] ?? {}).map(([name, place]) =>
      el("div", { class: "line place", "data-id": `${group} ${name}` }, el("span", { text: `${name} → ${JSON.stringify(place)}` }),
        ...(group === "sites" ? [el("button", { type: "button", text: "remove target", onclick: () => void change(["keyframe", key], { sites: { [name]: null } }, revision) })] : [])))),
    ...stage.joints.map((joint) => poseRow(key, joint)));
  if (model.joint !== chosen) {
    chosen = model.joint;
    box.querySelector(".joint.selected")?.scrollIntoView({ block: "nearest" });
  }
};

const problems = (): void => {
  const { violations } = model, count = violations.length, notes = (model.loaded?.notes ?? []).map((text) => el("p", { class: "hint", text }));
  $("count").textContent = count ? String(count) : "";
  $("count").hidden = !count;
  const box = $("panel-problems");
  if (!count) {
    fill(box, el("p", { class: "hint good", id: "nothing-wrong", text: model.status.state === "settled" ? "No problems." : "No problems so far." }), ...notes);
    return;
  }
  fill(box, ...notes, el("p", { class: "hint", text: "Worst first. Click one to go there." }), el("ol", { class: "violations" }, ...violations.map((violation) =>
    el("li", {}, el("button", {
      type: "button", class: violation.keyframe === null ? "" : "own", text: violation.text,
      onclick: () => {
        model.visit(violation.time, violation.name);
        if (violation.keyframe !== null) model.select([violation.keyframe - 1]);
        if (violation.time === null) toast("it concerns the whole motion", "note");
      },
    })))));
};

const SCALE = 4; // decades of a slider, on either side of the default
const weights = (): void => {
  const { kinds, document, loaded, course } = model;
  if (!kinds.length || !document || $("panel-weights").hidden) return;
  const parts = course?.parts ?? {};
  const sum = Object.values(parts).reduce((total, each) => total + each, 0);
  const rows = kinds.map(({ kind, part, term, weight: base, quantity: small, "is on": on }) => {
    const now = document.weights[term] ?? loaded?.weights[term] ?? (on ? base : 0);
    const set = (weight: number | null, stroke?: string) => void edit("set_weight", { kind, part, weight }, stroke);
    const entry = numberField(`weight of ${term}`, now, "", set, 0.1, 4);
    const slider = el("input", {
      type: "range", min: -SCALE, max: SCALE, step: 0.05, "aria-label": `weight of ${term}`, value: now > 0 ? Math.log10(now / base) : -SCALE,
      oninput: ({ currentTarget }) => {
        const decades = Number((currentTarget as HTMLInputElement).value);
        set(decades <= -SCALE ? 0 : Number((base * 10 ** decades).toPrecision(3)), strokeOf(term));
      },
    });
    const share = sum > 0 ? (parts[term] ?? 0) / sum : 0;
    const bar = el("i", { class: "share" });
    bar.style.width = `${100 * share}%`;
    return el("div", { "data-id": term, class: `weight${term in (loaded?.weights ?? {}) ? "" : " off"}`, title: `penalises ${small}` },
      el("span", { class: "name" }, el("b", { text: term }), el("small", { text: small })), slider, entry,
      el("button", { type: "button", class: "axis", text: "↺", disabled: !(term in document.weights), title: "its default", "aria-label": `default weight of ${term}`, onclick: () => set(null) }),
      el("span", { class: "part", title: "its share of E" }, bar, el("small", { text: parts[term] === undefined ? "" : parts[term].toPrecision(2) })));
  });
  const tolerance = numberField("tolerance of the search", Number(document.solve.tolerance ?? 0.001), "", (value, stroke) => void change(["solve"], { tolerance: value }, undefined, stroke), 0.001, 6);
  const people = el("input", {
    type: "checkbox", checked: (document.weights.prior ?? loaded?.weights.prior ?? 0) > 0,
    onchange: ({ currentTarget }) => void edit("set_weight", { kind: "prior", weight: (currentTarget as HTMLInputElement).checked ? kinds.find(({ term }) => term === "prior")?.weight : 0 }),
  });
  fill($("panel-weights"),
    el("label", { class: "line", title: "stay near the poses of people between such keyframes" }, people, " as people move"),
    el("label", { class: "line" }, "tolerance of the search ", tolerance), ...rows);
};

const NEW: Record<string, { position?: number[]; [entry: string]: unknown }> = { // entries of a new obstacle [m]
  box: { position: [0, 0, 0.2], size: [0.4, 0.4, 0.4] },
  step: { x: 0, height: 0.2 },
  sphere: { position: [0, 0, 0.2], radius: 0.2 },
  capsule: { position: [0, 0, 0.9], length: 1, radius: 0.03 },
  cylinder: { position: [0, 0, 0.25], length: 0.5, radius: 0.15 },
};
const scene = (): void => {
  const { document } = model;
  if (!document || $("panel-scene").hidden) return;
  const { revision, obstacles } = document;
  const adding = Object.entries(NEW).map(([kind, entries]) => el("button", {
    type: "button", text: `+ ${kind}`, disabled: kind === "step" && obstacles.some((obstacle) => obstacle.kind === kind), onclick: () => {
      const x = Math.round(100 * (model.now ? model.now.centreAt(model.time)[0] + 0.8 : 0.6)) / 100;
      const index = obstacles.filter((obstacle) => obstacle.kind === kind).length;
      const added = kind === "step" ? change(["scene"], { step: { ...entries, x } })
        : edit("add", { at: ["scene", kind], entries: { ...entries, position: [x, 0, entries.position![2]] } });
      void added.then(({ ok }) => { if (ok) model.pick({ kind, index }); });
    },
  }));
  const rows = obstacles.map((obstacle) => {
    const selected = model.obstacle?.kind === obstacle.kind && model.obstacle.index === obstacle.index;
    const title = obstacle.name ? `${obstacle.kind} ‘${obstacle.name}’` : `${obstacle.kind}${obstacle.kind === "step" ? "" : ` ${obstacle.index + 1}`}`;
    const row = el("div", { "data-id": `${obstacle.kind} ${obstacle.index}`, class: `joint${selected ? " selected" : ""}` },
      el("button", { type: "button", class: "name", text: title, title: "select it on the stage", onclick: () => model.pick(selected ? null : obstacle) }),
      el("button", { type: "button", class: "axis", text: "✕", "aria-label": `delete the ${title}`, onclick: () => { model.pick(null); void edit("remove", { at: addressOf(obstacle), revision }); } }));
    const line = el("div", { class: "numbers" });
    const present = (name: string) => [(model.document?.obstacles.find(({ kind, index }) => kind === obstacle.kind && index === obstacle.index) ?? obstacle)[name]].flat() as number[];
    /** The position of a box that stays on what it stands on when its size changes. */
    const stays = (name: string, now: number | number[]): object => {
      if (obstacle.kind !== "box" || name !== "size" || obstacle.rotation || !obstacle.position) return {};
      const [x, y, z] = present("position");
      return { position: [x, y, Number((z + ((now as number[])[2] - present("size")[2]) / 2).toFixed(6))] };
    };
    for (const [name, value] of Object.entries(obstacle)) {
      if (["kind", "index", "color", "mass"].includes(name)) continue;
      const send = (now: number | number[], stroke?: string) => void change(addressOf(obstacle), { [name]: now, ...stays(name, now) }, revision, stroke);
      const named = (caption: string, entry: HTMLElement) => line.append(el("label", { class: "axis-name", "data-unit": "m" }, caption, entry));
      if (typeof value === "number") named(name, numberField(`${title} ${name}`, value, "m", send, 0.01));
      else if (Array.isArray(value)) value.forEach((each, i) => named(i ? "xyz"[i] : `${name} x`, numberField(`${title} ${name} ${"xyz"[i]}`, each as number, "m",
        (now, stroke) => send(present(name).map((old, k) => (k === i ? now : old)), stroke), 0.01)));
    }
    row.append(line);
    return row;
  });
  fill($("panel-scene"), el("div", { class: "buttons" }, ...adding), ...(rows.length ? rows : [el("p", { class: "hint", text: "Nothing but the floor. Add something to step on or to run into." })]));
};

const panels = { pose: soon(pose), problems: soon(problems), weights: soon(weights), scene: soon(scene) };

export const beginPanels = (): void => {
  for (const name of tabs) {
    $(`tab-${name}`).addEventListener("click", () => showTab(name));
    $(`tab-${name}`).addEventListener("keydown", (event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (!by) return;
      event.stopPropagation();
      const next = tabs[(tabs.indexOf(name) + by + tabs.length) % tabs.length];
      showTab(next);
      $(`tab-${next}`).focus();
    });
  }
  model.on(["time", "joint", "loaded", "stage", "document", "poses", "settled"], panels.pose);
  $("panel-pose").addEventListener("focusin", () => { if (model.playing) { model.playing = false; model.seek(time); } });
  model.on(["settled", "status", "loaded"], panels.problems);
  model.on(["kinds", "document", "loaded", "settled"], panels.weights);
  let later = 0;
  model.on("path", () => { if (!later) later = window.setTimeout(() => { later = 0; weights(); }, 300); });
  model.on(["document", "joint"], panels.scene);
  showTab("pose");
};
