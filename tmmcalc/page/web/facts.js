// Results of the stages in tables: found by a word, copied, each with its diagram; warnings, errors, the given data.
import { content, scene } from "./data.js";
import { button, copied, folding, lettered, made } from "./elements.js";
import { keep, kept } from "./kept.js";
import { decimal, isCode, measured, parted, saying, told, word, written } from "./words.js";

const DIGITS = 5; // of numbers in the table of a summary
const NOTHING = 1e-12;
const FEW = 2; // stages, of which all are unfolded

/**
 * All results under a field to find some.
 * @param {Element} parent
 * @param {(column: string) => void} show the diagram of a column
 */
export function facts(parent, show) {
  const label = made("label", { class: "find" }, parent);
  const said = made("span", {}, label);
  const field = made("input", { type: "search" }, label);
  field.value = kept("search", "");
  saying(() => (said.textContent = word("find")));
  /** @type {{row: HTMLElement, text: () => string, part: HTMLDetailsElement}[]} */
  const rows = [];
  /** @type {{part: HTMLDetailsElement, unfold: () => void}[]} */
  const parts = [];
  /** @type {HTMLElement[]} */
  const lists = [];
  const nothing = made("p", { class: "nothing", hidden: "" }, parent);
  saying(() => (nothing.textContent = word("none")));
  if (scene().given.length) given(parent);
  const stages = scene().stages.filter((each) => each.facts.length || each.tables.length || each.warnings.length || each.errors.length);
  for (const stage of stages) {
    const { part, fold } = folding(parent, "stage", stage.name, () => told(stage.title));
    part.dataset.stage = stage.name;
    parts.push({ part, unfold: () => fold(stages.length <= FEW || stage.warnings.length > 0) });
    /** @param {HTMLElement} row @param {() => string} text what it is found by, beside the title of its stage */
    const sought = (row, text) => rows.push({ row, part, text: () => `${text()} ${told(stage.title)}`.toLowerCase() });
    for (const warning of stage.warnings) {
      const line = made("p", { class: "warning" }, part);
      saying(() => (line.textContent = told(warning)));
      sought(line, () => told(warning));
    }
    if (stage.facts.length) {
      const table = made("table", {}, part);
      header(table, ["quantity", "designation", "value"]);
      const body = made("tbody", {}, table);
      for (const fact of stage.facts) {
        const row = made("tr", { "data-fact": `${stage.name}.${fact.name}` }, body);
        listed(row, fact, () => columnFor(stage, fact), show);
        sought(row, () => `${fact.name} ${told(fact.meaning)} ${typeof fact.value === "number" ? "" : valued(fact)}`);
      }
    }
    for (const each of stage.tables) lists.push(listing(part, each, sought));
    const { errors } = stage;
    if (errors.length) {
      const line = made("p", { class: "errors" }, part);
      saying(() => (line.textContent = `${word("errors")}: ${errors.map(([name, value]) => `${told(name)} ${written(value, 2)}`).join("; ")}`));
    }
  }
  const search = () => {
    const asked = field.value.trim().toLowerCase();
    let found = 0;
    const open = new Set();
    for (const { row, part, text } of rows) {
      row.hidden = asked !== "" && !text().includes(asked);
      if (!row.hidden) {
        found += 1;
        open.add(part);
      }
    }
    for (const { part, unfold } of parts) {
      part.hidden = asked !== "" && !open.has(part);
      if (asked) part.open = open.has(part);
      else unfold();
    }
    for (const each of lists) each.hidden = !each.querySelector("tbody tr:not([hidden])");
    nothing.hidden = found > 0 || asked === "";
  };
  search();
  field.addEventListener("input", () => {
    keep("search", field.value);
    search();
  });
  source(parent);
}

/**
 * @param {HTMLTableElement} table
 * @param {string[]} keys
 */
function header(table, keys) {
  const row = made("tr", {}, made("thead", {}, table));
  for (const key of keys) {
    const cell = made("th", { scope: "col" }, row);
    saying(() => (cell.textContent = word(key)));
  }
}

/**
 * @param {HTMLElement} row
 * @param {import("./data.js").Fact} fact
 * @param {() => string | null} column
 * @param {(column: string) => void} show
 */
function listed(row, fact, column, show) {
  const meaning = made("td", {}, row);
  const sign = made("td", { class: "sign", title: fact.name }, row);
  const value = made("td", { class: "number" }, row);
  lettered(sign, isCode(fact.name) ? [fact.name, ""] : parted(fact.name));
  sign.classList.toggle("code", isCode(fact.name));
  const copy = made("button", { type: "button", class: "value" }, value);
  saying(() => {
    meaning.textContent = told(fact.meaning);
    copy.textContent = valued(fact);
    copy.title = word("copy");
  });
  copy.addEventListener("click", () => copied(copy));
  const name = column();
  if (name) {
    button(value, "curve", () => word("diagram"), () => show(name)).classList.add("show");
  }
}

