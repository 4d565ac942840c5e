// What the page holds: the content as JSON, numbers in one block of single floats.

/** @typedef {string | string[]} Said a text, or one in each language */
/** @typedef {[number, number]} Ref place and count in the block */
/** @typedef {number | [Ref, Ref]} Track a number that stands, or values and rates over the input */
/** @typedef {[string, number[], number?, number?]} Mark kind, coordinates of its points, size, number of its colour */
/** @typedef {[number, number] | null} Range between which places of the input something is there; null: always */
/**
 * @typedef {object} Body
 * @property {string} name
 * @property {Track} x
 * @property {Track} y
 * @property {Track} angle
 * @property {Mark[]} marks
 * @property {string} number
 * @property {number[][]} beside
 * @property {string} on the body in whose axes its tracks are
 * @property {Range} there
 */
/** @typedef {{name: string, body: string, at: number[], kind: "pin" | "mass" | "point" | "word", path: boolean}} Spot */
/** @typedef {[string, [string, number, number][]]} Span kind; its points, each a body and a place in its axes */
/** @typedef {{sign: string, spot: string, x: string, y: string, sense: number}} Arrow */
/** @typedef {{sign: string, body: string, x: Track, y: Track, places: Ref | null}} Vector the nearest of its places counts */
/** @typedef {{sign: string, body: string, start: Track, end: Track, column: string}} Angle */
/**
 * @typedef {{name: string, title: Said, unit: Said, arrows: Arrow[], vectors: Vector[], angles: Angle[], tone: number,
 *   hidden: boolean}} Layer hidden until it is asked for
 */
/** @typedef {{name: Said, sign: string, unit: Said, value: Track, there: Range}} Reading */
/** @typedef {[number, number, string, string]} Edge tail, head, sign, kind */
/**
 * @typedef {{name: string, title: Said, unit: Said, vertices: [string, Ref, Ref][], edges: Edge[], places: Ref | null,
 *   note: Said}} Plan
 */
/**
 * @typedef {object} View
 * @property {string} name
 * @property {string} room of its stage
 * @property {Said} title
 * @property {string} symbol
 * @property {Said} unit
 * @property {Ref} values
 * @property {boolean} whole
 * @property {string} column
 * @property {[string, number][]} steps
 * @property {number[]} box
 * @property {Body[]} bodies
 * @property {Mark[]} frame
 * @property {Mark[]} front of the frame, before all that moves
 * @property {Spot[]} spots
 * @property {Span[]} spans
 * @property {{body: string, pivot: number[] | null} | null} handle
 * @property {Layer[]} layers
 * @property {{name: string, x: Ref, y: Ref}[]} centres
 * @property {Plan[]} plans
 * @property {{title: Said, at: number}[]} stops
 * @property {string[]} shown
 * @property {string[]} stages
 * @property {Said} note
 * @property {[number, number][]} reach
 * @property {Reading[]} readings
 * @property {{view: string, ratio: number, begin: number} | null} driver another view that moves it
 * @property {number} seconds that the whole travel takes
 * @property {number | null} nudge of an arrow key
 */
/** @typedef {{name: string, meaning: Said, value: number | boolean | Said, unit: Said}} Fact */
/** @typedef {{name: string, meaning: Said, unit: Said, values: Ref}} Column */
/**
 * @typedef {object} List
 * @property {Said} title of its part of the stage, or nothing
 * @property {{name: Said, sign: boolean, unit: Said, cells: (number | boolean | Said)[]}[]} columns
 */
/**
 * @typedef {object} Stage
 * @property {string} name
 * @property {string} room
 * @property {Said} title
 * @property {Fact[]} facts
 * @property {List[]} tables of its summary
 * @property {{header: string, name: string, unit: Said, values: Ref, kept: number, of: number} | null} rows
 * @property {Column[]} columns
 * @property {Said[]} warnings
 * @property {[Said, number][]} errors
 */
/** @typedef {number | string | [string, ...any[]]} Formula as `tmmcalc.report.formula.carried` writes it */
/** @typedef {[string, string, Formula]} Told name, function of it on the left side or none, formula */
/** @typedef {[string, Formula, Formula, Told[]]} Root name, its ends, steps of which the last one vanishes */
/** @typedef {Told | Root} Step */
/** @typedef {{parameter: string, start: Formula, end: Formula, steps: Told[], x: Formula, y: Formula}} Piece */
/**
 * @typedef {{half: Piece[], worked: Piece, beyond: Said, count: Formula, turn: Formula, x: Formula, y: Formula,
 *   tone: number}} Toothed half a tooth left of +Y, and where the body stands
 */
/**
 * @typedef {{kind: string, places: [Formula, Formula][], size: Formula, tone: number, name: string, side: number,
 *   there: Formula}} Drawn
 */
/** @typedef {{title: Said, middle: [Formula, Formula], reach: number, bodies: Toothed[], marks: Drawn[]}} Sketch */
/** @typedef {{formula: Formula, text: Said, needed: boolean}} Condition holds where its formula is not negative */
/**
 * @typedef {object} Trial a plane of two inputs with a point, sizes that follow by formulas
 * @property {string} name
 * @property {Said} title
 * @property {[string, string]} inputs
 * @property {[number, number]} start
 * @property {number[]} box
 * @property {{kind: "strict" | "tolerated", apart: boolean, x: Ref, y: Ref}[]} regions
 * @property {{number: string, title: Said, value: number, x: Ref, y: Ref}[]} curves
 * @property {{name: Said, title: Said, at: [number, number]}[]} points
 * @property {Record<string, number>} given
 * @property {Step[]} steps
 * @property {{name: string, meaning: Said, unit: Said, least: number | string | null, where: string}[]} shown
 * @property {Condition[]} conditions
 * @property {Sketch} sketch
 */
/** @typedef {{what: Said, keys: string[], values: number[], unit: Said, text: Said}} Datum */
/** @typedef {{name: Said, stages: Stage[], given: Datum[], source: string, views: View[], trials: Trial[]}} Variant */
/**
 * @typedef {object} Content
 * @property {string} title
 * @property {string} key what the variants differ in
 * @property {Record<string, string>} languages
 * @property {string} language
 * @property {Record<string, Said>} words
 * @property {Record<string, string>} letters Greek ones by their names
 * @property {number} error
 * @property {Variant[]} scenes
 * @property {string} block
 */

/** @type {Content} */
export const content = JSON.parse(/** @type {HTMLElement} */ (document.getElementById("content")).textContent || "{}");

const block = decoded(content.block);

/**
 * The numbers of a text in base64.
 * @param {string} text
 */
function decoded(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 4 }, (_, k) => view.getFloat32(4 * k, true));
}

/**
 * The numbers that a reference stands for.
 * @param {Ref} ref
 */
export function numbers([at, count]) {
  return block.subarray(at, at + count);
}

let shown = 0;

/** The variant that is shown. */
export function scene() {
  return content.scenes[shown];
}

/** @param {number} k */
export function choose(k) {
  shown = k;
}

/**
 * A column by the name of its stage and its own.
 * @param {string} name
 * @returns {{stage: Stage, column: Column} | null}
 */
export function columnOf(name, { stages } = scene()) {
  for (const stage of stages) {
    // what a course is called by may have a dot itself
    const column = stage.columns.find((each) => `${stage.name}.${each.name}` === name);
    if (column) return { stage, column };
  }
  return null;
}
