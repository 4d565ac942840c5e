// Bodies of a scene are taken by the pointer: the input goes where what is held comes nearest to it.
import { numbers } from "./data.js";
import { between, placed, STILL, straight } from "./motion.js";

/** @typedef {import("./scene.js").Scene} Scene */

const SMALL = 1e-5; // of the travel: a step by which velocities are found
const REST = 0.05; // of the size of the scene: what goes less in the whole travel at its speed there, rests there

/**
 * The place of the machine under a pointer.
 * @param {Scene} scene
 * @param {PointerEvent} event
 * @returns {[number, number]}
 */
function pointed(scene, event) {
  const box = scene.svg.getBoundingClientRect();
  const view = /** @type {SVGSVGElement} */ (scene.svg).viewBox.baseVal;
  const factor = Math.min(box.width / view.width, box.height / view.height);
  const x = (event.clientX - box.left - (box.width - view.width * factor) / 2) / factor;
  const y = (event.clientY - box.top - (box.height - view.height * factor) / 2) / factor;
  return [(x - scene.x0) / scene.scale, -(y - scene.y0) / scene.scale];
}

/**
 * Every body follows the pointer that holds it, as far as the input lets it.
 * @param {Scene} scene
 */
export function dragged(scene) {
  scene.view.bodies.forEach((body, k) => {
    const grip = scene.bodies[k];
    /** @type {[number, number] | null} */
    let held = null; // the point of the body, in its axes
    let [last, wanted] = [0, 0]; // of a crank the angle of the pointer, and where the input would be without its ends
    const even = scene.state.values.length === 2 && typeof body.x === "number" && typeof body.y === "number" && !body.on;
    const about = even ? [/** @type {number} */ (body.x), /** @type {number} */ (body.y)] : null; // it turns evenly
    const pivot = scene.view.handle?.body === body.name ? scene.view.handle.pivot : about;
    /** @param {PointerEvent} event @param {number[]} about */
    const angle = (event, about) => {
      const [x, y] = pointed(scene, event);
      return Math.atan2(y - about[1], x - about[0]);
    };
    grip.addEventListener("pointerdown", (event) => {
      const pose = scene.poses?.get(body.name);
      if (!pose) return;
      held = within(pose, pointed(scene, event));
      if (pivot) [last, wanted] = [angle(event, pivot), scene.state.at];
      grip.setPointerCapture(event.pointerId);
      grip.classList.add("held");
      event.preventDefault();
    });
    grip.addEventListener("pointermove", (event) => {
      if (!held) return;
      if (pivot) {
        const now = angle(event, pivot);
        wanted += Math.atan2(Math.sin(now - last), Math.cos(now - last)) / (rate(scene, body.angle) || 1);
        last = now;
        scene.state.take(wanted);
      } else {
        const before = scene.state.at;
        scene.state.take(sought(scene, body, held, pointed(scene, event)));
        const pose = scene.poses?.get(body.name);
        const round = Math.abs(scene.state.at - before) > scene.state.span / 2;
        if (round && pose) held = within(pose, pointed(scene, event)); // another tooth is there now
      }
    });
    const leave = () => {
      held = null;
      grip.classList.remove("held");
    };
    grip.addEventListener("pointerup", leave);
    grip.addEventListener("pointercancel", leave);
  });
}

/**
 * The rate of a track by the input.
 * @param {Scene} scene
 * @param {import("./data.js").Track} track
 */
function rate(scene, track) {
  return typeof track === "number" ? 0 : numbers(track[1])[scene.state.near];
}

/**
 * Where the input stands when a point of a body is nearest to a place, found by steps that come nearer each.
 * @param {Scene} scene
 * @param {import("./data.js").Body} body
 * @param {[number, number]} held
 * @param {[number, number]} wanted
 */
function sought(scene, body, held, wanted) {
  const { state } = scene;
  const { low, high, view } = state;
  const most = state.span / 24;
  /** @param {number} input @returns {[number, number]} */
  const point = (input) => {
    const there = state.values.length > 2 ? between(state.values, state.turned(input)) : straight(state.values, input);
    const poses = scene.posed(there);
    return placed(poses.get(body.name) ?? STILL, held[0], held[1]);
  };
  let at = state.at;
  let left = Infinity;
  let next = at;
  for (let k = 0; k < 24; k++) {
    const [x, y] = point(next);
    const [dx, dy] = [wanted[0] - x, wanted[1] - y];
    if (Math.hypot(dx, dy) >= left) break;
    left = Math.hypot(dx, dy);
    at = next;
    const [vx, vy] = velocity(scene, point, at);
    const size = vx * vx + vy * vy;
    if (!size) break;
    next = at + Math.min(most, Math.max(-most, (dx * vx + dy * vy) / size));
    if (!view.whole && (next < low || next > high)) return next;
  }
  return at;
}

/**
 * How a point goes with the input; where it rests, as at the ends of a motion over the time, the way from there on.
 * @param {Scene} scene
 * @param {(input: number) => [number, number]} point
 * @param {number} at
 */
function velocity(scene, point, at) {
  const { low, high, span, view } = scene.state;
  /** @param {number} before @param {number} after */
  const over = (before, after) => {
    const [[bx, by], [ax, ay]] = [point(before), point(after)];
    return [(ax - bx) / (after - before), (ay - by) / (after - before)];
  };
  const small = SMALL * span;
  const found = view.whole ? over(at - small, at + small) : over(Math.max(low, at - small), Math.min(high, at + small));
  if (view.whole || Math.hypot(found[0], found[1]) * span >= REST * scene.size) return found;
  return at + span / 24 <= high ? over(at, at + span / 24) : over(at - span / 24, at);
}

/**
 * A place in the axes of a body.
 * @param {import("./motion.js").Pose} pose
 * @param {[number, number]} place
 * @returns {[number, number]}
 */
function within(pose, [x, y]) {
  const [dx, dy] = [x - pose.x, y - pose.y];
  return [pose.cos * dx + pose.sin * dy, pose.cos * dy - pose.sin * dx];
}
