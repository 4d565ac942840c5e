// The plane of a trial as it is drawn in one shape: regions, lines, points, the hand, and the sketch of its point.
import { numbers } from "./data.js";
import { around, settled } from "./labels.js";
import { named } from "./letters.js";
import { drawn } from "./marks.js";
import { standard } from "./scales.js";
import { Sketch } from "./sketch.js";
import { parted, told, word, written } from "./words.js";

const PHONE = 600; // pixels of a window below which the plane is drawn smaller, its letters are not
// width of both, height of the plane against it at most, height of the sketch
const SHAPES = { wide: { width: 760, part: 0.6, deep: 350 }, phone: { width: 360, part: 0.95, deep: 280 } };
const LETTER = 13; // height of a name
const LEFT = 52;
const BELOW = 40;

/** The shape that the window asks for. */
export function shaped() {
  return innerWidth < PHONE ? SHAPES.phone : SHAPES.wide;
}

export class Field {
  /**
   * @param {Element} parent
   * @param {import("./data.js").Trial} trial
   */
  constructor(parent, trial) {
    this.trial = trial;
    this.shape = shaped();
    const [low, bottom, high, top] = trial.box;
    const { width, part, deep } = this.shape;
    this.scale = Math.min((width - LEFT - 8) / (high - low), (part * width - BELOW - 8) / (top - bottom));
    this.width = (high - low) * this.scale;
    this.height = (top - bottom) * this.scale;
    this.left = LEFT + (width - LEFT - 8 - this.width) / 2;
    /** @type {(() => void)[]} */
    this.says = [];
    this.svg = drawn("svg", { viewBox: `0 0 ${width} ${Math.round(this.height + BELOW + 8)}`, class: "plane", role: "application", tabindex: 0 }, parent);
    this.grid();
    const frame = { x: this.left, y: 8, width: this.width, height: this.height };
    this.frame = drawn("svg", { ...frame, class: "within" }, this.svg);
    this.regions();
    this.curves();
    drawn("rect", { ...frame, class: "frame" }, this.svg);
    this.points();
    this.hand = drawn("circle", { class: "hand", r: 8 }, this.frame);
    this.sketch = new Sketch(parent, trial.sketch, width, deep);
  }

  /** All words, in the language. */
  say() {
    this.svg.setAttribute("aria-label", `${told(this.trial.title)}. ${word("pick")}`);
    this.sketch.say();
    for (const each of this.says) each();
  }

  /** @param {number} x */
  across(x) {
    return (x - this.trial.box[0]) * this.scale;
  }

  /** @param {number} y */
  up(y) {
    return (this.trial.box[3] - y) * this.scale;
  }

  /** Lines of round values, the names of the axes. */
  grid() {
    const [low, bottom, high, top] = this.trial.box;
    const step = standard(Math.max(high - low, top - bottom) / 9);
    const group = drawn("g", { class: "grid" }, this.svg);
    /** @type {Element[]} */
    const texts = [];
    /** @type {number[]} */
    const values = [];
    for (let k = Math.ceil(low / step); k * step <= high; k++) {
      const x = this.left + this.across(k * step);
      drawn("line", { x1: x, x2: x, y1: 8, y2: 8 + this.height, class: k === 0 ? "zero" : "" }, group);
      texts.push(drawn("text", { x, y: this.height + 24, "text-anchor": "middle" }, group));
      values.push(k * step);
    }
    for (let k = Math.ceil(bottom / step); k * step <= top; k++) {
      const y = 8 + this.up(k * step);
      drawn("line", { x1: this.left, x2: this.left + this.width, y1: y, y2: y, class: k === 0 ? "zero" : "" }, group);
      texts.push(drawn("text", { x: this.left - 6, y: y + 4, "text-anchor": "end" }, group));
      values.push(k * step);
    }
    this.says.push(() => {
      for (const [k, text] of texts.entries()) text.textContent = written(values[k], 3);
    });
    const [first, second] = this.trial.inputs.map(parted);
    named(group, first, { x: this.left + this.width / 2, y: this.height + 42, class: "axis" });
    named(group, second, { x: this.left - 46, y: 8 + this.height / 2, class: "axis" });
  }

