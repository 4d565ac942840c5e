// Letters with their indices as SVG: as the program writes them, and how much room they take.
import { drawn } from "./marks.js";

const INDEX = 0.72; // of the size of a letter that its index has
const HALO = 1.5; // pixels around letters that hide what is behind them
const LOWER = 5; // pixels that an index stands below its letter, or above it
const [WIDTH, ABOVE, BELOW] = [0.58, 0.7, 0.22]; // of the size of a letter: its width, what is above its line and below

/**
 * A letter with its index, in an element of text, and what comes after it.
 * @param {Element} parent
 * @param {[string, string]} sign
 * @param {Record<string, string | number>} attributes
 */
export function named(parent, [letter, index], attributes = {}, after = "") {
  const found = texted(parent, index ? `${letter}_{${index}}` : letter, attributes);
  if (after) drawn("tspan", { dy: index ? -LOWER : 0 }, found).textContent = after;
  return found;
}

/**
 * A sign as the program writes it, with braces: `v_{BA}`, `a^{n}_{B_{2}A}`.
 * @param {Element} parent
 * @param {string} sign
 * @param {Record<string, string | number>} attributes
 */
export function texted(parent, sign, attributes = {}) {
  const found = drawn("text", attributes, parent);
  let level = 0;
  /** @param {string} text @param {number} wanted */
  const put = (text, wanted) => {
    if (!text) return;
    const apart = wanted < level ? HALO : 0; // what comes after an index hides nothing of it
    const size = wanted ? `${100 * INDEX}%` : "100%";
    const part = drawn("tspan", { "font-size": size, dx: apart, dy: (wanted - level) * LOWER }, found);
    part.textContent = text;
    level = wanted;
  };
  /** @param {string} text @param {number} wanted */
  const read = (text, wanted) => {
    let rest = text;
    while (rest) {
      const cut = rest.search(/[_^]/);
      if (cut < 0) return put(rest.replaceAll(/[{}]/g, ""), wanted);
      put(rest.slice(0, cut).replaceAll(/[{}]/g, ""), wanted);
      const lower = rest[cut] === "_";
      const [inner, after] = braced(rest.slice(cut + 1));
      read(inner, wanted + (lower ? 1 : -1));
      rest = after;
    }
  };
  read(sign, 0);
  return found;
}

/**
 * About how large a sign is in pixels, and how far its line is below its middle.
 * @param {string} sign as `texted` has it
 * @param {number} font
 * @returns {{size: [number, number], drop: number}}
 */
export function sized(sign, font) {
  const [letter, ...index] = sign.replaceAll(", ", ",").split(/[_^]/);
  const small = INDEX * font;
  const wide = WIDTH * (font * letter.length + small * index.join("").replaceAll(/[{}]/g, "").length);
  const up = Math.max(ABOVE * font, sign.includes("^") ? LOWER + ABOVE * small : 0);
  const deep = /_\{[^}]*_/.test(sign) ? 2 : sign.includes("_") ? 1 : 0; // an index may have one
  const down = Math.max(BELOW * font, deep ? deep * LOWER + BELOW * small : 0);
  return { size: [wide, up + down], drop: (up - down) / 2 };
}

/**
 * What stands in braces at the beginning, or the first letter, and what comes after it.
 * @param {string} text
 * @returns {[string, string]}
 */
function braced(text) {
  if (text[0] !== "{") return [text.slice(0, 1), text.slice(1)];
  let depth = 0;
  for (let k = 0; k < text.length; k++) {
    depth += text[k] === "{" ? 1 : text[k] === "}" ? -1 : 0;
    if (!depth) return [text.slice(1, k), text.slice(k + 1)];
  }
  return [text.slice(1), ""];
}
