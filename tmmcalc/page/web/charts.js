// Diagrams of columns over the rows of their stage, with the place of the input, extremes and dead centres.
import { columnOf, content, numbers, scene } from "./data.js";
import { between } from "./motion.js";
import { named } from "./letters.js";
import { drawn } from "./marks.js";
import { called, copied, lettered, made, resized, signed, WIDE, widthIn } from "./elements.js";
import { keep, kept } from "./kept.js";
import { keyed, turning } from "./keys.js";
import { around, settled } from "./labels.js";
import { standard } from "./scales.js";
import { State } from "./state.js";
import { isAngle, measured, parted, same, saying, told, word, written } from "./words.js";

const HIGH = 198;
const LEFT = 62; // at least
const DIGIT = 7.7; // width of a figure of an axis, in a wide font
const RIGHT = 14;
const TOP = 12;
const BOTTOM = 34;
const MANY = 200; // rows, of which neighbours lie so near
const END = 1e-5; // of the axis: what is beyond the rows by less is at their end
const STEEP = 0.2; // that a step of this part of the height is a jump

export class Charts {
  /**
   * @param {HTMLElement} parent
   * @param {import("./state.js").State[]} states
   * @param {string[]} usual columns, of which diagrams are shown where none are chosen, or this variant has none of these
   */
  constructor(parent, states, usual) {
    this.states = states;
    /** @type {Map<string, State>} */
    this.own = new Map();
    this.parent = parent;
    const bar = made("div", { class: "adding" }, parent);
    const label = made("label", {}, bar);
    const said = made("span", {}, label);
    saying(() => (said.textContent = word("add")));
    this.choice = made("select", {}, label);
    saying(() => this.choices());
    this.choice.addEventListener("change", () => {
      if (this.choice.value) this.add(this.choice.value);
      this.choice.value = "";
    });
    parent.hidden = !columned().length; // nothing can be added
    this.list = made("div", { class: "charts" }, parent);
    /** @type {Map<string, Chart>} */
    this.shown = new Map();
    const wished = kept("columns", usual);
    const own = wished.filter((name) => columnOf(name)?.stage.rows);
    this.lacking = wished.filter((name) => !own.includes(name));
    for (const name of wished.length && !own.length ? usual : own) this.show(name);
  }

  /** All columns, by stage. */
  choices() {
    this.choice.replaceChildren(made("option", { value: "" }));
    for (const stage of columned()) {
      const group = made("optgroup", { label: told(stage.title) }, this.choice);
      for (const column of stage.columns) {
        const meaning = told(column.meaning);
        const option = made("option", { value: `${stage.name}.${column.name}` }, group);
        option.textContent = meaning ? `${column.name}: ${meaning}` : column.name;
      }
    }
  }

  /** What is shown now was chosen; so was what this variant lacks and another one has. */
  chosen() {
    keep("columns", [...this.lacking, ...this.shown.keys()]);
  }

  /**
   * Bring the diagram of a column into sight, be it there already or not.
   * @param {string} name
   */
  add(name) {
    if (!this.shown.has(name)) {
      this.show(name);
      this.chosen();
    }
    this.shown.get(name)?.card.scrollIntoView({ block: "nearest" });
  }

  /**
   * The place along rows that nothing moves along: one for all diagrams of a stage, kept as a hand leaves it for the
   * other variants. A list has none.
   * @param {import("./data.js").Stage} stage
   */
  along({ name, rows }) {
    if (!rows?.header) return null;
    const known = this.own.get(name);
    if (known) return known;
    const own = new State(bare(rows));
    const place = `place ${name} ${rows.header}`;
    own.move(kept(place, own.at));
    const put = own.at; // it may be nearer than what was wished, which stays wished for others
    let moved = false;
    own.follow((at) => {
      moved ||= at !== put;
      if (moved) keep(place, at);
    });
    this.own.set(name, own);
    return own;
  }

