// Handles that resize obstacles: on faces, at ends, on curved surfaces.
import * as THREE from "three";
import { axesOf } from "./axes";
import { short, toast } from "./dom";
import { addressOf, change } from "./link";
import { model, type Obstacle } from "./model";
import type { Stage } from "./stage";

type Entries = Record<string, unknown>;
/** Its position; the direction of dragging, or null for any; the obstacle's entries after dragging so far, or to a position. */
interface Handle { at: THREE.Vector3; along: THREE.Vector3 | null; entries: (by: number, to: THREE.Vector3) => Entries; }

const NEAR = 11; // [px] from a handle within which it is taken
const LEAST = 0.02; // [m] of a side
const AXES = [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)];

const vector = (given: unknown): THREE.Vector3 => new THREE.Vector3().fromArray((given as number[] | undefined) ?? [0, 0, 0]);
const rounded = (value: unknown): unknown => (Array.isArray(value) ? value.map((each) => Math.round(1000 * each) / 1000) : typeof value === "number" ? Math.round(1000 * value) / 1000 : value);

export class Handles {
  private readonly spots = new THREE.Group();
  private readonly frame = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0xffb454, depthTest: false, transparent: true }));
  private readonly ball = new THREE.SphereGeometry(1, 14, 10);
  private readonly paint = new THREE.MeshBasicMaterial({ color: 0xffb454, depthTest: false, transparent: true, opacity: 0.95 });
  private shown: Handle[] = [];
  private held: { handle: Handle; obstacle: Obstacle; revision: number; entries: Entries } | null = null;

  constructor(private readonly stage: Stage) {
    const { canvas } = stage;
    this.frame.visible = false;
    this.frame.renderOrder = 9;
    stage.extra.add(this.spots, this.frame);
    canvas.addEventListener("pointerdown", (event) => this.down(event), true);
    canvas.addEventListener("pointermove", (event) => this.move(event), true);
    window.addEventListener("pointerup", (event) => void this.up(event));
    model.on(["joint", "document", "stage"], () => stage.draw());
    stage.sights.push(() => this.place());
  }

  get busy(): boolean { return this.held !== null; }

  /** [px] where they are on the page, in order. */
  places(): number[][] { this.place(); return this.shown.map(({ at }) => this.seen(at)); }

  cancel(): void {
    this.held = null;
    this.frame.visible = false;
    this.stage.orbit.enabled = true;
    this.stage.draw();
  }

  private obstacle(): Obstacle | null {
    const { obstacle, document } = model;
    if (!obstacle || model.playing || !this.stage.figure) return null;
    return document?.obstacles.find((each) => each.kind === obstacle.kind && each.index === obstacle.index) ?? null;
  }

  private handles(obstacle: Obstacle): Handle[] {
    if (obstacle.kind === "step") return this.ofStep(obstacle);
    const { turn, out, into, within } = axesOf(this.stage, obstacle), at = vector(obstacle.position), radius = obstacle.radius as number;
    const handle = (direction: THREE.Vector3, away: number, entries: Handle["entries"]): Handle => ({
      at: out(at.clone().addScaledVector(direction, away)), along: direction.clone().applyQuaternion(within), entries,
    });
    const moved = (direction: THREE.Vector3, by: number) => at.clone().addScaledVector(direction, by / 2).toArray();
    const wider = (direction: THREE.Vector3) => handle(direction, radius, (by) => ({ radius: Math.max(LEAST / 2, radius + by) }));
    if (obstacle.kind === "box") {
      const size = obstacle.size as number[];
      return [0, 1, 2].flatMap((k) => [1, -1].map((sign) => {
        const direction = AXES[k].clone().multiplyScalar(sign).applyQuaternion(turn);
        return handle(direction, size[k] / 2, (given) => {
          const by = Math.max(given, LEAST - size[k]);
          return { size: size.map((side, i) => (i === k ? side + by : side)), position: moved(direction, by) };
        });
      }));
    }
    if (obstacle.kind === "sphere") return AXES.map((axis) => wider(axis));
    if (obstacle.from && obstacle.to) {
      const ends = [vector(obstacle.from), vector(obstacle.to)], along = ends[1].clone().sub(ends[0]).normalize();
      const side = new THREE.Vector3().crossVectors(along, Math.abs(along.z) < 0.9 ? AXES[2] : AXES[0]).normalize();
      at.copy(ends[0]).add(ends[1]).multiplyScalar(0.5);
      return [
        ...(["from", "to"] as const).map((name, i) => ({ at: out(ends[i]), along: null, entries: (_: number, to: THREE.Vector3) => ({ [name]: into(to).toArray() }) })),
        wider(side),
      ];
    }
    const length = obstacle.length as number, long = AXES[2].clone().applyQuaternion(turn);
    return [
      ...[1, -1].map((sign) => {
        const direction = long.clone().multiplyScalar(sign);
        return handle(direction, length / 2, (given) => {
          const by = Math.max(given, LEAST - length);
          return { length: length + by, position: moved(direction, by) };
        });
      }),
      wider(AXES[0].clone().applyQuaternion(turn)),
    ];
  }

  private ofStep(obstacle: Obstacle): Handle[] {
    const { x, height, y = 0, length = 3, width = 2.4 } = obstacle as unknown as Record<string, number>;
    const at = (u: number, v: number, z: number) => new THREE.Vector3(x + u, y + v, z), most = (side: number, by: number) => Math.max(by, LEAST - side);
    return [
      { at: at(length / 2, 0, height), along: AXES[2], entries: (by) => ({ height: height + most(height, by) }) },
      { at: at(0, 0, height / 2), along: AXES[0].clone().negate(), entries: (by) => ({ x: x - most(length, by), length: length + most(length, by) }) },
      { at: at(length, 0, height / 2), along: AXES[0], entries: (by) => ({ length: length + most(length, by) }) },
      ...[1, -1].map((sign) => ({
        at: at(length / 2, (sign * width) / 2, height / 2), along: AXES[1].clone().multiplyScalar(sign),
        entries: (by: number) => ({ width: width + most(width, by), y: y + (sign * most(width, by)) / 2 }),
      })),
    ];
  }

  private place(): void {
    const obstacle = this.obstacle();
    this.shown = obstacle && !this.held ? this.handles(obstacle) : this.held ? this.shown : [];
    while (this.spots.children.length < this.shown.length) {
      const spot = new THREE.Mesh(this.ball, this.paint);
      spot.renderOrder = 11;
      this.spots.add(spot);
    }
    const tall = this.stage.canvas.getBoundingClientRect().height || 1;
    this.spots.children.forEach((spot, i) => {
      spot.visible = i < this.shown.length && !this.held;
      if (!spot.visible) return;
      spot.position.copy(this.shown[i].at);
      const away = spot.position.distanceTo(this.stage.camera.position);
      spot.scale.setScalar((5.5 / tall) * 2 * away * Math.tan((this.stage.camera.fov * Math.PI) / 360));
    });
  }

  private seen(point: THREE.Vector3): number[] {
    const at = point.clone().project(this.stage.camera), box = this.stage.canvas.getBoundingClientRect();
    return [box.left + ((at.x + 1) / 2) * box.width, box.top + ((1 - at.y) / 2) * box.height, at.z];
  }

  private found(event: PointerEvent): Handle | null {
    const away = this.shown.map((handle) => ({ handle, px: this.seen(handle.at) })).filter(({ px }) => px[2] < 1)
      .map(({ handle, px }) => ({ handle, px: Math.hypot(px[0] - event.clientX, px[1] - event.clientY) }));
    const nearest = away.sort((a, b) => a.px - b.px)[0];
    return nearest && nearest.px < NEAR ? nearest.handle : null;
  }

  private down(event: PointerEvent): void {
    const obstacle = this.obstacle(), handle = obstacle && event.button === 0 ? this.found(event) : null;
    if (!obstacle || !handle) return;
    event.stopImmediatePropagation();
    this.stage.orbit.enabled = false;
    this.stage.canvas.setPointerCapture(event.pointerId);
    this.held = { handle, obstacle, revision: model.document!.revision, entries: {} };
  }

  private move(event: PointerEvent): void {
    const { held } = this;
    if (!held) {
      if (event.buttons === 0 && this.shown.length && this.found(event)) { this.stage.canvas.style.cursor = "grab"; event.stopImmediatePropagation(); }
      return;
    }
    event.stopImmediatePropagation();
    const { at, along } = held.handle, ray = this.stage.through(event), { origin, direction } = ray;
    let by = 0, to = at.clone();
    if (along) {
      const between = origin.clone().sub(at), b = along.dot(direction), sine = 1 - b * b;
      if (sine < 1e-4) return; // seen along itself
      by = (along.dot(between) - b * direction.dot(between)) / sine;
    } else {
      const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new THREE.Vector3()), at);
      to = ray.intersectPlane(plane, new THREE.Vector3()) ?? to;
    }
    held.entries = Object.fromEntries(Object.entries(held.handle.entries(by, to)).map(([name, value]) => [name, rounded(value)]));
    toast(Object.entries(held.entries).map(([name, value]) => `${name} ${[value].flat().map((each) => short(each as number)).join(" ")} m`).join(", "), "note");
    this.outline({ ...held.obstacle, ...held.entries } as Obstacle);
    this.stage.draw();
  }

  /** How large it would be. */
  private outline(obstacle: Obstacle): void {
    const { frame } = this, { turn, out, within } = axesOf(this.stage, { ...obstacle, position: this.held!.obstacle.position } as Obstacle);
    const { x, height, y = 0, length = obstacle.kind === "step" ? 3 : 1, width = 2.4, radius } = obstacle as unknown as Record<string, number>;
    frame.geometry.dispose();
    frame.quaternion.copy(within).multiply(turn);
    frame.position.copy(out(vector(obstacle.position)));
    let whole: THREE.BufferGeometry;
    if (obstacle.kind === "step") {
      whole = new THREE.BoxGeometry(length, width, height);
      frame.position.set(x + length / 2, y, height / 2);
      frame.quaternion.identity();
    } else if (obstacle.kind === "box") whole = new THREE.BoxGeometry(...(obstacle.size as [number, number, number]));
    else if (obstacle.kind === "sphere") whole = new THREE.IcosahedronGeometry(radius, 1);
    else {
      const ends = obstacle.from && obstacle.to ? [vector(obstacle.from), vector(obstacle.to)] : null;
      whole = new THREE.CylinderGeometry(radius, radius, ends ? ends[0].distanceTo(ends[1]) : length, 12).rotateX(Math.PI / 2);
      if (ends) {
        frame.position.copy(out(ends[0].clone().add(ends[1]).multiplyScalar(0.5)));
        frame.quaternion.copy(within).multiply(new THREE.Quaternion().setFromUnitVectors(AXES[2], ends[1].clone().sub(ends[0]).normalize()));
      }
    }
    frame.geometry = new THREE.EdgesGeometry(whole, 1);
    whole.dispose();
    frame.visible = true;
  }

  private async up(event: PointerEvent): Promise<void> {
    const { held } = this;
    if (!held || event.button !== 0) return;
    const { obstacle, entries, revision } = held;
    this.cancel();
    if (Object.keys(entries).length) await change(addressOf(obstacle), entries, revision);
  }
}
