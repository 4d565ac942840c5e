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
const CLOSE = 1e-15; // relative steps with which a root is found

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
 * What writes the names that steps tell into values that hold what they need.
 * @param {import("./data.js").Step[]} steps
 * @returns {(values: Values) => void}
 */
export function filling(steps) {
  const acts = steps.map((step) => (step.length === 4 ? seeking(step) : telling(step)));
  return (values) => {
    for (const act of acts) act(values);
  };
}

/**
 * @param {import("./data.js").Told} step
 * @returns {(values: Values) => void}
 */
function telling([name, left, formula]) {
  const right = compiled(formula);
  const back = INVERSES[left];
  return (values) => {
    values[name] = back ? back(right(values)) : right(values);
  };
}

/**
 * A root between ends of different signs by secants (Illinois); all that its steps tell there is known afterwards.
 * @param {import("./data.js").Root} root
 * @returns {(values: Values) => void}
 */
function seeking([name, low, high, steps]) {
  const [from, to] = [compiled(low), compiled(high)];
  const [fill, last] = [filling(steps), steps[steps.length - 1][0]];
  return (values) => {
    /** @param {number} x */
    const at = (x) => {
      values[name] = x;
      fill(values);
      return values[last];
    };
    let [near, far] = [from(values), to(values)];
    let [below, above] = [at(near), at(far)];
    if (!(below * above < 0)) {
      at(near);
      return;
    }
    for (let k = 0; k < ROUNDS; k++) {
      const x = (near * above - far * below) / (above - below);
      const step = Math.abs(x - far);
      const y = at(x);
      if (y === 0 || step <= CLOSE * Math.abs(x)) break;
      if (y * above < 0) [near, below] = [far, above];
      else below /= 2;
      [far, above] = [x, y];
    }
  };
}

/**
 * All names that steps tell, from given values and those of the inputs.
 * @param {import("./data.js").Step[]} steps
 * @returns {(given: Values) => Values}
 */
export function chained(steps) {
  const fill = filling(steps);
  return (given) => {
    const values = { ...given };
    fill(values);
    return values;
  };
}
