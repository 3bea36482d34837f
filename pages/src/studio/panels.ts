// The side panel: joints of a keyframe, problems, weights, obstacles.
import { $, el, short, toast } from "./dom";
import { act, addressOf, change, edit } from "./link";
import { model, type Joint } from "./model";

const tabs = ["pose", "problems", "weights", "scene"] as const;

export const showTab = (name: string): void => {
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

const values = (joint: Joint, qpos: number[]): number[] => {
  if (joint.kind === "free") return [...qpos.slice(joint.qpos, joint.qpos + 3), ...rotvec(qpos.slice(joint.qpos + 3, joint.qpos + 7))];
  if (joint.kind === "ball") return rotvec(qpos.slice(joint.qpos, joint.qpos + 4));
  return [joint.kind === "hinge" ? (qpos[joint.qpos] * 180) / Math.PI : qpos[joint.qpos]];
};

/** What is in a field: a number, or NaN for what is none, which the studio refuses in words. */
const read = (field: HTMLInputElement): number => {
  const text = field.value.trim().replace(",", ".");
  return text === "" ? NaN : Number(text);
};

const field = (label: string, value: number, unit: string, changed: (value: number) => void, step = 1): HTMLInputElement => {
  const made = el("input", { type: "text", inputmode: "decimal", class: "number", value: short(value, 3), "aria-label": `${label} [${unit}]`, title: `${label} [${unit}]; arrow keys change it` });
  made.addEventListener("change", () => changed(read(made)));
  made.addEventListener("keydown", (event) => {
    if (event.key === "Enter") made.blur();
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
    event.preventDefault();
    const by = (event.key === "ArrowUp" ? 1 : -1) * step * (event.shiftKey ? 10 : 1);
    made.value = short(read(made) + by, 3);
    changed(read(made));
  });
  return made;
};

const poseRow = (key: number, joint: Joint): HTMLElement => {
  const { loaded, document } = model, revision = document!.revision;
  const state = loaded!.keys[key], authored = document!.keys[key];
  const start = joint.kind === "free" ? joint.qpos + 3 : joint.qpos;
  const fixed = state.fixed[start];
  const numbers = values(joint, state.qpos);
  const at = ["keyframe", key], isRoot = joint === model.stage!.joints.find((each) => each.kind === "free"); // or another free body
  const rooted = (part: object) => (isRoot ? { root: part } : { roots: { [joint.name]: part } });
  const explicit = joint.kind === "free" || authored.joints?.[joint.name] !== undefined;
  const mode = fixed ? "pin" : "free";
  const choice = el("select", { class: "mode", "aria-label": `${joint.name}: pinned, free, or by the keyframe's rule for other joints`, title: "pinned: fixed at this value; free: chosen by the optimiser; others: by the keyframe's rule for other joints" });
  for (const [value, text] of [["pin", "pinned"], ["free", "free"], ...(joint.kind === "free" ? [] : [["none", `others (${authored.others})`]])]) {
    choice.append(el("option", { value, text, selected: value === (explicit ? mode : "none") }));
  }
  choice.addEventListener("change", () => {
    if (choice.value === "none") void change(at, { joints: { [joint.name]: null } }, revision);
    else void act(choice.value, { key, revision, joints: [joint.name] });
  });
  const row = el("div", { class: `joint${model.joint === joint.name ? " selected" : ""}${fixed ? "" : " free"}` },
    el("button", { type: "button", class: "name", text: joint.name, title: joint.range ? `range ${joint.range.map((x) => short(x, 1)).join(" to ")}` : joint.kind, onclick: () => { model.joint = model.joint === joint.name ? null : joint.name; model.tell("joint"); } }),
    choice);
  const line = el("div", { class: "numbers" });
  const send = (i: number, value: number): void => {
    const now = [...numbers];
    now[i] = value;
    if (joint.kind === "free") {
      const axes = now.slice(0, 3).map((each, k) => (k !== i && !state.fixed[joint.qpos + k] ? "free" : each));
      void change(at, rooted(i < 3 ? { position: axes } : { rotation: { rotvec: now.slice(3) } }), revision).then(panels.pose);
    } else void change(at, { joints: { [joint.name]: joint.kind === "ball" ? { rotvec: now } : value } }, revision).then(panels.pose);
  };
  const names = joint.kind === "free" ? ["x", "y", "z", "turn x", "turn y", "turn z"] : joint.kind === "ball" ? ["x", "y", "z"] : [""];
  numbers.forEach((value, i) => {
    const metres = joint.kind === "slide" || (joint.kind === "free" && i < 3);
    const entry = field(`${joint.name} ${names[i]}`.trim(), value, metres ? "m" : "degrees", (now) => send(i, now), metres ? 0.01 : 1);
    const axisFixed = joint.kind === "free" && i < 3 ? state.fixed[joint.qpos + i] : fixed;
    entry.classList.toggle("loose", !axisFixed);
    line.append(entry);
    if (joint.kind === "free" && i < 3) {
      line.append(el("button", {
        type: "button", class: "axis", text: axisFixed ? "•" : "○", "aria-pressed": String(!axisFixed),
        "aria-label": `${joint.name} ${names[i]}: ${axisFixed ? "pinned; press to free it" : "free; press to pin it"}`, title: axisFixed ? "free this axis" : "pin this axis",
        onclick: () => {
          const axes = numbers.slice(0, 3).map((each, k) => ((k === i ? axisFixed : !state.fixed[joint.qpos + k]) ? "free" : each));
          void change(at, rooted({ position: axes }), revision);
        },
      }));
    }
  });
  row.append(line);
  return row;
};

let chosen: string | null = null; // the joint that was scrolled to last

const pose = (): void => {
  const box = $("panel-pose"), { stage, loaded, document } = model;
  if (box.contains(window.document.activeElement) && (window.document.activeElement as HTMLElement).matches("input:focus") && model.playing) return;
  const key = model.here;
  if (!stage || !loaded || !document) return;
  if (key === null || !loaded.keys[key]) {
    box.replaceChildren(
      el("p", { class: "hint" }, "No keyframe here. Drag any point of the figure, or press ", el("kbd", { text: "K" }), ", to make one from the path."));
    return;
  }
  const authored = document.keys[key], { revision } = document;
  const others = el("select", { "aria-label": "joints that this keyframe does not name" });
  for (const value of new Set(["free", "rest", "previous", authored.others])) others.append(el("option", { value, text: value, selected: value === authored.others }));
  others.addEventListener("change", () => void change(["keyframe", key], { others: others.value === "free" ? null : others.value }, revision));
  const time = field("time", authored.time, "s", (value) => void edit("move_keys", { moves: [[key, value]], revision }).then((answer) => { if (answer.ok) model.seek(value); else pose(); }), 1 / model.fps);
  const focused = (window.document.activeElement as HTMLElement | null)?.getAttribute("aria-label");
  box.replaceChildren(
    el("div", { class: "heading" }, el("h2", { text: `Keyframe ${key + 1}` }), el("label", {}, "at ", time, " s")),
    el("div", { class: "buttons" },
      el("button", { type: "button", text: "mirror", title: "mirror left and right (M)", onclick: () => void act("mirror", { keys: [key], revision }) }),
      el("button", { type: "button", text: "rest", title: "set every joint to rest", onclick: () => void act("rest", { key, revision }) }),
      el("button", { type: "button", text: "pin all", onclick: () => void act("pin", { key, revision, joints: stage.joints.map((joint) => joint.name) }) }),
      el("button", { type: "button", text: "free all", onclick: () => void act("free", { key, revision, joints: stage.joints.map((joint) => joint.name) }) })),
    el("label", { class: "line" }, "other joints: ", others),
    ...["sites", "bodies"].flatMap((group) => Object.entries((authored as any)[group] ?? {}).map(([name, place]) =>
      el("div", { class: "line place" }, el("span", { text: `${name} → ${JSON.stringify(place)}` }),
        ...(group === "sites" ? [el("button", { type: "button", text: "remove target", onclick: () => void change(["keyframe", key], { sites: { [name]: null } }, revision) })] : [])))),
    ...stage.joints.map((joint) => poseRow(key, joint))); // it stays scrolled: to ask how far would lay out all of it twice
  if (model.joint !== chosen) {
    chosen = model.joint;
    box.querySelector(".joint.selected")?.scrollIntoView({ block: "nearest" });
  }
  if (focused && !box.contains(window.document.activeElement)) box.querySelector<HTMLElement>(`[aria-label="${CSS.escape(focused)}"]`)?.focus();
};

const problems = (): void => {
  const { violations } = model, count = violations.length;
  $("count").textContent = count ? String(count) : "";
  $("count").hidden = !count;
  const box = $("panel-problems");
  if (!count) {
    box.replaceChildren(el("p", { class: "hint good", id: "nothing-wrong", text: model.status.state === "settled" ? "No problems." : "No problems so far." }));
    return;
  }
  box.replaceChildren(el("p", { class: "hint", text: "Worst first. Click one to go there." }), el("ol", { class: "violations" }, ...violations.map((violation) =>
    el("li", {}, el("button", {
      type: "button", class: violation.keyframe === null ? "" : "own", text: violation.text,
      onclick: () => {
        if (violation.time !== null) { model.playing = false; model.seek(violation.time); }
        const joint = model.stage?.joints.find((each) => each.name === violation.name);
        if (joint) { model.joint = joint.name; model.tell("joint"); }
        if (violation.keyframe !== null) model.select([violation.keyframe - 1]);
        if (violation.time === null) toast("it concerns the whole motion", "note");
      },
    })))));
};

const SCALE = 4; // decades of a slider, on either side of the default
const weights = (): void => {
  const { kinds, document, loaded, course } = model;
  if (!kinds.length || !document || $("panel-weights").hidden) return;
  const box = $("panel-weights"), parts = course?.parts ?? {}, scroll = box.scrollTop;
  if (box.contains(window.document.activeElement) && (window.document.activeElement as HTMLInputElement).type === "range") return;
  const sum = Object.values(parts).reduce((total, each) => total + each, 0);
  const rows = kinds.map(({ kind, part, term, weight: base, quantity: small, "is on": on }) => {
    const own = document.weights[term], given = term in document.weights;
    const now = own ?? loaded?.weights[term] ?? (on ? base : 0);
    const slider = el("input", { type: "range", min: -SCALE, max: SCALE, step: 0.05, "aria-label": `weight of ${term}`, value: now > 0 ? Math.log10(now / base) : -SCALE });
    const entry = field(`weight of ${term}`, now, "", (value) => void edit("set_weight", { kind, part, weight: value }), 0.1);
    slider.addEventListener("input", () => { entry.value = short(base * 10 ** Number(slider.value), 4); });
    slider.addEventListener("change", () => {
      const value = Number(slider.value) <= -SCALE ? 0 : Number((base * 10 ** Number(slider.value)).toPrecision(3));
      slider.blur();
      void edit("set_weight", { kind, part, weight: value });
    });
    const share = sum > 0 ? (parts[term] ?? 0) / sum : 0;
    const bar = el("i", { class: "share" });
    bar.style.width = `${100 * share}%`;
    return el("div", { class: `weight${term in (loaded?.weights ?? {}) ? "" : " off"}`, title: `penalises ${small}` },
      el("span", { class: "name" }, el("b", { text: term }), el("small", { text: small })), slider, entry,
      el("button", { type: "button", class: "axis", text: "↺", disabled: !given, title: "its default", "aria-label": `default weight of ${term}`, onclick: () => void edit("set_weight", { kind, part, weight: null }) }),
      el("span", { class: "part", title: "its share of E" }, bar, el("small", { text: parts[term] === undefined ? "" : parts[term].toPrecision(2) })));
  });
  const tolerance = field("tolerance of the search", Number(document.solve.tolerance ?? 0.001), "", (value) => void change(["solve"], { tolerance: value }), 0.001);
  tolerance.value = String(document.solve.tolerance ?? 0.001);
  const people = el("input", { type: "checkbox", checked: (document.weights.prior ?? loaded?.weights.prior ?? 0) > 0 });
  people.addEventListener("change", () => void edit("set_weight", { kind: "prior", weight: people.checked ? kinds.find(({ term }) => term === "prior")?.weight : 0 }));
  box.replaceChildren(
    el("label", { class: "line", title: "stay near the poses of people between such keyframes" }, people, " as people move"),
    el("label", { class: "line" }, "tolerance of the search ", tolerance), ...rows);
  box.scrollTop = scroll;
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
  const box = $("panel-scene");
  const { revision, obstacles } = document;
  const adding = Object.entries(NEW).map(([kind, entries]) => el("button", {
    type: "button", text: `+ ${kind}`, disabled: kind === "step" && obstacles.some((thing) => thing.kind === kind), onclick: () => {
      const x = Math.round(100 * (model.now ? model.now.centreAt(model.time)[0] + 0.8 : 0.6)) / 100;
      if (kind === "step") void change(["scene"], { step: { ...entries, x } });
      else void edit("add", { at: ["scene", kind], entries: { ...entries, position: [x, 0, entries.position![2]] } });
    },
  }));
  const rows = obstacles.map((thing) => {
    const selected = model.obstacle?.kind === thing.kind && model.obstacle.index === thing.index;
    const title = `${thing.kind}${thing.name ? ` ‘${thing.name}’` : ""}`;
    const row = el("div", { class: `joint${selected ? " selected" : ""}` },
      el("button", { type: "button", class: "name", text: title, title: "select it on the stage", onclick: () => { model.obstacle = selected ? null : { kind: thing.kind, index: thing.index }; model.joint = null; model.tell("joint"); scene(); } }),
      el("button", { type: "button", class: "axis", text: "✕", "aria-label": `delete the ${title}`, onclick: () => { model.obstacle = null; model.tell("joint"); void edit("remove", { at: addressOf(thing), revision }); } }));
    const line = el("div", { class: "numbers" });
    for (const [name, value] of Object.entries(thing)) {
      if (["kind", "index", "color", "mass"].includes(name)) continue;
      if (typeof value === "number") line.append(field(`${title} ${name}`, value, "m", (now) => void change(addressOf(thing), { [name]: now }, revision), 0.01));
      else if (Array.isArray(value)) value.forEach((each, i) => line.append(field(`${title} ${name} ${"xyz"[i]}`, each as number, "m", (now) => {
        const all = [...(value as number[])];
        all[i] = now;
        void change(addressOf(thing), { [name]: all }, revision);
      }, 0.01)));
    }
    row.append(line);
    return row;
  });
  box.replaceChildren(el("div", { class: "buttons" }, ...adding), ...(rows.length ? rows : [el("p", { class: "hint", text: "Nothing but the floor. Add something to step on or to run into." })]));
};

export const panels = { pose, problems, weights, scene };

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
  let last = "";
  const posed = (): void => {
    const now = `${model.here}|${model.joint}|${model.document?.revision}`;
    if (model.playing || (now === last && model.here === null)) return;
    if (now !== last) { last = now; pose(); }
  };
  model.on(["time", "joint"], posed);
  model.on(["loaded", "stage", "document"], () => {
    if (model.document?.revision !== model.loaded?.revision) return; // the rest of what was edited follows at once
    last = "";
    posed();
  });
  model.on(["settled", "status"], problems);
  model.on(["kinds", "document", "loaded", "settled"], weights);
  let soon = 0;
  model.on("path", () => { if (!soon) soon = window.setTimeout(() => { soon = 0; weights(); }, 300); });
  model.on(["document", "joint"], scene);
  showTab("pose");
};