  /** @param {string} name */
  show(name) {
    const found = columnOf(name);
    if (!found?.stage.rows) return;
    const header = found.stage.rows.header;
    const { name: stage, room } = found.stage;
    const known = this.states.filter(
      ({ view }) => header && view.column === header && (!view.stages.length || view.stages.includes(stage)),
    );
    const state = known.find(({ view }) => view.room === room) ?? known[0] ?? this.along(found.stage);
    const gone = () => {
      this.shown.delete(name);
      this.chosen();
    };
    this.shown.set(name, new Chart(this.list, name, found, state, gone));
  }
}

/**
 * A view of rows that no machine moves along.
 * @param {NonNullable<import("./data.js").Stage["rows"]>} rows
 */
function bare({ name, unit, values }) {
  const view = { name: "", symbol: name, unit, values, whole: false, column: "", steps: [], stops: [], reach: [], nudge: null };
  return /** @type {import("./data.js").View} */ (/** @type {unknown} */ (view));
}

class Chart {
  wide = WIDE;
  left = LEFT;
  step = 1; // between the lines of the grid
  low = 0;
  high = 1;
  start = 0;
  end = 1;

  /**
   * @param {Element} parent
   * @param {string} name
   * @param {NonNullable<ReturnType<typeof columnOf>>} found
   * @param {import("./state.js").State | null} state
   * @param {() => void} gone
   */
  constructor(parent, name, { stage, column }, state, gone) {
    this.column = column;
    this.rows = /** @type {NonNullable<import("./data.js").Stage["rows"]>} */ (stage.rows);
    this.state = state;
    this.x = numbers(this.rows.values);
    this.y = cleared(numbers(column.values));
    this.card = made("figure", { class: this.rows.header ? "chart" : "chart list", "data-column": name }, parent);
    this.caption = made("figcaption", {}, this.card);
    this.name = made("strong", {}, this.caption);
    this.value = made("button", { type: "button", class: "value" }, this.caption);
    this.where = made("span", { class: "where" }, this.caption);
    this.meaning = made("span", { class: "meaning" }, this.caption);
    this.svg = drawn("svg", state ? { role: "slider", tabindex: 0 } : { role: "img" }, this.card);
    this.others = content.scenes.filter((each) => each !== scene()).flatMap((each) => {
      const found = columnOf(name, each);
      if (!found?.stage.rows || !alike(this.rows, found.stage.rows) || !same(column.unit, found.column.unit)) return [];
      return [{ name: each.name, x: numbers(found.stage.rows.values), y: cleared(numbers(found.column.values)) }];
    });
    this.scaled();
    this.value.addEventListener("click", () => copied(this.value));
    this.close = signed(this.caption, "close", () => {
      this.leave();
      gone();
    });
    this.close.classList.add("close");
    this.silent = saying(() => this.draw());
    resized(this.card, () => this.draw());
    if (state) {
      this.cursor = drawn("line", { class: "cursor", y1: TOP, y2: HIGH - BOTTOM }, this.svg);
      this.dot = drawn("circle", { class: "dot", r: 4 }, this.svg);
      this.following = () => this.follow();
      state.follow(this.following);
      keyed(this.svg, turning(state));
      /** @param {Event} event */
      const turn = (event) => this.turn(/** @type {PointerEvent} */ (event));
      this.svg.addEventListener("pointerdown", turn);
      this.svg.addEventListener("pointermove", (event) => {
        if (/** @type {PointerEvent} */ (event).buttons) turn(event);
      });
    }
  }

