// The page put together: what moves with its player and layers, diagrams, results.
import { Charts } from "./charts.js";
import { content } from "./data.js";
import { facts } from "./facts.js";
import { Plans } from "./plans.js";
import { button, made, Player } from "./player.js";
import { readings } from "./readings.js";
import { Scene } from "./scene.js";
import { State } from "./state.js";
import { language, saying, speak, told, word } from "./words.js";

const SHOWN = ["paths", "numbers", "names", "masses", "centres"];
const HIDDEN = new Set(["centres", "acceleration", "reaction"]);

const title = /** @type {HTMLElement} */ (document.getElementById("title"));
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
title.textContent = content.title;
tools(/** @type {HTMLElement} */ (document.getElementById("tools")));

const states = content.views.map((view) => new State(view));
const left = states.length ? made("div", { class: "moving" }, main) : null;
states.forEach((state) => left && moved(left, state));

const right = made("div", { class: "read" }, main);
const diagrams = made("section", { class: "diagrams" }, right);
heading(diagrams, () => word("diagrams"));
const charts = new Charts(diagrams, states);
for (const name of content.views.flatMap((view) => view.shown)) charts.add(name);
if (!states.length) {
  for (const stage of content.stages) if (stage.columns.length) charts.add(`${stage.name}.${stage.columns[0].name}`);
}
const results = made("section", { class: "results" }, right);
heading(results, () => word("facts"));
facts(results, (column) => charts.add(column));

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
  const stage = made("div", { class: "stage" }, section);
  const scene = new Scene(stage, state);
  const player = new Player(section, state, scene.svg);
  scene.svg.addEventListener("pointerdown", () => player.play(false));
  readings(section, state);
  const layers = made("fieldset", { class: "layers" }, section);
  const legend = made("legend", {}, layers);
  saying(() => (legend.textContent = word("show")));
  const known = SHOWN.filter((name) => shown(state.view, name));
  for (const name of known) tick(layers, scene, name, () => word(name));
  for (const layer of scene.layers) {
    tick(layers, scene, layer.layer.name, () => `${told(layer.layer.title)} (${scene.scaleOf(layer)})`, layer.colour);
  }
  if (state.view.plans.length) new Plans(section, state);
}

/**
 * Whether a view has what may be shown or hidden by this name.
 * @param {import("./data.js").View} view
 * @param {string} name
 */
function shown(view, name) {
  const has = {
    paths: view.spots.some((spot) => spot.path),
    numbers: view.bodies.some((body) => body.number),
    names: view.spots.some((spot) => spot.kind !== "mass"),
    masses: view.spots.some((spot) => spot.kind === "mass"),
    centres: view.centres.length > 0,
  };
  return has[/** @type {keyof typeof has} */ (name)];
}

/**
 * @param {Element} parent
 * @param {Scene} scene
 * @param {string} name
 * @param {() => string} says
 * @param {string} [colour]
 */
function tick(parent, scene, name, says, colour) {
  const label = made("label", colour ? { class: colour } : {}, parent);
  const box = made("input", { type: "checkbox", name }, label);
  const said = made("span", {}, label);
  saying(() => (said.textContent = says()));
  box.checked = !HIDDEN.has(name);
  scene.show(name, box.checked);
  box.addEventListener("change", () => scene.show(name, box.checked));
}

/** @param {Element} parent */
function tools(parent) {
  const label = made("label", {}, parent);
  const said = made("span", { class: "unseen" }, label);
  saying(() => (said.textContent = word("language")));
  const choice = made("select", { name: "language" }, label);
  for (const [key, name] of Object.entries(content.languages)) {
    made("option", { value: key, lang: key }, choice).textContent = key === "uk" ? "Українська" : name;
  }
  choice.value = language();
  choice.addEventListener("change", () => speak(choice.value));
  button(parent, "theme", () => word("theme"), () => {
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const root = document.documentElement;
    const now = root.dataset.theme ?? (dark ? "dark" : "light");
    root.dataset.theme = now === "dark" ? "light" : "dark";
  });
  button(parent, "print", () => word("print"), () => print());
}
