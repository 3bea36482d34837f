// Where hands, feet and the centre of mass go, as lines with beads at keyframes; contact points by how they are.
import * as THREE from "three";
import type { Path } from "../scene/path";
import { model, type Marked } from "./model";
import type { Stage } from "./stage";

const COLOURS = [0x6cc4ff, 0xffa45c, 0x8be28b, 0xff8fb3, 0xc9a8ff, 0xffe08a, 0x7fe0d4];
const CENTRE = 0xf5f5f5;

export class Trails {
  private readonly lines = new THREE.Group();
  private readonly dots = new THREE.Group();
  private readonly spot = new THREE.SphereGeometry(0.016, 12, 8);
  private readonly paints: Record<string, THREE.MeshBasicMaterial> = {
    rests: new THREE.MeshBasicMaterial({ color: 0x5fd38d, depthTest: false, transparent: true }),
    stands: new THREE.MeshBasicMaterial({ color: 0x58a6ff, depthTest: false, transparent: true }),
    free: new THREE.MeshBasicMaterial({ color: 0x9aa4b0, depthTest: false, transparent: true, opacity: 0.5 }),
  };

  constructor(private readonly stage: Stage) {
    stage.extra.add(this.lines, this.dots);
    model.on(["path", "shown", "stage", "document"], () => this.draw());
    stage.sights.push(() => this.colour());
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
    for (const line of [...this.lines.children]) { line.removeFromParent(); (line as THREE.Line).geometry.dispose(); }
    const { now, stage } = model;
    if (model.trails && now && stage && now.bodies === stage.bodies.length) {
      this.ends().forEach((end, i) => this.line(this.places(now, end), COLOURS[i % COLOURS.length]));
      this.line(Array.from({ length: now.count }, (_, i) => new THREE.Vector3().fromArray(now.centre, 3 * i)), CENTRE);
    }
    this.stage.draw();
  }

  private places(path: Path, mark: Marked): THREE.Vector3[] {
    const turn = new THREE.Quaternion(), offset = new THREE.Vector3().fromArray(mark.offset);
    return Array.from({ length: path.count }, (_, i) => {
      const at = i * path.bodies + mark.body;
      return offset.clone().applyQuaternion(turn.fromArray(path.rotation, 4 * at)).add(new THREE.Vector3().fromArray(path.position, 3 * at));
    });
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

  /** Contact points: green that rest in a contact, blue that stand, grey that are free. */
  private colour(): void {
    const { stage, loaded, document, time } = model;
    const shown = model.trails && stage !== null && this.stage.figure !== null;
    const soles = shown ? stage.soles : [];
    while (this.dots.children.length < soles.length) {
      const dot = new THREE.Mesh(this.spot, this.paints.free);
      dot.renderOrder = 9;
      this.dots.add(dot);
    }
    this.dots.children.forEach((dot, i) => {
      dot.visible = i < soles.length;
      if (!dot.visible) return;
      const sole = soles[i], in_ = (bar: { from: number; to: number }) => bar.from - 1e-6 <= time && time <= bar.to + 1e-6;
      const rests = document?.contacts.some((bar) => bar.point === sole.name && in_(bar));
      const stands = loaded?.stances.some((bar) => bar.point === sole.name && in_(bar));
      (dot as THREE.Mesh).material = this.paints[rests ? "rests" : stands ? "stands" : "free"];
      dot.position.copy(this.stage.placeOf(sole.body, sole.offset));
    });
  }
}
