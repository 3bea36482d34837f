// Edits that the server has not confirmed yet, applied to the clip that it sent last: the page shows them at once.
import * as THREE from "three";
import type { KeyframeRow, KeyState, Loaded, Outline, Rotation, Stage } from "./model";

/** An edit in a request; later edits with the same stroke replace it as long as it waits, and are undone with it. */
export interface Edit { name: string; args: Record<string, any>; stroke?: string; }

type Table = Record<string, any>;
const GROUPS = ["root", "roots", "joints", "sites", "bodies"]; // tables of a keyframe of which an edit changes single entries

/** The address of a table in the clip, such as ["keyframe", 2]. */
export type Address = (string | number)[];

const quaternionOf = (rotvec: number[]): number[] => {
  const axis = new THREE.Vector3().fromArray(rotvec).multiplyScalar(Math.PI / 180), angle = axis.length();
  const { x, y, z, w } = new THREE.Quaternion().setFromAxisAngle(axis.normalize(), angle);
  return [w, x, y, z];
};

/** A table with entries changed; null removes one. */
const assigned = (table: Table, entries: Table): Table => {
  const out = { ...table };
  for (const [key, value] of Object.entries(entries)) {
    if (GROUPS.includes(key) && value !== null && typeof value === "object") {
      out[key] = key === "roots" ? { ...out[key] } : assigned(out[key] ?? {}, value);
      if (key === "roots") for (const [name, parts] of Object.entries(value)) out[key][name] = { ...out[key][name], ...(parts as Table) };
    } else if (value === null) delete out[key];
    else out[key] = value;
  }
  return out;
};

/** The clip with edits applied, as far as the page can tell their result. */
export const edited = (clip: Outline, edits: Edit[]): Outline => edits.reduce((before, { name, args }) => {
  const out: Outline = { ...before, dirty: true, undo: before.undo ?? name };
  const changed = <Row>(rows: Row[], isMeant: (row: Row, i: number) => boolean): Row[] => rows.map((row, i) => (isMeant(row, i) ? assigned(row as Table, args.entries) as Row : row));
  const [list, ...address] = (args.at ?? []) as Address, at = address.at(-1);
  if (name === "move_keys") {
    const times = new Map<number, number>(args.moves);
    out.keys = out.keys.map((key, i) => ({ ...key, time: times.get(i) ?? key.time }));
  } else if (name === "change" && list === "keyframe") out.keys = changed(out.keys, (_, i) => i === at);
  else if (name === "change" && list === "contact") out.contacts = changed(out.contacts, (_, i) => i === at);
  else if (name === "change" && list === "grasp") out.grasps = changed(out.grasps, (_, i) => i === at);
  else if (name === "change" && list === "scene") out.obstacles = changed(out.obstacles, ({ kind, index }) => kind === address[0] && (address.length === 1 || index === at));
  else if (name === "change" && list === "solve") out.solve = assigned(out.solve, args.entries);
  return out;
}, clip);

/** The poses of keyframes with edits applied. */
export const posed = (loaded: Loaded, edits: Edit[], stage: Stage): Loaded => {
  const keys = [...loaded.keys];
  for (const { name, args } of edits) {
    if (name !== "change" || args.at[0] !== "keyframe" || !keys[args.at[1]]) continue;
    const key = keys[args.at[1]] = { ...keys[args.at[1]], qpos: [...keys[args.at[1]].qpos], fixed: [...keys[args.at[1]].fixed] };
    const row = args.entries as Partial<KeyframeRow> & { roots?: Record<string, Table> }, root = stage.joints.find((joint) => joint.kind === "free");
    for (const joint of stage.joints) {
      const value = row.joints?.[joint.name], part = joint === root ? row.root : row.roots?.[joint.name];
      if (joint.kind !== "free") put(key, joint.qpos, joint.kind === "ball" ? turn(value) : typeof value === "number" ? [joint.kind === "hinge" ? value * Math.PI / 180 : value] : value);
      else if (part) {
        const { position, rotation } = part as NonNullable<KeyframeRow["root"]>;
        (Array.isArray(position) ? position : [position, position, position]).forEach((each, k) => put(key, joint.qpos + k, typeof each === "number" ? [each] : each));
        put(key, joint.qpos + 3, turn(rotation));
      }
    }
  }
  return { ...loaded, keys };
};

const turn = (value: Rotation | number | "free" | undefined) => (typeof value === "object" && value?.rotvec ? quaternionOf(value.rotvec) : value === "free" ? value : undefined);

/** Pins a joint's entries of a keyframe at values, or frees them; what is undefined or removed stays until the server has loaded it. */
const put = (key: KeyState, start: number, value: number[] | "free" | unknown): void => {
  if (value === "free") key.fixed[start] = false;
  else if (Array.isArray(value)) value.forEach((each, i) => { key.qpos[start + i] = each; key.fixed[start + i] = true; });
};
