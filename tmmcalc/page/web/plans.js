// Plans of vectors at the nearest solved position: velocities, accelerations, forces, the lever.
import { numbers } from "./data.js";
import { between } from "./motion.js";
import { around, settled } from "./labels.js";
import { drawn, head, sized, texted } from "./marks.js";
import { folding, made, resized, widthIn } from "./elements.js";
import { keep, kept } from "./kept.js";
import { perPixel, scaleTold } from "./scales.js";
import { saying, told, word } from "./words.js";

const WIDE = 560;
const HIGH = 360;
const MARGIN = 36;
const FONT = 15; // of names, in pixels
const PLAIN = new Set(["arm", "turned"]); // lines of the lever that are no vectors
const NAMED = 26; // a shorter vector has no room for its sign

export class Plans {
  wide = WIDE;

  /**
   * @param {Element} parent
   * @param {import("./state.js").State} state
   */
  constructor(parent, state) {
    this.state = state;
    const { plans, name } = state.view;
    const { part, fold } = folding(parent, "plans", name, () => word("plans"));
    const label = made("label", {}, part);
    const said = made("span", {}, label);
    saying(() => (said.textContent = word("show")));
    const choice = made("select", { name: "plan" }, label);
    plans.forEach((plan, k) => {
      const option = made("option", { value: String(k) }, choice);
      saying(() => (option.textContent = told(plan.title)));
    });
    const wished = kept(`plan ${name}`, plans[0].name);
    this.chosen = Math.max(0, plans.findIndex((plan) => plan.name === wished));
    choice.value = String(this.chosen);
    this.svg = drawn("svg", { class: "plan", role: "img" }, part);
    this.under = made("p", { class: "errors" }, part);
    this.part = part;
    fold(false);
    choice.addEventListener("change", () => {
      this.choose(Number(choice.value));
      keep(`plan ${name}`, this.plan.name);
    });
    part.addEventListener("toggle", () => this.size());
    resized(part, () => this.size());
    saying(() => this.choose(this.chosen));
    state.follow(() => this.update());
  }

  /** Draw it as wide as there is room. */
  size() {
    this.wide = widthIn(this.part, WIDE);
    this.svg.setAttribute("viewBox", `0 0 ${this.wide} ${HIGH}`);
    this.update();
  }

  get plan() {
    return this.state.view.plans[this.chosen];
  }

  /** @param {number} k */
  choose(k) {
    this.chosen = k;
    const { plan } = this;
    this.places = plan.places ? numbers(plan.places) : this.state.values;
    this.corners = plan.vertices.map(([name, x, y]) => ({ name, x: numbers(x), y: numbers(y) }));
    this.svg.setAttribute("aria-label", told(plan.title));
    this.update();
  }

  /**
   * Names of corners and signs of vectors, each where it covers least.
   * @param {number[][]} at
   * @param {Element} names
   */
  name(at, names) {
    /** @type {[number, number, number, number][]} */
    const lines = this.plan.edges.map(([tail, tip]) => [at[tail][0], at[tail][1], at[tip][0], at[tip][1]]);
    /** @type {(import("./labels.js").Item & {text: string, kind: string, drop: number})[]} */
    const items = [];
    /** @type {number[][]} */
    const done = [];
    this.corners?.forEach(({ name }, k) => {
      if (!name || done.some(([x, y]) => Math.hypot(x - at[k][0], y - at[k][1]) < 12)) return;
      done.push(at[k]);
      const { size, drop } = sized(name, FONT);
      items.push({ at: [[at[k][0], at[k][1]]], size, drop, choices: around(...size), text: name, kind: "vertex" });
    });
    this.plan.edges.forEach(([, , sign, kind], k) => {
      const [x1, y1, x2, y2] = lines[k];
      const long = Math.hypot(x2 - x1, y2 - y1);
      if (!sign || long < NAMED) return;
      const { size, drop } = sized(sign, FONT);
      const [ex, ey] = [(x2 - x1) / long, (y2 - y1) / long];
      const off = (Math.abs(ey) * size[0] + Math.abs(ex) * size[1]) / 2 + 3;
      /** @type {import("./labels.js").Pair[]} */
      const choices = [0, 0.15, -0.15, 0.28, -0.28].flatMap((part) =>
        [1, -1].map((side) => /** @type {import("./labels.js").Pair} */ ([part * long * ex + side * off * ey, part * long * ey - side * off * ex])),
      );
      items.push({ at: [[(x1 + x2) / 2, (y1 + y2) / 2]], size, drop, choices, text: sign, kind: `sign ${kind}` });
    });
    settled(items, [lines]).forEach(([dx, dy], k) => {
      const { at: places, text, kind, drop } = items[k];
      texted(names, text, { class: kind, x: places[0][0] + dx, y: places[0][1] + dy + drop, "text-anchor": "middle" });
    });
  }

  /**
   * The corners in pixels, to the standard scale in which they have room there.
   * @param {number} k
   */
  fitted(k) {
    const { plan } = this;
    /** @type {{x: Float32Array, y: Float32Array}[]} */
    const corners = this.corners ?? [];
    const [xs, ys] = [corners.map(({ x }) => x[k]), corners.map(({ y }) => y[k])];
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const need = Math.max((right - left) / (this.wide - 2 * MARGIN), (high - low) / (HIGH - 2 * MARGIN));
    const per = perPixel(need || 1); // of the unit to a pixel
    this.under.textContent = [scaleTold(per, plan.unit), told(plan.note)].filter(Boolean).join("; ");
    const x0 = this.wide / 2 - (left + right) / 2 / per;
    const y0 = HIGH / 2 + (low + high) / 2 / per;
    return corners.map(({ x, y }) => [x0 + x[k] / per, y0 - y[k] / per]);
  }

  /** Draw it where the input stands. */
  update() {
    if (!this.part.open || !this.corners || !this.places) return;
    const k = between(this.places, this.state.at).near;
    const at = this.fitted(k);
    this.svg.replaceChildren();
    const lines = drawn("g", {}, this.svg);
    const names = drawn("g", {}, this.svg);
    for (const [tail, tip, , kind] of this.plan.edges) {
      const [x1, y1] = at[tail];
      const [x2, y2] = at[tip];
      const long = Math.hypot(x2 - x1, y2 - y1);
      if (long < 0.7) continue;
      const group = drawn("g", { class: `edge ${kind}` }, lines);
      drawn("line", { x1, y1, x2, y2 }, group);
      if (!PLAIN.has(kind)) drawn("path", { d: head(at[tail], at[tip]) }, group);
    }
    this.name(at, names);
    drawn("circle", { class: "pole", cx: at[0][0], cy: at[0][1], r: 3 }, this.svg);
  }
}
