// The page put together: what moves with its player and layers, diagrams, results.
import { Charts } from "./charts.js";
import { choose, content, numbers, scene } from "./data.js";
import { button, made } from "./elements.js";
import { Drawing } from "./drawing.js";
import { facts } from "./facts.js";
import { MANY, others } from "./ghosts.js";
import { keep, kept } from "./kept.js";
import { Plans } from "./plans.js";
import { Player } from "./player.js";
import { readings } from "./readings.js";
import { coupled, halt, State } from "./state.js";
import { Plane } from "./trials.js";
import { forget, known, language, remember, saying, speak, told, word } from "./words.js";

const FIRST = 4; // diagrams of a scene that asks for none
const AIR = 16; // pixels above and below what stays in sight
const ROWS = 8; // of a table that is a curve and no list
const NUMBER = "i"; // of a row
const BENT = 1e-3; // of its greatest value: what a curve differs from a straight line by
const NOTHING = 1e-12;

const title = /** @type {HTMLElement} */ (document.getElementById("title"));
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
const system = matchMedia("(prefers-color-scheme: dark)");
title.textContent = content.title;
lit();
tools(/** @type {HTMLElement} */ (document.getElementById("tools")));
const choice = content.scenes.length > 1 ? variants() : null;
/** @type {Map<State, number>} */
const states = new Map(); // those that are shown, with the place where each was put

/** What moves stays in sight beside what is read: all of it where the window has room, else its end. */
const beside = () => {
  const left = /** @type {HTMLElement | null} */ (main.querySelector(".moving"));
  if (left) left.style.top = `${Math.min(AIR, innerHeight - left.offsetHeight - AIR)}px`;
};
const sized = new ResizeObserver(beside);
addEventListener("resize", beside);

printed();
remember();
shown();

/** What is folded is printed all the same: data, results; not the spec. */
function printed() {
  /** @type {HTMLDetailsElement[]} */
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details")].filter((each) => !each.open && !each.matches(".source, .plans"));
    for (const each of opened) each.open = true;
  });
  addEventListener("afterprint", () => {
    for (const each of opened) each.open = false;
  });
}

/** Show the variant that is chosen, with what the hand has chosen in others: only the slider stays itself. */
function shown() {
  halt();
  for (const [state, put] of states) if (state.at !== put) keep(placeOf(state.view), state.at);
  forget();
  main.style.minHeight = `${main.offsetHeight}px`; // the window stays where it is
  while (main.lastElementChild && main.lastElementChild !== choice) main.lastElementChild.remove();
  states.clear();
  const { views, trials, stages } = scene();
  const left = views.length || trials.length ? made("div", { class: "moving" }, main) : null;
  sized.disconnect();
  if (left) sized.observe(left);
  for (const view of views) {
    const state = new State(view);
    if (left) moved(left, state);
    state.move(kept(placeOf(view), state.at));
    states.set(state, state.at);
  }
  coupled([...states.keys()]);
  for (const state of states.keys()) states.set(state, state.at);
  for (const trial of trials) if (left) new Plane(left, trial);
  const right = made("div", { class: "read" }, main);
  const diagrams = made("section", { class: "diagrams" }, right);
  heading(diagrams, () => word("diagrams"));
  const telling = new Set(stages.filter((stage) => stage.facts.length).map((stage) => stage.name)); // others only draw
  const ordered = stages.filter(
    ({ name, rows }) => rows?.header && rows.name !== NUMBER && rows.of >= ROWS && telling.has(name.split("/")[0]),
  );
  const first = ordered.flatMap((stage) => {
    const along = stage.rows ? numbers(stage.rows.values) : new Float32Array();
    const column = stage.columns.find(({ values }) => curved(along, numbers(values)));
    return column ? [`${stage.name}.${column.name}`] : [];
  });
  const wished = views.flatMap((view) => view.shown);
  const charts = new Charts(diagrams, [...states.keys()], wished.length ? wished : first.slice(0, FIRST));
  const results = made("section", { class: "results" }, right);
  heading(results, () => word("facts"));
  facts(results, (column) => charts.add(column));
  main.style.minHeight = "";
}

/**
 * Whether values go along a curve: a straight line tells little, what rounding leaves of nothing tells nothing.
 * @param {Float32Array} x
 * @param {Float32Array} y
 */
