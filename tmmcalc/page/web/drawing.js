// A scene as large as there is room for it, with what is ticked of it.
import { made, resized } from "./elements.js";
import { keep, kept } from "./kept.js";
import { Scene } from "./scene.js";
import { saying } from "./words.js";

export class Drawing {
  /**
   * @param {HTMLElement} stage
   * @param {import("./state.js").State} state
   */
  constructor(stage, state) {
    this.scene = new Scene(stage, state);
    /** @type {(() => void)[]} */
    this.ticks = [];
    resized(stage, () => {
      this.scene.leave();
      this.scene = new Scene(stage, state);
      for (const each of this.ticks) each();
    });
    saying(() => this.scene.say());
  }

  /**
   * A box by which something is shown or hidden.
   * @param {Element} parent
   * @param {string} name
   * @param {() => string} says
   * @param {{colour?: string, hidden?: boolean}} [choices] hidden until it is asked for
   */
  tick(parent, name, says, { colour, hidden = false } = {}) {
    const label = made("label", colour ? { class: colour } : {}, parent);
    const box = made("input", { type: "checkbox", name }, label);
    const said = made("span", {}, label);
    const tell = () => (said.textContent = says());
    const key = `tick ${this.scene.view.name} ${name}`;
    box.checked = kept(key, !hidden);
    box.addEventListener("change", () => keep(key, box.checked));
    const show = () => this.scene.show(name, box.checked);
    box.addEventListener("change", show);
    this.ticks.push(() => [show(), tell()]);
    show();
    saying(tell);
  }
}
