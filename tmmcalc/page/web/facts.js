// Results of the stages in tables: found by a word, copied, each with its diagram; warnings, errors, the given data.
import { content, scene } from "./data.js";
import { button, copied, folding, lettered, made } from "./elements.js";
import { keep, kept } from "./kept.js";
import { isCode, measured, parted, saying, told, word, written } from "./words.js";

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
  const nothing = made("p", { class: "nothing", hidden: "" }, parent);
  saying(() => (nothing.textContent = word("none")));
  if (scene().given.length) given(parent);
  for (const stage of scene().stages) {
    const { part, fold } = folding(parent, "stage", stage.name, () => told(stage.title));
    part.dataset.stage = stage.name;
    parts.push({ part, unfold: () => fold(scene().stages.length <= FEW || stage.warnings.length > 0) });
    for (const warning of stage.warnings) {
      const line = made("p", { class: "warning" }, part);
      saying(() => (line.textContent = told(warning)));
    }
    if (stage.facts.length) {
      const table = made("table", {}, part);
      header(table, ["quantity", "designation", "value"]);
      const body = made("tbody", {}, table);
      for (const fact of stage.facts) {
        const row = made("tr", { "data-fact": `${stage.name}.${fact.name}` }, body);
        listed(row, fact, () => columnFor(stage, fact.name), show);
        rows.push({ row, part, text: () => `${fact.name} ${told(fact.meaning)} ${typeof fact.value === "number" ? "" : valued(fact)} ${told(stage.title)}`.toLowerCase() });
      }
    }
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

/** @param {import("./data.js").Fact} fact */
function valued({ value, unit }) {
  if (typeof value === "boolean") return word(value ? "holds" : "fails");
  return typeof value === "number" ? measured(value, unit) : told(value);
}

/**
 * The column that a fact is an extreme of, or belongs to: whose name begins it.
 * @param {import("./data.js").Stage} stage
 * @param {string} name
 */
function columnFor(stage, name) {
  const found = stage.columns.filter((each) => name === each.name || name.startsWith(`${each.name}_`));
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
