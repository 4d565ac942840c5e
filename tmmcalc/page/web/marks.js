// The signs of schemes as SVG: shapes to scale, signs in pixels, whatever the size of the machine.

const SVG = "http://www.w3.org/2000/svg";
export const PIN = 5;
export const RING = 9; // radius of the ring of a number
export const COLOURS = ["blue", "orange", "green", "purple", "olive"];
export const BLOCK = [34, 19];
export const PIVOT = [22, 17];
const WALL = 2.5; // half the thickness of a rod that slides along one
const [COILS, COIL] = [5, 7]; // turns of a spring, half its width
const DOT = 4.5;
const [HEAD, WING] = [9, 3]; // length and half the width of the head of an arrow
const FINEST = 0.8; // module in pixels below which teeth are not drawn
const SLOPE = Math.tan(Math.PI / 9); // of their flanks

/**
 * An element of SVG with attributes.
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {Element} [parent]
 * @returns {SVGElement}
 */
export function drawn(name, attributes = {}, parent) {
  const found = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) found.setAttribute(key, String(value));
  if (parent) parent.append(found);
  return found;
}

/**
 * Draw a mark in pixels: `scale` pixels are one metre, y goes down.
 * @param {Element} parent
 * @param {import("./data.js").Mark} mark
 * @param {number} scale
 */
export function draw(parent, mark, scale) {
  const found = shaped(parent, mark, scale);
  const tone = mark[3] ?? 0;
  if (tone) found.classList.add(COLOURS[(tone - 1) % COLOURS.length]);
  return found;
}

/**
 * @param {Element} parent
 * @param {import("./data.js").Mark} mark
 * @param {number} scale
 */
function shaped(parent, mark, scale) {
  const [kind, flat, size = 0] = mark;
  /** @type {[number, number][]} */
  const points = [];
  for (let k = 0; k < flat.length; k += 2) points.push([flat[k] * scale, -flat[k + 1] * scale]);
  const path = points.map(([x, y]) => `${round(x)},${round(y)}`).join(" ");
  const [x, y] = points[0];
  switch (kind) {
    case "plate":
    case "outline":
    case "zone":
    case "range":
    case "gear":
    case "hole":
      return drawn("polygon", { class: kind, points: path }, parent);
    case "bar":
    case "slot":
    case "line":
    case "axis":
    case "flank":
    case "spoke":
      return drawn("polyline", { class: kind, points: path }, parent);
    case "circle":
    case "pitch":
    case "base":
    case "roller":
      return drawn("circle", { class: kind, cx: x, cy: y, r: size * scale }, parent);
    case "dot":
      return drawn("circle", { class: kind, cx: x, cy: y, r: DOT }, parent);
    case "cog":
      return drawn("path", { class: kind, d: toothed(points[0], points[1], size, 1) }, parent);
    case "rim":
      return rim(parent, points, size);
    case "sense":
      return sense(parent, points, size);
    case "held":
      return held(parent, x, y, size * scale);
    case "block":
      return block(parent, x, y, flat[2], flat[3]);
    case "weld":
      return weld(parent, x, y, flat);
    case "pivot":
      return pivot(parent, x, y, flat[2], flat[3]);
    case "guide":
      return guide(parent, points, flat[4], flat[5]);
    case "wall":
      return hatchedAlong(parent, points, flat[4], flat[5], 0, WALL);
    case "sleeve": {
      const group = drawn("g", {}, parent);
      guide(group, [points[0], points[0]], flat[4], flat[5]);
      return block(group, x, y, flat[2], flat[3]);
    }
    default:
      return drawn("path", { class: "cross", d: `M${x - 5},${y - 5}l10,10m0,-10l-10,10` }, parent);
  }
}

/**
 * Put what is drawn in the axes of a body where that is.
 * @param {Element} element
 * @param {import("./motion.js").Pose} pose
 * @param {number} scale
 */
export function put(element, { x, y, cos, sin }, scale) {
  const matrix = [cos, -sin, sin, cos, x * scale, -y * scale].map((each) => each.toFixed(5));
  element.setAttribute("transform", `matrix(${matrix.join(" ")})`);
}

/**
 * A line through points in pixels, as a body has it that is drawn out or pressed together.
 * @param {Element[]} lines
 * @param {string} kind
 * @param {[number, number][]} points
 */
export function stretch(lines, kind, points) {
  const path = (kind === "spring" ? wound(points) : points).map(([x, y]) => `${round(x)},${round(y)}`).join(" ");
  for (const line of lines) line.setAttribute("points", path);
}

/**
 * A spring between the first point and the last, with straight ends.
 * @param {[number, number][]} points
 * @returns {[number, number][]}
 */
