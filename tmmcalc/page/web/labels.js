// Where names stand: each at one place beside its point over the whole motion, where it covers least.

/** @typedef {[number, number]} Pair */
/** @typedef {{at: Pair[], size: Pair, choices: Pair[]}} Item places over some moments, width and height, shifts */

const AIR = 3; // around a name, in pixels
const TOUCH = 30; // what it costs to lie on another name

/**
 * The best shift of every item, in their order.
 * @param {Item[]} items
 * @param {[number, number, number, number][][]} lines what is drawn at each moment, from end to end
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
 * @param {[number, number, number, number][]} lines
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
