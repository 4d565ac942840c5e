// Poses between solved positions: cubics that fit values and rates, so that what is rigid stays so.
import { numbers } from "./data.js";

/** @typedef {{from: number, to: number, t: number, near: number}} Between rows on both sides, the part of the way, the nearest */

/**
 * Where a value lies among ordered ones.
 * @param {Float32Array} values
 * @param {number} at
 * @returns {Between}
 */
export function between(values, at) {
  const last = values.length - 1;
  const rising = values[last] >= values[0];
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= at === rising) low = middle;
    else high = middle;
  }
  const step = values[high] - values[low];
  const t = step ? Math.min(1, Math.max(0, (at - values[low]) / step)) : 0;
  return { from: low, to: high, t, near: t < 0.5 ? low : high };
}

/**
 * A place of the input between its two rows, or beyond them: what goes evenly goes on there.
 * @param {Float32Array} values
 * @param {number} at
 * @returns {Between}
 */
export function straight(values, at) {
  const last = values.length - 1;
  const t = (at - values[0]) / (values[last] - values[0] || 1);
  return { from: 0, to: last, t, near: t < 0.5 ? 0 : last };
}

/**
 * The value of a track there.
 * @param {import("./data.js").Track} track
 * @param {Float32Array} values of the input
 * @param {Between} there
 */
export function trackAt(track, values, there) {
  if (typeof track === "number") return track;
  const y = numbers(track[0]);
  const d = numbers(track[1]);
  const { from, to, t } = there;
  const h = values[to] - values[from];
  const s = 1 - t;
  return s * s * ((1 + 2 * t) * y[from] + t * h * d[from]) + t * t * ((1 + 2 * s) * y[to] - s * h * d[to]);
}

/** @typedef {{x: number, y: number, cos: number, sin: number}} Pose */

/**
 * The pose of a body there.
 * @param {import("./data.js").Body} body
 * @param {Float32Array} values
 * @param {Between} there
 * @returns {Pose}
 */
export function poseOf(body, values, there) {
  const angle = trackAt(body.angle, values, there);
  return {
    x: trackAt(body.x, values, there),
    y: trackAt(body.y, values, there),
    cos: Math.cos(angle),
    sin: Math.sin(angle),
  };
}

/**
 * The poses of all bodies there; those on others move with them.
 * @param {import("./data.js").Body[]} bodies
 * @param {Float32Array} values
 * @param {Between} there
 * @returns {Map<string, Pose>}
 */
export function posesOf(bodies, values, there) {
  /** @type {Map<string, Pose>} */
  const poses = new Map();
  /** @param {import("./data.js").Body} body @returns {Pose} */
  const found = (body) => {
    const known = poses.get(body.name);
    if (known) return known;
    const own = poseOf(body, values, there);
    const bearer = body.on ? bodies.find((each) => each.name === body.on) : undefined;
    const pose = bearer ? onto(found(bearer), own) : own;
    poses.set(body.name, pose);
    return pose;
  };
  bodies.forEach(found);
  return poses;
}

/**
 * A pose in the axes of another one.
 * @param {Pose} bearer
 * @param {Pose} own
 * @returns {Pose}
 */
function onto(bearer, own) {
  const [x, y] = placed(bearer, own.x, own.y);
  return { x, y, cos: bearer.cos * own.cos - bearer.sin * own.sin, sin: bearer.sin * own.cos + bearer.cos * own.sin };
}

/**
 * Whether something is there at a place of the input.
 * @param {import("./data.js").Range} range
 * @param {number} at
 */
export function isThere(range, at) {
  return !range || (at >= range[0] && at <= range[1]);
}

/** @type {Pose} */
export const STILL = { x: 0, y: 0, cos: 1, sin: 0 };

/**
 * Where a point of a body is.
 * @param {Pose} pose
 * @param {number} x
 * @param {number} y
 * @returns {[number, number]}
 */
export function placed(pose, x, y) {
  return [pose.x + pose.cos * x - pose.sin * y, pose.y + pose.sin * x + pose.cos * y];
}
