// The machines of the other variants, faint behind the one that is shown, at the same place of the input.
import { content, scene } from "./data.js";
import { between, isThere, placed, posesOf, STILL } from "./motion.js";
import { draw, drawn, put, stretch } from "./marks.js";
import { State } from "./state.js";
import { same } from "./words.js";

export const MANY = 13; // variants, of which ghosts are not shown before they are asked for
const SIZES = 3; // times its size: a picture that would have to grow more keeps its own

/** @typedef {import("./data.js").View} View */

/**
 * The same view of the other variants.
 * @param {View} view
 * @returns {View[]}
 */
export function others(view) {
  const all = content.scenes.filter((each) => each !== scene()).flatMap((each) => each.views);
  return all.filter((each) => each.name === view.name && each.room === view.room && same(each.unit, view.unit));
}

/**
 * The corners of a view with its ghosts, so that all variants are drawn to one scale where they are alike.
 * @param {View} view
 */
export function boxed(view) {
  const boxes = [view, ...others(view)].map((each) => each.box);
  const ends = [0, 1, 2, 3].map((k) => Math[k < 2 ? "min" : "max"](...boxes.map((box) => box[k])));
  /** @param {number[]} box */
  const size = ([left, bottom, right, top]) => Math.max(right - left, top - bottom);
  return size(ends) <= SIZES * size(view.box) ? ends : view.box;
}

export class Ghosts {
  /**
   * @param {View} view
   * @param {number} scale pixels of a metre
   * @param {Element} world
   */
  constructor(view, scale, world) {
    this.scale = scale;
    const group = drawn("g", { class: "ghosts" }, world);
    this.machines = others(view).map((other) => this.made(other, drawn("g", { class: "ghost" }, group)));
  }

  /**
   * @param {View} view
   * @param {Element} group
   */
  made(view, group) {
    const bodies = view.bodies.map((body) => {
      const own = drawn("g", {}, group);
      for (const mark of body.marks) draw(own, mark, this.scale);
      return own;
    });
    const spans = view.spans.map(([kind]) => drawn("polyline", { class: kind }, group));
    return { view, state: new State(view), group, bodies, spans };
  }

  /**
   * Draw them where the input is at a place; one whose travel does not reach it is not seen.
   * @param {number} at
   */
  update(at) {
    const s = this.scale;
    for (const { view, state, group, bodies, spans } of this.machines) {
      const reached = state.move(at);
      group.classList.toggle("lost", !reached);
      if (!reached) continue;
      const poses = posesOf(view.bodies, state.values, between(state.values, state.at));
      view.bodies.forEach((body, k) => {
        put(bodies[k], poses.get(body.name) ?? STILL, s);
        bodies[k].classList.toggle("lost", !isThere(body.there, state.at));
      });
      view.spans.forEach(([kind, points], k) => {
        const along = points.map(([body, x, y]) => placed(poses.get(body) ?? STILL, x, y));
        stretch([spans[k]], kind, along.map(([x, y]) => [x * s, -y * s]));
      });
    }
  }
}
