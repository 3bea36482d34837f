// The timeline: a ruler, keyframes as diamonds, limbs when unfolded, contacts, grasps and flights as bars.
import { pointOf } from "../scene/figure";
import { $, el, menu, toast } from "./dom";
import { savePose } from "./files";
import { act, change, edit, moveKeys } from "./link";
import { model, type Bar } from "./model";
import { applyPose } from "./transport";

const LABEL = 188; // [px] of the column of names
export const PAD = 16; // [px] beside the first and the last moment
export const POSE = "text/x-pose"; // type of the name of a pose that is dragged to a time
const CLOSE = 6; // [px] that snap
const EDGE = 7; // [px] of the ends of a bar
const ROOM = 0.08; // of the motion that is shown after it, for more keyframes
const STEPS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60];

type Drag = { move: (time: number, event: PointerEvent) => void; up: (time: number, event: PointerEvent) => void };

/** The end of a bar that is at the mouse. */
const edgeOf = (bar: HTMLElement, { clientX }: PointerEvent): "from" | "to" | "" => {
  const { left, right } = bar.getBoundingClientRect();
  return clientX - left < EDGE ? "from" : right - clientX < EDGE ? "to" : "";
};

export class Timeline {
  private readonly box = $("timeline");
  private readonly head = el("div", { class: "playhead", "aria-hidden": "true" });
  private readonly rows = el("div", { class: "rows" });
  private readonly ruler = el("div", { class: "ruler" });
  private readonly frames = el("div", { class: "frames" });
  private readonly band = el("div", { class: "band", hidden: true });
  begin = 0; // [s] of the left edge
  end = 1;
  private fitted = "";
  unfolded = false;
  private drag: Drag | null = null;
  private preview = new Map<number, number>(); // times of keyframes that are being dragged
  private redraw = 0;
  private wide = 0; // [px] of the box, queried once per size: a query forces a layout
  private ticked = ""; // which variable frames are drawn, and where

  constructor() {
    this.box.append(this.ruler, this.rows, this.band, this.head);
    model.on(["document", "loaded", "selection", "stage", "joint", "range", "settled"], () => this.draw());
    let span = "";
    model.on("path", () => {
      const now = `${model.first}|${model.last}`;
      if (now !== span) this.draw();
      else this.ticks();
      span = now;
    });
    model.on("time", () => this.point());
    new ResizeObserver(() => { this.wide = 0; this.draw(); }).observe(this.box);
    this.box.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.box.addEventListener("pointerdown", (event) => this.down(event));
    this.box.addEventListener("dragover", (event) => { if (event.dataTransfer?.types.includes(POSE)) event.preventDefault(); });
    this.box.addEventListener("drop", (event) => {
      event.preventDefault();
      model.playing = false;
      model.seek(this.snapped(this.timeAt(event), event, true));
      applyPose(event.dataTransfer!.getData(POSE));
    });
    window.addEventListener("pointermove", (event) => this.drag?.move(this.timeAt(event), event));
    window.addEventListener("pointerup", (event) => {
      const { drag } = this;
      this.drag = null;
      drag?.up(this.timeAt(event), event);
    });
  }

  private get width(): number {
    this.wide ||= this.box.clientWidth;
    return Math.max(50, this.wide - LABEL - 2 * PAD);
  }
  private x(time: number): number { return LABEL + PAD + ((time - this.begin) / (this.end - this.begin)) * this.width; }
  private timeAt(event: MouseEvent): number {
    const left = this.box.getBoundingClientRect().left;
    return this.begin + ((event.clientX - left - LABEL - PAD) / this.width) * (this.end - this.begin);
  }

  /** To the nearest image, unless Alt is held; to the playhead and to keyframes where they are near. */
  private snapped(time: number, event: { altKey: boolean }, keys = false): number {
    if (event.altKey) return Math.max(Math.round(time * 1e4) / 1e4, Math.min(0, model.first));
    const near = (CLOSE / this.width) * (this.end - this.begin);
    const marks = [model.time, ...(keys ? (model.document?.keys ?? []).map((key) => key.time) : [])];
    const mark = marks.filter((each) => Math.abs(each - time) < near).sort((a, b) => Math.abs(a - time) - Math.abs(b - time))[0];
    if (mark !== undefined) return mark;
    return Math.max(Math.round(Math.round(time * model.fps) / model.fps * 1e4) / 1e4, Math.min(0, model.first));
  }

  fit(): void {
    const [begin, end] = model.played;
    this.show(begin, end + (end < model.last ? 0 : ROOM * Math.max(end - begin, 0.1)));
  }

