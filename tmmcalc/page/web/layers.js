// Vectors and angles that are shown together: arrows from their spots to one scale, angles with their legs and values.
import { columnOf, numbers } from "./data.js";
import { boxAt, free } from "./labels.js";
import { between, placed, STILL, trackAt } from "./motion.js";
import { named, sized } from "./letters.js";
import { drawn, head } from "./marks.js";
import { perPixel, scaleTold } from "./scales.js";
import { measured, parted } from "./words.js";

/** @typedef {import("./scene.js").Scene} Scene */
/**
 * @typedef {{line: SVGElement, tip: SVGElement, name: SVGElement, size: import("./labels.js").Pair, drop: number}} Drawn
 *   an arrow and its sign
 */
/** @typedef {import("./labels.js").Box} Box of a sign */

const FONT = 14; // of signs, in pixels
const LONGEST = 110; // of a vector, in pixels
const PART = 0.2; // of the width of the drawing, that it has at most
const NAMED = 13; // a shorter vector has no room for its sign
const BEYOND = 9; // its tip a sign stands
const LEG = 110; // of an angle, in pixels
const ARC = 84;
const SIGN = 76; // of its sign and value
const SHORT = 0.4; // of their length that legs have at least
const USUAL = 560; // width of a drawing, below which legs are shorter

export class Layer {
  /**
   * @param {Scene} scene
   * @param {import("./data.js").Layer} layer
   * @param {string} colour
   * @param {Element} world
   */
  constructor(scene, layer, colour, world) {
    this.scene = scene;
    this.layer = layer;
    this.colour = colour;
    this.shown = true;
    this.group = drawn("g", { class: `layer ${colour}`, "data-layer": layer.name }, world);
    this.arrows = layer.arrows.flatMap((arrow) => {
      const [x, y] = [columnOf(arrow.x), columnOf(arrow.y)];
      const spot = scene.view.spots.find((each) => each.name === arrow.spot);
      if (!x || !y || !x.stage.rows || !spot) return [];
      const rows = numbers(x.stage.rows.values);
      return [{ ...this.drawn(arrow.sign), arrow, spot, rows, x: numbers(x.column.values), y: numbers(y.column.values) }];
    });
    this.vectors = layer.vectors.map((vector) => ({ vector, ...this.drawn(vector.sign) }));
    this.angles = layer.angles.map((angle) => {
      const found = columnOf(angle.column);
      const legs = [0, 1].map(() => drawn("line", { class: "leg" }, this.group));
      const arc = drawn("path", { class: "arc" }, this.group);
      const name = named(this.group, parted(angle.sign), { class: "name" }, " = ");
      return { angle, found, legs, arc, name, value: /** @type {Element} */ (name.lastElementChild) };
    });
    let largest = 0;
    for (const { x, y } of this.arrows) largest = x.reduce((most, _, k) => Math.max(most, Math.hypot(x[k], y[k]) || 0), largest);
    for (const { vector } of this.vectors) largest = Math.max(largest, this.longest(vector));
    this.largest = largest;
    this.per = largest ? perPixel(largest / Math.min(LONGEST, PART * scene.width)) : 1; // of the unit to a pixel
  }

  /**
   * @param {string} sign
   * @returns {Drawn}
   */
  drawn(sign) {
    const letters = parted(sign);
    const [line, tip] = [drawn("line", {}, this.group), drawn("path", { class: "head" }, this.group)];
    const name = named(this.group, letters, { class: "name", "text-anchor": "middle" });
    return { line, tip, name, ...sized(letters.filter(Boolean).join("_"), FONT) };
  }

  /**
   * The greatest length of a vector where its body is there, in its unit.
   * @param {import("./data.js").Vector} vector
   */
  longest(vector) {
    const { state, view } = this.scene;
    const { values, low, high } = state;
    const [from, to] = view.bodies.find((each) => each.name === vector.body)?.there ?? [low, high];
    const own = vector.places ? [...numbers(vector.places)] : [from, ...values.filter((value) => value > from && value < to), to];
    return Math.max(...own.map((at) => Math.hypot(...this.valued(vector, at, between(values, at))) || 0));
  }

  /**
   * A vector at a place of the input: at the nearest of its own places, where it has such.
   * @param {import("./data.js").Vector} vector
   * @param {number} at
   * @param {import("./motion.js").Between} there
   */
  valued({ x, y, places }, at, there) {
    const { values } = this.scene.state;
    const near = places ? between(numbers(places), at).near : 0;
    return [x, y].map((track) => (places && typeof track !== "number" ? numbers(track[0])[near] : trackAt(track, values, there)));
  }

  /** The scale in words, where it has vectors. */
  get scaled() {
    return this.largest ? scaleTold(this.per, this.layer.unit) : "";
  }

  /** @param {boolean} shown */
  show(shown) {
    this.shown = shown;
    this.group.classList.toggle("off", !shown);
  }

