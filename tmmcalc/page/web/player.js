// What moves the scene: play, speed, steps, a slider, keys.
import { numbers } from "./data.js";
import { button, called, icon, made } from "./elements.js";
import { keep, kept } from "./kept.js";
import { keyed, turning } from "./keys.js";
import { halt, plays } from "./state.js";
import { measured, saying, told, word, written } from "./words.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2];

export class Player {
  /**
   * @param {Element} parent
   * @param {import("./state.js").State} state
   * @param {Element} keys what listens to keys beside the slider
   */
  constructor(parent, state, keys) {
    this.state = state;
    this.playing = false;
    const speed = `speed ${state.view.name}`;
    this.speed = kept(speed, 1);
    this.sense = 1;
    const place = made("div", {}, parent);
    const bar = made("div", { class: "player", role: "group" }, place);
    this.docked(bar, place);
    this.toggle = button(bar, "play", () => word(this.playing ? "pause" : "play"), () => this.toggled());
    this.toggle.classList.add("main");
    if (state.steps) {
      button(bar, "back", () => word("back"), () => state.step(-1));
      button(bar, "on", () => word("on"), () => state.step(1));
    }
    this.slider = made("input", { type: "range", step: "any" }, bar);
    this.slider.min = String(state.low);
    this.slider.max = String(state.high);
    saying(() => this.slider.setAttribute("aria-label", word("input")));
    this.slider.addEventListener("input", () => state.take(Number(this.slider.value)));
    for (const each of [this.slider, keys]) keyed(each, { ...turning(state), " ": () => this.toggled() });
    const label = made("label", { class: "speed" }, bar);
    const said = made("span", {}, label);
    saying(() => (said.textContent = word("speed")));
    const choice = made("select", {}, label);
    for (const each of SPEEDS) {
      const option = made("option", { value: String(each) }, choice);
      saying(() => (option.textContent = `${written(each)}×`));
    }
    choice.value = String(this.speed);
    choice.addEventListener("change", () => {
      this.speed = Number(choice.value);
      keep(speed, this.speed);
    });
    const lines = made("output", { class: "told", "aria-live": "off" }, parent);
    this.told = made("span", {}, lines);
    this.solved = state.view.column ? made("span", {}, lines) : null; // a line of its own: what stands below does not leap
    this.wrong = made("p", { class: "wrong", role: "status" }, parent);
    if (state.view.stops.length) this.stops(parent);
    saying(() => this.tell());
    state.follow(() => this.tell());
    state.refused.push((asked) => {
      this.wrong.textContent = Number.isNaN(asked) ? "" : `${this.placed(asked)}: ${word(state.closes(asked) ? "beyond" : "unreached")}`;
    });
  }

  /**
   * While it plays the bar stays in sight: out of its place it stands at the edge of the window.
   * @param {HTMLElement} bar
   * @param {HTMLElement} place
   */
  docked(bar, place) {
    let seen = true;
    this.dock = () => {
      const docked = this.playing && !seen;
      if (docked && !bar.classList.contains("docked")) place.style.height = `${place.offsetHeight}px`;
      else if (!docked) place.style.height = "";
      bar.classList.toggle("docked", docked);
    };
    const look = new IntersectionObserver(
      ([entry]) => {
        if (!place.isConnected) return look.disconnect(); // another variant stands in its place
        seen = entry.intersectionRatio > 0.99;
        this.dock?.();
      },
      { threshold: [0, 1] },
    );
    look.observe(place);
  }

  /**
   * Places that are marked, each a button that takes the input there.
   * @param {Element} parent
   */
  stops(parent) {
    const list = made("div", { class: "stops" }, parent);
    const { stops } = this.state.view;
    for (const stop of [...stops].sort((one, other) => this.state.along * (one.at - other.at))) {
      const found = made("button", { type: "button" }, list);
      saying(() => {
        const title = told(stop.title);
        const alike = stops.filter((each) => told(each.title) === title).length > 1;
        found.textContent = alike ? `${title}, ${this.placed(stop.at)}` : title;
      });
      found.addEventListener("click", () => this.state.take(stop.at));
    }
  }

  /** Where the input stands, in words. @param {number} value */
  placed(value) {
    return `${this.state.view.symbol} = ${measured(value, this.state.view.unit, 5)}`;
  }

  /** Say where the input stands, and whose values are shown. */
  tell() {
    const { state } = this;
    this.slider.value = String(state.at);
    const step = state.view.steps.find(([, at]) => Math.abs(at - state.at) <= state.small);
    const here = this.placed(state.at);
    const near = numbers(state.view.values)[state.near];
    this.slider.setAttribute("aria-valuetext", here);
    this.told.textContent = `${here}${step?.[0] ? ` ${word("step", { label: step[0] })}` : ""}`;
    if (this.solved) this.solved.textContent = word("solved", { value: this.placed(near) });
  }

  /** Let it go, or stop it. */
  toggled() {
    if (this.playing) return halt();
    plays(() => this.play(false));
    this.play(true);
    let last = performance.now();
    /** @param {number} now */
    const frame = (now) => {
      if (!this.playing) return;
      const { state } = this;
      const way = (Math.min(Math.max(now - last, 0), 100) / (1000 * state.view.seconds)) * this.speed * state.span;
      const next = () => state.at + this.sense * state.along * way;
      last = now;
      if (!state.view.whole && (next() > state.high || next() < state.low)) this.sense = -this.sense; // to and fro
      state.move(next());
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  /**
   * Show that it plays, or does not.
   * @param {boolean} playing
   */
  play(playing) {
    this.playing = playing;
    this.toggle.replaceChildren(icon(playing ? "pause" : "play"));
    called(this.toggle, word(playing ? "pause" : "play"));
    this.dock?.();
  }
}
