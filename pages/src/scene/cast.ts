// The shadow of a mesh on level ground, its own triangles laid flat: for a processor that draws far less than a shadow map.
import * as THREE from "three";
import type { Piece } from "./shapes";

const LEVEL = 1e-3; // of a normal that may lean
const LIFTED = 0.003; // [m] above the ground
const MOST = 6; // grounds

const VERTEX = `
uniform float top; uniform vec2 slope; varying vec2 at;
void main() {
  at = position.xy - max(position.z - top, 0.0) * slope;
  gl_Position = projectionMatrix * viewMatrix * vec4(at, top + ${LIFTED.toFixed(4)}, 1.0);
}`;
const FRAGMENT = `
uniform vec4 field; uniform vec2 turn; uniform float dark; varying vec2 at;
void main() {
  vec2 away = at - field.xy;
  if (abs(dot(away, turn)) > field.z || abs(dot(away, vec2(-turn.y, turn.x))) > field.w) discard;
  gl_FragColor = vec4(0.0, 0.0, 0.0, dark);
}`;

/** Shadows on planes and on what has a level top, of a mesh in the world's axes. */
export class Cast {
  readonly root = new THREE.Group();

  /** light: where it comes from; dark: how much darker it is there, as on a screen; bodies: what still pieces lie on */
  constructor(geometry: THREE.BufferGeometry, pieces: Piece[], bodies: THREE.Object3D[], light: THREE.Vector3, dark: number) {
    const grounds = pieces.filter(({ kind, colour }) => (kind === "plane" || kind === "box") && colour[3] === 1);
    grounds.forEach((piece) => {
      const turn = new THREE.Quaternion().fromArray(piece.rotation).premultiply(bodies[piece.body].quaternion);
      const up = new THREE.Vector3(0, 0, 1).applyQuaternion(turn), along = new THREE.Vector3(1, 0, 0).applyQuaternion(turn);
      if (up.z < 1 - LEVEL || this.root.children.length >= MOST) return;
      const at = new THREE.Vector3().fromArray(piece.position).applyQuaternion(bodies[piece.body].quaternion).add(bodies[piece.body].position);
      const ref = this.root.children.length + 1;
      const paint = new THREE.ShaderMaterial({
        vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthWrite: false, side: THREE.DoubleSide,
        stencilWrite: true, stencilRef: ref, stencilFunc: THREE.NotEqualStencilFunc, stencilZPass: THREE.ReplaceStencilOp,
        uniforms: {
          top: { value: at.z + (piece.kind === "box" ? piece.size[2] : 0) },
          slope: { value: new THREE.Vector2(light.x / light.z, light.y / light.z) },
          field: { value: new THREE.Vector4(at.x, at.y, piece.size[0], piece.size[1]) },
          turn: { value: new THREE.Vector2(along.x, along.y).normalize() },
          dark: { value: dark },
        },
      });
      const mesh = new THREE.Mesh(geometry, paint);
      mesh.frustumCulled = false;
      this.root.add(mesh);
    });
  }

  dispose(): void {
    this.root.removeFromParent();
    for (const mesh of this.root.children) ((mesh as THREE.Mesh).material as THREE.Material).dispose();
  }
}
