// A figure on a scene: a group for every body, and poses for them.
import * as THREE from "three";
import { Merged } from "./merged";
import type { Part, Piece, Shapes } from "./shapes";

export interface Pose { position: ArrayLike<number>; rotation: ArrayLike<number>; }

export const UNSEEN = 1; // the layer of what is only taken hold of

const turn = new THREE.Quaternion();

/** A material for figures that are seen through, nearest parts only: put on meshes in this order. */
export const veil = (colour: number, opacity: number, behind = 0.05): THREE.Material[] => {
  const paints = [
    new THREE.MeshBasicMaterial({ colorWrite: false, transparent: true }),
    new THREE.MeshLambertMaterial({ color: colour, transparent: true, opacity, depthWrite: false }),
  ];
  // Where both nearly coincide the solid one shows: to the depth test the ghost lies a few centimetres behind its place
  for (const paint of paints) paint.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>
      vec4 behind = projectionMatrix * vec4(mvPosition.xyz + ${behind.toFixed(3)} * normalize(mvPosition.xyz), 1.0);
      gl_Position.z = behind.z / behind.w * gl_Position.w;`);
  };
  return paints;
};

export class Figure {
  readonly root = new THREE.Group();
  readonly groups: THREE.Group[];
  readonly planes: { mesh: THREE.Mesh; part: Part }[] = [];
  private readonly merged: Merged | null = null;
  private readonly rough: Merged | null = null; // of fewer, in place of the merged one, and of a ghost

  /** veils: materials of a ghost; none for the figure itself; rough: triangles of a body where it is one mesh, of few points */
  constructor(bodies: string[], pieces: Piece[], shapes: Shapes, veils?: THREE.Material[], rough = 0) {
    this.groups = bodies.map((name, body) => Object.assign(new THREE.Group(), { name, userData: { body } }));
    const parts = shapes.parts(pieces), joined = rough ? parts.filter((part) => part.joined) : [];
    if (joined.length) {
      this.merged = veils ? null : new Merged(joined, [joined[0].material]);
      this.rough = new Merged(joined, veils ?? [joined[0].material], rough);
      for (const each of [this.merged, this.rough]) if (each) this.root.add(each.mesh);
      this.isRough = veils !== undefined;
    }
    for (const part of veils ? parts.filter((each) => !joined.includes(each)) : parts) {
      (veils ?? [part.material]).forEach((paint, order) => {
        const mesh = new THREE.Mesh(part.geometry, paint);
        if (veils) mesh.renderOrder = 1 + order;
        mesh.castShadow = !veils && part.casts;
        mesh.receiveShadow = !veils;
        if (joined.includes(part)) mesh.layers.set(UNSEEN);
        if (part.plain) this.planes.push({ mesh, part });
        this.groups[part.body].add(mesh);
      });
    }
    this.root.add(...this.groups);
  }

  dispose(): void {
    this.root.removeFromParent();
    this.merged?.dispose();
    this.rough?.dispose();
  }

  /** Whether it is drawn with fewer triangles; poses that are put count from here on. */
  set isRough(yes: boolean) {
    if (this.merged) this.merged.mesh.visible = !yes;
    if (this.rough) this.rough.mesh.visible = yes;
  }

  /** Bodies where a pose has them: positions (B, 3) and rotations (B, 4) xyzw, one after the other. */
  put(pose: Pose): void {
    this.groups.forEach((group, body) => {
      group.position.fromArray(pose.position as number[], 3 * body);
      group.quaternion.fromArray(pose.rotation as number[], 4 * body);
    });
    for (const mesh of [this.merged, this.rough]) if (mesh?.mesh.visible) mesh.put(pose);
  }
}

/** Where a point of a body is in a pose, whose bodies begin at a number. */
export const pointOf = ({ position, rotation }: Pose, { body, offset }: { body: number; offset: number[] }, begin = 0): THREE.Vector3 =>
  new THREE.Vector3().fromArray(offset).applyQuaternion(turn.fromArray(rotation as number[], 4 * (begin + body))).add(new THREE.Vector3().fromArray(position as number[], 3 * (begin + body)));

/** A pose that is a share of the way from one to another, written into the third. */
export const mixed = (a: Pose, b: Pose, share: number, out: { position: Float32Array; rotation: Float32Array }): void => {
  const other = new THREE.Quaternion();
  for (let i = 0; i < out.position.length; i++) out.position[i] = a.position[i] + share * (b.position[i] - a.position[i]);
  for (let i = 0; i < out.rotation.length; i += 4) {
    turn.fromArray(a.rotation as number[], i).slerp(other.fromArray(b.rotation as number[], i), share).toArray(out.rotation, i);
  }
};
