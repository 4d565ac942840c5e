// Standard scales: of axes, of vectors to a centimetre of the screen.
import { measured, word } from "./words.js";

const CENTIMETRE = 37.8; // in pixels of a screen

/**
 * The next standard scale above a value: 1, 2, 5 by powers of ten.
 * @param {number} value
 */
export function standard(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((each) => each * power).find((each) => each >= value * (1 - 1e-9)) ?? value;
}

/**
 * The next standard scale above one, both in units to a pixel: so many to a centimetre.
 * @param {number} least
 */
export function perPixel(least) {
  return standard(least * CENTIMETRE) / CENTIMETRE;
}

/**
 * A scale in words.
 * @param {number} per units to a pixel
 * @param {import("./data.js").Said} unit
 */
export function scaleTold(per, unit) {
  return word("arrow", { value: measured(per * CENTIMETRE, unit, 3) });
}
