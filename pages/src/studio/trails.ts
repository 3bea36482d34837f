// Where hands, feet and the centre of mass go, as lines with beads at keyframes.
import * as THREE from "three";
import { pointOf } from "../scene/figure";
import type { Path } from "../scene/path";
import { model, type Marked } from "./model";
import type { Stage } from "./stage";

const COLOURS = [0x6cc4ff, 0xffa45c, 0x8be28b, 0xff8fb3, 0xc9a8ff, 0xffe08a, 0x7fe0d4];
const CENTRE = 0xf5f5f5;

export class Trails {
  private readonly lines = new THREE.Group();

  constructor(private readonly stage: Stage) {
    stage.extra.add(this.lines);
    model.on(["path", "shown", "stage", "document"], () => this.draw());
  }

  /** Hands, feet, or what else lies at the ends of limbs. */
  private ends(): Marked[] {
    const { stage } = model;
    if (!stage) return [];
    const last = (body: number) => stage.sites.filter((site) => site.body === body).at(-1);
    return stage.limbs.filter((limb) => limb.name !== "root and trunk").map((limb) =>
      last(limb.end) ?? stage.soles.find((sole) => sole.body === limb.end) ?? { name: limb.name, body: limb.end, offset: [0, 0, 0] });
  }

  private draw(): void {
    for (const line of [...this.lines.children] as THREE.Line<THREE.BufferGeometry, THREE.Material>[]) {
      line.removeFromParent();
      line.geometry.dispose();
      line.material.dispose();
    }
    const { now, stage } = model;
    if (model.trails && now && stage && now.bodies === stage.bodies.length) {
      this.ends().forEach((end, i) => this.line(this.places(now, end), COLOURS[i % COLOURS.length]));
      this.line(Array.from({ length: now.count }, (_, i) => new THREE.Vector3().fromArray(now.centre, 3 * i)), CENTRE);
    }
    this.stage.draw();
  }

  private places(path: Path, mark: Marked): THREE.Vector3[] {
    return Array.from({ length: path.count }, (_, i) => pointOf(path, mark, i * path.bodies));
  }

  private line(points: THREE.Vector3[], colour: number): void {
    const paint = new THREE.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.85 });
    this.lines.add(new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), paint));
    const { now, document } = model;
    if (!now || !document) return;
    const beads = document.keys.map((key) => points[Math.min(points.length - 1, Math.max(0, Math.round((key.time - now.first) * now.rate)))]);
    const dots = new THREE.PointsMaterial({ color: colour, size: 5, sizeAttenuation: false });
    this.lines.add(new THREE.Points(new THREE.BufferGeometry().setFromPoints(beads), dots));
  }
}
