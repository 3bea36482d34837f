// Where a camera looks from, by name; x is forward, y to the left, z up.
export const VIEWS: Record<string, [number, number, number]> = {
  quarter: [0.62, -1, 0.32],
  side: [0, -1, 0.08],
  left: [0, 1, 0.08],
  front: [1, 0, 0.08],
  back: [-1, 0, 0.08],
  top: [-0.001, 0, 1],
};
