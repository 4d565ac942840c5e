// What was chosen by hand stays when another variant is shown: places, diagrams, ticks, what is unfolded, a search.

/** @type {Map<string, any>} */
const choices = new Map();

/**
 * What was chosen, or what is usual.
 * @template T
 * @param {string} key
 * @param {T} usual
 * @returns {T}
 */
export function kept(key, usual) {
  return choices.has(key) ? choices.get(key) : usual;
}

/**
 * @param {string} key
 * @param {unknown} value
 */
export function keep(key, value) {
  choices.set(key, value);
}
