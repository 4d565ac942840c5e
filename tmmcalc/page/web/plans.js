// Plans of vectors at the nearest solved position: velocities, accelerations, forces, the lever.
import { numbers } from "./data.js";
import { between } from "./motion.js";
import { around, boxAt, free } from "./labels.js";
import { sized, texted } from "./letters.js";
import { drawn, head } from "./marks.js";
import { folding, made, resized, WIDE, widthIn } from "./elements.js";
import { keep, kept } from "./kept.js";
import { perPixel, scaleTold } from "./scales.js";
import { saying, told, word } from "./words.js";

const HIGH = 360;
const MARGIN = 36;
const FONT = 15; // of names, in pixels
const CORNER = 6; // that a corner takes
const SAME = 12; // pixels within which corners have one name
const OFF = [3, 9]; // pixels between a vector and its sign
const PARTS = [0.5, 0.62, 0.38, 0.74, 0.26, 0.86]; // of a vector, where its sign may stand
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
    this.wide = widthIn(this.part);
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
   * Names of corners, then signs of vectors, the longest first: each where it lies on nothing, or nowhere.
   * @param {number[][]} at
   * @param {Element} names
   */
  name(at, names) {
    const { edges } = this.plan;
    /** @type {import("./labels.js").Line[]} */
    const lines = edges.map(([tail, tip]) => [at[tail][0], at[tail][1], at[tip][0], at[tip][1]]);
    const taken = at.map(([x, y]) => boxAt(x, y, [CORNER, CORNER]));
    /** @param {string} text @param {string} kind @param {(size: import("./labels.js").Pair) => number[][]} choices */
    const put = (text, kind, choices) => {
      const { size, drop } = sized(text, FONT);
      const boxes = choices(size).map(([x, y]) => boxAt(x, y, size));
      const place = free(boxes.filter((box) => this.within(box)), taken, lines);
      if (!place) return;
      taken.push(place);
      const [x, y] = [(place[0] + place[2]) / 2, (place[1] + place[3]) / 2 + drop];
      texted(names, text, { class: kind, x, y, "text-anchor": "middle" });
    };
    /** @type {number[][]} */
    const done = [];
    this.corners?.forEach(({ name }, k) => {
      const [x, y] = at[k];
      if (!name || done.some((each) => Math.hypot(each[0] - x, each[1] - y) < SAME)) return;
      done.push(at[k]);
      put(name, "vertex", (size) => around(...size).map(([dx, dy]) => [x + dx, y + dy]));
    });
    const long = lines.map(([ax, ay, bx, by]) => Math.hypot(bx - ax, by - ay));
    for (const k of [...edges.keys()].sort((i, j) => long[j] - long[i])) {
      const [, , sign, kind] = edges[k];
      if (sign && long[k] >= NAMED) put(sign, `sign ${kind}`, (size) => beside(lines[k], long[k], size));
    }
  }

  /** Whether a sign is seen whole. @param {import("./labels.js").Box} box */
  within([left, top, right, bottom]) {
    return left >= 0 && top >= 0 && right <= this.wide && bottom <= HIGH;
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

/**
 * Places of a sign along a vector, on both sides of it, from its middle on.
 * @param {import("./labels.js").Line} line
 * @param {number} long
 * @param {import("./labels.js").Pair} size
 */
function beside([ax, ay, bx, by], long, [wide, high]) {
  const [ex, ey] = [(bx - ax) / long, (by - ay) / long];
  const half = (Math.abs(ey) * wide + Math.abs(ex) * high) / 2;
  return OFF.flatMap((off) =>
    PARTS.flatMap((part) => {
      const [x, y] = [ax + part * (bx - ax), ay + part * (by - ay)];
      return [half + off, -half - off].map((aside) => [x + aside * ey, y - aside * ex]);
    }),
  );
}