function wound(points) {
  const [ax, ay] = points[0];
  const [bx, by] = points[points.length - 1];
  const long = Math.hypot(bx - ax, by - ay) || 1;
  const [ex, ey] = [(bx - ax) / long, (by - ay) / long];
  /** @param {number} along @param {number} aside @returns {[number, number]} */
  const at = (along, aside) => [ax + along * long * ex - aside * ey, ay + along * long * ey + aside * ex];
  const turns = Array.from({ length: 2 * COILS }, (_, k) => at(0.15 + (0.7 * (k + 0.5)) / (2 * COILS), k % 2 ? -COIL : COIL));
  return [points[0], at(0.15, 0), ...turns, at(0.85, 0), points[points.length - 1]];
}

/**
 * A ring with teeth inside: its centre, the middle of a tooth, a point of its outer circle.
 * @param {Element} parent
 * @param {[number, number][]} points
 * @param {number} teeth
 */
function rim(parent, [centre, tooth, edge], teeth) {
  const d = circled(centre, Math.hypot(edge[0] - centre[0], edge[1] - centre[1])) + toothed(centre, tooth, teeth, -1);
  return drawn("path", { class: "rim", d, "fill-rule": "evenodd" }, parent);
}

/**
 * @param {[number, number]} centre
 * @param {number} r
 */
function circled([x, y], r) {
  return `M${round(x - r)},${round(y)}a${r},${r} 0 1 0 ${2 * r},0a${r},${r} 0 1 0 ${-2 * r},0z`;
}

/**
 * The outline of a wheel with straight teeth of usual height, one of them through a point of the pitch circle.
 * @param {[number, number]} centre
 * @param {[number, number]} tooth
 * @param {number} teeth
 * @param {1 | -1} sense outward, or inward
 */
function toothed([x, y], tooth, teeth, sense) {
  const [dx, dy] = [tooth[0] - x, tooth[1] - y];
  const r = Math.hypot(dx, dy);
  const module = (2 * r) / teeth;
  if (module < FINEST) return circled([x, y], r);
  const [tip, root] = [r + sense * module, r - 1.25 * sense * module];
  const half = Math.PI / 2 / teeth;
  const [narrow, wide] = [half - (SLOPE * module) / r, half + (1.25 * SLOPE * module) / r];
  const start = Math.atan2(dy, dx);
  let d = "";
  for (let k = 0; k < teeth; k++) {
    const at = start + 4 * half * k;
    for (const [radius, turn] of [[root, -wide], [tip, -narrow], [tip, narrow], [root, wide]]) {
      d += `${d ? "L" : "M"}${round(x + radius * Math.cos(at + turn))},${round(y + radius * Math.sin(at + turn))}`;
    }
  }
  return `${d}z`;
}

/**
 * An arrow along a circle about the first point, from the second one on.
 * @param {Element} parent
 * @param {[number, number][]} points
 * @param {number} turn
 */
function sense(parent, [[x, y], [sx, sy]], turn) {
  const r = Math.hypot(sx - x, sy - y);
  const end = Math.atan2(sy - y, sx - x) - turn;
  const [ex, ey] = [x + r * Math.cos(end), y + r * Math.sin(end)];
  const group = drawn("g", {}, parent);
  const d = `M${round(sx)},${round(sy)}A${r},${r} 0 0 ${turn > 0 ? 0 : 1} ${round(ex)},${round(ey)}`;
  drawn("path", { class: "sense", d }, group);
  const way = ((end - (Math.sign(turn) * Math.PI) / 2) * 180) / Math.PI;
  const place = `translate(${round(ex)} ${round(ey)}) rotate(${round(way)})`;
  drawn("path", { class: "head", d: "M6,0L-7,5V-5z", transform: place }, group);
  return group;
}

/**
 * A circle that stands still: hatched outside.
 * @param {Element} parent
 * @param {number} x
 * @param {number} y
 * @param {number} r
 */
function held(parent, x, y, r) {
  const count = Math.max(12, Math.round((2 * Math.PI * r) / 9));
  let d = `M${round(x - r)},${round(y)}a${r},${r} 0 1 0 ${2 * r},0a${r},${r} 0 1 0 ${-2 * r},0`;
  for (let k = 0; k < count; k++) {
    const from = (2 * Math.PI * k) / count;
    const to = from + 5 / r;
    d += `M${round(x + r * Math.cos(from))},${round(y + r * Math.sin(from))}L${round(x + (r + 7) * Math.cos(to))},${round(y + (r + 7) * Math.sin(to))}`;
  }
  return drawn("path", { class: "ground", d }, parent);
}

/** @param {number} value */
function round(value) {
  return Math.round(value * 100) / 100;
}

/**
 * @param {Element} parent
 * @param {number} x
 * @param {number} y
 * @param {number} ex
 * @param {number} ey
 */
