// The studio's state: the document, the stage and the paths; and of this page alone: the time and the selection.
import type { Drawn } from "../scene/shapes";
import type { Path } from "../scene/path";

export interface Rotation { rotvec?: number[]; euler?: number[]; quat?: number[]; heading?: number; }
export interface KeyframeRow {
  time: number; others: string; joints?: Record<string, Rotation | number | "free">;
  root?: { position?: (number | "free")[] | "free"; rotation?: Rotation | "free" };
  sites?: Record<string, unknown>; bodies?: Record<string, unknown>;
}
export interface Bar { point?: string; hand?: string; body?: string; from: number; to: number; }
export interface Obstacle { kind: string; index: number; [key: string]: unknown; }
export interface Outline {
  name: string; file: string | null; dirty: boolean; revision: number; undo: string | null; redo: string | null;
  figure: string; fps: number; keys: KeyframeRow[]; contacts: Bar[]; grasps: Bar[]; weights: Record<string, number>;
  obstacles: Obstacle[]; solve: Record<string, unknown>;
}
export interface KeyState { time: number; qpos: number[]; fixed: boolean[]; }
export interface Loaded {
  revision: number; keys: KeyState[]; stances: { point: string; from: number; to: number }[]; flights: [number, number][]; notes: string[];
  weights: Record<string, number>;
}
export interface Joint {
  name: string; kind: "free" | "ball" | "hinge" | "slide"; qpos: number; body: number; range: number[] | null;
  axis: number[]; anchor: number[];
}
export interface Marked { name: string; body: number; offset: number[]; radius?: number; }
export interface Stage extends Drawn {
  bodies: string[]; parents: number[]; still: boolean[]; size: number; joints: Joint[]; sites: Marked[]; soles: Marked[];
  limbs: { name: string; joints: string[]; end: number }[];
}
export interface Violation { kind: string; name: string; time: number | null; amount: number; unit: string; keyframe: number | null; text: string; }
export interface Kind { kind: string; part: string; term: string; weight: number; quantity: string; "is on": boolean; }
export interface Series { name: string; joint: string; axis: number | null; after: number[]; before?: number[]; }
export interface Curves { time: number[]; groups: { name: string; unit: string; series: Series[] }[]; }
export interface Mark { time: number; joint: string; text: string; }
export interface Course { value?: number; parts?: Record<string, number>; frames: number[]; keys: number[][]; kind: string; }

export type Which = "after" | "before" | "both" | "side" | "snapshot";
export type Heard =
  | "stage" | "document" | "loaded" | "path" | "time" | "selection" | "settled" | "status" | "kinds" | "which" | "shown"
  | "curves" | "theme" | "task" | "offer" | "outside" | "joint" | "line" | "zoom" | "range" | "poses";

const HAND = /hand|grip|palm|wrist|finger|tool/i; // of the names of sites that can hold something
const NEAR = 1e-4; // [s] distance up to which a time is that of a keyframe

class Model {
  document: Outline | null = null;
  loaded: Loaded | null = null;
  stage: Stage | null = null;
  now: Path | null = null;
  raw: Path | null = null;
  snapshot: Path | null = null;
  course: Course | null = null;
  violations: Violation[] = [];
  overshoots: Mark[] = []; // of joints beyond their values in keyframes
  kinds: Kind[] = [];
  curves: Curves | null = null;
  poses: string[] = []; // names of the saved ones
  status: { state: string; go: boolean; stop?: string; words?: string } = { state: "loading", go: true };
  time = 0;
  range = [-Infinity, Infinity]; // [s] that is played, as far as the motion reaches
  playing = false;
  speed = 1;
  loop = true;
  follow = true;
  which: Which = "after";
  ghosts = ""; // onion skin: at keyframes ("keys"), every so many frames, or none
  trails = false;
  partial = false; // whether new keyframes specify only the dragged limb
  frames = 0; // paths that have come
  keys = new Set<number>();
  bar: { kind: "contact" | "grasp"; index: number } | null = null;
  joints: string[] = []; // that are selected; fields and rings show the last one
  obstacle: { kind: string; index: number } | null = null;
  resizes = false; // whether the arrows of an obstacle resize it
  readonly fk = new Set<string>(); // names of limbs whose joints a drag rotates
  readonly locks = new Set<string>(); // bodies that stay where they are while others are posed
  private readonly ears = new Map<Heard, (() => void)[]>();

