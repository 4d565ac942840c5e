// What is drawn of the point of a trial: bodies with teeth and marks, all by formulas, around a place in the middle.
import { compiled } from "./formulas.js";
import { COLOURS, drawn, named } from "./marks.js";
import { around, toothed } from "./outlines.js";
import { saying, told } from "./words.js";

const FINE = 5e-4; // how far chords may lie from curves, in the units of the formulas
const BESIDE = [10, -9]; // pixels from a point to its name
const EDGE = 12; // within which points lose their names
const RING = 9;

export class Sketch {
  /**
   * @param {Element} parent
   * @param {import("./data.js").Sketch} sketch
   * @param {number} wide pixels
   * @param {number} high
   */
  constructor(parent, sketch, wide, high) {
    [this.wide, this.high, this.scale] = [wide, high, high / 2 / sketch.reach];
    this.svg = drawn("svg", { viewBox: `0 0 ${wide} ${high}`, class: "scene sketch", role: "img" }, parent);
    saying(() => this.svg.setAttribute("aria-label", told(sketch.title)));
    this.middle = sketch.middle.map(compiled);
    this.at = [0, 0];
    this.bodies = sketch.bodies.map((body) => {
      const group = drawn("g", { class: `body still ${COLOURS[body.tone - 1]}` }, this.svg);
      const [gear, flank] = ["gear", "flank"].map((kind) => drawn("path", { class: kind }, group));
      return { told: body.beyond, placed: toothed(body), gear, flank };
    });
    this.marks = sketch.marks.map((mark) => this.marked(mark));
  }

  /**
   * The element of a mark, and what puts it where the values have it.
   * @param {import("./data.js").Drawn} mark
   */
  marked({ kind, places, size, tone, name, side, there }) {
    const group = drawn("g", { class: tone ? COLOURS[tone - 1] : "", "data-mark": name || kind }, this.svg);
    const round = kind !== "line" && kind !== "bar" && kind !== "axis";
    const one = drawn(round ? "circle" : "polyline", { class: kind }, group);
    const [x, y] = [BESIDE[0] * side, BESIDE[1] * side];
    if (kind === "number") one.setAttribute("r", String(RING));
    if (kind === "dot") one.setAttribute("r", name ? "2.5" : "4.5");
    if (kind === "number") drawn("text", { y: 4, "text-anchor": "middle" }, group).textContent = name;
    else if (name) named(group, name[0], name.slice(1), { x, y: y + 4, class: "name", "text-anchor": side > 0 ? "start" : "end" });
    const at = places.map((place) => place.map(compiled));
    const [radius, seen] = [compiled(size), compiled(there)];
    return (/** @type {Record<string, number>} */ values) => {
      const points = at.map(([across, up]) => this.shown([across(values), up(values)]));
      const inside = !name || (Math.abs(points[0][0] - this.wide / 2) < this.wide / 2 - EDGE && Math.abs(points[0][1] - this.high / 2) < this.high / 2 - EDGE);
      group.classList.toggle("lost", !(seen(values) >= 0) || !inside);
      if (!round) one.setAttribute("points", points.map((point) => point.map(tidy).join(",")).join(" "));
      else if (kind === "dot" || kind === "number") group.setAttribute("transform", `translate(${points[0].map(tidy).join(" ")})`);
      else for (const [key, value] of Object.entries({ cx: points[0][0], cy: points[0][1], r: radius(values) * this.scale })) one.setAttribute(key, tidy(value));
    };
  }

  /** A place in pixels. @param {number[]} place @returns {[number, number]} */
  shown([x, y]) {
    return [this.wide / 2 + (x - this.at[0]) * this.scale, this.high / 2 - (y - this.at[1]) * this.scale];
  }

  /** @param {import("./outlines.js").Point[]} points */
  path(points) {
    return points.map((point, k) => `${k ? "L" : "M"}${this.shown(point).map(tidy).join(",")}`).join("");
  }

  /**
   * Draw all at these values, or nothing where a body cannot be: then what is told of it comes back.
   * @param {Record<string, number>} values
   */
  draw(values) {
    this.at = this.middle.map((each) => each(values));
    const placed = this.bodies.map((body) => body.placed(values, FINE));
    const gone = placed.findIndex((each) => each.beyond);
    if (gone >= 0) return this.bodies[gone].told;
    this.bodies.forEach(({ gear, flank }, k) => {
      const { outline, flanks } = around(placed[k], [this.at[0], this.at[1]], this.wide / this.scale);
      gear.setAttribute("d", `${this.path(outline)}z`);
      flank.setAttribute("d", flanks.map((each) => this.path(each)).join(""));
    });
    for (const place of this.marks) place(values);
    return null;
  }

  /** @param {boolean} gone */
  hide(gone) {
    this.svg.classList.toggle("gone", gone);
  }
}

/** @param {number} value */
function tidy(value) {
  return value.toFixed(3);
}