  /** Ends of both axes. */
  scaled() {
    let [least, greatest] = [Infinity, -Infinity];
    for (const y of [this.y, ...this.others.map((each) => each.y)]) {
      for (const value of y) {
        if (value < least) least = value;
        if (value > greatest) greatest = value;
      }
    }
    if (least > greatest) [least, greatest] = [0, 0];
    const flat = greatest - least <= 1e-9 * Math.max(Math.abs(least), Math.abs(greatest));
    if (flat) [least, greatest] = [least - (Math.abs(least) || 1), greatest + (Math.abs(greatest) || 1)];
    else if (least > 0 && least < 0.4 * greatest) least = 0;
    else if (greatest < 0 && greatest > 0.4 * least) greatest = 0;
    const step = standard((greatest - least) / 4.5);
    this.step = step;
    this.low = Math.floor(least / step + 1e-9) * step;
    this.high = Math.ceil(greatest / step - 1e-9) * step;
    const all = [this.x, ...this.others.map((each) => each.x)].flatMap((x) => [x[0], x[x.length - 1]]);
    this.start = Math.min(...all);
    this.end = Math.max(...all);
    if (this.end === this.start) this.end += 1;
  }

  /** @param {number} x */
  across(x) {
    return this.left + ((x - this.start) / (this.end - this.start || 1)) * (this.wide - this.left - RIGHT);
  }

  /** @param {number} y */
  up(y) {
    return HIGH - BOTTOM - ((y - this.low) / (this.high - this.low || 1)) * (HIGH - TOP - BOTTOM);
  }

  /** Go, and listen to nothing any more. */
  leave() {
    this.silent?.();
    if (this.following) this.state?.leave(this.following);
    this.card.remove();
  }

  /** Axes, curve, extremes, dead centres, in the language. */
  draw() {
    this.name.replaceChildren();
    lettered(this.name, parted(this.column.name));
    const measure = told(this.column.unit);
    if (!this.state && measure) made("span", { class: "unit" }, this.name).textContent = `, ${measure}`; // no value has it
    const { kept, of } = this.rows;
    const part = kept < of ? ` (${word("kept", { kept: String(kept), of: String(of) })})` : "";
    this.meaning.textContent = told(this.column.meaning) + part;
    this.svg.setAttribute("aria-label", `${this.column.name}: ${told(this.column.meaning)}`);
    this.value.title = word("copy");
    called(this.close, word("remove"));
    this.wide = widthIn(this.card);
    this.svg.setAttribute("viewBox", `0 0 ${this.wide} ${HIGH}`);
    this.back?.remove();
    const back = drawn("g");
    this.back = back;
    this.svg.prepend(back);
    const grid = drawn("g", { class: "grid" }, back);
    const digits = 3;
    const [first, last] = [this.low, this.high].map((end) => Math.round(end / this.step));
    const steps = Array.from({ length: last - first + 1 }, (_, k) => ({ k: first + k, text: written((first + k) * this.step, digits) }));
    this.left = Math.max(LEFT, ...steps.map(({ text }) => DIGIT * text.length + 8));
    for (const { k, text } of steps) {
      const y = this.up(k * this.step);
      drawn("line", { x1: this.left, x2: this.wide - RIGHT, y1: y, y2: y, class: k === 0 ? "zero" : "" }, grid);
      drawn("text", { x: this.left - 6, y: y + 4, "text-anchor": "end" }, grid).textContent = text;
    }
    const along = isAngle(this.rows.unit) && this.end - this.start > 200 ? 60 : standard((this.end - this.start) / 6);
    for (let k = Math.ceil(this.start / along - 1e-6); k * along <= this.end + 1e-6 * along; k++) {
      const x = this.across(k * along);
      drawn("line", { x1: x, x2: x, y1: TOP, y2: HIGH - BOTTOM }, grid);
      const text = written(k * along, digits);
      const room = Math.min(x, this.wide - (DIGIT * text.length) / 2 - 1); // it is seen whole
      drawn("text", { x: room, y: HIGH - BOTTOM + 15, "text-anchor": "middle" }, grid).textContent = text;
    }
    const unit = told(this.rows.unit);
    /** @type {[string, string]} */
    const over = this.state?.view.name ? [this.state.view.symbol, ""] : parted(this.rows.name);
    const place = { x: this.wide - RIGHT, y: HIGH - 6, "text-anchor": "end", class: "axis" };
    named(grid, over, place, unit ? `, ${unit}` : "");
    if (this.state) {
      for (const stop of this.state.view.stops.filter((each) => each.at >= this.start && each.at <= this.end)) {
        const x = this.across(stop.at);
        const line = drawn("line", { x1: x, x2: x, y1: TOP, y2: HIGH - BOTTOM, class: "stop" }, back);
        drawn("title", {}, line).textContent = told(stop.title);
      }
    }
    this.others.forEach((other) => {
      const curve = drawn("path", { class: "curve other", d: this.path(other.x, other.y) }, back);
      drawn("title", {}, curve).textContent = told(other.name);
    });
    drawn("path", { class: "curve", d: this.path(this.x, this.y) }, back);
    if (this.rows.header) drawn("path", { class: "curve jump", d: this.jumps() }, back);
    this.extremes(back);
    if (!this.state) {
      this.value.hidden = true;
      return;
    }
    this.svg.setAttribute("aria-valuemin", String(this.start));
    this.svg.setAttribute("aria-valuemax", String(this.end));
    this.follow();
  }

