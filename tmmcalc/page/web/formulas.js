// Formulas of the note as functions: each tree becomes closures, nothing is evaluated as text.

/** @typedef {Record<string, number>} Values by name */
/** @typedef {(values: Values) => number} Compute */

/** @type {Record<string, (...x: number[]) => number>} */
const FUNCTIONS = {
  sin: Math.sin, cos: Math.cos, tan: Math.tan, asin: Math.asin, acos: Math.acos, atan: Math.atan, atan2: Math.atan2,
  sqrt: Math.sqrt, abs: Math.abs, exp: Math.exp, ln: Math.log, lg: Math.log10, min: Math.min, max: Math.max,
  floor: Math.floor, ceil: Math.ceil, sign: (x) => (x < 0 || Object.is(x, -0) ? -1 : 1), rad: (x) => x,
  deg: (x) => (x * Math.PI) / 180, inv: (x) => Math.tan(x) - x,
};

/** What gives the argument of a function back. @type {Record<string, (y: number) => number>} */
const INVERSES = { inv: angleOf };

const ROUNDS = 60;

/**
 * The angle whose involute function has a value; none below 0.
 * @param {number} y
 */
function angleOf(y) {
  if (!(y >= 0)) return NaN;
  let x = Math.min(Math.cbrt(3 * y), 1.4);
  for (let k = 0; k < ROUNDS && x > 0; k++) {
    const step = (Math.tan(x) - x - y) / Math.tan(x) ** 2;
    x = Math.min(x - step, (x + Math.PI / 2) / 2);
    if (Math.abs(step) <= 1e-16 * x) break;
  }
  return x;
}

/**
 * The function that a formula is.
 * @param {import("./data.js").Formula} formula
 * @returns {Compute}
 */
export function compiled(formula) {
  if (typeof formula === "number") return () => formula;
  if (typeof formula === "string") return formula === "pi" ? () => Math.PI : (values) => values[formula];
  const [sign, ...rest] = formula;
  if (sign === "+") {
    /** @type {[number, Compute][]} */
    const terms = rest.map(([way, term]) => [way, compiled(term)]);
    return (values) => terms.reduce((sum, [way, term]) => sum + way * term(values), 0);
  }
  const parts = rest.map(compiled);
  if (sign === "*") return (values) => parts.reduce((product, factor) => product * factor(values), 1);
  const [first, second] = parts;
  if (sign === "/") return (values) => first(values) / second(values);
  if (sign === "^") return (values) => first(values) ** second(values);
  const act = FUNCTIONS[sign];
  return (values) => act(...parts.map((part) => part(values)));
}

/**
 * All names that steps tell, from given values and those of the inputs.
 * @param {import("./data.js").Step[]} steps
 * @returns {(given: Values) => Values}
 */
export function chained(steps) {
  const acts = steps.map(([name, left, formula]) => {
    const right = compiled(formula);
    const back = INVERSES[left];
    return { name, act: back ? (/** @type {Values} */ values) => back(right(values)) : right };
  });
  return (given) => {
    const values = { ...given };
    for (const { name, act } of acts) values[name] = act(values);
    return values;
  };
}
