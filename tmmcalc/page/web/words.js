// Texts in the language that is chosen, numbers and names as they are written in it.
import { content } from "./data.js";

const languages = Object.keys(content.languages);
let spoken = content.language;
/** @type {(() => void)[]} */
const listeners = [];
let kept = 0;

export function language() {
  return spoken;
}

/**
 * Choose a language: all that listens says its texts anew.
 * @param {string} chosen
 */
export function speak(chosen) {
  spoken = chosen;
  document.documentElement.lang = chosen;
  for (const each of listeners) each();
}

/**
 * Call now and whenever the language changes, until what is returned is called.
 * @param {() => void} say
 */
export function saying(say) {
  listeners.push(say);
  say();
  return () => {
    const at = listeners.indexOf(say);
    if (at >= 0) listeners.splice(at, 1);
  };
}

/** Listeners that are there stay for good: `forget` keeps them. */
export function remember() {
  kept = listeners.length;
}

/** Let go those that listen since, for what they told of is gone. */
export function forget() {
  listeners.length = kept;
}

/**
 * A text of the content in the language.
 * @param {import("./data.js").Said} text
 */
export function told(text) {
  return Array.isArray(text) ? text[languages.indexOf(spoken)] : text;
}

/**
 * What a text is known by, whatever language is spoken.
 * @param {import("./data.js").Said} text
 */
export function known(text) {
  return Array.isArray(text) ? text[0] : text;
}

/**
 * Whether texts say the same: those in several languages are lists, of which no two are one.
 * @param {import("./data.js").Said} one
 * @param {import("./data.js").Said} other
 */
export function same(one, other) {
  return known(one) === known(other);
}

/**
 * A text of the page itself, with values in its places.
 * @param {string} key
 * @param {Record<string, string>} values
 */
export function word(key, values = {}) {
  return told(content.words[key]).replace(/\{(\w+)\}/g, (_, name) => values[name] ?? "");
}

/**
 * A number with so many digits, no exponent where it is of usual size, a true minus, the decimal sign of the language.
 * @param {number} value
 */
export function written(value, digits = 6) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const usual = size === 0 || (size >= 1e-4 && size < 1e7);
  if (usual) return decimal(Number(value.toPrecision(digits)));
  const [mantissa, power] = value.toExponential(digits - 1).split("e");
  return `${decimal(Number(mantissa))}·10${raised(power)}`;
}

/**
 * A number with all its digits and a true minus.
 * @param {number} value
 */
export function decimal(value) {
  const shown = String(value).replace(/^-/, "−");
  return spoken === "en" ? shown : shown.replace(".", ",");
}

/** @param {string} power */
function raised(power) {
  const signs = { "-": "⁻", "+": "" };
  return [...power].map((sign) => signs[/** @type {"-"} */ (sign)] ?? "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)]).join("");
}

const DEGREES = "°";

/**
 * Whether a unit is that of angles.
 * @param {import("./data.js").Said} unit
 */
export function isAngle(unit) {
  return told(unit) === DEGREES;
}

/**
 * A number with its unit, or several with one: the sign of degrees stands at each. Nothing has no unit.
 * @param {number | number[]} value
 * @param {import("./data.js").Said} unit
 * @param {number} [digits]
 */
export function measured(value, unit, digits) {
  const all = [value].flat();
  const behind = isAngle(unit) ? DEGREES : "";
  const numbers = all.map((each) => written(each, digits) + (Number.isFinite(each) ? behind : "")).join("; ");
  return behind || !all.some(Number.isFinite) ? numbers : `${numbers} ${told(unit)}`.trim();
}

/** @type {Record<string, string>} */
const letters = { ...content.letters, angle: "φ" };

/**
 * A letter by its name, another name as it is.
 * @param {string} name
 */
function lettered(name) {
  return Object.hasOwn(letters, name) ? letters[name] : name;
}

/**
 * A name as it is set: its letter and its index, which may be the number after its letter.
 * @param {string} name
 * @returns {[string, string]}
 */
export function parted(name) {
  const [first, ...rest] = name.replaceAll(/[{}]/g, "").split("_");
  const numbered = /^([A-Za-z]+)(\d+)$/.exec(first);
  const known = numbered && lettered(numbered[1]).length === 1;
  const [letter, index] = known ? [numbered[1], [numbered[2], ...rest]] : [first, rest];
  const plain = letter.replaceAll("'", "");
  return [lettered(plain) + "′".repeat(letter.length - plain.length), index.map(lettered).join(", ")];
}

/**
 * Whether a name is one of programs, no letter with an index.
 * @param {string} name
 */
export function isCode(name) {
  return parted(name)[0].length > 2 || /[.[]/.test(name);
}
