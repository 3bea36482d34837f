// A motion as poses at equal times; only the last comes when it may.
import { mixed, type Pose } from "./figure";

export class Path {
  private readonly out: { position: Float32Array; rotation: Float32Array };

  constructor(
    readonly first: number, readonly last: number, readonly rate: number, readonly count: number, readonly bodies: number,
    readonly position: Float32Array, readonly rotation: Float32Array, readonly centre: Float32Array,
  ) {
    this.out = { position: new Float32Array(3 * bodies), rotation: new Float32Array(4 * bodies) };
  }

  /** The time [s] of a sample. */
  timeOf(sample: number): number {
    return sample >= this.count - 1 ? this.last : this.first + sample / this.rate;
  }

  /** The sample before a time, and the share of the way to the next. */
  private found(time: number): [number, number] {
    const inside = Math.min(Math.max(time, this.first), this.last);
    const before = Math.min(Math.floor((inside - this.first) * this.rate + 1e-9), this.count - 2);
    if (before < 0) return [0, 0];
    const a = this.timeOf(before), b = this.timeOf(before + 1);
    return [before, b > a ? Math.min(1, (inside - a) / (b - a)) : 0];
  }

  /** The pose at a time [s]; good until the next call. */
  at(time: number): Pose {
    const [i, share] = this.found(time), p = 3 * this.bodies, q = 4 * this.bodies, j = Math.min(i + 1, this.count - 1);
    mixed(
      { position: this.position.subarray(i * p, (i + 1) * p), rotation: this.rotation.subarray(i * q, (i + 1) * q) },
      { position: this.position.subarray(j * p, (j + 1) * p), rotation: this.rotation.subarray(j * q, (j + 1) * q) },
      share, this.out,
    );
    return this.out;
  }

  /** The centre of mass at a time [s]. */
  centreAt(time: number): [number, number, number] {
    const [i, share] = this.found(time), j = Math.min(i + 1, this.count - 1), c = this.centre;
    return [0, 1, 2].map((k) => c[3 * i + k] + share * (c[3 * j + k] - c[3 * i + k])) as [number, number, number];
  }
}
