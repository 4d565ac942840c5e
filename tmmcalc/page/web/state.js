// Where the input stands, and who is told when it moves.
import { numbers } from "./data.js";
import { between } from "./motion.js";
import { isAngle } from "./words.js";

/** @type {() => void} */
let stop = () => {};

/**
 * One plays in the page: what played before stops.
 * @param {() => void} stopped what stops it
 */
export function plays(stopped) {
  halt();
  stop = stopped;
}

/** Stop what plays. */
export function halt() {
  const playing = stop;
  stop = () => {};
  playing();
}

export class State {
  /** @param {import("./data.js").View} view */
  constructor(view) {
    this.view = view;
    this.values = numbers(view.values);
    this.low = Math.min(this.values[0], this.values[this.values.length - 1]);
    this.high = Math.max(this.values[0], this.values[this.values.length - 1]);
    this.at = this.values[0];
    /** @type {((at: number) => void)[]} */
    this.listeners = [];
    /** @type {((asked: number) => void)[]} */
    this.refused = [];
  }

  get span() {
    return this.high - this.low;
  }

  /** How far apart places are that count as one. */
  get small() {
    return 1e-5 * this.span;
  }

  /** The sense in which it goes on. */
  get along() {
    return Math.sign(this.values[this.values.length - 1] - this.values[0]) || 1;
  }

  /** Whether there are positions to step by. */
  get steps() {
    return this.view.whole || this.view.steps.length > 0;
  }

  get there() {
    return between(this.values, this.at);
  }

  /** The row whose values are shown. */
  get near() {
    return this.there.near;
  }

  /**
   * The place within the turn.
   * @param {number} asked
   */
  turned(asked) {
    return this.view.whole ? this.low + ((((asked - this.low) % this.span) + this.span) % this.span) : asked;
  }

  /**
   * Move the input; what lies beyond its ends is refused, of a whole turn it comes round.
   * @param {number} asked
   */
  move(asked) {
    const turned = this.turned(asked);
    this.at = Math.min(this.high, Math.max(this.low, turned));
    const beyond = Math.abs(turned - this.at) > 1e-6 * this.span;
    for (const each of this.listeners) each(this.at);
    for (const each of this.refused) each(beyond ? asked : NaN);
    return !beyond;
  }

  /**
   * Move the input by hand: what plays stops.
   * @param {number} asked
   */
  take(asked) {
    halt();
    return this.move(asked);
  }

  /**
   * Whether the links close there, be it within the travel or not.
   * @param {number} asked
   */
  closes(asked) {
    const { reach, unit } = this.view;
    const turns = isAngle(unit) ? [-360, 0, 360] : [0];
    return !reach.length || turns.some((turn) => reach.some(([low, high]) => low <= asked + turn && asked + turn <= high));
  }

  /**
   * Move by hand to the next position of the spec, or the one before.
   * @param {number} sense
   */
  step(sense) {
    const way = this.along;
    const places = this.view.steps.map((step) => step[1] * way).sort((a, b) => a - b);
    const at = this.at * way;
    const next =
      sense > 0 ? places.find((place) => place > at + this.small) : places.findLast((place) => place < at - this.small);
    if (next !== undefined) this.take(next * way);
    else if (this.view.whole) this.take(sense > 0 ? this.values[0] : (places.at(-2) ?? 0) * way);
  }

  /**
   * Call now and whenever the input moves.
   * @param {(at: number) => void} act
   */
  follow(act) {
    this.listeners.push(act);
    act(this.at);
  }

  /**
   * Call no more.
   * @param {(at: number) => void} act
   */
  leave(act) {
    this.listeners = this.listeners.filter((each) => each !== act);
  }
}

/**
 * What moves one input moves the other that it drives, and back.
 * @param {State[]} states
 */
export function coupled(states) {
  for (const state of states) {
    const { driver } = state.view;
    const other = driver && states.find((each) => each.view.name === driver.view);
    if (!driver || !other) continue;
    let busy = false;
    /** @param {() => void} act */
    const once = (act) => {
      if (busy) return;
      busy = true;
      act();
      busy = false;
    };
    const wanted = () => driver.ratio * (other.at - driver.begin);
    other.follow(() => once(() => state.move(wanted())));
    state.follow(() =>
      once(() => {
        const turns = Math.round((state.at - wanted()) / state.span); // whole turns make no difference
        const moved = other.move(other.at + (state.at - wanted() - turns * state.span) / driver.ratio);
        if (!moved) state.move(wanted()); // where the other one ends this one does
      }),
    );
  }
}
