// Rings that rotate a joint, of which the server computes the pose; arrows that move or resize an obstacle.
import * as THREE from "three";
import { TransformControls } from "three/examples/jsm/controls/TransformControls.js";
import { axesOf } from "./axes";
import { short, toast } from "./dom";
import { addressOf, ask, change, drop } from "./link";
import { model, type Obstacle } from "./model";
import type { Stage } from "./stage";

const rounded = (place: THREE.Vector3): number[] => place.toArray().map((value) => Math.round(1000 * value) / 1000);
const ends = ({ from, to }: Obstacle): THREE.Vector3[] => [from, to].map((end) => new THREE.Vector3().fromArray(end as number[]));

/** Where the arrows of an obstacle are: in its middle, on a step's front edge. */
const placeOf = (obstacle: Obstacle): THREE.Vector3 | undefined => {
  if (obstacle.kind === "step") return new THREE.Vector3(obstacle.x as number, (obstacle.y as number) ?? 0, obstacle.height as number);
  if (obstacle.position) return new THREE.Vector3().fromArray(obstacle.position as number[]);
  if (!obstacle.from || !obstacle.to) return undefined;
  const [from, to] = ends(obstacle);
  return from.add(to).multiplyScalar(0.5);
};

/** The obstacle's entries after its arrows were dragged to a position. */
const movedTo = (obstacle: Obstacle, place: THREE.Vector3): Record<string, unknown> => {
  const [x, y, z] = rounded(place);
  if (obstacle.kind === "step") return { x, y, height: Math.max(0.02, z) };
  if (obstacle.position) return { position: [x, y, z] };
  const by = place.clone().sub(placeOf(obstacle)!), [from, to] = ends(obstacle);
  return { from: rounded(from.add(by)), to: rounded(to.add(by)) };
};

const LEAST = 0.02; // [m] of a side
const UP = new THREE.Vector3(0, 0, 1);

/** The sides of an obstacle along the axes of its arrows [m], and its middle from where they scale it. */
const sidesOf = (obstacle: Obstacle): { sides: number[]; middle: number[] } => {
  const { height = 0.2, length = 3, width = 2.4, radius = 0 } = obstacle as unknown as Record<string, number>;
  if (obstacle.kind === "step") return { sides: [length, width, height], middle: [length / 2, 0, -height / 2] };
  if (obstacle.kind === "box") return { sides: obstacle.size as number[], middle: [0, 0, (obstacle.size as number[])[2] / 2] };
  const [from, to] = obstacle.from ? ends(obstacle) : [];
  return { sides: [2 * radius, 2 * radius, obstacle.kind === "sphere" ? 2 * radius : from ? from.distanceTo(to) : length], middle: [0, 0, 0] };
};

/** The entries of an obstacle that is scaled: a box stays on what it stands on, a step keeps its front edge. */
const resized = (obstacle: Obstacle, scale: THREE.Vector3, turn: THREE.Quaternion): Record<string, unknown> => {
  const { sides } = sidesOf(obstacle), [along, across, up] = sides.map((side, k) => Math.max(LEAST, side * Math.abs(scale.getComponent(k))));
  const near = (value: number): number => Math.round(1000 * value) / 1000;
  if (obstacle.kind === "step") return Object.fromEntries([["length", along], ["width", across], ["height", up]].filter((_, k) => scale.getComponent(k) !== 1));
  if (obstacle.kind === "box") {
    const rise = UP.clone().applyQuaternion(turn).multiplyScalar((up - sides[2]) / 2);
    return { size: [along, across, up].map(near), position: rounded(placeOf(obstacle)!.add(rise)) };
  }
  const wide = scale.x === 1 ? across : along;
  if (obstacle.kind === "sphere") return { radius: near((wide === sides[0] ? up : wide) / 2) };
  if (!obstacle.from) return { radius: near(wide / 2), length: near(up) };
  const middle = placeOf(obstacle)!, [from, to] = ends(obstacle).map((end) => rounded(end.sub(middle).multiplyScalar(up / sides[2]).add(middle)));
  return { radius: near(wide / 2), from, to };
};

export class Gizmo {
  private readonly controls: TransformControls;
  private readonly handle = new THREE.Object3D();
  private readonly begin = new THREE.Quaternion();
  private held: { obstacle: Obstacle | undefined; revision: number; time: number; waits: boolean; again: boolean } | null = null; // at the start of the drag

