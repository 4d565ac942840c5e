// Names of points and numbers of links in a scene, each at one place beside what it names over the whole motion.
import { around, settled } from "./labels.js";
import { sized } from "./letters.js";
import { BLOCK, drawn, PIVOT, RING } from "./marks.js";
import { between, placed, STILL } from "./motion.js";
import { parted } from "./words.js";

/** @typedef {import("./scene.js").Scene} Scene */
/** @typedef {import("./labels.js").Pair} Pair */
/** @typedef {{body: string, at: number[], shift: Pair, size: Pair}} Named a place in the axes of a body, and pixels from it */

const FONT = 16; // of names, in pixels
const CHORDS = 60; // of a curve that names keep off
const MOMENTS = 25; // of the motion that places of names are chosen by
const LINES = new Set(["plate", "bar", "slot", "outline", "hole", "line"]);

/**
 * Put names and numbers at places that suit the whole motion.
 * @param {Scene} scene
 * @returns {Named[]} where they are
 */
export function putNames(scene) {
  const { low, span, values } = scene.state;
  const moments = Array.from({ length: MOMENTS }, (_, k) => low + (k * span) / (MOMENTS - 1));
  const poses = moments.map((at) => scene.posed(between(values, at)));
  /** @param {string} body @param {number[]} at @returns {import("./labels.js").Pair[]} */
  const over = (body, at) =>
    poses.map((pose) => {
      const [x, y] = placed(pose.get(body) ?? STILL, at[0], at[1]);
      return [x * scene.scale, -y * scene.scale];
    });
  const rings = scene.view.bodies.filter((body) => body.number);
  /** @type {import("./labels.js").Item[]} */
  const items = [];
  /** @type {number[]} */
  const drops = [];
  for (const spot of scene.view.spots) {
    const { size, drop } = sized(parted(spot.name).filter(Boolean).join("_"), FONT);
    drops.push(drop);
    /** @type {import("./labels.js").Pair[]} */
    const choices = spot.kind === "word" ? [[0, 0], ...around(...size)] : around(...size);
    items.push({ at: over(spot.body, spot.at), size, choices });
  }
  for (const body of rings) {
    const first = body.beside[0] ?? [0, 0];
    const start = over(body.name, first);
    const choices = /** @type {import("./labels.js").Pair[]} */ ([[0, 0], ...around(0, 0).map(([x, y]) => [1.6 * x, 1.6 * y])]);
    items.push({ at: start, size: [2 * RING, 2 * RING], choices });
  }
  const shifts = settled(items, poses.map((pose) => linesOf(scene, pose)));
  scene.spots.forEach((group, k) => {
    const [x, y] = shifts[k];
    const name = /** @type {Element} */ (group.querySelector(".name"));
    name.setAttribute("x", x.toFixed(1));
    name.setAttribute("y", (y + drops[k]).toFixed(1));
  });
  rings.forEach((body, k) => {
    const [x, y] = shifts[scene.spots.length + k];
    const group = scene.rings[scene.view.bodies.indexOf(body)];
    const ring = /** @type {Element} */ (group.firstElementChild);
    ring.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
    if (x || y) group.prepend(drawn("line", { class: "leader", x2: x.toFixed(1), y2: y.toFixed(1) }));
  });
  const named = [...scene.view.spots, ...rings.map((body) => ({ body: body.name, at: body.beside[0] ?? [0, 0] }))];
  return named.map(({ body, at }, k) => ({ body, at, shift: shifts[k], size: items[k].size }));
}

/**
 * All lines that names should keep off, in pixels.
 * @param {Scene} scene
 * @param {Map<string, import("./motion.js").Pose>} poses
 * @returns {[number, number, number, number][]}
 */
function linesOf(scene, poses) {
  /** @type {[number, number, number, number][]} */
  const found = [];
  /** @param {import("./motion.js").Pose} pose @param {number[]} flat @param {boolean} closed */
  const add = (pose, flat, closed) => {
    /** @type {[number, number][]} */
    const points = [];
    const stride = 2 * Math.max(1, Math.floor(flat.length / 2 / CHORDS)); // of a curve some chords do
    for (let k = 0; k + 1 < flat.length; k += stride) {
      const [x, y] = placed(pose, flat[k], flat[k + 1]);
      points.push([x * scene.scale, -y * scene.scale]);
    }
    points.forEach(([x, y], k) => {
      const next = points[k + 1] ?? (closed ? points[0] : null);
      if (next) found.push([x, y, next[0], next[1]]);
    });
  };
  for (const body of scene.view.bodies) {
    const pose = /** @type {import("./motion.js").Pose} */ (poses.get(body.name));
    for (const [kind, flat] of body.marks) {
      if (LINES.has(kind)) add(pose, flat, kind === "plate" || kind === "outline" || kind === "hole");
      else if (kind === "block") blocked(scene.scale, found, pose, flat);
    }
  }
  for (const [, points] of scene.view.spans) {
    const ends = scene.along(points, poses);
    for (let k = 1; k < ends.length; k++) found.push([...ends[k - 1], ...ends[k]]);
  }
  for (const [kind, flat] of [...scene.view.frame, ...scene.view.front]) {
    if (kind === "guide" || kind === "wall") add(STILL, flat.slice(0, 4), false);
    if (kind === "pivot") {
      const [x, y] = [flat[0] * scene.scale, -flat[1] * scene.scale];
      const [wide, high] = PIVOT;
      found.push([x, y, x + 1.2 * high * flat[2], y - 1.2 * high * flat[3]]);
      for (const [far, half] of [[0.6 * high, 0.3 * wide], [1.2 * high, 0.7 * wide]]) {
        const [cx, cy] = [x + far * flat[2], y - far * flat[3]];
        found.push([cx - half * flat[3], cy - half * flat[2], cx + half * flat[3], cy + half * flat[2]]);
      }
    }
  }
  for (const spot of scene.view.spots.filter((each) => each.kind !== "word")) {
    const [x, y] = placed(poses.get(spot.body) ?? STILL, spot.at[0], spot.at[1]);
    found.push([x * scene.scale - 3, -y * scene.scale, x * scene.scale + 3, -y * scene.scale]);
  }
  return found;
}

/**
 * A block as the line of its middle and its two long sides.
 * @param {number} scale
 * @param {[number, number, number, number][]} found
 * @param {import("./motion.js").Pose} pose
 * @param {number[]} flat
 */
function blocked(scale, found, pose, flat) {
  const [x, y] = placed(pose, flat[0], flat[1]);
  const ex = pose.cos * flat[2] - pose.sin * flat[3];
  const ey = pose.sin * flat[2] + pose.cos * flat[3];
  const [half, high] = [BLOCK[0] / 2, BLOCK[1] / 2];
  for (const side of [-high, 0, high]) {
    const [px, py] = [x * scale - ey * side, -y * scale - ex * side];
    found.push([px - half * ex, py + half * ey, px + half * ex, py - half * ey]);
  }
}
