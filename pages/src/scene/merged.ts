// All of a figure as one mesh in the world's axes, moved point by point here: a processor that draws pays by the mesh.
import * as THREE from "three";
import type { Pose } from "./figure";
import { clustered, type Part } from "./shapes";

export class Merged {
  readonly mesh: THREE.Mesh;
  private readonly spans: { body: number; begin: number; end: number }[] = []; // of points
  private readonly points: Float32Array;
  private readonly normals: Float32Array;

  /** parts: with colours at their points, in their bodies' axes; materials: put on in this order, or that of the figure
   * itself; most: triangles of each part */
  constructor(given: Part[], materials: THREE.Material[], most = Infinity) {
    const parts = given.map((part) => ({ body: part.body, geometry: fewer(part.geometry, most) }));
    const size = parts.reduce((sum, part) => sum + part.geometry.attributes.position.count, 0);
    this.points = new Float32Array(3 * size);
    this.normals = new Float32Array(3 * size);
    const colours = new Float32Array(3 * size), faces: number[] = [];
    let begin = 0;
    for (const { body, geometry } of parts) {
      const { position, normal, color } = geometry.attributes, end = begin + position.count;
      this.points.set(position.array, 3 * begin);
      this.normals.set(normal.array, 3 * begin);
      if (color) colours.set(color.array, 3 * begin);
      const corners = geometry.index ? Array.from(geometry.index.array) : Array.from({ length: position.count }, (_, i) => i);
      for (const corner of corners) faces.push(begin + corner);
      this.spans.push({ body, begin, end });
      begin = end;
    }
    const geometry = new THREE.BufferGeometry();
    for (const name of ["position", "normal"]) {
      geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * size), 3).setUsage(THREE.DynamicDrawUsage));
    }
    geometry.setAttribute("color", new THREE.BufferAttribute(colours, 3));
    geometry.setIndex(faces);
    const single = materials.length === 1, meshes = materials.map((material, order) => Object.assign(new THREE.Mesh(geometry, material), {
      castShadow: single, receiveShadow: single, frustumCulled: false, matrixAutoUpdate: false, renderOrder: single ? 0 : 1 + order,
      raycast: () => {}, // it is of no one body: what is taken hold of are their own meshes
    }));
    this.mesh = meshes[0];
    for (const other of meshes.slice(1)) this.mesh.add(other);
  }

  put(pose: Pose): void {
    const { position, normal } = this.mesh.geometry.attributes;
    const turn = new THREE.Matrix4(), quaternion = new THREE.Quaternion();
    for (const { body, begin, end } of this.spans) {
      turn.makeRotationFromQuaternion(quaternion.fromArray(pose.rotation as number[], 4 * body));
      const [a, b, c, , d, e, f, , g, h, i] = turn.elements;
      const x = pose.position[3 * body], y = pose.position[3 * body + 1], z = pose.position[3 * body + 2];
      moved(this.points, position.array as Float32Array, begin, end, a, b, c, d, e, f, g, h, i, x, y, z);
      moved(this.normals, normal.array as Float32Array, begin, end, a, b, c, d, e, f, g, h, i, 0, 0, 0);
    }
    position.needsUpdate = normal.needsUpdate = true;
  }

  dispose(): void { this.mesh.geometry.dispose(); }
}

const fewer = (geometry: THREE.BufferGeometry, most: number): THREE.BufferGeometry => {
  const { position, color } = geometry.attributes, corners = geometry.index?.array ?? Uint32Array.from({ length: position.count }, (_, i) => i);
  if (corners.length <= 3 * most) return geometry;
  return (geometry.userData[most] ??= clustered(position.array as Float32Array, Uint32Array.from(corners), most, color?.array)); // for all ghosts
};

/** Points turned by a matrix, column by column, and moved. */
const moved = (
  from: Float32Array, to: Float32Array, begin: number, end: number, a: number, b: number, c: number, d: number, e: number,
  f: number, g: number, h: number, i: number, x: number, y: number, z: number,
): void => {
  for (let k = 3 * begin; k < 3 * end; k += 3) {
    const p = from[k], q = from[k + 1], r = from[k + 2];
    to[k] = a * p + d * q + g * r + x;
    to[k + 1] = b * p + e * q + h * r + y;
    to[k + 2] = c * p + f * q + i * r + z;
  }
};
