// Hands on the figure: what the mouse lies on lights up; a drag of any point of it is posed by the server.
import * as THREE from "three";
import { pointOf } from "../scene/figure";
import { $, el, menu, PATHS, toast } from "./dom";
import { act, ask, drop, edit } from "./link";
import { axesOf } from "./axes";
import { model, type Joint, type Marked, type Obstacle } from "./model";
import { showTab } from "./panels";
import type { Stage } from "./stage";

const STILL = 4; // [px] that a click may move
const PLANTED = 0.05; // [m] that keyframes may move a foot that stays planted
const NEAR = 6; // [px] beside the figure at which a figure is still picked

/** A drag: the grabbed point, the joint that it rotates if the limb is posed by joints, the plane in which it moves, where it is on
 * the page, and its next target while an answer is pending. */
interface Held {
  body: number; joint: Joint | null; begin: THREE.Vector3; pivot: THREE.Vector3; offset: number[]; plane: THREE.Plane; x: number; y: number; clientX: number; clientY: number; time: number;
  moved: boolean; waits: boolean; next: THREE.Vector3 | null; ended: boolean;
}

/** A padlock, drawn. */
const padlock = (): THREE.CanvasTexture => {
  const canvas = el("canvas", { width: 64, height: 64 }), pen = canvas.getContext("2d")!, shape = new Path2D(PATHS.lock);
  pen.scale(2.6, 2.6);
  Object.assign(pen, { fillStyle: "#ffb454", strokeStyle: "#14171c", lineWidth: 3 });
  pen.stroke(shape);
  pen.fill(shape, "evenodd");
  return new THREE.CanvasTexture(canvas);
};

/** Where a ray meets an obstacle. */
const meets = (stage: Stage, obstacle: Obstacle, ray: THREE.Ray): THREE.Vector3 | null => {
  const { turn, out, within } = axesOf(stage, obstacle), { x = 0, y = 0, height = 0, radius = 0, length = obstacle.kind === "step" ? 3 : 0, width = 2.4 } = obstacle as unknown as Record<string, number>;
  const vector = (given: unknown) => new THREE.Vector3().fromArray((given as number[] | undefined) ?? [0, 0, 0]);
  if (obstacle.kind !== "box" && obstacle.kind !== "step") {
    const ends = obstacle.from && obstacle.to ? [vector(obstacle.from), vector(obstacle.to)] : [-1, 1].map((sign) => new THREE.Vector3(0, 0, (sign * length) / 2).applyQuaternion(turn).add(vector(obstacle.position)));
    const near = new THREE.Vector3();
    return ray.distanceSqToSegment(out(ends[0]), out(ends[1]), near) < radius ** 2 ? near : null;
  }
  const step = obstacle.kind === "step", middle = step ? new THREE.Vector3(x + length / 2, y, height / 2) : out(vector(obstacle.position));
  const frame = new THREE.Matrix4().compose(middle, step ? new THREE.Quaternion() : within.clone().multiply(turn), new THREE.Vector3(1, 1, 1));
  const box = new THREE.Box3().setFromCenterAndSize(new THREE.Vector3(), step ? new THREE.Vector3(length, width, height) : vector(obstacle.size));
  return ray.clone().applyMatrix4(frame.clone().invert()).intersectBox(box, new THREE.Vector3())?.applyMatrix4(frame) ?? null;
};

export class Hands {
  private held: Held | null = null;
  private readonly mark = new THREE.Mesh(
    new THREE.SphereGeometry(0.022, 16, 12),
    new THREE.MeshBasicMaterial({ color: 0xffb454, depthTest: false, transparent: true, opacity: 0.95 }),
  );
  private readonly signs = new THREE.Group(); // on locked bodies, and on joints that are selected together
  private readonly lockPaint = new THREE.SpriteMaterial({ map: padlock(), depthTest: false, sizeAttenuation: false });
  private readonly jointPaint = new THREE.SpriteMaterial({ color: 0xffb454, rotation: Math.PI / 4, depthTest: false, sizeAttenuation: false });
  private over: number | null = null; // the body at the pointer

