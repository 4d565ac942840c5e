// Elements of the page: made with their attributes, buttons that say what they do, icons.
import { keep, kept } from "./kept.js";
import { drawn } from "./marks.js";
import { saying } from "./words.js";

/**
 * An element of HTML with classes and attributes.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} name
 * @param {Record<string, string>} [attributes]
 * @param {Element} [parent]
 */
export function made(name, attributes = {}, parent) {
  const found = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) found.setAttribute(key, value);
  if (parent) parent.append(found);
  return found;
}

// drawn here, for no font has them everywhere
const ICONS = {
  play: "M6,3L18,11L6,19z",
  pause: "M5,3h4v16h-4zM13,3h4v16h-4z",
  back: "M16,4v14L7,11zM5,4h2v14h-2z",
  on: "M6,4v14L15,11zM15,4h2v14h-2z",
  close: "M5,6.5L6.5,5L11,9.5L15.5,5L17,6.5L12.5,11L17,15.5L15.5,17L11,12.5L6.5,17L5,15.5L9.5,11z",
  curve: "M3,3h1.6v14.4h14.4v1.6h-16zM6,14q3,-11 6,-5t7,-4l1.3,1.2q-5,8 -8.4,3.6t-4.3,4.6z",
  theme: "M11,2a9,9 0 1 0 0.01,0zM11,4.2v13.6a6.8,6.8 0 0 1 0,-13.6z",
  print: "M6,2h10v5h-10zM3,8h16v8h-3v4h-10v-4h-3zM7.6,13v5.4h6.8v-5.4z",
};

/** @param {keyof typeof ICONS} name */
export function icon(name) {
  const found = drawn("svg", { viewBox: "0 0 22 22", class: "icon", "aria-hidden": "true" });
  drawn("path", { d: ICONS[name], "fill-rule": "evenodd" }, found);
  return found;
}

/**
 * A button that says what it does, in each language.
 * @param {Element} parent
 * @param {keyof typeof ICONS} sign
 * @param {() => string} says
 * @param {() => void} act
 */
export function button(parent, sign, says, act) {
  const found = signed(parent, sign, act);
  saying(() => called(found, says()));
  return found;
}

/**
 * A button with a sign, that is not called anything yet.
 * @param {Element} parent
 * @param {keyof typeof ICONS} sign
 * @param {() => void} act
 */
export function signed(parent, sign, act) {
  const found = made("button", { type: "button" }, parent);
  found.append(icon(sign));
  found.addEventListener("click", act);
  return found;
}

/**
 * Say what a button with a sign does.
 * @param {HTMLElement} element
 * @param {string} name
 */
export function called(element, name) {
  element.title = name;
  element.setAttribute("aria-label", name);
}

/**
 * A part that can be folded; whether it is stays as the hand chose it.
 * @param {Element} parent
 * @param {string} name its class, and with `key` what its choice is kept by
 * @param {string} key
 * @param {() => string} says
 */
export function folding(parent, name, key, says) {
  const part = made("details", { class: name }, parent);
  const title = made("summary", {}, part);
  saying(() => (title.textContent = says()));
  const choice = `${name} ${key}`;
  title.addEventListener("click", () => keep(choice, !part.open)); // it is about to change
  /** @param {boolean} usual */
  const fold = (usual) => {
    part.open = kept(choice, usual);
  };
  return { part, fold };
}

/**
 * Put a letter with its index behind what an element says.
 * @param {Element} element
 * @param {[string, string]} sign
 */
export function lettered(element, [letter, index]) {
  element.append(letter);
  if (index) made("sub", {}, element).textContent = index;
}

/**
 * Copy what an element says.
 * @param {HTMLElement} element
 */
export function copied(element) {
  const text = element.textContent ?? "";
  const done = () => {
    element.classList.add("done");
    setTimeout(() => element.classList.remove("done"), 900);
  };
  if (navigator.clipboard) navigator.clipboard.writeText(text).then(done, () => selected(element));
  else selected(element);
}

/**
 * Where there is no clipboard the text is selected.
 * @param {HTMLElement} element
 */
function selected(element) {
  getSelection()?.selectAllChildren(element);
}

export const WIDE = 560; // of a diagram or a plan at most, in its own pixels
const OTHER = 1.1; // a width larger or smaller by this is another

/**
 * The width that a drawing in an element has in its own pixels: of a narrow one as many as it is shown with.
 * @param {Element} element
 */
export function widthIn(element) {
  return Math.min(WIDE, Math.max(280, element.clientWidth || WIDE));
}

/**
 * Call when an element has another width, or the window another height, until it is gone.
 * @param {Element} element
 * @param {() => void} act
 */
export function resized(element, act) {
  let known = [element.clientWidth, innerHeight];
  const look = new ResizeObserver(() => {
    if (!element.isConnected) return look.disconnect(); // another variant stands in its place
    const found = [element.clientWidth, innerHeight];
    if (!found[0] || found.every((side, k) => side < OTHER * known[k] && known[k] < OTHER * side)) return;
    known = found;
    act();
  });
  look.observe(element);
}