function curved(x, y) {
  const last = x.length - 1;
  const most = y.reduce((size, value) => Math.max(size, Math.abs(value) || 0), 0);
  const slope = (y[last] - y[0]) / (x[last] - x[0]);
  return most > NOTHING && y.some((value, k) => Math.abs(value - y[0] - slope * (x[k] - x[0])) > BENT * most);
}

/**
 * What the place of a view is kept by: views of this name over the same are put there, as ghosts are.
 * @param {import("./data.js").View} view
 */
function placeOf({ room, name, unit }) {
  return `place ${room} ${name} ${known(unit)}`;
}

/** A slider over the variants; it stays while all else is made anew, for a hand holds it. */
function variants() {
  const section = made("section", { class: "variants" }, main);
  const label = made("label", {}, section);
  const said = made("span", {}, label);
  const slider = made("input", { type: "range", min: "0", max: String(content.scenes.length - 1), step: "1" }, label);
  slider.value = String(content.scenes.indexOf(scene()));
  const tell = () => {
    const name = told(scene().name);
    said.textContent = `${content.key || word("variant")}: ${name}`;
    slider.setAttribute("aria-valuetext", name);
  };
  saying(tell);
  slider.addEventListener("input", () => {
    const k = Number(slider.value);
    if (content.scenes[k] === scene()) return;
    choose(k);
    tell();
    shown();
  });
  return section;
}

/**
 * @param {Element} parent
 * @param {() => string} says
 */
function heading(parent, says) {
  const found = made("h2", {}, parent);
  saying(() => (found.textContent = says()));
}

/**
 * A scene with its player and what can be shown of it.
 * @param {Element} parent
 * @param {State} state
 */
function moved(parent, state) {
  const section = made("section", { class: "view", "data-view": state.view.name }, parent);
  heading(section, () => told(state.view.title));
  const note = made("p", { class: "drawn" }, section);
  saying(() => (note.textContent = told(state.view.note)));
  note.hidden = !state.view.note;
  const stage = made("div", { class: "stage" }, section);
  const drawing = new Drawing(stage, state);
  new Player(section, state, stage);
  stage.addEventListener("pointerdown", halt);
  readings(section, state);
  const layers = made("fieldset", { class: "layers" }, section);
  const legend = made("legend", {}, layers);
  saying(() => (legend.textContent = word("show")));
  for (const [name, hidden] of offered(state.view)) drawing.tick(layers, name, () => word(name), { hidden });
  for (const { layer, colour } of drawing.scene.layers) {
    const scale = () => drawing.scene.layers.find((each) => each.layer === layer)?.scaled;
    drawing.tick(layers, layer.name, () => told(layer.title) + (scale() ? ` (${scale()})` : ""), { colour, hidden: layer.hidden });
  }
  layers.hidden = !layers.querySelector("label");
  if (state.view.plans.length) new Plans(section, state);
}

/**
 * What may be shown or hidden of a view beside its layers: its name, and whether it is hidden until it is asked for.
 * @param {import("./data.js").View} view
 * @returns {[string, boolean][]}
 */
function offered(view) {
  /** @type {[string, boolean, boolean][]} */
  const all = [
    ["paths", view.spots.some((spot) => spot.path), false],
    ["numbers", view.bodies.some((body) => body.number), false],
    ["names", view.spots.some((spot) => spot.name && spot.kind !== "mass"), false],
    ["masses", view.spots.some((spot) => spot.kind === "mass"), false],
    ["centres", view.centres.length > 0, true],
    ["ghosts", others(view).length > 0, content.scenes.length > MANY],
  ];
  return all.flatMap(([name, there, hidden]) => (there ? [[name, hidden]] : []));
}

/** Light or dark as the system is, until a button says otherwise. */
function lit() {
  system.onchange = lit;
  document.documentElement.dataset.theme = system.matches ? "dark" : "light";
}

/** @param {Element} parent */
function tools(parent) {
  const label = made("label", {}, parent);
  const said = made("span", { class: "unseen" }, label);
  saying(() => (said.textContent = word("language")));
  const choice = made("select", { name: "language" }, label);
  for (const [key, name] of Object.entries(content.languages)) {
    made("option", { value: key, lang: key }, choice).textContent = name;
  }
  choice.value = language();
  choice.addEventListener("change", () => speak(choice.value));
  button(parent, "theme", () => word("theme"), () => {
    system.onchange = null;
    const { dataset } = document.documentElement;
    dataset.theme = dataset.theme === "dark" ? "light" : "dark";
  });
  button(parent, "print", () => word("print"), () => print());
}