  constructor(private readonly stage: Stage) {
    const { canvas } = stage;
    this.mark.visible = false;
    this.mark.renderOrder = 10;
    stage.extra.add(this.mark, this.signs);
    stage.sights.push(() => this.showSigns());
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerdown", (event) => this.down(event), true);
    window.addEventListener("pointerup", (event) => void this.up(event));
    canvas.addEventListener("pointerleave", () => { if (!this.held) this.light(null); });
    let pressed = { x: NaN, y: NaN };
    canvas.addEventListener("pointerdown", ({ clientX, clientY }) => { pressed = { x: clientX, y: clientY }; });
    canvas.addEventListener("pointerup", (event) => {
      if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) >= STILL || canvas.dataset.gizmo === "on") return;
      if (event.button === 0) this.choose(event);
      else if (event.button === 2) this.offer(event);
    });
  }

  /** Whether something is being dragged. */
  get busy(): boolean { return this.held !== null; }

  /** Lets go, and nothing has happened. */
  async cancel(): Promise<void> {
    if (!this.held) return;
    this.held.ended = true;
    this.held = null;
    this.stage.orbit.enabled = true;
    await ask("cancel");
    if (!this.held) this.stage.override = null;
    this.stage.draw();
  }

  /** The selected joints. */
  private get chosen(): Joint[] { return model.stage?.joints.filter(({ name }) => model.joints.includes(name)) ?? []; }

  /** Locks or unlocks a body, or if it is selected, or there is none, those of the selected joints. */
  lock(body = this.over): void {
    const chosen = this.chosen.map((joint) => joint.body), bodies = body === null || chosen.includes(body) ? chosen : [body];
    const names = bodies.filter((each) => !model.stage!.still[each]).map((each) => model.stage!.bodies[each]);
    if (!names.length) { toast("point at a body, or select a joint", "note"); return; }
    const locks = names.some((name) => !model.locks.has(name));
    for (const name of names) locks ? model.locks.add(name) : model.locks.delete(name);
    toast(`${names.join(", ")}: ${locks ? "locked" : "not locked any more"}`);
    this.stage.draw();
  }

  /** The menu of a body. */
  private offer(event: PointerEvent): void {
    const body = this.hit(event)?.body, name = model.stage?.bodies[body ?? -1];
    if (!name) return;
    const soles = model.stage!.soles.filter((sole) => sole.body === body), limb = this.limbOf(body!);
    const entries: [string, boolean, () => void][] = [
      [model.locks.has(name) ? "Unlock" : "Lock", true, () => this.lock(body)],
      ["Unlock all", model.locks.size > 0, () => { model.locks.clear(); this.stage.draw(); }],
      ["Flat on the ground", soles.length > 0, () => void this.flatten(body!)],
      ["Plant from here", soles.length > 0, () => void this.plant(soles)],
      [`${limb}: drag by joints (FK)`, limb !== undefined && !model.fk.has(limb), () => model.fk.add(limb!)],
      [`${limb}: drag by its end (IK)`, limb !== undefined && model.fk.has(limb), () => model.fk.delete(limb!)],
    ];
    const offered = entries.filter(([, isOffered]) => isOffered);
    menu(name, event, offered.map(([text]) => text), (chosen) => offered.find(([text]) => text === chosen)?.[2]());
  }

  /** The joint that moves a body. */
  private jointOf(body: number): Joint | undefined {
    const { joints, parents } = model.stage!;
    return joints.find((joint) => joint.body === body) ?? (body ? this.jointOf(parents[body]) : undefined);
  }

  /** The name of the limb of a body. */
  private limbOf(body: number): string | undefined {
    const joint = this.jointOf(body);
    return joint && model.stage!.limbs.find((limb) => limb.joints.includes(joint.name))?.name;
  }

  /** Keeps a foot in its place from here to the next keyframe, and on as long as keyframes leave it there. */
  private async plant(soles: Marked[]): Promise<void> {
    this.toKey();
    const from = model.moment, later = model.document!.keys.map((key) => key.time).filter((time) => time > from), stroke = String(Math.random());
    const place = (time: number): THREE.Vector3 => pointOf(model.now!.at(time), soles[0]), here = place(from);
    const leaves = later.findIndex((time) => place(time).distanceTo(here) > PLANTED), to = later[Math.max(leaves === -1 ? later.length - 1 : leaves - 1, 0)];
    if (to === undefined) { toast("no keyframe follows, up to which the foot could stay", "note"); return; }
    for (const { name } of soles) await edit("add", { at: ["contact"], entries: { point: name, from, to } }, stroke);
  }

  /** Puts a foot that is near the ground flat on it, as a drag does that ends there. */
  private async flatten(body: number): Promise<void> {
    this.toKey();
    const { time } = model, position = this.stage.placeOf(body, [0, 0, 0]).toArray();
    const grip = await act("grip", { time, body, offset: [0, 0, 0], locks: model.locked });
    if (!grip.ok || !(await ask("drag", { position })).ok) return;
    await drop(time, "this foot is not near the ground, or flat already");
  }

  /** Stops, and goes to a keyframe that is less than half a video frame away. */
  private toKey(): void {
    model.playing = false;
    const near = model.document?.keys.find((key) => Math.abs(key.time - model.time) < 0.5 / model.fps);
    if (near) model.seek(near.time);
  }

  /** A padlock on every locked body, and a mark on every joint if several are selected. */
  private showSigns(): void {
    const { locked } = model, { chosen, stage } = this;
    const locks = locked.map((body) => ({ body, offset: model.stage!.sites.findLast((site) => site.body === body)?.offset ?? [0, 0, 0], paint: this.lockPaint, size: 0.03 }));
    const joints = chosen.length < 2 ? [] : chosen.map(({ body, anchor }) => ({ body, offset: anchor, paint: this.jointPaint, size: 0.012 }));
    this.signs.clear();
    for (const { body, offset, paint, size } of [...locks, ...joints]) {
      const sprite = new THREE.Sprite(paint);
      sprite.scale.setScalar(size);
      sprite.renderOrder = 12;
      sprite.position.copy(stage.placeOf(body, offset));
      this.signs.add(sprite);
    }
  }

  /** The body at a point of the page, or near it. */
  private hit({ clientX, clientY }: { clientX: number; clientY: number }): { body: number; point: THREE.Vector3 } | null {
    const { figure } = this.stage;
    if (!figure || !figure.root.visible) return null;
    for (const away of [0, NEAR / 2, NEAR]) {
      for (let i = 0; i < (away ? 8 : 1); i++) {
        this.stage.through({ clientX: clientX + away * Math.cos((i * Math.PI) / 4), clientY: clientY + away * Math.sin((i * Math.PI) / 4) });
        const found = this.stage.caster.intersectObject(figure.root, true)[0];
        let node: THREE.Object3D | null = found?.object ?? null;
        while (node && node.userData.body === undefined) node = node.parent;
        if (node) return { body: node.userData.body, point: found.point };
      }
    }
    return null;
  }

  /** Selects the nearest obstacle at a point of the page, or nothing; with Shift, one more joint. */
  private choose(event: PointerEvent): void {
    if (event.shiftKey) { model.choose(this.jointOf(this.hit(event)?.body ?? 0)?.name ?? null, true); return; }
    const ray = this.stage.through(event), away = (obstacle: Obstacle) => meets(this.stage, obstacle, ray)?.distanceTo(ray.origin) ?? Infinity;
    const found = (model.document?.obstacles ?? []).map((obstacle) => ({ obstacle, far: away(obstacle) })).filter(({ far }) => far < Infinity)
      .sort((a, b) => a.far - b.far)[0]?.obstacle;
    if (!found && !model.obstacle && model.joint === null) return;
    model.pick(found ?? null);
    if (found) showTab("scene");
  }

  private light(found: { body: number; point: THREE.Vector3 } | null, event?: PointerEvent): void {
    const lit = found !== null, name = $("hover");
    this.over = found?.body ?? null;
    this.stage.canvas.style.cursor = lit ? "grab" : "";
    if (this.mark.visible !== lit || lit) this.stage.draw();
    this.mark.visible = lit;
    if (found) this.mark.position.copy(found.point);
    name.hidden = !found || !event;
    if (!found || !event) return;
    name.textContent = `${model.stage?.bodies[found.body] ?? ""}${model.locked.includes(found.body) ? ", locked" : ""}`;
    name.style.transform = `translate(${event.offsetX + 14}px, ${event.offsetY + 10}px)`;
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0 || event.shiftKey || this.stage.canvas.dataset.gizmo === "on") return;
    const found = this.hit(event);
    if (!found) return;
    event.stopImmediatePropagation();
    this.stage.orbit.enabled = false;
    this.stage.canvas.setPointerCapture(event.pointerId);
    this.toKey();
    const group = this.stage.figure!.groups[found.body];
    const offset = found.point.clone().sub(group.position).applyQuaternion(group.quaternion.clone().invert()).toArray();
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new THREE.Vector3()), found.point);
    const limb = this.limbOf(found.body), joint = limb !== undefined && model.fk.has(limb) ? this.jointOf(found.body)! : null;
    this.held = { body: found.body, joint, begin: found.point.clone(), pivot: joint ? this.stage.placeOf(joint.body, joint.anchor) : found.point, offset, plane, x: event.clientX, y: event.clientY, clientX: event.clientX, clientY: event.clientY, time: model.time, moved: false, waits: false, next: null, ended: false };
    this.stage.canvas.style.cursor = "grabbing";
    $("hover").hidden = true;
  }

  private move(event: PointerEvent): void {
    const { held } = this;
    if (!held) {
      if (event.buttons === 0) this.light(this.hit(event), event);
      return;
    }
    if (!held.moved && Math.hypot(event.clientX - held.x, event.clientY - held.y) < STILL) return;
    if (!held.moved) {
      held.moved = true;
      held.waits = !held.joint;
      if (!held.joint) void ask("grip", { time: held.time, body: held.body, offset: held.offset, plant: !event.altKey, alone: model.partial && model.here === null, locks: model.locked })
        .then((answer) => this.answered(held, answer.ok, answer.words));
    }
    if (event.ctrlKey) held.plane.constant += (event.clientY - held.y) * this.stage.perPixel(held.plane); // up: away
    else { held.clientX += event.clientX - held.x; held.clientY += event.clientY - held.y; }
    held.x = event.clientX;
    held.y = event.clientY;
    held.next = this.stage.through(held).intersectPlane(held.plane, new THREE.Vector3());
    if (!held.waits) this.pull(held);
  }

  /** Continues with the mouse's present position, or lets go after a refusal. */
  private answered(held: Held, ok: boolean, words = ""): void {
    held.waits = false;
    if (!ok && !held.ended) { toast(words, "wrong"); held.ended = true; } // what follows from it is not reported
    if (this.held !== held) return;
    if (ok) this.pull(held);
    else void this.cancel();
  }

  /** The rotation about a drag's joint to a place, wxyz. */
  private turnOf({ begin, pivot }: Held, to: THREE.Vector3): number[] {
    const [from, now] = [begin, to].map((place) => place.clone().sub(pivot).normalize());
    const { x, y, z, w } = new THREE.Quaternion().setFromUnitVectors(from, now);
    return [w, x, y, z];
  }

  /** Requests the pose for the mouse's last position. */
  private pull(held: Held): void {
    if (!held.next) return;
    const position = held.next.toArray();
    const answered = held.joint ? ask("turn", { time: held.time, joint: held.joint.name, turn: this.turnOf(held, held.next), locks: model.locked }) : ask("drag", { position });
    held.next = null;
    held.waits = true;
    void answered.then((answer) => {
      if (answer.ok && !held.ended && (this.held === held || !this.held)) {
        this.stage.show(answer);
        this.stage.figure!.put(this.stage.override!);
        this.mark.visible = this.held === held;
        this.mark.position.copy(this.stage.placeOf(held.body, held.offset));
        (this.mark.material as THREE.MeshBasicMaterial).color.set((answer.missed as number) > 0.005 ? 0xff5c5c : 0xffb454);
      }
      this.answered(held, answer.ok, answer.words);
    });
  }

  /** Ends the drag at once: what is still being posed is answered before the pose is dropped, and another drag may begin. */
  private async up(event: PointerEvent): Promise<void> {
    const { held } = this;
    if (!held || event.button !== 0) return;
    this.held = null;
    this.stage.orbit.enabled = true;
    this.stage.canvas.style.cursor = "";
    this.mark.visible = false;
    if (!held.moved) {
      model.choose(this.jointOf(held.body)?.name ?? null);
      return;
    }
    this.pull(held);
    await drop(held.time);
    held.ended = true;
    if (!this.held) this.stage.override = null;
    this.stage.draw();
  }
}
