// Rings about a joint that turn it; the server says what pose that is.
import * as THREE from "three";
import { TransformControls } from "three/examples/jsm/controls/TransformControls.js";
import { act, ask, edit } from "./link";
import { model } from "./model";
import type { Stage } from "./stage";

export class Gizmo {
  private readonly controls: TransformControls;
  private readonly handle = new THREE.Object3D();
  private readonly begin = new THREE.Quaternion();
  private revision = 0;
  private dragging = false;
  private waiting = false;
  private again = false;

  constructor(private readonly stage: Stage) {
    this.controls = new TransformControls(stage.camera, stage.canvas);
    this.controls.setSize(0.7);
    stage.extra.add(this.handle, this.controls.getHelper());
    this.controls.getHelper().visible = false;
    this.controls.enabled = false;
    this.controls.addEventListener("change", () => stage.draw());
    this.controls.addEventListener("mouseDown", () => this.start());
    this.controls.addEventListener("mouseUp", () => void this.end());
    this.controls.addEventListener("objectChange", () => this.changed());
    model.on(["joint", "time", "path", "selection"], () => this.place());
    stage.sights.push(() => {
      stage.canvas.dataset.gizmo = this.controls.axis ? "on" : "";
      if (!this.dragging) this.place();
    });
  }

  private place(): void {
    const shown = (model.joint !== null || model.obstacle !== null) && !model.playing && this.stage.figure !== null;
    if (!shown) {
      if (this.controls.object) { this.controls.detach(); this.controls.enabled = false; }
      return;
    }
    if (this.dragging) return;
    if (model.joint !== null) {
      const joint = model.stage?.joints.find((each) => each.name === model.joint);
      if (!joint) return;
      const group = this.stage.figure!.groups[joint.body];
      this.handle.position.copy(this.stage.placeOf(joint.body, joint.anchor));
      this.handle.quaternion.copy(group.quaternion);
      this.controls.setMode("rotate");
      const single = joint.kind === "hinge" ? joint.axis.map(Math.abs) : null;
      const main = single ? single.indexOf(Math.max(...single)) : -1;
      this.controls.showX = !single || main === 0;
      this.controls.showY = !single || main === 1;
      this.controls.showZ = !single || main === 2;
      this.controls.setSpace("local");
    } else {
      const thing = this.thing();
      const at = thing?.position as number[] | undefined;
      if (!thing || (!at && thing.kind !== "step")) return;
      this.handle.position.fromArray(at ?? [thing.x as number, (thing.y as number) ?? 0, thing.height as number]);
      this.handle.quaternion.identity();
      this.controls.setMode("translate");
      Object.assign(this.controls, { showX: true, showY: true, showZ: true });
      this.controls.setSpace("world");
    }
    if (this.controls.object !== this.handle) this.controls.attach(this.handle);
    this.controls.enabled = true;
  }

  private thing() {
    const { obstacle, document } = model;
    return document?.obstacles.find((each) => each.kind === obstacle?.kind && each.index === obstacle?.index);
  }

  private start(): void {
    this.dragging = true;
    this.revision = model.document?.revision ?? 0;
    this.stage.orbit.enabled = false;
    this.begin.copy(this.handle.quaternion);
  }

  private changed(): void {
    if (!this.dragging || model.joint === null) return;
    if (this.waiting) { this.again = true; return; }
    const turn = this.handle.quaternion.clone().multiply(this.begin.clone().invert());
    this.waiting = true;
    void ask("turn", { time: model.time, joint: model.joint, turn: [turn.w, turn.x, turn.y, turn.z], partial: model.partial }).then((answer) => {
      this.waiting = false;
      if (answer.ok && this.dragging) {
        this.stage.override = { position: answer.position as number[], rotation: answer.rotation as number[] };
        this.stage.draw();
      }
      if (this.again) { this.again = false; this.changed(); }
    });
  }

  private async end(): Promise<void> {
    while (this.waiting) await new Promise((resolve) => window.setTimeout(resolve, 4));
    this.dragging = false;
    this.stage.orbit.enabled = true;
    if (model.joint !== null) await act("drop", { time: model.time, partial: model.partial });
    else if (model.obstacle) {
      const [x, y, z] = this.handle.position.toArray().map((value) => Math.round(1000 * value) / 1000);
      const said = model.obstacle.kind === "step" ? { x, y, height: Math.max(0.02, z) } : { position: [x, y, z] };
      await edit("set_obstacle", { kind: model.obstacle.kind, index: model.obstacle.index, said, revision: this.revision });
    }
    this.stage.override = null;
    this.stage.draw();
  }
}
