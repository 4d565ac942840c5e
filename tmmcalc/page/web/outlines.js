// Outlines by formulas: curves in as many points as they need, bodies with teeth in their places.
import { compiled, filling } from "./formulas.js";

/** @typedef {[number, number]} Point */

const LEAST = 2; // times that a curve is halved at least
const MOST = 12;

/**
 * The curve that a piece is, as a function of the values: points from which it is nowhere farther than the tolerance.
 * @param {import("./data.js").Piece} piece
 * @returns {(values: Record<string, number>, tolerance: number) => Point[]}
 */
export function traced({ parameter, start, end, steps, x, y }) {
  const [from, to, fill, across, up] = [compiled(start), compiled(end), filling(steps), compiled(x), compiled(y)];
  return (values, tolerance) => {
    const own = Object.create(values);
    /** @param {number} t @returns {Point} */
    const at = (t) => {
      own[parameter] = t;
      fill(own);
      return [across(own), up(own)];
    };
    /** @type {Point[]} */
    const points = [at(from(values))];
    /** @param {number} s @param {Point} a @param {number} t @param {Point} b @param {number} depth */
    const halve = (s, a, t, b, depth) => {
      const half = (s + t) / 2;
      const middle = at(half);
      if (depth < LEAST || (depth < MOST && away(a, b, middle) > tolerance)) {
        halve(s, a, half, middle, depth + 1);
        halve(half, middle, t, b, depth + 1);
      } else {
        points.push(middle, b);
      }
    };
    halve(from(values), points[0], to(values), at(to(values)), 0);
    return points;
  };
}

/**
 * A body with teeth, as a function of the values: half a tooth about the origin, whether it reaches beyond its middle,
 * the part of its flank that works, and where the body stands.
 * @param {import("./data.js").Toothed} body
 */
export function toothed(body) {
  const pieces = body.half.map(traced);
  const flank = traced(body.worked);
  const [count, turn, x, y, low, high] = [body.count, body.turn, body.x, body.y, body.worked.start, body.worked.end].map(compiled);
  return (/** @type {Record<string, number>} */ values, /** @type {number} */ tolerance) => {
    const half = pieces.flatMap((piece) => piece(values, tolerance));
    return {
      half,
      beyond: half.some((point) => point[0] > tolerance),
      worked: low(values) < high(values) ? flank(values, tolerance) : [],
      count: count(values),
      turn: turn(values),
      x: x(values),
      y: y(values),
    };
  };
}

/** @typedef {ReturnType<ReturnType<typeof toothed>>} Placed */

/**
 * The teeth of a body around the direction to a place, so many that they fill a width there; their outline, closed
 * through the centre unless all are there, and the flanks that work.
 * @param {Placed} body
 * @param {Point} place
 * @param {number} width
 */
export function around({ half, worked, count, turn, x, y }, place, width) {
  const step = (2 * Math.PI) / count;
  const towards = Math.atan2(place[1] - y, place[0] - x) - Math.PI / 2 - turn;
  const seen = Math.ceil(width / Math.hypot(place[0] - x, place[1] - y) / step) + 2;
  const some = Math.min(seen, count);
  const first = Math.round(towards / step - (some - 1) / 2);
  const tooth = [...half.map(([px, py]) => /** @type {Point} */ ([-px, py])), ...half.toReversed()];
  /** @type {Point[]} */
  const outline = [];
  /** @type {Point[][]} */
  const flanks = [];
  for (let k = first; k < first + some; k++) {
    const [c, s] = [Math.cos(turn + k * step), Math.sin(turn + k * step)];
    /** @param {Point} point @returns {Point} */
    const put = ([px, py]) => [x + c * px - s * py, y + s * px + c * py];
    outline.push(...tooth.map(put));
    flanks.push(worked.map(put));
  }
  if (some < count) outline.push([x, y]);
  return { outline, flanks };
}

/**
 * The distance of a place from a segment.
 * @param {number[]} from
 * @param {number[]} to
 * @param {number[]} place
 */
export function away(from, to, place) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const [px, py] = [place[0] - from[0], place[1] - from[1]];
  const part = Math.min(1, Math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(px - part * dx, py - part * dy);
}
