// Numbers that go along with the input, in a table under the scene.
import { numbers } from "./data.js";
import { isThere, trackAt } from "./motion.js";
import { lettered, made } from "./elements.js";
import { measured, parted, saying, told } from "./words.js";

const DIGITS = 4;
const NOTHING = 1e-6; // of the greatest value: what rounding leaves of nothing

/**
 * @param {Element} parent
 * @param {import("./state.js").State} state
 */
export function readings(parent, state) {
  if (!state.view.readings.length) return;
  const table = made("table", { class: "readings" }, parent);
  const body = made("tbody", {}, table);
  const rows = state.view.readings.map((reading) => {
    const row = made("tr", {}, body);
    const name = made("th", { scope: "row" }, row);
    const sign = made("td", { class: "sign" }, row);
    lettered(sign, parted(reading.sign));
    const value = made("td", { class: "number" }, row);
    const all = typeof reading.value === "number" ? [reading.value] : [...numbers(reading.value[0])];
    const least = NOTHING * Math.max(...all.map(Math.abs));
    return { reading, name, value, least };
  });
  const tell = () => {
    for (const { reading, name, value, least } of rows) {
      const there = isThere(reading.there, state.at);
      name.textContent = told(reading.name);
      const found = trackAt(reading.value, state.values, state.there);
      value.textContent = measured(!there ? NaN : Math.abs(found) < least ? 0 : found, reading.unit, DIGITS);
    }
  };
  saying(tell);
  state.follow(tell);
}