  on(what: Heard | Heard[], ear: () => void): void {
    for (const each of [what].flat()) this.ears.set(each, [...(this.ears.get(each) ?? []), ear]);
  }

  tell(what: Heard): void {
    for (const ear of this.ears.get(what) ?? []) ear();
  }

  get joint(): string | null { return this.joints.at(-1) ?? null; }

  /** Numbers of the locked bodies. */
  get locked(): number[] { return (this.stage?.bodies ?? []).flatMap((name, body) => (this.locks.has(name) ? [body] : [])); }

  get first(): number { return this.now?.first ?? this.document?.keys[0]?.time ?? 0; }
  get last(): number { return this.now?.last ?? this.document?.keys.at(-1)?.time ?? 1; }
  /** The first and last time that is played [s]. */
  get played(): [number, number] {
    const begin = Math.max(this.first, this.range[0]), end = Math.min(this.last, this.range[1]);
    return begin < end ? [begin, end] : [this.first, this.last];
  }

  /** Begins (0) or ends (1) playback at a time [s]; outside of the motion, with the motion. */
  setRange(end: 0 | 1, time: number): void {
    const whole = [-Infinity, Infinity];
    this.range[end] = this.first < time && time < this.last ? time : whole[end];
    if (this.range[0] >= this.range[1]) this.range[1 - end] = whole[1 - end];
    this.tell("range");
  }

  get fps(): number { return this.document?.fps ?? 30; }

  /** The time [s] at which a keyframe is inserted or changed. */
  get moment(): number { return this.here === null ? Math.round(this.time * 1e4) / 1e4 : this.document!.keys[this.here].time; }

  /** The keyframe at the present time, if one is there. */
  get here(): number | null {
    return this.at([this.time])[0] ?? null;
  }

  /** The pose of a keyframe, in which the path decides what is free. */
  poseOf(key: number): number[] {
    const { qpos, fixed } = this.loaded!.keys[key], keys = this.course?.keys ?? [];
    const path = keys.length === this.loaded!.keys.length ? keys[key] : qpos;
    return qpos.map((value, i) => (fixed[i] ? value : path[i] ?? value));
  }

  /** The joints of the limb that the chosen joint is on, with the points at which it can hold something. */
  get limb(): { joints: string[]; hands: string[]; bodies: Set<number> } | null {
    const { stage } = this, found = stage?.limbs.find((limb) => this.joint !== null && limb.joints.includes(this.joint));
    if (!stage || !found) return null;
    const bodies = new Set(stage.joints.filter((joint) => found.joints.includes(joint.name)).map((joint) => joint.body));
    return { joints: found.joints, hands: stage.sites.filter((site) => bodies.has(site.body) && HAND.test(site.name)).map((site) => site.name), bodies };
  }

  /** Goes to a time, also after the last keyframe. A selection of at most one keyframe follows. */
  seek(time: number): void {
    this.time = Math.max(time, Math.min(0, this.first));
    const here = this.here === null ? [] : [this.here];
    if (this.keys.size <= 1 && String([...this.keys]) !== String(here) && this.bar === null) this.select(here);
    this.tell("time");
  }

  /** Goes to a time and selects a joint, if there is one of this name. */
  visit(time: number | null, joint: string): void {
    this.playing = false;
    if (time !== null) this.seek(time);
    this.choose(this.stage?.joints.find(({ name }) => name === joint)?.name ?? this.joint);
  }

  /** Selects a joint, or with `adds` adds it to the selected ones, or removes it. */
  choose(joint: string | null, adds = false): void {
    const others = adds ? this.joints.filter((name) => name !== joint) : [];
    this.joints = joint === null || (adds && this.joints.includes(joint)) ? others : [...others, joint];
    this.obstacle = null;
    this.tell("joint");
  }

  /** Selects an obstacle instead of joints; null selects nothing. */
  pick(obstacle: { kind: string; index: number } | null): void {
    this.obstacle = obstacle && { kind: obstacle.kind, index: obstacle.index };
    this.joints = [];
    this.tell("joint");
  }

  /** The keyframes at times [s]. */
  at(times: number[]): number[] {
    const found = (key: KeyframeRow) => times.some((time) => Math.abs(key.time - time) < NEAR);
    return (this.document?.keys ?? []).flatMap((key, i) => (found(key) ? [i] : []));
  }

  select(keys: Iterable<number>): void {
    this.keys = new Set(keys);
    this.bar = null;
    this.tell("selection");
  }
}

export const model = new Model();
