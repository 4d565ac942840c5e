// A plane of two inputs whose point is moved by hand: regions, lines, points; sizes and a drawing follow by formulas.
import { numbers } from "./data.js";
import { button, made } from "./elements.js";
import { chained, compiled } from "./formulas.js";
import { around, settled } from "./labels.js";
import { drawn, named } from "./marks.js";
import { away } from "./outlines.js";
import { standard } from "./scales.js";
import { Sketch } from "./sketch.js";
import { parted, saying, told, word, written } from "./words.js";

const PHONE = 600; // pixels of a window below which the plane is drawn smaller, its letters are not
// width, height to it of the plane at most, height of the drawing
const SHAPES = { wide: [760, 0.6, 350], phone: [360, 0.95, 280] };
const LETTER = 13; // height of a name
const LEFT = 52;
const BELOW = 40;
const NEAR = 1e-4; // of an edge: what lies on it belongs to its region
const STEP = 0.01; // of the arrow keys; with Shift a tenth of it
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

export class Plane {
  /**
   * @param {Element} parent
   * @param {import("./data.js").Trial} trial
   */
  constructor(parent, trial) {
    this.trial = trial;
    this.compute = chained(trial.steps);
    this.at = trial.start;
    const section = made("section", { class: "trial", "data-trial": trial.name }, parent);
    const title = made("h2", {}, section);
    saying(() => (title.textContent = told(trial.title)));
    const [low, bottom, high, top] = trial.box;
    const [wide, most, deep] = innerWidth < PHONE ? SHAPES.phone : SHAPES.wide;
    this.scale = Math.min((wide - LEFT - 8) / (high - low), (most * wide - BELOW - 8) / (top - bottom));
    this.width = (high - low) * this.scale;
    this.height = (top - bottom) * this.scale;
    this.left = LEFT + (wide - LEFT - 8 - this.width) / 2;
    this.svg = drawn("svg", { viewBox: `0 0 ${wide} ${Math.round(this.height + BELOW + 8)}`, class: "plane", role: "application", tabindex: 0 }, section);
    saying(() => this.svg.setAttribute("aria-label", `${told(trial.title)}. ${word("pick")}`));
    this.grid();
    const frame = { x: this.left, y: 8, width: this.width, height: this.height };
    this.frame = drawn("svg", { ...frame, class: "within" }, this.svg);
    this.regions();
    this.curves();
    drawn("rect", { ...frame, class: "frame" }, this.svg);
    this.points();
    this.hand = drawn("circle", { class: "hand", r: 8 }, this.frame);
    this.sketch = new Sketch(section, trial.sketch, wide, deep);
    this.conditions = trial.conditions.map((each) => ({ ...each, spare: compiled(each.formula) }));
    this.refusal = made("output", { class: "wrong" }, section);
    const bar = made("div", { class: "player" }, section);
    const back = button(bar, "back", () => word("chosen"), () => this.move(trial.start));
    back.classList.add("main");
    this.verdict = made("output", { class: "told" }, bar);
    const table = made("table", { class: "readings" }, section);
    const body = made("tbody", {}, table);
    this.rows = trial.shown.map((shown) => {
      const row = made("tr", {}, body);
      const meaning = made("th", { scope: "row" }, row);
      const sign = made("td", { class: "sign" }, row);
      const [letter, index] = parted(shown.name.replace(/[{}]/g, "").replace("Delta", "Δ"));
      sign.append(letter);
      if (index) made("sub", {}, sign).textContent = index;
      return { shown, row, meaning, value: made("td", { class: "number" }, row), least: made("td", { class: "least" }, row) };
    });
    this.moved();
    saying(() => this.tell());
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
    saying(() => {
      for (const [k, text] of texts.entries()) text.textContent = written(values[k], 3);
    });
    const [first, second] = this.trial.inputs.map(parted);
    named(group, first[0], first[1], { x: this.left + this.width / 2, y: this.height + 42, class: "axis" });
    named(group, second[0], second[1], { x: this.left - 46, y: 8 + this.height / 2, class: "axis" });
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
    for (const region of this.trial.regions) drawn("path", { class: `region ${region.kind}`, d: `${this.path(region)}z` }, this.frame);
  }

