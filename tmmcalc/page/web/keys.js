// Keys that move something: of an input wherever it is shown, of whatever has acts of its own.

/** @typedef {Record<string, (event: KeyboardEvent) => void>} Acts by the names of keys */

/**
 * Let keys act on what has the focus; with Ctrl, Alt or Meta they belong to the browser.
 * @param {Element} element
 * @param {Acts} acts
 */
export function keyed(element, acts) {
  element.addEventListener("keydown", (each) => {
    const event = /** @type {KeyboardEvent} */ (each);
    const act = acts[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act(event);
  });
}

/**
 * Keys of an input: it turns by little, steps by positions where there are some, and goes back to its beginning.
 * @param {import("./state.js").State} state
 * @returns {Acts}
 */
export function turning(state) {
  const small = state.view.nudge ?? state.span / 360;
  /** @type {Acts} */
  const acts = {
    ArrowRight: () => state.take(state.at + state.along * small),
    ArrowLeft: () => state.take(state.at - state.along * small),
    Home: () => state.take(state.values[0]),
  };
  const [on, back] = [() => state.step(1), () => state.step(-1)];
  return state.steps ? { ...acts, ArrowUp: on, PageUp: on, ArrowDown: back, PageDown: back } : acts;
}