  private readonly frame = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxGeometry()), new THREE.LineBasicMaterial({ color: 0xffb454, depthTest: false, transparent: true }));

  constructor(private readonly stage: Stage) {
    this.controls = new TransformControls(stage.camera, stage.canvas);
    this.controls.setSize(0.7);
    stage.extra.add(this.handle.add(this.frame), this.controls.getHelper());
    this.controls.getHelper().visible = false;
    this.controls.enabled = false;
    this.controls.addEventListener("change", () => stage.draw());
    this.controls.addEventListener("mouseDown", () => this.start());
    this.controls.addEventListener("mouseUp", () => void this.end());
    this.controls.addEventListener("objectChange", () => this.changed());
    model.on(["joint", "time", "path", "selection"], () => this.place());
    stage.sights.push(() => {
      stage.canvas.dataset.gizmo = this.controls.axis ? "on" : "";
      if (!this.held) this.place();
    });
  }

  private place(): void {
    const { figure } = this.stage, obstacle = model.joint === null ? this.obstacle() : undefined;
    const own = obstacle && placeOf(obstacle), at = obstacle && own && axesOf(this.stage, obstacle).out(own);
    const joint = model.stage?.joints.find((each) => each.name === model.joint);
    if (model.playing || !figure || !(joint ?? at)) {
      this.hide();
      return;
    }
    if (this.held) return;
    this.frame.visible = !joint && model.resizes;
    if (joint) {
      const group = figure.groups[joint.body];
      this.handle.position.copy(this.stage.placeOf(joint.body, joint.anchor));
      this.handle.quaternion.copy(group.quaternion);
      this.controls.setMode("rotate");
      const single = joint.kind === "hinge" ? joint.axis.map(Math.abs) : null;
      const main = single ? single.indexOf(Math.max(...single)) : -1;
      this.controls.showX = !single || main === 0;
      this.controls.showY = !single || main === 1;
      this.controls.showZ = !single || main === 2;
      this.controls.setSpace("local");
    } else if (at && obstacle) {
      const { turn, within } = axesOf(this.stage, obstacle), { sides, middle } = sidesOf(obstacle), long = obstacle.from ? ends(obstacle) : null;
      if (long) turn.setFromUnitVectors(UP, long[1].sub(long[0]).normalize());
      this.handle.position.copy(at);
      this.handle.scale.setScalar(1);
      this.handle.quaternion.identity();
      if (model.resizes && obstacle.kind !== "step") this.handle.quaternion.copy(within).multiply(turn);
      if (model.resizes && obstacle.kind === "box") this.handle.translateZ(-sides[2] / 2);
      this.frame.scale.fromArray(sides);
      this.frame.position.fromArray(middle);
      this.controls.setMode(model.resizes ? "scale" : "translate");
      Object.assign(this.controls, { showX: true, showY: true, showZ: true });
      this.controls.setSpace("world");
    }
    if (this.controls.object !== this.handle) this.controls.attach(this.handle);
    this.controls.enabled = true;
  }

  /** Detaches the gizmo; an unfinished rotation or move is undone. */
  private hide(): void {
    const { held } = this;
    this.held = null;
    this.frame.visible = false;
    if (held) this.controls.pointerUp(null); // it receives no further mouse events
    if (this.controls.object) { this.controls.detach(); this.controls.enabled = false; }
    if (!held) return;
    this.stage.orbit.enabled = true;
    this.stage.override = null;
    void ask("cancel");
    this.stage.draw();
  }

  private obstacle(): Obstacle | undefined {
    const { obstacle, document } = model;
    return document?.obstacles.find((each) => each.kind === obstacle?.kind && each.index === obstacle?.index);
  }

  private start(): void {
    this.held = { obstacle: this.obstacle(), revision: model.document?.revision ?? 0, time: model.time, waits: false, again: false };
    this.stage.orbit.enabled = false;
    this.begin.copy(this.handle.quaternion);
  }

  private changed(): void {
    const { held } = this;
    if (held?.obstacle && model.resizes && model.joint === null) toast(this.entries(held.obstacle).map(([name, value]) => `${name} ${[value].flat().map((each) => short(each as number)).join(" ")} m`).join(", "), "note");
    if (!held || model.joint === null) return;
    held.again = true;
    if (!held.waits) this.turn(held);
  }

  /** Requests the pose for the present rotation. */
  private turn(held: NonNullable<Gizmo["held"]>): void {
    if (!held.again) return;
    const turn = this.handle.quaternion.clone().multiply(this.begin.clone().invert());
    held.again = false;
    held.waits = true;
    void ask("turn", { time: held.time, joint: model.joint, turn: [turn.w, turn.x, turn.y, turn.z], locks: model.locked }).then((answer) => {
      held.waits = false;
      if (this.held !== held) return;
      if (answer.ok) this.stage.show(answer);
      else toast(answer.words!, "wrong");
      this.turn(held);
    });
  }

  /** The obstacle's entries that its arrows have changed. */
  private entries(obstacle: Obstacle): [string, unknown][] {
    const { turn, into } = axesOf(this.stage, obstacle);
    const now = model.resizes ? resized(obstacle, this.handle.scale, turn) : movedTo(obstacle, into(this.handle.position));
    return Object.entries(now).filter(([name, value]) => String(value) !== String(obstacle[name]));
  }

  private async end(): Promise<void> {
    const { held } = this;
    if (!held) return; // released in the meantime
    if (model.joint !== null) this.turn(held);
    this.held = null;
    this.stage.orbit.enabled = true;
    if (model.joint !== null) await (this.handle.quaternion.equals(this.begin) ? ask("cancel") : drop(held.time)); // a click turns nothing
    else if (model.obstacle && held.obstacle) {
      await change(addressOf(model.obstacle), Object.fromEntries(this.entries(held.obstacle)), held.revision);
    }
    if (!this.held) this.stage.override = null;
    this.stage.draw();
  }
}