function block(parent, x, y, ex, ey) {
  const turn = (Math.atan2(-ey, ex) * 180) / Math.PI;
  const [wide, high] = BLOCK;
  const place = `translate(${round(x)} ${round(y)}) rotate(${round(turn)})`;
  return drawn("rect", { class: "block", x: -wide / 2, y: -high / 2, width: wide, height: high, transform: place }, parent);
}

/**
 * @param {Element} parent
 * @param {number} x
 * @param {number} y
 * @param {number[]} flat
 */
function weld(parent, x, y, flat) {
  const first = Math.atan2(-flat[3], flat[2]);
  let turn = Math.atan2(-flat[5], flat[4]) - first;
  turn = Math.atan2(Math.sin(turn), Math.cos(turn));
  if (Math.abs(turn) < 0.05 || Math.abs(turn) > 2.2) return drawn("g", {}, parent);
  const r = 16;
  const end = first + turn;
  const d =
    `M${x},${y}L${x + r * Math.cos(first)},${y + r * Math.sin(first)}` +
    `A${r},${r} 0 0 ${turn > 0 ? 1 : 0} ${x + r * Math.cos(end)},${y + r * Math.sin(end)}z`;
  return drawn("path", { class: "weld", d }, parent);
}

/**
 * @param {Element} parent
 * @param {number} x
 * @param {number} y
 * @param {number} dx
 * @param {number} dy
 */
function pivot(parent, x, y, dx, dy) {
  const turn = (Math.atan2(-dy, dx) * 180) / Math.PI - 90;
  const group = drawn("g", { transform: `translate(${round(x)} ${round(y)}) rotate(${round(turn)})` }, parent);
  const [wide, high] = PIVOT;
  drawn("path", { class: "support", d: `M0,0L${wide / 2},${high}H${-wide / 2}z` }, group);
  hatched(group, -0.75 * wide, 0.75 * wide, high);
  return group;
}

/**
 * A hatched line from end to end with a block's room beyond them, along the far side of the block.
 * @param {Element} parent
 * @param {[number, number][]} ends
 * @param {number} ox
 * @param {number} oy
 */
function guide(parent, ends, ox, oy) {
  return hatchedAlong(parent, ends, ox, oy, BLOCK[0] / 2 + 8, BLOCK[1] / 2);
}

/**
 * A hatched line between two points, so far beyond them and outward from them.
 * @param {Element} parent
 * @param {[number, number][]} ends
 * @param {number} ox
 * @param {number} oy
 * @param {number} over
 * @param {number} out
 */
function hatchedAlong(parent, [a, b], ox, oy, over, out) {
  const turn = (Math.atan2(-oy, ox) * 180) / Math.PI - 90;
  const group = drawn("g", { transform: `translate(${round(a[0])} ${round(a[1])}) rotate(${round(turn)})` }, parent);
  const c = Math.cos((turn * Math.PI) / 180);
  const s = Math.sin((turn * Math.PI) / 180);
  const along = (b[0] - a[0]) * c + (b[1] - a[1]) * s;
  hatched(group, Math.min(0, along) - over, Math.max(0, along) + over, out);
  return group;
}

/**
 * A ground line along x with hatching below it.
 * @param {Element} parent
 * @param {number} from
 * @param {number} to
 * @param {number} y
 */
function hatched(parent, from, to, y) {
  let d = `M${round(from)},${y}H${round(to)}`;
  for (let x = from + 6; x <= to; x += 6) d += `M${round(x)},${y}l-6,6`;
  drawn("path", { class: "ground", d }, parent);
}

/**
 * The sign of a centre of mass.
 * @param {Element} parent
 */
export function centreOfMass(parent) {
  const group = drawn("g", { class: "mass" }, parent);
  drawn("circle", { r: 4.5 }, group);
  drawn("path", { d: "M0,0V-4.5A4.5,4.5 0 0 1 4.5,0zM0,0V4.5A4.5,4.5 0 0 1 -4.5,0z" }, group);
  return group;
}

/**
 * The head of an arrow between two points in pixels, as the way of a path: no longer than half of a short one.
 * @param {number[]} tail
 * @param {number[]} tip
 */
export function head([ax, ay], [bx, by]) {
  const long = Math.hypot(bx - ax, by - ay);
  const [ex, ey] = [(bx - ax) / (long || 1), (by - ay) / (long || 1)];
  const size = Math.min(HEAD, long / 2);
  const wing = Math.min(WING, 0.6 * size);
  const [x, y] = [bx - size * ex, by - size * ey];
  const wings = [1, -1].map((side) => `${round(x - side * wing * ey)},${round(y + side * wing * ex)}`);
  return `M${round(bx)},${round(by)}L${wings.join("L")}z`;
}
