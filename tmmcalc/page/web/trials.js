// A plane of two inputs whose point is moved by hand: regions, lines, points; sizes and a drawing follow by formulas.
import { numbers } from "./data.js";
import { button, lettered, made, resized } from "./elements.js";
import { Field, shaped } from "./field.js";
import { chained, compiled } from "./formulas.js";
import { keep, kept } from "./kept.js";
import { keyed } from "./keys.js";
import { away } from "./outlines.js";
import { isAngle, measured, parted, saying, told, word, written } from "./words.js";

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
    this.place = `point ${trial.name}`;
    this.at = this.within(kept(this.place, null) ?? trial.start);
    const section = made("section", { class: "trial", "data-trial": trial.name }, parent);
    const title = made("h2", {}, section);
    saying(() => (title.textContent = told(trial.title)));
    const room = made("div", {}, section);
    this.field = new Field(room, trial);
    this.moved();
    this.conditions = trial.conditions.map((each) => ({ ...each, spare: compiled(each.formula) }));
    this.verdict = made("output", { class: "told" }, section);
    this.refusal = made("output", { class: "wrong" }, section);
    const bar = made("div", { class: "player" }, section);
    const back = button(bar, "back", () => word("chosen"), () => this.back());
    back.classList.add("main");
    if (trial.points.length) this.points(section);
    const table = made("table", { class: "readings" }, section);
    const body = made("tbody", {}, table);
    this.rows = trial.shown.map((shown) => {
      const row = made("tr", {}, body);
      const meaning = made("th", { scope: "row" }, row);
      const sign = made("td", { class: "sign" }, row);
      lettered(sign, parted(shown.name.replace("Delta", "Δ")));
      return { shown, row, meaning, value: made("td", { class: "number" }, row), bound: made("td", { class: "least" }, row) };
    });
    saying(() => this.say());
    resized(section, () => {
      if (this.field.shape === shaped()) return;
      room.replaceChildren();
      this.field = new Field(room, trial);
      this.moved();
      this.say();
    });
  }

  /** All words, in the language. */
  say() {
    this.field.say();
    this.tell();
  }

  /** The hand follows the pointer, and the keys. */
  moved() {
    const { field } = this;
    const { svg } = field;
    svg.addEventListener("pointerdown", (event) => {
      const one = /** @type {PointerEvent} */ (event);
      svg.setPointerCapture(one.pointerId);
      this.move(field.pointed(one));
    });
    svg.addEventListener("pointermove", (event) => {
      const one = /** @type {PointerEvent} */ (event);
      if (one.buttons && svg.hasPointerCapture(one.pointerId)) this.move(field.pointed(one));
    });
    /** @type {import("./keys.js").Acts} */
    const acts = { Home: () => this.back() };
    for (const [key, [across, up]] of Object.entries(KEYS)) {
      acts[key] = ({ shiftKey }) => {
        const step = shiftKey ? STEP / 10 : STEP;
        this.move([this.at[0] + across * step, this.at[1] + up * step]);
      };
    }
    keyed(svg, acts);
  }

  /** Named points, each a button that takes the hand there. @param {Element} parent */
  points(parent) {
    const list = made("div", { class: "stops" }, parent);
    for (const point of this.trial.points) {
      const found = made("button", { type: "button" }, list);
      saying(() => {
        found.textContent = told(point.name);
        found.title = told(point.title);
      });
      found.addEventListener("click", () => this.move(point.at));
    }
  }

  /** The point that is nearest within the plane. @param {[number, number]} asked @returns {[number, number]} */
  within([x, y]) {
    const [low, bottom, high, top] = this.trial.box;
    return [Math.min(high, Math.max(low, x)), Math.min(top, Math.max(bottom, y))];
  }

  /** Move the point by hand: other variants have it there too. @param {[number, number]} asked */
  move(asked) {
    this.at = this.within(asked);
    keep(this.place, this.at);
    this.tell();
  }

  /** To the chosen point, of every variant its own. */
  back() {
    this.move(this.trial.start);
    keep(this.place, null);
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
    const missing = broken.find((each) => each.needed)?.text ?? this.field.sketch.draw(values);
    this.field.sketch.hide(missing !== null);
    if (missing !== null) return word("absent", { why: told(missing) });
    return broken.length ? word("useless", { why: broken.map((each) => told(each.text)).join("; ") }) : "";
  }

  /** Sizes and figures at the point. */
  tell() {
    const { inputs, given, regions } = this.trial;
    const [x, y] = this.at;
    this.field.mark(this.at);
    const values = this.compute({ ...given, [inputs[0]]: x, [inputs[1]]: y });
    const held = regions.filter((region) => this.holds(region));
    const strict = held.filter((region) => region.kind === "strict");
    const place = strict.length ? "within" : held.length ? "flawed" : "outside";
    const apart = held.length > 0 && (strict.length ? strict : held).every((region) => region.apart);
    const verdict = apart ? word("apart", { place: word(place) }) : word(place);
    this.verdict.replaceChildren();
    this.said(inputs[0], x, "; ");
    this.said(inputs[1], y, `: ${verdict}`);
    this.verdict.classList.toggle("broken", place === "outside");
    put(this.refusal, this.drawing(values));
    for (const { shown, row, meaning, value, bound } of this.rows) {
      const factor = isAngle(shown.unit) ? 180 / Math.PI : 1;
      const found = shown.where && values[shown.where] < 0 ? NaN : values[shown.name] * factor;
      const least = typeof shown.least === "string" ? values[shown.least] : shown.least;
      const limit = least === null ? null : least * factor;
      put(meaning, told(shown.meaning));
      put(value, measured(found, shown.unit));
      put(bound, limit === null ? "" : word("least", { low: measured(limit, shown.unit, 4) }));
      row.classList.toggle("broken", limit !== null && !(found >= limit - 1e-9));
    }
  }

  /**
   * Where the point stands along an axis, and what comes after that.
   * @param {string} name
   * @param {number} value
   * @param {string} after
   */
  said(name, value, after) {
    lettered(this.verdict, parted(name));
    this.verdict.append(` = ${written(value, 4)}${after}`);
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