  /**
   * A curve; two rows at one place are a jump.
   * @param {Float32Array} x
   * @param {Float32Array} y
   */
  path(x, y) {
    if (!this.rows.header) return this.points(x, y);
    let d = "";
    let pen = false;
    for (let k = 0; k < x.length; k++) {
      if (!Number.isFinite(y[k])) {
        pen = false;
        continue;
      }
      const jump = k > 0 && this.jumped(x, y, k);
      d += `${pen && !jump ? "L" : "M"}${this.across(x[k]).toFixed(1)},${this.up(y[k]).toFixed(1)}`;
      pen = true;
    }
    return d;
  }

  /**
   * The values of a list, which no curve joins, as dots.
   * @param {Float32Array} x
   * @param {Float32Array} y
   */
  points(x, y) {
    let d = "";
    for (let k = 0; k < x.length; k++) {
      if (Number.isFinite(y[k])) d += `M${this.across(x[k]).toFixed(1)},${this.up(y[k]).toFixed(1)}h0`;
    }
    return d;
  }

  /**
   * Whether a curve jumps before a row: two rows at one place, or between neighbours of many a large part of its height.
   * @param {Float32Array} x
   * @param {Float32Array} y
   * @param {number} k
   */
  jumped(x, y, k) {
    return x[k] === x[k - 1] || (x.length > MANY && Math.abs(y[k] - y[k - 1]) > STEEP * (this.high - this.low));
  }

  /** The jumps as lines of their own. */
  jumps() {
    let d = "";
    for (let k = 1; k < this.x.length; k++) {
      if (!this.jumped(this.x, this.y, k) || !Number.isFinite(this.y[k - 1] + this.y[k])) continue;
      const ends = [k - 1, k].map((j) => `${this.across(this.x[j]).toFixed(1)},${this.up(this.y[j]).toFixed(1)}`);
      d += `M${ends.join("L")}`;
    }
    return d;
  }

  /** @param {Element} back */
  extremes(back) {
    let [least, greatest] = [-1, -1];
    this.y.forEach((y, k) => {
      if (!Number.isFinite(y)) return;
      if (least < 0 || y < this.y[least]) least = k;
      if (greatest < 0 || y > this.y[greatest]) greatest = k;
    });
    if (least < 0 || this.y[greatest] - this.y[least] <= 1e-9 * Math.abs(this.y[greatest])) return;
    const ends = /** @type {[string, number][]} */ ([["lowest", least], ["highest", greatest]]).map(([key, k]) => {
      const at = /** @type {import("./labels.js").Pair} */ ([this.across(this.x[k]), this.up(this.y[k])]);
      const text = written(this.y[k], 4);
      /** @type {import("./labels.js").Pair} */
      const size = [DIGIT * text.length, 12];
      const choices = around(...size).filter(([x, y]) => this.within(at[0] + x, at[1] + y, size));
      return { key, k, at, text, size, choices };
    });
    const shifts = settled(ends.map(({ at, size, choices }) => ({ at: [at], size, choices })), [this.lines()]);
    ends.forEach(({ key, k, at: [x, y], text }, place) => {
      const mark = drawn("circle", { class: "extreme", cx: x, cy: y, r: 3 }, back);
      drawn("title", {}, mark).textContent = `${word(key)}: ${measured(this.y[k], this.column.unit)}`;
      const [dx, dy] = shifts[place];
      drawn("text", { class: "extreme", x: x + dx, y: y + dy + 4, "text-anchor": "middle" }, back).textContent = text;
    });
  }

