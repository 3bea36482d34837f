// The axes of an object's position on the stage: the world's, or those of its body.
import * as THREE from "three";
import { model, type Obstacle } from "./model";
import type { Stage } from "./stage";

/** turn: its own in those axes; within: theirs in the world; out and into: places from there to the world, and back. */
export interface Axes {
  turn: THREE.Quaternion; within: THREE.Quaternion;
  out: (point: THREE.Vector3) => THREE.Vector3; into: (point: THREE.Vector3) => THREE.Vector3;
}

export const axesOf = (stage: Stage, obstacle: Obstacle): Axes => {
  const at = new THREE.Vector3().fromArray((obstacle.position as number[] | undefined) ?? [0, 0, 0]), pieces = model.stage?.pieces ?? [];
  const near = (given: number[]) => at.distanceTo(new THREE.Vector3().fromArray(given)) < 1e-4;
  const piece = pieces.find((each) => each.kind === obstacle.kind && each.name === obstacle.name) ?? pieces.find((each) => each.kind === obstacle.kind && near(each.position));
  const body = obstacle.body === undefined || obstacle.body === null ? -1 : model.stage?.bodies.indexOf(obstacle.body as string) ?? -1;
  const group = stage.figure?.groups[body];
  const within = group ? group.quaternion.clone() : new THREE.Quaternion(), place = group ? group.position.clone() : new THREE.Vector3();
  return {
    turn: new THREE.Quaternion().fromArray(piece?.rotation ?? [0, 0, 0, 1]),
    within,
    out: (point) => point.clone().applyQuaternion(within).add(place),
    into: (point) => point.clone().sub(place).applyQuaternion(within.clone().invert()),
  };
};
