// The machine drawn to scale: bodies that move, names, paths, vectors; the input link is dragged by hand.
import { columnOf, numbers } from "./data.js";
import { dragged } from "./drag.js";
import { between, isThere, placed, poseOf, posesOf, STILL, trackAt } from "./motion.js";
import { lettered, putNames } from "./naming.js";
import { centreOfMass, COLOURS, draw, drawn, named, PIN, RING, stretch } from "./marks.js";
import { perPixel, scaleTold } from "./scales.js";
import { parted, saying, told, word, written } from "./words.js";

const WIDE = 760;
const LEAST = 480; // width of a tall scene: it is larger on a narrow screen
const HIGH = 560;
const MARGIN = 56;
const LONGEST = 110; // of a vector, in pixels
const LEG = 110; // of an angle, in pixels
const ARC = 84;
const SIGN = 76; // of its sign and value

export class Scene {
  /**
   * @param {Element} parent
   * @param {import("./state.js").State} state
   */
  constructor(parent, state) {
    this.state = state;
    this.view = state.view;
    const [left, bottom, right, top] = this.view.box;
    const wide = Math.max(right - left, 1e-9);
    const high = Math.max(top - bottom, 1e-9);
    this.size = Math.max(wide, high);
    this.scale = Math.min((WIDE - 2 * MARGIN) / wide, (HIGH - 2 * MARGIN) / high);
    const height = Math.max(260, high * this.scale + 2 * MARGIN);
    const width = Math.min(WIDE, Math.max(LEAST, wide * this.scale + 2 * MARGIN));
    this.x0 = width / 2 - ((left + right) / 2) * this.scale;
    this.width = width;
    this.height = height;
    this.y0 = height / 2 + ((top + bottom) / 2) * this.scale;
    this.svg = drawn("svg", { viewBox: `0 0 ${Math.round(width)} ${Math.round(height)}`, class: "scene", role: "img", tabindex: 0 }, parent);
    const title = drawn("title", {}, this.svg);
    saying(() => (title.textContent = `${told(this.view.title)}. ${word("drag")}`));
    this.heads();
    const world = drawn("g", { transform: `translate(${this.x0} ${this.y0})` }, this.svg);
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
    this.layers = this.view.layers.map((layer, k) => this.layered(layer, COLOURS[((layer.tone || k + 1) - 1) % COLOURS.length], world));
    this.trace();
    putNames(this);
    dragged(this);
    state.follow(() => this.update());
  }

  /** Heads of arrows, one for each colour. */
  heads() {
    const defs = drawn("defs", {}, this.svg);
    for (const colour of COLOURS) {
      const marker = drawn(
        "marker",
        { id: `head-${colour}`, viewBox: "0 0 10 6", refX: 9.5, refY: 3, markerWidth: 9, markerHeight: 6, orient: "auto", markerUnits: "userSpaceOnUse" },
        defs,
      );
      drawn("path", { d: "M0,0L10,3L0,6z", class: `fill-${colour}` }, marker);
    }
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
    named(group, ...lettered(spot.name), { class: "name", "text-anchor": "middle" });
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
    named(group, ...parted(centre.name), { class: "name", x: 8, y: 14 });
    return group;
  }

  /**
   * @param {import("./data.js").Layer} layer
   * @param {string} colour
   * @param {Element} world
   */
  layered(layer, colour, world) {
    const group = drawn("g", { class: `layer ${colour}`, "data-layer": layer.name }, world);
    const arrows = layer.arrows.flatMap((arrow) => {
      const [x, y] = [columnOf(arrow.x), columnOf(arrow.y)];
      if (!x || !y || !x.stage.rows) return [];
      const line = drawn("line", { "marker-end": `url(#head-${colour})` }, group);
      const name = named(group, ...parted(arrow.sign), { class: "name" });
      const rows = numbers(x.stage.rows.values);
      return [{ arrow, line, name, rows, x: numbers(x.column.values), y: numbers(y.column.values) }];
    });
    const vectors = layer.vectors.map((vector) => {
      const line = drawn("line", { "marker-end": `url(#head-${colour})` }, group);
      return { vector, line, name: named(group, ...parted(vector.sign), { class: "name" }) };
    });
    const angles = layer.angles.map((angle) => {
      const found = columnOf(angle.column);
      const legs = [0, 1].map(() => drawn("line", { class: "leg" }, group));
      const arc = drawn("path", { class: "arc" }, group);
      return { angle, found, legs, arc, name: drawn("text", { class: "name" }, group) };
    });
    let largest = 0;
    for (const { x, y } of arrows) largest = x.reduce((most, _, k) => Math.max(most, Math.hypot(x[k], y[k]) || 0), largest);
    for (const { vector } of vectors) largest = Math.max(largest, this.longest(vector));
    const per = largest ? perPixel(largest / LONGEST) : 1; // of the unit to a pixel
    return { layer, colour, group, arrows, vectors, angles, per, largest };
  }

  /**
   * The greatest length of a vector where its body is there, in its unit.
   * @param {import("./data.js").Vector} vector
   */
  longest(vector) {
    const { values, low, high } = this.state;
    const [from, to] = this.view.bodies.find((each) => each.name === vector.body)?.there ?? [low, high];
    const places = [from, ...values.filter((value) => value > from && value < to), to].map((at) => between(values, at));
    return Math.max(...places.map((each) => Math.hypot(trackAt(vector.x, values, each), trackAt(vector.y, values, each))));
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
      const { x, y, cos, sin } = pose;
      const s = this.scale;
      const matrix = [cos, -sin, sin, cos, x * s, -y * s].map((each) => each.toFixed(5)).join(" ");
      this.bodies[k].setAttribute("transform", `matrix(${matrix})`);
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
    for (const layer of this.layers) if (!layer.group.classList.contains("off")) this.point(layer);
  }