  /**
   * The way along points of the plane.
   * @param {{x: import("./data.js").Ref, y: import("./data.js").Ref}} line
   */
  path({ x, y }) {
    const [xs, ys] = [numbers(x), numbers(y)];
    return Array.from(xs, (value, k) => `${k ? "L" : "M"}${this.across(value).toFixed(1)},${this.up(ys[k]).toFixed(1)}`).join("");
  }

  regions() {
    for (const region of this.trial.regions) {
      const kind = `region ${region.kind}${region.apart ? " apart" : ""}`;
      drawn("path", { class: kind, d: `${this.path(region)}z` }, this.frame);
    }
  }

  /** Lines with their numbers where they are in sight. */
  curves() {
    this.trial.curves.forEach((curve, place) => {
      const line = drawn("path", { class: "curve", d: this.path(curve) }, this.frame);
      const title = drawn("title", {}, line);
      this.says.push(() => (title.textContent = `${told(curve.title)}: ${written(curve.value, 4)}`));
      const [xs, ys] = [numbers(curve.x), numbers(curve.y)];
      const seen = [...xs.keys()].filter((k) => {
        const [x, y] = [this.across(xs[k]), this.up(ys[k])];
        return x > 14 && x < this.width - 14 && y > 14 && y < this.height - 14;
      });
      if (!seen.length) return;
      const k = seen[Math.floor((0.15 + 0.7 * ((place * 0.37) % 1)) * (seen.length - 1))];
      const label = drawn("text", { class: "number", x: this.across(xs[k]), y: this.up(ys[k]) + 4, "text-anchor": "middle" }, this.frame);
      label.textContent = curve.number;
    });
  }

  /** Points that have a name: a click takes the hand there. */
  points() {
    /** @type {{x: number, y: number, names: import("./data.js").Trial["points"]}[]} */
    const places = [];
    for (const point of this.trial.points) {
      const [x, y] = [this.across(point.at[0]), this.up(point.at[1])];
      const same = places.find((each) => Math.hypot(each.x - x, each.y - y) < 6);
      if (same) same.names.push(point);
      else places.push({ x, y, names: [point] });
    }
    const above = drawn("g", { transform: `translate(${this.left} 8)` }, this.svg);
    const texts = places.map(({ x, y, names }) => {
      const group = drawn("g", { class: "point" }, above);
      drawn("circle", { cx: x, cy: y, r: 4 }, group);
      const text = /** @type {SVGTextElement} */ (drawn("text", { "text-anchor": "middle" }, group));
      const title = drawn("title", {}, group);
      this.says.push(() => {
        text.textContent = names.map((each) => told(each.name)).join(", ");
        title.textContent = names.map((each) => `${told(each.name)}: ${told(each.title)}`).join("; ");
      });
      return text;
    });
    this.says.push(() => {
      const others = places.map(({ x, y }) => /** @type {[number, number, number, number]} */ ([x - 4, y, x + 4, y]));
      const items = places.map(({ x, y }, k) => {
        const wide = texts[k].getComputedTextLength();
        const all = around(wide, LETTER);
        const within = all.filter(([dx]) => x + dx > wide / 2 && x + dx < this.width - wide / 2);
        const choices = within.length ? within : all; // a narrow plane has names beside it
        /** @type {[number, number][]} */
        const at = [[x, y]];
        return { at, size: /** @type {[number, number]} */ ([wide, LETTER]), choices };
      });
      settled(items, [others]).forEach(([dx, dy], k) => {
        texts[k].setAttribute("x", String(places[k].x + dx));
        texts[k].setAttribute("y", String(places[k].y + dy + 4));
      });
    });
  }

  /** The place of the plane under a pointer. @param {PointerEvent} event @returns {[number, number]} */
  pointed(event) {
    const svg = /** @type {SVGSVGElement} */ (this.svg);
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
    const [left, , , top] = this.trial.box;
    return [(at.x - this.left) / this.scale + left, top - (at.y - 8) / this.scale];
  }

  /** Put the hand at a place of the plane. @param {[number, number]} at */
  mark([x, y]) {
    this.hand.setAttribute("cx", this.across(x).toFixed(2));
    this.hand.setAttribute("cy", this.up(y).toFixed(2));
  }
}
