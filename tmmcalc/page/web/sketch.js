// What is drawn of the point of a trial: bodies with teeth and marks, all by formulas, around a place in the middle.
import { compiled } from "./formulas.js";
import { named } from "./letters.js";
import { COLOURS, drawn, RING } from "./marks.js";
import { teethAt, toothed } from "./outlines.js";
import { parted, told } from "./words.js";

const FINE = 5e-4; // how far cubics may lie from curves, in the units of the formulas
const BESIDE = [10, -9]; // pixels from a point to its name
const MIDDLE = 4; // pixels from the middle of a letter to its line
const EDGE = 12; // within which points are not shown
const [SMALL, LARGE] = [2.5, 4.5]; // radii of points with names, and without
const POINTS = new Set(["dot", "number"]);
const ROUND = new Set(["pitch", "base"]);

/** @typedef {Record<string, number>} Values */

export class Sketch {
  /**
   * @param {Element} parent
   * @param {import("./data.js").Sketch} sketch
   * @param {number} wide pixels
   * @param {number} high
   */
  constructor(parent, sketch, wide, high) {
    this.wide = wide;
    this.high = high;
    this.scale = high / 2 / sketch.reach;
    this.svg = drawn("svg", { viewBox: `0 0 ${wide} ${high}`, class: "scene sketch", role: "img" }, parent);
    this.title = sketch.title;
    this.middle = sketch.middle.map(compiled);
    this.at = [0, 0];
    this.bodies = sketch.bodies.map((body) => {
      const group = drawn("g", { class: `body still ${COLOURS[body.tone - 1]}` }, this.svg);
      const [gear, flank] = ["gear", "flank"].map((kind) => drawn("path", { class: kind }, group));
      return { beyond: body.beyond, placed: toothed(body), gear, flank };
    });
    this.marks = sketch.marks.map((mark) => this.marked(mark));
  }

  /**
   * A mark, as what puts it where the values have it.
   * @param {import("./data.js").Drawn} mark
   * @returns {(values: Values) => void}
   */
  marked(mark) {
    const { kind, tone, name } = mark;
    const group = drawn("g", { class: tone ? COLOURS[tone - 1] : "", "data-mark": name || kind }, this.svg);
    const at = mark.places.map((place) => place.map(compiled));
    const [radius, there] = [compiled(mark.size), compiled(mark.there)];
    const put = POINTS.has(kind) ? this.point(group, mark) : ROUND.has(kind) ? circle(group, kind) : line(group, kind);
    return (values) => {
      const points = at.map(([x, y]) => this.shown([x(values), y(values)]));
      group.classList.toggle("lost", !(there(values) >= 0) || (name !== "" && !this.inside(points[0])));
      put(points, radius(values) * this.scale);
    };
  }

  /**
   * A point with its name beside it, or a number in its ring.
   * @param {Element} group
   * @param {import("./data.js").Drawn} mark
   */
  point(group, { kind, name, side }) {
    drawn("circle", { class: kind, r: kind === "number" ? RING : name ? SMALL : LARGE }, group);
    const [x, y] = [BESIDE[0] * side, BESIDE[1] * side + MIDDLE];
    const anchor = side > 0 ? "start" : side < 0 ? "end" : "middle";
    if (name) named(group, parted(name), { x, y, class: side ? "name" : "", "text-anchor": anchor });
    return (/** @type {number[][]} */ [at]) => group.setAttribute("transform", `translate(${at.map(tidy).join(" ")})`);
  }

  /** Whether a place is seen with its name. @param {number[]} place */
  inside([x, y]) {
    return x > EDGE && x < this.wide - EDGE && y > EDGE && y < this.high - EDGE;
  }

  /** A place in pixels. @param {number[]} place @returns {[number, number]} */
  shown([x, y]) {
    return [this.wide / 2 + (x - this.at[0]) * this.scale, this.high / 2 - (y - this.at[1]) * this.scale];
  }

  /** @param {import("./outlines.js").Chain} chain */
  path(chain) {
    const [start, ...rest] = chain.map((point) => this.shown(point).map(tidy).join(","));
    return start ? `M${start}C${rest.join(" ")}` : "";
  }

  /**
   * Draw all at these values, or nothing where a body cannot be: then what is told of it comes back.
   * @param {Values} values
   */
  draw(values) {
    this.at = this.middle.map((each) => each(values));
    const placed = this.bodies.map((body) => body.placed(values, FINE));
    const gone = placed.findIndex((each) => each.beyond);
    if (gone >= 0) return this.bodies[gone].beyond;
    this.bodies.forEach(({ gear, flank }, k) => {
      const { outline, flanks, centre } = teethAt(placed[k], [this.at[0], this.at[1]], this.wide / this.scale);
      gear.setAttribute("d", `${this.path(outline)}${centre ? `L${this.shown(centre).map(tidy).join(",")}` : ""}z`);
      flank.setAttribute("d", flanks.map((each) => this.path(each)).join(""));
    });
    for (const place of this.marks) place(values);
    return null;
  }

  /** What it is, in the language. */
  say() {
    this.svg.setAttribute("aria-label", told(this.title));
  }

  /** @param {boolean} gone */
  hide(gone) {
    this.svg.classList.toggle("gone", gone);
  }
}

/**
 * @param {Element} group
 * @param {string} kind
 */
function circle(group, kind) {
  const found = drawn("circle", { class: kind }, group);
  return (/** @type {number[][]} */ [[x, y]], /** @type {number} */ r) => {
    for (const [key, value] of Object.entries({ cx: x, cy: y, r })) found.setAttribute(key, tidy(value));
  };
}

/**
 * @param {Element} group
 * @param {string} kind
 */
function line(group, kind) {
  const found = drawn("polyline", { class: kind }, group);
  return (/** @type {number[][]} */ points) => {
    found.setAttribute("points", points.map((point) => point.map(tidy).join(",")).join(" "));
  };
}

/** @param {number} value */
function tidy(value) {
  return value.toFixed(3);
}
