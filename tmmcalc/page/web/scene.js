// The machine drawn to scale: bodies that move, names, paths, vectors; the input link is dragged by hand.
import { numbers } from "./data.js";
import { dragged } from "./drag.js";
import { boxed, Ghosts } from "./ghosts.js";
import { boxAt } from "./labels.js";
import { Layer } from "./layers.js";
import { isThere, placed, poseOf, posesOf, STILL } from "./motion.js";
import { putNames } from "./naming.js";
import { named } from "./letters.js";
import { centreOfMass, COLOURS, draw, drawn, PIN, put, RING, stretch } from "./marks.js";
import { parted, told, word } from "./words.js";

const WIDE = 760;
const LEAST = 480; // width of a tall scene: it is larger on a narrow screen
const HIGH = 560;
const LOW = 260;
const MARGIN = 56;
const PART = 0.13; // of the width, that the margin has at most
const SHRUNK = 0.9; // a drawing is not shown smaller than this, so that its letters can be read
const NARROW = 300; // narrower is none
const WINDOW = 0.74; // of the height of the window, that it has at most

/**
 * The largest width and height of a drawing, in its pixels, that has room in an element and in the window.
 * @param {Element} parent
 */
function roomIn(parent) {
  const [wide, high] = [parent.clientWidth || WIDE, WINDOW * innerHeight];
  return [Math.min(WIDE, Math.max(NARROW, wide / SHRUNK)), Math.min(HIGH, Math.max(LOW, high / SHRUNK))];
}

export class Scene {
  /**
   * @param {Element} parent
   * @param {import("./state.js").State} state
   */
  constructor(parent, state) {
    this.state = state;
    this.view = state.view;
    const [left, bottom, right, top] = boxed(this.view);
    const wide = Math.max(right - left, 1e-9);
    const high = Math.max(top - bottom, 1e-9);
    const room = roomIn(parent);
    const margin = Math.min(MARGIN, PART * room[0]);
    this.size = Math.max(wide, high);
    this.scale = Math.min((room[0] - 2 * margin) / wide, (room[1] - 2 * margin) / high);
    const height = Math.max(LOW, high * this.scale + 2 * margin);
    const width = Math.min(room[0], Math.max(LEAST, wide * this.scale + 2 * margin));
    this.x0 = width / 2 - ((left + right) / 2) * this.scale;
    this.width = width;
    this.height = height;
    this.y0 = height / 2 + ((top + bottom) / 2) * this.scale;
    this.svg = drawn("svg", { viewBox: `0 0 ${Math.round(width)} ${Math.round(height)}`, class: "scene", role: "img", tabindex: 0 }, parent);
    this.title = drawn("title", {}, this.svg);
    const world = drawn("g", { transform: `translate(${this.x0} ${this.y0})` }, this.svg);
    this.ghosts = new Ghosts(this.view, this.scale, world);
    this.paths = drawn("g", { class: "paths" }, world);
    const frame = drawn("g", { class: "frame" }, world);
    for (const mark of this.view.frame) draw(frame, mark, this.scale);
    this.bodies = this.view.bodies.map((body) => this.made(body, world));
    const front = drawn("g", { class: "frame front" }, world);
    for (const mark of this.view.front) draw(front, mark, this.scale);
    this.spans = this.view.spans.map((span) => this.spanned(span, world));
    this.spots = this.view.spots.map((spot) => this.spotted(spot, world));
    this.rings = this.view.bodies.map((body) => this.ringed(body, world));
    this.centres = this.view.centres.map((centre) => this.centred(centre, world));
    this.layers = this.view.layers.map((layer, k) => new Layer(this, layer, COLOURS[((layer.tone || k + 1) - 1) % COLOURS.length], world));
    this.trace();
    this.named = putNames(this);
    dragged(this);
    this.follow = () => this.update();
    state.follow(this.follow);
    this.say();
  }

  /** Say in the language what is said by words. */
  say() {
    this.title.textContent = `${told(this.view.title)}. ${word("drag")}`;
    this.update();
  }

  /** Give its place to another drawing. */
  leave() {
    this.state.leave(this.follow);
    this.svg.remove();
  }

  /**
   * @param {import("./data.js").Body} body
   * @param {Element} world
   */
  made(body, world) {
    const handle = this.view.handle !== null && this.view.handle.body === body.name;
    const group = drawn("g", { class: handle ? "body handle" : "body", "data-body": body.name }, world);
    for (const mark of body.marks) draw(group, mark, this.scale);
    const still = !body.on && [body.x, body.y, body.angle].every((track) => typeof track === "number");
    if (still) group.classList.add("still");
    else for (const mark of body.marks) draw(group, mark, this.scale).classList.add("grip");
    return group;
  }

  /**
   * @param {import("./data.js").Span} span
   * @param {Element} world
   */
  spanned([kind, points], world) {
    const sides = kind === "tube" ? ["tube", "tube inner"] : [kind];
    return { kind, points, lines: sides.map((side) => drawn("polyline", { class: `span ${side}` }, world)) };
  }