  /**
   * Vectors of a layer from their spots, at the nearest solved position.
   * @param {ReturnType<Scene["layered"]>} layer
   */
  point(layer) {
    for (const { arrow, line, name, rows, x, y } of layer.arrows) {
      const spot = this.view.spots.find((each) => each.name === arrow.spot);
      if (!spot) continue;
      const [px, py] = placed(this.poses?.get(spot.body) ?? STILL, spot.at[0], spot.at[1]);
      const k = between(rows, this.state.at).near;
      this.arrow(line, name, [px, py], [(arrow.sense * x[k]) / layer.per, (arrow.sense * y[k]) / layer.per]);
    }
    for (const each of layer.angles) this.opened(each);
    for (const { vector, line, name } of layer.vectors) {
      const pose = this.gone?.has(vector.body) ? undefined : this.poses?.get(vector.body);
      const { values, there } = this.state;
      const way = [trackAt(vector.x, values, there) / layer.per, trackAt(vector.y, values, there) / layer.per];
      this.arrow(line, name, pose ? [pose.x, pose.y] : [0, 0], pose ? way : [0, 0]);
    }
  }

  /**
   * An angle with its legs and its value at the nearest solved position.
   * @param {ReturnType<Scene["layered"]>["angles"][number]} shown
   */
  opened({ angle, found, legs, arc, name }) {
    const pose = this.poses?.get(angle.body) ?? STILL;
    const { values, there, at } = this.state;
    const [from, to] = [trackAt(angle.start, values, there), trackAt(angle.end, values, there)];
    const [x, y] = [pose.x * this.scale, -pose.y * this.scale];
    /** @param {number} direction @param {number} far @returns {[number, number]} */
    const point = (direction, far) => [x + far * Math.cos(direction), y - far * Math.sin(direction)];
    [from, to].forEach((direction, k) => {
      const [x1, y1] = point(direction, -LEG / 2);
      const [x2, y2] = point(direction, LEG);
      for (const [key, value] of Object.entries({ x1, y1, x2, y2 })) legs[k].setAttribute(key, value.toFixed(1));
    });
    const [ends, sweep] = [[point(from, ARC), point(to, ARC)], to > from ? 0 : 1];
    const [start, end] = ends.map((each) => each.map((value) => value.toFixed(1)).join(","));
    arc.setAttribute("d", `M${start}A${ARC},${ARC} 0 0 ${sweep} ${end}`);
    const away = to + (to > from ? 1 : -1) * (Math.PI / 2); // beside the second leg, outside the angle
    const [ex, ey] = point(to, LEG - 6);
    const [tx, ty] = [ex + 8 * Math.cos(away), ey - 8 * Math.sin(away) + 5];
    const rows = found?.stage.rows;
    const value = rows ? numbers(found.column.values)[between(numbers(rows.values), at).near] : NaN;
    name.textContent = `${parted(angle.sign)[0]} = ${written(value, 3)}${told(found?.column.unit ?? "")}`;
    const before = Math.cos(away) < 0;
    const [left, right] = [-this.x0 + 4 + (before ? SIGN : 0), this.width - this.x0 - 4 - (before ? 0 : SIGN)];
    name.setAttribute("x", Math.min(right, Math.max(left, tx)).toFixed(1));
    name.setAttribute("y", Math.min(this.height - this.y0 - 6, Math.max(16 - this.y0, ty)).toFixed(1));
    name.setAttribute("text-anchor", before ? "end" : "start");
  }

  /**
   * An arrow with its name, none where it is too short to be seen.
   * @param {Element} line
   * @param {Element} name
   * @param {number[]} from a place of the machine
   * @param {number[]} way in pixels, y upward
   */
  arrow(line, name, from, way) {
    const [dx, dy] = [way[0], -way[1]];
    const long = Math.hypot(dx, dy);
    const [ax, ay] = [from[0] * this.scale, -from[1] * this.scale];
    const seen = long > 1;
    line.classList.toggle("lost", !seen);
    name.classList.toggle("lost", !seen);
    if (!seen) return;
    for (const [key, value] of Object.entries({ x1: ax, y1: ay, x2: ax + dx, y2: ay + dy })) line.setAttribute(key, value.toFixed(1));
    name.setAttribute("x", (ax + dx + (9 * dx) / long - 6).toFixed(1));
    name.setAttribute("y", (ay + dy + (9 * dy) / long + 5).toFixed(1));
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  shifted(x, y) {
    return `translate(${(x * this.scale).toFixed(2)} ${(-y * this.scale).toFixed(2)})`;
  }

  /**
   * Show or hide what belongs together.
   * @param {string} name
   * @param {boolean} shown
   */
  show(name, shown) {
    const layer = this.layers.find((each) => each.layer.name === name);
    if (layer) {
      layer.group.classList.toggle("off", !shown);
      if (shown) this.point(layer);
    } else this.svg.classList.toggle(`no-${name}`, !shown);
  }

  /**
   * The scale of a layer in words, where it has vectors.
   * @param {ReturnType<Scene["layered"]>} layer
   */
  scaleOf(layer) {
    if (!layer.largest) return "";
    return scaleTold(layer.per, layer.layer.unit);
  }

}