  /**
   * Vectors from their spots, at the nearest solved position; signs stand where none is yet.
   * @param {Box[]} taken
   */
  update(taken) {
    const { state, poses, gone } = this.scene;
    const { there, at } = state;
    /** @type {{shown: Drawn, from: number[], way: number[], long: number}[]} */
    const all = [];
    /** @param {Drawn} shown @param {number[]} from @param {number[]} value */
    const add = (shown, from, value) => {
      const way = [value[0] / this.per, -value[1] / this.per];
      all.push({ shown, from: [from[0] * this.scene.scale, -from[1] * this.scene.scale], way, long: Math.hypot(...way) });
    };
    for (const shown of this.arrows) {
      const { arrow, spot, rows, x, y } = shown;
      const k = between(rows, at).near;
      add(shown, placed(poses?.get(spot.body) ?? STILL, spot.at[0], spot.at[1]), [arrow.sense * x[k], arrow.sense * y[k]]);
    }
    for (const shown of this.vectors) {
      const { vector } = shown;
      const pose = gone?.has(vector.body) ? undefined : poses?.get(vector.body);
      const value = this.valued(vector, at, there);
      add(shown, pose ? [pose.x, pose.y] : [0, 0], pose ? value : [0, 0]);
    }
    all.sort((a, b) => b.long - a.long);
    for (const each of all) arrow(each.shown, each.from, each.way, each.long, taken);
    for (const each of this.angles) this.opened(each);
  }

  /**
   * An angle with its legs and its value at the nearest solved position.
   * @param {Layer["angles"][number]} shown
   */
  opened({ angle, found, legs, arc, name, value }) {
    const { state, poses, scale, x0, y0, width, height } = this.scene;
    const pose = poses?.get(angle.body) ?? STILL;
    const { values, there, at } = state;
    const [from, to] = [trackAt(angle.start, values, there), trackAt(angle.end, values, there)];
    const [x, y] = [pose.x * scale, -pose.y * scale];
    const edges = [-x0, -y0, width - x0, height - y0];
    const room = Math.min(...[from, to].map((direction) => far([x, y], [Math.cos(direction), -Math.sin(direction)], edges)));
    const small = Math.min(1, width / USUAL, Math.max(SHORT, room / LEG)); // legs end in sight
    const [leg, radius] = [small * LEG, small * ARC];
    /** @param {number} direction @param {number} far @returns {[number, number]} */
    const point = (direction, far) => [x + far * Math.cos(direction), y - far * Math.sin(direction)];
    [from, to].forEach((direction, k) => {
      const [x1, y1] = point(direction, -leg / 2);
      const [x2, y2] = point(direction, leg);
      for (const [key, value] of Object.entries({ x1, y1, x2, y2 })) legs[k].setAttribute(key, value.toFixed(1));
    });
    const [ends, sweep] = [[point(from, radius), point(to, radius)], to > from ? 0 : 1];
    const [start, end] = ends.map((each) => each.map((value) => value.toFixed(1)).join(","));
    arc.setAttribute("d", `M${start}A${radius},${radius} 0 0 ${sweep} ${end}`);
    const away = to + (to > from ? 1 : -1) * (Math.PI / 2); // beside the second leg, outside the angle
    const [ex, ey] = point(to, leg - 6);
    const [tx, ty] = [ex + 8 * Math.cos(away), ey - 8 * Math.sin(away) + 5];
    const rows = found?.stage.rows;
    const size = rows ? numbers(found.column.values)[between(numbers(rows.values), at).near] : NaN;
    value.textContent = ` = ${measured(size, found?.column.unit ?? "", 3)}`;
    const before = Math.cos(away) < 0;
    const [left, right] = [-x0 + 4 + (before ? SIGN : 0), width - x0 - 4 - (before ? 0 : SIGN)];
    name.setAttribute("x", Math.min(right, Math.max(left, tx)).toFixed(1));
    name.setAttribute("y", Math.min(height - y0 - 6, Math.max(16 - y0, ty)).toFixed(1));
    name.setAttribute("text-anchor", before ? "end" : "start");
  }
}

/**
 * How far it is along a way from a place to the edges of the drawing.
 * @param {number[]} at
 * @param {number[]} way of length 1
 * @param {number[]} edges left, top, right, bottom
 */
function far(at, way, edges) {
  return Math.min(...way.map((part, k) => (part ? (edges[part < 0 ? k : k + 2] - at[k]) / part : Infinity)));
}

/**
 * An arrow, none where it is too short to be seen; its sign beyond its tip or beside it, none where there is no room.
 * @param {Drawn} shown
 * @param {number[]} from in pixels
 * @param {number[]} way in pixels
 * @param {number} long
 * @param {Box[]} taken
 */
function arrow({ line, tip, name, size, drop }, [ax, ay], [dx, dy], long, taken) {
  const seen = long > 1;
  for (const each of [line, tip]) each.classList.toggle("lost", !seen);
  if (seen) {
    const [bx, by] = [ax + dx, ay + dy];
    for (const [key, value] of Object.entries({ x1: ax, y1: ay, x2: bx, y2: by })) line.setAttribute(key, value.toFixed(1));
    tip.setAttribute("d", head([ax, ay], [bx, by]));
  }
  const [ex, ey] = [dx / (long || 1), dy / (long || 1)];
  const out = BEYOND + Math.min(size[0] / 2 / (Math.abs(ex) || 1e-9), size[1] / 2 / (Math.abs(ey) || 1e-9)) / 2;
  const aside = (Math.abs(ey) * size[0] + Math.abs(ex) * size[1]) / 2 + 5;
  const places = [[long + out, 0], [0.7 * long, aside], [0.7 * long, -aside], [0.4 * long, aside], [0.4 * long, -aside]];
  const boxes = places.map(([along, beside]) => boxAt(ax + along * ex - beside * ey, ay + along * ey + beside * ex, size));
  const place = long >= NAMED ? free(boxes, taken, []) : undefined;
  name.classList.toggle("lost", !place);
  if (!place) return;
  taken.push(place);
  name.setAttribute("x", ((place[0] + place[2]) / 2).toFixed(1));
  name.setAttribute("y", ((place[1] + place[3]) / 2 + drop).toFixed(1));
}