  /** Shows a span [s]; nothing is before the beginning of time. */
  private show(begin: number, end: number): void {
    const by = Math.max(0, Math.min(0, model.first) - begin);
    [this.begin, this.end] = [begin + by, end + by];
    this.draw();
  }

  zoom(factor: number, about = model.time): void {
    const span = Math.min(Math.max((this.end - this.begin) * factor, 0.02), 3 * (model.last - model.first) + 1);
    const share = (about - this.begin) / (this.end - this.begin);
    this.show(about - share * span, about - share * span + span);
  }

  private wheel(event: WheelEvent): void {
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.002), this.timeAt(event));
    } else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      event.preventDefault();
      const by = ((event.deltaX || event.deltaY) / this.width) * (this.end - this.begin);
      this.show(this.begin + by, this.end + by);
    }
  }

  private point(): void {
    this.head.style.transform = `translateX(${this.x(model.time)}px)`;
    const here = model.here;
    for (const key of this.rows.querySelectorAll<HTMLElement>(".keys .diamond")) key.classList.toggle("here", Number(key.dataset.key) === here);
    this.ruler.setAttribute("aria-valuenow", model.time.toFixed(3));
    this.ruler.setAttribute("aria-valuetext", `${model.time.toFixed(2)} seconds`);
  }

  /** Redraws once per animation frame, however often it is called. */
  draw(): void {
    if (!this.redraw) this.redraw = requestAnimationFrame(() => { this.redraw = 0; this.drawn(); });
  }

  private drawn(): void {
    const { document } = model;
    if (!document) return;
    const isShown = this.begin <= model.first && model.last <= this.end; // where it is longer than before, there may be room
    const span = isShown ? document.name : `${document.name}|${model.first}|${model.last}`;
    if (!span.startsWith(this.fitted) || !isShown && span !== this.fitted) this.fit();
    this.fitted = span;
    const focused = (window.document.activeElement as HTMLElement | null)?.dataset.id;
    this.rows.replaceChildren(this.keysRow(), ...(this.unfolded ? this.limbRows() : []), ...this.barRows());
    this.drawRuler();
    this.point();
    model.tell("zoom");
    if (focused) this.rows.querySelector<HTMLElement>(`[data-id="${CSS.escape(focused)}"]`)?.focus();
  }

  private drawRuler(): void {
    const wanted = ((this.end - this.begin) / this.width) * 70;
    const step = STEPS.find((each) => each >= wanted) ?? 60;
    const ticks: HTMLElement[] = [];
    for (let i = Math.ceil((this.begin - 1e-9) / step); i * step <= this.end + 1e-9; i++) {
      const tick = el("span", { class: "tick", text: (i * step).toFixed(step < 0.01 ? 3 : step < 1 ? 2 : 0) });
      tick.style.left = `${this.x(i * step)}px`;
      ticks.push(tick);
    }
    const range = this.placed(el("span", { class: "range", title: "playback range: drag its ends, double-click it to play all", ondblclick: () => { model.range = [-Infinity, Infinity]; model.tell("range"); } }), ...model.played);
    this.ruler.replaceChildren(el("span", { class: "label", text: "s" }), range, ...ticks);
    Object.entries({ role: "slider", tabindex: "0", "aria-label": "time", "aria-valuemin": model.first.toFixed(3), "aria-valuemax": model.last.toFixed(3) })
      .forEach(([name, value]) => this.ruler.setAttribute(name, value));
  }

  private label(text: string, extra?: HTMLElement): HTMLElement {
    const label = el("span", { class: "label", title: text });
    if (extra) label.append(extra);
    label.append(el("span", { text }));
    return label;
  }

  private keysRow(): HTMLElement {
    const fold = el("button", {
      type: "button", class: "fold", "aria-expanded": String(this.unfolded), "aria-label": "limbs", title: "limbs (U)",
      onclick: () => { this.unfolded = !this.unfolded; this.draw(); },
    }, this.unfolded ? "▾" : "▸");
    const row = el("div", { class: "row keys" }, this.label("keyframes", fold));
    row.append(this.frames);
    this.ticks();
    for (const { time, joint, text } of model.overshoots.filter(({ time: at }) => at >= this.begin && at <= this.end)) {
      const mark = el("button", { type: "button", class: "overshoot", text: "▲", title: text, "aria-label": text, onclick: () => model.visit(time, joint) });
      mark.style.left = `${this.x(time)}px`;
      row.append(mark);
    }
    model.document!.keys.forEach((key, i) => {
      const state = model.loaded?.keys[i], partial = state ? !state.fixed.every(Boolean) : false;
      const time = this.preview.get(i) ?? key.time;
      if (time < this.begin - 1e-6 || time > this.end + 1e-6) return;
      row.append(this.diamond(i, time, partial, `keyframe ${i + 1} at ${key.time.toFixed(3)} s${partial ? ", partial" : ""}`));
    });
    return row;
  }

  /** Variable frames, which come and go while it optimises. */
  private ticks(): void {
    const shown = (model.course?.frames ?? []).filter((time) => time >= this.begin && time <= this.end);
    const now = `${shown}|${this.begin}|${this.end}|${this.width}`;
    if (now === this.ticked) return;
    this.ticked = now;
    this.frames.replaceChildren(...shown.map((time) => {
      const tick = el("i", { class: "frame" });
      tick.style.left = `${this.x(time)}px`;
      return tick;
    }));
  }

  private diamond(index: number, time: number, hollow: boolean, title: string): HTMLElement {
    const selected = model.keys.has(index);
    const made = el("button", {
      type: "button", class: `diamond${hollow ? " hollow" : ""}${selected ? " selected" : ""}`, title, "aria-label": title,
      "aria-pressed": String(selected), "data-key": index, "data-id": `key${index}`,
    });
    made.style.left = `${this.x(time)}px`;
    made.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        event.stopPropagation();
        this.choose(index, event);
        model.seek(model.document!.keys[index].time);
      }
    });
    return made;
  }

  private limbRows(): HTMLElement[] {
    const { stage, loaded, document } = model, revision = document!.revision;
    if (!stage || !loaded) return [];
    return stage.limbs.map((limb) => {
      const row = el("div", { class: "row limb" }, this.label(limb.name));
      const columns = limb.joints.map((name) => stage.joints.find((joint) => joint.name === name)!).filter(Boolean);
      document!.keys.forEach((key, i) => {
        const state = loaded.keys[i];
        if (!state || key.time < this.begin || key.time > this.end) return;
        const fixed = columns.map((joint) => state.fixed[joint.kind === "free" ? joint.qpos + 3 : joint.qpos]);
        const hollow = !fixed.every(Boolean), none = !fixed.some(Boolean);
        const toggle = (): void => void act(none ? "pin" : "free", { key: i, revision, joints: limb.joints });
        const words = `${limb.name}, keyframe ${i + 1}: ${none ? "free" : hollow ? "partly free" : "fixed"}; Enter or double click ${none ? "pins" : "frees"} it`;
        const mark = el("button", {
          type: "button", class: `diamond small${hollow ? " hollow" : ""}${none ? " none" : ""}`, title: words, "aria-label": words,
          "data-id": `limb${limb.name}${i}`,
          ondblclick: () => toggle(), onkeydown: (event) => { if ((event as KeyboardEvent).key === "Enter") toggle(); },
        });
        mark.style.left = `${this.x(key.time)}px`;
        row.append(mark);
      });
      return row;
    });
  }

  private barRows(): HTMLElement[] {
    const { document, loaded, stage } = model;
    const points = [...new Set([...(stage?.soles ?? []).map((sole) => sole.name), ...document!.contacts.map((bar) => bar.point!)])];
    const hands = [...new Set([...(model.limb?.hands ?? []), ...document!.grasps.map((bar) => bar.hand!)])];
    const rows = points.slice(0, 24).map((point) => {
      const row = el("div", { class: "row bars", "data-point": point }, this.label(point));
      for (const told of loaded?.stances.filter((each) => each.point === point) ?? []) row.append(this.told(told.from, told.to, `${point}: stance inferred from keyframes`));
      document!.contacts.forEach((bar, i) => { if (bar.point === point) row.append(this.bar("contact", i, bar, `contact of ${point}`)); });
      return row;
    });
    for (const hand of hands) {
      const row = el("div", { class: "row bars", "data-hand": hand, title: "drag here for a new grasp" }, this.label(`${hand} holds`));
      document!.grasps.forEach((bar, i) => { if (bar.hand === hand) row.append(this.bar("grasp", i, bar, `${hand} holds ${bar.body}`)); });
      rows.push(row);
    }
    if (loaded?.flights.length) {
      const row = el("div", { class: "row bars" }, this.label("flights"));
      for (const [from, to] of loaded.flights) row.append(this.told(from, to, "flight inferred from keyframes", "flight"));
      rows.push(row);
    }
    return rows;
  }

  private placed(made: HTMLElement, from: number, to: number): HTMLElement {
    const left = this.x(Math.max(from, this.begin)), right = this.x(Math.min(to, this.end));
    made.style.left = `${left}px`;
    made.style.width = `${Math.max(3, right - left)}px`;
    return made;
  }

  private told(from: number, to: number, title: string, kind = "stance"): HTMLElement {
    return this.placed(el("span", { class: `bar ${kind}`, title: `${title}: ${from.toFixed(2)} to ${to.toFixed(2)} s` }), from, to);
  }

  private bar(kind: "contact" | "grasp", index: number, bar: Bar, title: string): HTMLElement {
    const selected = model.bar?.kind === kind && model.bar.index === index;
    const words = `${title}, ${bar.from.toFixed(2)} to ${bar.to.toFixed(2)} s`;
    const made = el("button", {
      type: "button", class: `bar ${kind}${selected ? " selected" : ""}`, title: `${words}; drag it or its ends`, "aria-label": words,
      "data-bar": kind, "data-index": index, "data-id": `${kind}${index}`, "aria-pressed": String(selected),
      onfocus: () => { if (model.bar?.index !== index || model.bar.kind !== kind) { model.bar = { kind, index }; model.keys.clear(); model.tell("selection"); } },
    });
    return this.placed(made, bar.from, bar.to);
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const target = event.target as HTMLElement, time = this.timeAt(event);
    const left = event.clientX - this.box.getBoundingClientRect().left;
    if (target.closest(".fold") || left < LABEL) return;
    const end = target.matches(".range") ? edgeOf(target, event) : "";
    if (end) {
      this.drag = { move: (t, e) => model.setRange(end === "from" ? 0 : 1, this.snapped(t, e, true)), up: () => {} };
      return;
    }
    if (target.closest(".ruler")) {
      model.playing = false;
      const scrub = (t: number, e: PointerEvent) => model.seek(this.snapped(t, e, true));
      scrub(time, event);
      this.drag = { move: scrub, up: () => {} };
      return;
    }
    const key = target.closest<HTMLElement>(".keys .diamond");
    const bar = target.closest<HTMLElement>("[data-bar]");
    const row = target.closest<HTMLElement>("[data-point], [data-hand]");
    if (key) this.grabKey(Number(key.dataset.key), time, event);
    else if (bar) this.grabBar(bar, time, event);
    else if (row) this.drawBar(row, time, event);
    else if (!target.closest("button")) this.boxSelect(time, event);
  }

  private choose(index: number, event: { shiftKey: boolean; ctrlKey: boolean; metaKey: boolean }): void {
    const keys = new Set(model.keys);
    if (event.ctrlKey || event.metaKey) keys.has(index) ? keys.delete(index) : keys.add(index);
    else if (event.shiftKey && keys.size) {
      const some = [...keys, index];
      for (let i = Math.min(...some); i <= Math.max(...some); i++) keys.add(i);
    } else if (!keys.has(index)) { keys.clear(); keys.add(index); }
    model.select(keys);
  }

  private grabKey(index: number, begin: number, event: PointerEvent): void {
    const was = model.document!.keys.map((key) => key.time), { revision } = model.document!;
    const wasSelected = model.keys.has(index);
    this.choose(index, event);
    const keys = [...model.keys]; // as they are numbered now, whatever another page does meanwhile
    model.playing = false;
    model.seek(was[index]);
    const panel = $("panel-pose"), isOverPoses = (e: PointerEvent): boolean => panel.contains(document.elementFromPoint(e.clientX, e.clientY));
    let moved = false;
    const times = (time: number, e: PointerEvent): Map<number, number> => {
      if (isOverPoses(e)) return new Map();
      const to = this.snapped(was[index] + time - begin, e);
      return new Map(keys.map((i) => [i, Math.round((was[i] + to - was[index]) * 1e4) / 1e4]));
    };
    this.drag = {
      move: (time, e) => {
        if (!moved && Math.abs(this.x(time) - this.x(begin)) < 3) return;
        moved = true;
        this.preview = times(time, e);
        panel.classList.toggle("dropping", isOverPoses(e));
        this.draw();
      },
      up: (time, e) => {
        this.preview.clear();
        panel.classList.remove("dropping");
        this.draw();
        if (!moved) {
          if (wasSelected && model.keys.size > 1 && !e.shiftKey && !e.ctrlKey) model.select([index]);
          return;
        }
        if (isOverPoses(e)) savePose(was[index]);
        else void moveKeys([...times(time, e)], revision);
      },
    };
  }

  private grabBar(target: HTMLElement, begin: number, event: PointerEvent): void {
    const kind = target.dataset.bar as "contact" | "grasp", index = Number(target.dataset.index);
    const { revision } = model.document!, bar = (kind === "contact" ? model.document!.contacts : model.document!.grasps)[index];
    const edge = edgeOf(target, event);
    model.bar = { kind, index };
    model.keys.clear();
    model.tell("selection");
    const span = (time: number, e: PointerEvent): [number, number] => {
      if (edge === "from") return [this.snapped(time, e, true), bar.to];
      if (edge === "to") return [bar.from, this.snapped(time, e, true)];
      const from = this.snapped(bar.from + time - begin, e, true);
      return [from, from + bar.to - bar.from];
    };
    let moved = false;
    this.drag = {
      move: (time, e) => {
        if (!moved && Math.abs(this.x(time) - this.x(begin)) < 3) return;
        moved = true;
        const shown = this.rows.querySelector<HTMLElement>(`[data-id="${kind}${index}"]`);
        if (shown) this.placed(shown, ...span(time, e));
      },
      up: (time, e) => {
        if (!moved) return;
        const [from, to] = span(time, e);
        void change([kind, index], { from, to }, revision);
      },
    };
  }

  /** A new contact of a point, or a new grasp of a hand, over its row. */
  private drawBar(row: HTMLElement, begin: number, event: PointerEvent): void {
    const { point, hand } = row.dataset, kind = point ? "contact" : "grasp";
    const from = this.snapped(begin, event, true);
    const shown = el("span", { class: `bar ${kind} new` });
    let moved = false;
    this.drag = {
      move: (time, e) => {
        if (!moved && Math.abs(this.x(time) - this.x(begin)) < 5) return;
        if (!moved) this.rows.querySelector(`[data-${point ? "point" : "hand"}="${CSS.escape((point ?? hand)!)}"]`)?.append(shown);
        moved = true;
        const to = this.snapped(time, e, true);
        this.placed(shown, Math.min(from, to), Math.max(from, to));
      },
      up: (time, e) => {
        const to = this.snapped(time, e, true), span = { from: Math.min(from, to), to: Math.max(from, to) };
        if (!moved || to === from) { shown.remove(); model.select([]); model.seek(this.snapped(begin, e, true)); return; }
        if (point) { shown.remove(); void edit("add", { at: ["contact"], entries: { point, ...span } }); return; }
        this.graspable(hand!, span.from, e, (body) => { shown.remove(); if (body !== null) void edit("add", { at: ["grasp"], entries: { hand, body, ...span } }); });
      },
    };
  }

  /** Asks what a hand is to grasp: bodies that move, the nearest to it first; what no limb of its own is. */
  private graspable(hand: string, time: number, at: { clientX: number; clientY: number }, done: (body: string | null) => void): void {
    const { stage, now } = model, site = stage?.sites.find((each) => each.name === hand);
    if (!stage || !now || !site) { done(null); return; }
    const pose = now.at(time), root = (body: number): number => (stage.parents[body] ? root(stage.parents[body]) : body);
    const here = pointOf(pose, site);
    const own = stage.limbs.find((limb) => stage.joints.some((joint) => joint.body === site.body && limb.joints.includes(joint.name)));
    const bodies = stage.bodies.map((name, body) => ({ name, body, away: here.distanceTo(pointOf(pose, { body, offset: [0, 0, 0] })), other: root(body) !== root(site.body) }))
      .filter(({ name, body }) => body && name && !stage.still[body] && body !== site.body && stage.joints.some((joint) => joint.body === body)
        && !own?.joints.some((joint) => stage.joints.find((each) => each.name === joint)?.body === body))
      .sort((a, b) => Number(b.other) - Number(a.other) || a.away - b.away).slice(0, 8);
    if (!bodies.length) { toast("there is no free body to grasp", "note"); done(null); return; }
    menu(`${hand} holds`, at, bodies.map(({ name }) => name), done);
  }

  private boxSelect(begin: number, event: PointerEvent): void {
    let moved = false;
    const kept = event.shiftKey ? new Set(model.keys) : new Set<number>();
    this.drag = {
      move: (time) => {
        moved ||= Math.abs(this.x(time) - this.x(begin)) > 4;
        this.band.hidden = !moved;
        this.placed(this.band, Math.min(begin, time), Math.max(begin, time));
      },
      up: (time, e) => {
        this.band.hidden = true;
        if (!moved) { model.select(kept); model.playing = false; model.seek(this.snapped(begin, e, true)); return; }
        const [low, high] = [Math.min(begin, time), Math.max(begin, time)];
        model.document!.keys.forEach((key, i) => { if (key.time >= low && key.time <= high) kept.add(i); });
        model.select(kept);
        if (!kept.size) toast("no keyframe there", "note");
      },
    };
  }
}
