// Where names stand: each at one place over the whole motion, where it covers least; or now, where it covers nothing.

/** @typedef {[number, number]} Pair */
/** @typedef {[number, number, number, number]} Line from end to end */
/** @typedef {[number, number, number, number]} Box left, top, right, bottom */
/** @typedef {{at: Pair[], size: Pair, choices: Pair[]}} Item places over some moments, width and height, shifts */

const AIR = 3; // around a name, in pixels
const TOUCH = 30; // what it costs to lie on another name

/**
 * The best shift of every item, in their order.
 * @param {Item[]} items
 * @param {Line[][]} lines what is drawn at each moment, from end to end
 * @returns {Pair[]}
 */
export function settled(items, lines) {
  /** @type {{item: Item, shift: Pair}[]} */
  const done = [];
  for (const item of items) {
    let best = item.choices[0];
    let least = Infinity;
    item.choices.forEach((shift, rank) => {
      let cost = 0.15 * rank;
      item.at.forEach((at, moment) => {
        const x = at[0] + shift[0];
        const y = at[1] + shift[1];
        cost += covered(x, y, item.size, lines[moment]) / item.at.length;
        for (const other of done) {
          const [ox, oy] = other.item.at[moment];
          const wide = (item.size[0] + other.item.size[0]) / 2 - Math.abs(x - ox - other.shift[0]);
          const high = (item.size[1] + other.item.size[1]) / 2 - Math.abs(y - oy - other.shift[1]);
          if (wide > 0 && high > 0) cost += TOUCH / item.at.length;
        }
      });
      if (cost < least) [least, best] = [cost, shift];
    });
    done.push({ item, shift: best });
  }
  return done.map((each) => each.shift);
}

/**
 * How deep lines lie in a box around a place.
 * @param {number} x
 * @param {number} y
 * @param {Pair} size
 * @param {Line[]} lines
 */
function covered(x, y, size, lines) {
  let cost = 0;
  for (const [x1, y1, x2, y2] of lines) {
    const [dx, dy] = [x2 - x1, y2 - y1];
    const long = dx * dx + dy * dy;
    const t = long ? Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / long)) : 0;
    const wide = size[0] / 2 + AIR - Math.abs(x - x1 - t * dx);
    const high = size[1] / 2 + AIR - Math.abs(y - y1 - t * dy);
    if (wide > 0 && high > 0) cost += Math.min(wide, high);
  }
  return cost;
}

/**
 * Shifts around a point: to the right above first, then round, then farther.
 * @param {number} wide of the name
 * @param {number} high
 */
export function around(wide, high) {
  /** @type {Pair[]} */
  const found = [];
  for (const far of [8, 15, 24]) {
    for (const angle of [-45, -135, 45, 135, -90, 90, 0, 180, -20, 20, -160, 160]) {
      const turn = (angle * Math.PI) / 180;
      const [c, s] = [Math.cos(turn), Math.sin(turn)];
      const out = Math.min(wide / 2 / (Math.abs(c) || 1e-9), high / 2 / (Math.abs(s) || 1e-9));
      found.push([c * (far + out), s * (far + out)]);
    }
  }
  return found;
}

/**
 * The box of a name in the middle of a place.
 * @param {number} x
 * @param {number} y
 * @param {Pair} size
 * @returns {Box}
 */
export function boxAt(x, y, [wide, high]) {
  return [x - wide / 2, y - high / 2, x + wide / 2, y + high / 2];
}

/**
 * The first of some boxes that lies on no other one and on no line.
 * @param {Box[]} boxes
 * @param {Box[]} taken
 * @param {Line[]} lines
 */
export function free(boxes, taken, lines) {
  return boxes.find((box) => !taken.some((each) => overlap(box, each)) && !lines.some((line) => crossed(box, line)));
}

/**
 * @param {Box} one
 * @param {Box} other
 */
function overlap(one, other) {
  return one[0] < other[2] && other[0] < one[2] && one[1] < other[3] && other[1] < one[3];
}

/**
 * Whether a line has a part within a box.
 * @param {Box} box
 * @param {Line} line
 */
function crossed([left, top, right, bottom], [ax, ay, bx, by]) {
  let [from, to] = [0, 1]; // what of the line is left between the sides
  for (const [way, room] of [[ax - bx, ax - left], [bx - ax, right - ax], [ay - by, ay - top], [by - ay, bottom - ay]]) {
    if (way < 0) from = Math.max(from, room / way);
    else if (way > 0) to = Math.min(to, room / way);
    else if (room < 0) return false;
  }
  return from < to;
}