  /**
   * Whether a text around a place stands within the diagram.
   * @param {number} x
   * @param {number} y
   * @param {import("./labels.js").Pair} size
   */
  within(x, y, [wide, high]) {
    const across = x - wide / 2 > this.left && x + wide / 2 < this.wide;
    return across && y - high / 2 > 0 && y + high / 2 < HIGH - BOTTOM;
  }

  /**
   * What values of extremes keep off: the curve, the ends of the plane, dead centres.
   * @returns {[number, number, number, number][]}
   */
  lines() {
    /** @type {[number, number, number, number][]} */
    const found = [];
    for (let k = 1; k < this.x.length; k++) {
      const ends = [k - 1, k].flatMap((j) => [this.across(this.x[j]), this.up(this.y[j])]);
      if (ends.every(Number.isFinite)) found.push(/** @type {[number, number, number, number]} */ (ends));
    }
    for (const { at } of this.state?.view.stops ?? []) found.push([this.across(at), TOP, this.across(at), HIGH - BOTTOM]);
    return found;
  }

  /** The cursor and the value at the nearest solved position. */
  follow() {
    if (!this.state || !this.cursor || !this.dot) return;
    const { at } = this.state;
    const k = between(this.x, at).near;
    const x = this.across(at);
    this.cursor.setAttribute("x1", String(x));
    this.cursor.setAttribute("x2", String(x));
    const ends = [this.x[0], this.x[this.x.length - 1]];
    const small = END * (this.end - this.start);
    const beyond = at > Math.max(...ends) + small || at < Math.min(...ends) - small;
    this.cursor.classList.toggle("lost", beyond);
    const value = beyond ? NaN : this.y[k];
    const known = Number.isFinite(value);
    this.dot.classList.toggle("lost", !known);
    if (known) {
      this.dot.setAttribute("cx", String(this.across(this.x[k])));
      this.dot.setAttribute("cy", String(this.up(this.y[k])));
    }
    this.value.textContent = measured(value, this.column.unit);
    if (!this.state.view.name) {
      this.where.replaceChildren(); // no player tells it
      lettered(this.where, parted(this.rows.name));
      this.where.append(` = ${measured(at, this.rows.unit, 4)}`);
    }
    this.svg.setAttribute("aria-valuenow", String(at));
    this.svg.setAttribute("aria-valuetext", `${measured(at, this.state.view.unit, 5)}: ${this.value.textContent}`);
  }

  /** @param {PointerEvent} event */
  turn(event) {
    const box = this.svg.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * this.wide;
    const part = (x - this.left) / (this.wide - this.left - RIGHT);
    if (part > -0.05 && part < 1.05) this.state?.take(this.start + Math.min(1, Math.max(0, part)) * (this.end - this.start));
  }
}

/** The stages that have diagrams. */
function columned() {
  return scene().stages.filter((each) => each.columns.length && each.rows);
}

/**
 * Values without what rounding leaves of nothing.
 * @param {Float32Array} values
 */
function cleared(values) {
  const largest = values.reduce((size, value) => Math.max(size, Math.abs(value) || 0), 0);
  return values.map((value) => (Math.abs(value) < 1e-12 * largest ? 0 : value));
}

/**
 * Whether rows are over the same, in the same unit.
 * @param {NonNullable<import("./data.js").Stage["rows"]>} one
 * @param {NonNullable<import("./data.js").Stage["rows"]>} other
 */
function alike(one, other) {
  return one.header === other.header && one.name === other.name && same(one.unit, other.unit);
}
