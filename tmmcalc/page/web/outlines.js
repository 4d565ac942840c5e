// Outlines by formulas: curves as so many cubics as they need, bodies with teeth in their places.
import { compiled, filling } from "./formulas.js";

/** @typedef {[number, number]} Point */
/** @typedef {Point[]} Chain cubics end to end: a point, then two controls and the next point each */

const MOST = 8; // times that a curve is halved at most
const SHIFT = 1e-5; // of the way along a piece, by which its tangents are found
const LOOKS = [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1]; // places of a cubic

/**
 * The curve that a piece is, as a function of the values: cubics from which it is nowhere farther than the tolerance.
 * @param {import("./data.js").Piece} piece
 * @returns {(values: Record<string, number>, tolerance: number) => Chain}
 */
export function traced({ parameter, start, end, steps, x, y }) {
  const [from, to, fill, across, up] = [compiled(start), compiled(end), filling(steps), compiled(x), compiled(y)];
  return (values, tolerance) => {
    const own = Object.create(values);
    const [low, high] = [from(values), to(values)];
    /** @param {number} t @returns {Point} */
    const at = (t) => {
      own[parameter] = t;
      fill(own);
      return [across(own), up(own)];
    };
    /** A place, its point, its derivative. @param {number} t */
    const knot = (t) => {
      const over = SHIFT * (high - low);
      const [[ax, ay], [bx, by]] = [at(t - over), at(t + over)];
      return { t, at: at(t), dx: (bx - ax) / (2 * over), dy: (by - ay) / (2 * over) };
    };
    if (low === high) return [at(low)];
    const [first, last] = [knot(low), knot(high)];
    /** @type {Chain} */
    const chain = [first.at];
    /** @param {ReturnType<typeof knot>} a @param {ReturnType<typeof knot>} b @param {number} depth */
    const span = (a, b, depth) => {
      const third = (b.t - a.t) / 3;
      const [ax, ay, bx, by] = [...a.at, ...b.at];
      /** @type {Chain} */
      const cubic = [a.at, [ax + third * a.dx, ay + third * a.dy], [bx - third * b.dx, by - third * b.dy], b.at];
      const middle = knot((a.t + b.t) / 2);
      const [mx, my] = [0, 1].map((k) => along(cubic, 0.5, k));
      if (depth < MOST && Math.hypot(mx - middle.at[0], my - middle.at[1]) > tolerance) {
        span(a, middle, depth + 1);
        span(middle, b, depth + 1);
      } else {
        chain.push(...cubic.slice(1));
      }
    };
    span(first, last, 0);
    return chain;
  };
}

/**
 * A coordinate of a cubic.
 * @param {Chain} cubic
 * @param {number} t
 * @param {number} k
 */
function along([a, b, c, d], t, k) {
  const s = 1 - t;
  return s * s * s * a[k] + 3 * s * s * t * b[k] + 3 * s * t * t * c[k] + t * t * t * d[k];
}

/**
 * Whether cubics reach to the right of a line along Y.
 * @param {Chain} chain
 * @param {number} x
 */
function reaches(chain, x) {
  for (let k = 0; k + 3 < chain.length; k += 3) {
    const cubic = chain.slice(k, k + 4);
    if (LOOKS.some((t) => along(cubic, t, 0) > x)) return true;
  }
  return false;
}

/**
 * A body with teeth, as a function of the values: half a tooth about the origin, whether it reaches beyond its middle,
 * the part of its flank that works, and where the body stands.
 * @param {import("./data.js").Toothed} body
 */
export function toothed(body) {
  const pieces = body.half.map(traced);
  const flank = traced(body.worked);
  const [count, turn, x, y] = [body.count, body.turn, body.x, body.y].map(compiled);
  const [low, high] = [body.worked.start, body.worked.end].map(compiled);
  return (/** @type {Record<string, number>} */ values, /** @type {number} */ tolerance) => {
    /** @type {Chain} */
    const half = [];
    for (const piece of pieces) half.push(...piece(values, tolerance).slice(half.length ? 1 : 0));
    return {
      half,
      beyond: reaches(half, tolerance),
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
 * The teeth of a body around the direction to a place, so many that they fill a width there: their outline, the flanks
 * that work, and the centre, through which the outline is closed unless all teeth are there.
 * @param {Placed} body
 * @param {Point} place
 * @param {number} width
 */
export function teethAt({ half, worked, count, turn, x, y }, place, width) {
  const step = (2 * Math.PI) / count;
  const towards = Math.atan2(place[1] - y, place[0] - x) - Math.PI / 2 - turn;
  const seen = Math.ceil(width / Math.hypot(place[0] - x, place[1] - y) / step) + 2;
  const some = Math.min(seen, count);
  const first = Math.round(towards / step - (some - 1) / 2);
  const tooth = [...half.map(([px, py]) => /** @type {Point} */ ([-px, py])), ...half.toReversed().slice(1)];
  /** @type {Chain} */
  const outline = [];
  /** @type {Chain[]} */
  const flanks = [];
  for (let k = first; k < first + some; k++) {
    const [c, s] = [Math.cos(turn + k * step), Math.sin(turn + k * step)];
    /** @param {Point} point @returns {Point} */
    const put = ([px, py]) => [x + c * px - s * py, y + s * px + c * py];
    outline.push(...(outline.length ? tooth.slice(1) : tooth).map(put));
    flanks.push(worked.map(put));
  }
  return { outline, flanks, centre: some < count ? /** @type {Point} */ ([x, y]) : null };
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