  /** Lines with their numbers where they are in sight. */
  curves() {
    this.trial.curves.forEach((curve, place) => {
      const line = drawn("path", { class: "curve", d: this.path(curve) }, this.frame);
      const title = drawn("title", {}, line);
      saying(() => (title.textContent = `${told(curve.title)}: ${written(curve.value, 4)}`));
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
      saying(() => {
        text.textContent = names.map((each) => told(each.name)).join(", ");
        title.textContent = names.map((each) => `${told(each.name)}: ${told(each.title)}`).join("; ");
      });
      return text;
    });
    saying(() => {
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

  /** The hand follows the pointer, and the keys. */
  moved() {
    this.svg.addEventListener("pointerdown", (event) => {
      const one = /** @type {PointerEvent} */ (event);
      this.svg.setPointerCapture(one.pointerId);
      this.move(this.pointed(one));
    });
    this.svg.addEventListener("pointermove", (event) => {
      const one = /** @type {PointerEvent} */ (event);
      if (one.buttons && this.svg.hasPointerCapture(one.pointerId)) this.move(this.pointed(one));
    });
    this.svg.addEventListener("keydown", (event) => {
      const one = /** @type {KeyboardEvent} */ (event);
      const way = KEYS[/** @type {keyof typeof KEYS} */ (one.key)];
      if (one.key === "Home") this.move(this.trial.start);
      if (!way) return;
      event.preventDefault();
      const step = one.shiftKey ? STEP / 10 : STEP;
      this.move([this.at[0] + way[0] * step, this.at[1] + way[1] * step]);
    });
  }

  /** The place of the plane under a pointer. @param {PointerEvent} event @returns {[number, number]} */
  pointed(event) {
    const svg = /** @type {SVGSVGElement} */ (this.svg);
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
    const [left, , , top] = this.trial.box;
    return [(at.x - this.left) / this.scale + left, top - (at.y - 8) / this.scale];
  }

  /** @param {[number, number]} asked */
  move([x, y]) {
    const [low, bottom, high, top] = this.trial.box;
    /** @type {[number, number]} */
    const within = [Math.min(high, Math.max(low, x)), Math.min(top, Math.max(bottom, y))];
    this.at = within;
    this.tell();
  }

  /** Whether the point lies within a region. @param {import("./data.js").Trial["regions"][number]} region */
  holds(region) {
    const [xs, ys] = [numbers(region.x), numbers(region.y)];
    const [x, y] = this.at;
    let inside = false;
    for (let k = 0, j = xs.length - 1; k < xs.length; j = k++) {
      if (away([xs[k], ys[k]], [xs[j], ys[j]], this.at) < NEAR) return true;
      if (ys[k] > y !== ys[j] > y && x < ((xs[j] - xs[k]) * (y - ys[k])) / (ys[j] - ys[k]) + xs[k]) inside = !inside;
    }
    return inside;
  }

  /**
   * Draw what there is at these values; why there is nothing, or why it is of no use.
   * @param {Record<string, number>} values
   */
  drawing(values) {
    const broken = this.conditions.filter((each) => !(each.spare(values) >= 0));
    const missing = broken.find((each) => each.needed)?.text ?? this.sketch.draw(values);
    this.sketch.hide(missing !== null);
    if (missing !== null) return word("absent", { why: told(missing) });
    return broken.length ? word("useless", { why: broken.map((each) => told(each.text)).join("; ") }) : "";
  }

  /** Sizes and figures at the point. */
  tell() {
    const { inputs, given, regions } = this.trial;
    const [x, y] = this.at;
    this.hand.setAttribute("cx", this.across(x).toFixed(2));
    this.hand.setAttribute("cy", this.up(y).toFixed(2));
    const values = this.compute({ ...given, [inputs[0]]: x, [inputs[1]]: y });
    const kinds = regions.filter((region) => this.holds(region)).map((region) => region.kind);
    const place = kinds.includes("strict") ? "within" : kinds.length ? "flawed" : "outside";
    this.verdict.textContent = `${this.said(inputs[0], x)}; ${this.said(inputs[1], y)}: ${word(place)}`;
    this.verdict.classList.toggle("broken", place === "outside");
    put(this.refusal, this.drawing(values));
    for (const { shown, row, meaning, value, least } of this.rows) {
      const unit = told(shown.unit);
      const factor = unit === "°" ? 180 / Math.PI : 1;
      const found = shown.where && values[shown.where] < 0 ? NaN : values[shown.name] * factor;
      const limit = typeof shown.least === "string" ? values[shown.least] : shown.least;
      put(meaning, told(shown.meaning));
      const behind = unit === "°" ? "°" : unit ? ` ${unit}` : "";
      put(value, Number.isFinite(found) ? `${written(found)}${behind}` : "–");
      put(least, limit === null ? "" : word("least", { low: written(limit, 4) }));
      row.classList.toggle("broken", limit !== null && !(found >= limit - 1e-9));
    }
  }

  /**
   * @param {string} name
   * @param {number} value
   */
  said(name, value) {
    return `${parted(name).join("")} = ${written(value, 4)}`;
  }
}

/**
 * Say a text that is not said yet: what stays the same is not set anew at every move.
 * @param {Element} where
 * @param {string} text
 */
function put(where, text) {
  if (where.textContent !== text) where.textContent = text;
}