/**
 * A table of a summary: what is told of several things side by side.
 * @param {HTMLElement} parent
 * @param {import("./data.js").List} list
 * @param {(row: HTMLElement, text: () => string) => void} sought what is told that a row can be found by a text
 */
function listing(parent, { title, columns }, sought) {
  const room = made("div", { class: "wide", tabindex: "0", role: "group" }, parent); // a narrow screen scrolls it
  const table = made("table", { class: "list" }, room);
  const caption = title ? made("caption", {}, table) : null;
  saying(() => {
    if (caption) caption.textContent = told(title);
    room.setAttribute("aria-label", told(title) || told(columns[0].name));
  });
  const heads = made("tr", {}, made("thead", {}, table));
  for (const { name, sign, unit } of columns) {
    const head = made("th", { scope: "col", class: sign ? "sign" : "" }, heads);
    saying(() => {
      head.replaceChildren();
      if (sign) lettered(head, parted(told(name)));
      else head.append(told(name));
      if (told(unit)) made("span", { class: "unit" }, head).textContent = `, ${told(unit)}`;
    });
  }
  const body = made("tbody", {}, table);
  columns[0].cells.forEach((_, k) => {
    const row = made("tr", {}, body);
    for (const { cells } of columns) {
      const largest = Math.max(...cells.map((each) => (typeof each === "number" ? Math.abs(each) : 0)));
      const cell = made("td", { class: typeof cells[k] === "number" ? "number" : "" }, row);
      saying(() => (cell.textContent = celled(cells[k], largest)));
    }
    sought(row, () => {
      const words = columns.map(({ cells }) => (typeof cells[k] === "number" ? "" : celled(cells[k], 0)));
      return [told(title), ...columns.map(({ name }) => told(name)), ...words].join(" ");
    });
  });
  return room;
}

/**
 * @param {number | boolean | import("./data.js").Said} value
 * @param {number} largest of its column: what rounding leaves of nothing against it is nothing
 */
function celled(value, largest) {
  return typeof value === "number" ? written(Math.abs(value) < NOTHING * largest ? 0 : value, DIGITS) : answered(value);
}

/** @param {import("./data.js").Fact} fact */
function valued({ value, unit }) {
  if (typeof value !== "number") return answered(value);
  return Number.isSafeInteger(value) && unit === "" ? decimal(value) : measured(value, unit); // a count has all digits
}

/** @param {boolean | import("./data.js").Said} value a truth value as a word, a text as it is */
function answered(value) {
  return typeof value === "boolean" ? word(value ? "holds" : "fails") : told(value);
}

/**
 * The column that a fact is an extreme of, or the place of one: whose name begins it, in the same unit.
 * @param {import("./data.js").Stage} stage
 * @param {import("./data.js").Fact} fact
 */
function columnFor(stage, { name, unit }) {
  const found = stage.columns.filter((each) => {
    const place = name.startsWith(`${each.name}_`) && /_at(_|$)/.test(name.slice(each.name.length));
    return place || ((name === each.name || name.startsWith(`${each.name}_`)) && told(each.unit) === told(unit));
  });
  found.sort((a, b) => b.name.length - a.name.length);
  return found.length ? `${stage.name}.${found[0].name}` : null;
}

/** @param {Element} parent */
function given(parent) {
  const { part, fold } = folding(parent, "given", "", () => word("given"));
  fold(false);
  const table = made("table", {}, part);
  header(table, ["quantity", "designation", "value"]);
  const body = made("tbody", {}, table);
  for (const datum of scene().given) {
    const row = made("tr", {}, body);
    const what = made("td", {}, row);
    const sign = made("td", { class: "sign" }, row);
    const value = made("td", { class: "number" }, row);
    datum.keys.forEach((key, k) => {
      if (k) sign.append(", ");
      lettered(sign, parted(key));
    });
    saying(() => {
      what.textContent = told(datum.what);
      value.textContent = told(datum.text) || measured(datum.values, datum.unit);
    });
  }
}

/** @param {Element} parent */
function source(parent) {
  const { part, fold } = folding(parent, "source", "", () => word("spec"));
  fold(false);
  made("pre", {}, part).textContent = scene().source;
  const line = made("p", { class: "errors" }, part);
  saying(() => (line.textContent = word("precision", { error: written(content.error, 2) })));
}