  /**
   * Where the points of a span are, in pixels.
   * @param {import("./data.js").Span[1]} points
   * @param {Map<string, import("./motion.js").Pose>} poses
   */
  along(points, poses) {
    return points.map(([body, x, y]) => {
      const [px, py] = placed(poses.get(body) ?? STILL, x, y);
      return /** @type {[number, number]} */ ([px * this.scale, -py * this.scale]);
    });
  }

  /**
   * @param {import("./data.js").Spot} spot
   * @param {Element} world
   */
  spotted(spot, world) {
    const group = drawn("g", { class: `spot ${spot.kind}`, "data-spot": spot.name }, world);
    if (spot.kind === "pin") drawn("circle", { r: PIN, class: "joint" }, group);
    else if (spot.kind === "mass") centreOfMass(group);
    else if (spot.kind === "point") drawn("circle", { r: 2, class: "dot" }, group);
    named(group, parted(spot.name), { class: "name", "text-anchor": "middle" });
    return group;
  }

  /**
   * @param {import("./data.js").Body} body
   * @param {Element} world
   */
  ringed(body, world) {
    const group = drawn("g", { class: "number" }, world);
    if (body.number) {
      const ring = drawn("g", {}, group);
      drawn("circle", { r: RING }, ring);
      drawn("text", { "text-anchor": "middle", dy: "0.35em" }, ring).textContent = body.number;
    }
    return group;
  }

  /**
   * @param {{name: string}} centre
   * @param {Element} world
   */
  centred(centre, world) {
    const group = drawn("g", { class: "centre" }, world);
    drawn("path", { d: "M-5,-5L5,5M5,-5L-5,5" }, group);
    named(group, parted(centre.name), { class: "name", x: 8, y: 14 });
    return group;
  }

  /** Paths of the named points over all positions. */
  trace() {
    const count = this.state.values.length;
    for (const spot of this.view.spots.filter((each) => each.path)) {
      const body = this.view.bodies.find((each) => each.name === spot.body);
      if (!body) continue;
      let d = "";
      for (let k = 0; k < count; k++) {
        const there = { from: k, to: k, t: 0, near: k };
        const [x, y] = placed(poseOf(body, this.state.values, there), spot.at[0], spot.at[1]);
        d += `${k ? "L" : "M"}${(x * this.scale).toFixed(1)},${(-y * this.scale).toFixed(1)}`;
      }
      drawn("path", { d }, this.paths);
    }
  }

  /**
   * The poses of all bodies there.
   * @param {import("./motion.js").Between} there
   */
  posed(there) {
    return posesOf(this.view.bodies, this.state.values, there);
  }

  /** Draw all where it is now. */
  update() {
    const { at, there } = this.state;
    const poses = this.posed(there);
    this.poses = poses;
    const gone = new Set(this.view.bodies.filter((body) => !isThere(body.there, at)).map((body) => body.name));
    this.gone = gone;
    this.view.bodies.forEach((body, k) => {
      const pose = /** @type {import("./motion.js").Pose} */ (poses.get(body.name));
      put(this.bodies[k], pose, this.scale);
      for (const each of [this.bodies[k], this.rings[k]]) each.classList.toggle("lost", gone.has(body.name));
      const [bx, by] = placed(pose, body.beside[0]?.[0] ?? 0, body.beside[0]?.[1] ?? 0);
      this.rings[k].setAttribute("transform", this.shifted(bx, by));
    });
    for (const { kind, points, lines } of this.spans) stretch(lines, kind, this.along(points, poses));
    this.view.spots.forEach((spot, k) => {
      const [x, y] = placed(poses.get(spot.body) ?? STILL, spot.at[0], spot.at[1]);
      this.spots[k].setAttribute("transform", this.shifted(x, y));
      this.spots[k].classList.toggle("lost", gone.has(spot.body));
    });
    this.view.centres.forEach((centre, k) => {
      const x = numbers(centre.x)[there.near];
      const y = numbers(centre.y)[there.near];
      this.centres[k].classList.toggle("lost", !Number.isFinite(x));
      if (Number.isFinite(x)) this.centres[k].setAttribute("transform", this.shifted(x, y));
    });
    if (!this.svg.classList.contains("no-ghosts")) this.ghosts.update(at);
    this.point();
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  shifted(x, y) {
    return `translate(${(x * this.scale).toFixed(2)} ${(-y * this.scale).toFixed(2)})`;
  }

  /** Vectors of the layers that are shown, their signs beside names and numbers. */
  point() {
    if (!this.layers.some((each) => each.shown)) return;
    const taken = this.named.map(({ body, at, shift, size }) => {
      const [px, py] = placed(this.poses?.get(body) ?? STILL, at[0], at[1]);
      return boxAt(px * this.scale + shift[0], -py * this.scale + shift[1], size);
    });
    for (const layer of this.layers) if (layer.shown) layer.update(taken);
  }

  /**
   * Show or hide what belongs together.
   * @param {string} name
   * @param {boolean} shown
   */
  show(name, shown) {
    const layer = this.layers.find((each) => each.layer.name === name);
    if (layer) layer.show(shown);
    else this.svg.classList.toggle(`no-${name}`, !shown);
    this.update();
  }
}
