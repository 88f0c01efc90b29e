// A flat Abaqus deck on a finer net: every shell and beam as four or two of half its size, as often as
// asked, and all of them as S8R, S6 and B32R. What is held goes on along edges of which all nodes are.
//
//   node tests/decks/finer_deck.mjs DECK HALVINGS > FINER
//
// Throws where a deck says more than numbers of nodes and elements (parts, generated or tied nodes).
import { readFileSync } from "node:fs";

const shells4 = /^S4(R|R5)?$/, shells8 = /^S8(R|R5)?$/, shells3 = /^(S3R?|STRI3)$/, shells6 = /^(S6|STRI65)$/;
const beams2 = /^B31(R|H)?$/, beams3 = /^B32(R|H)?$/;
const notHad =
  /^(PART|INCLUDE|NGEN|ELGEN|NFILL|NCOPY|ELCOPY|TRANSFORM|TIE|NORMAL|SURFACE|COUPLING|RIGID BODY|SUBMODEL)$/;

// [{name, parameters, header, data}] of a text.
export function keywordsOf(text) {
  const all = [];
  let open = false; // the keyword goes on in the next line
  for (const line of text.split(/\r?\n/).map((l) => l.trim())) {
    if (line === "" || line.startsWith("**")) continue;
    if (open) all.at(-1).header += line;
    else if (line.startsWith("*")) all.push({ header: line, data: [] });
    else if (all.length > 0) all.at(-1).data.push(line);
    open = (open || line.startsWith("*")) && line.endsWith(",");
  }
  for (const keyword of all) {
    const [name, ...parameters] = keyword.header.split(",").map((part) => part.trim());
    keyword.name = name.slice(1).toUpperCase().replace(/\s+/g, " ");
    keyword.parameters = Object.fromEntries(parameters.map((p) => {
      const [key, value = ""] = p.split("=").map((x) => x.trim());
      return [key.toUpperCase(), value.toUpperCase()];
    }));
  }
  return all;
}

export const fieldsOf = (line) => line.split(",").map((x) => x.trim());

// --- elements: shape functions, places of their children, sides

function shapesOf8(x, y) {
  const corner = (a, b) => ((1 + a * x) * (1 + b * y) * (a * x + b * y - 1)) / 4;
  return [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), ((1 - x * x) * (1 - y)) / 2,
    ((1 + x) * (1 - y * y)) / 2, ((1 - x * x) * (1 + y)) / 2, ((1 - x) * (1 - y * y)) / 2];
}
const shapesOf4 = (x, y) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => ((1 + a * x) * (1 + b * y)) / 4);
function shapesOf6(r, s) {
  const t = 1 - r - s;
  return [t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * r * t, 4 * r * s, 4 * s * t];
}

// `corners`: of the element in its own coordinates; `sides`: numbers of its nodes, and who lies on them.
const quad = {
  corners: [[-1, -1], [1, -1], [1, 1], [-1, 1]],
  sides: [[0, 1, 4], [1, 2, 5], [2, 3, 6], [3, 0, 7]],
  on: ([x, y]) => [y === -1, x === 1, y === 1, x === -1],
  type: "S8R",
};
const triangle = {
  corners: [[0, 0], [1, 0], [0, 1]],
  sides: [[0, 1, 3], [1, 2, 4], [2, 0, 5]],
  on: ([r, s]) => [s === 0, r + s === 1, r === 0],
  type: "S6",
};
const beam = { corners: [[-1], [1]], sides: [[0, 1, 2]], on: () => [true], type: "B32R" };

function kindOf(type) {
  if (shells4.test(type)) return { ...quad, nodes: 4, shapes: (p) => shapesOf4(...p) };
  if (shells8.test(type)) return { ...quad, nodes: 8, shapes: (p) => shapesOf8(...p) };
  if (shells3.test(type)) return { ...triangle, nodes: 3, shapes: ([r, s]) => [1 - r - s, r, s] };
  if (shells6.test(type)) return { ...triangle, nodes: 6, shapes: (p) => shapesOf6(...p) };
  if (beams2.test(type)) return { ...beam, nodes: 2, shapes: ([x]) => [(1 - x) / 2, (1 + x) / 2] };
  if (beams3.test(type))
    return { ...beam, nodes: 3, shapes: ([x]) => [(x * (x - 1)) / 2, (x * (x + 1)) / 2, 1 - x * x] };
  throw new Error(`elements ${type}`);
}

const middle = (a, b) => a.map((v, i) => (v + b[i]) / 2);

// Corners of the children of an element, in its coordinates.
function childrenOf(kind, halvings) {
  let all = [kind.corners];
  for (let h = 0; h < halvings; ++h)
    all = all.flatMap((c) => {
      if (c.length === 2) return [[c[0], middle(c[0], c[1])], [middle(c[0], c[1]), c[1]]];
      const m = c.map((p, i) => middle(p, c[(i + 1) % c.length]));
      if (c.length === 3) return [...c.map((p, i) => [p, m[i], m[(i + 2) % 3]]), m];
      const centre = middle(c[0], c[2]);
      return c.map((p, i) => [p, m[i], centre, m[(i + 3) % 4]]);
    });
  return all;
}

// --- the deck

class FinerDeck {
  nodes = new Map();
  elements = []; // {type, number, nodes}
  sets = { NSET: new Map(), ELSET: new Map() };
  held = new Map(); // DOFs of a node
  thickness = new Map();
  rest = []; // what is passed on
  made = new Map(); // new nodes by what they lie on and where

  constructor(text) {
    const keywords = keywordsOf(text);
    let steps = 0;
    for (const k of keywords) {
      if (k.name === "STEP" && ++steps > 1) break;
      if (notHad.test(k.name)) throw new Error(k.name);
      this.read(k, steps > 0);
    }
    this.next = Math.max(...this.nodes.keys()) + 1;
  }

  read(k, inStep) {
    if (k.name === "BOUNDARY") return k.data.forEach((line) => this.hold(fieldsOf(line)));
    if (inStep) return;
    if (k.name === "NODE") return this.readNodes(k);
    if (k.name === "ELEMENT") return this.readElements(k);
    if (k.name === "NSET" || k.name === "ELSET") return this.readSet(k);
    if (k.name !== "NODAL THICKNESS") return this.rest.push(k.header, ...k.data);
    for (const [set, t] of k.data.map(fieldsOf)) for (const n of this.nodesOf(set)) this.thickness.set(n, Number(t));
  }

  setNamed(kind, name) {
    const all = this.sets[kind], key = name.toUpperCase();
    if (!all.has(key)) all.set(key, []);
    return all.get(key);
  }
  nodesOf(word) {
    return /^\d+$/.test(word) ? [Number(word)] : this.setNamed("NSET", word);
  }

  readNodes(k) {
    for (const [number, ...x] of k.data.map(fieldsOf)) {
      this.nodes.set(Number(number), [0, 1, 2].map((i) => Number(x[i] || 0)));
      if (k.parameters.NSET) this.setNamed("NSET", k.parameters.NSET).push(Number(number));
    }
  }

  readElements(k) {
    const kind = kindOf(k.parameters.TYPE), numbers = k.data.flatMap(fieldsOf).filter((x) => x !== "").map(Number);
    for (let i = 0; i < numbers.length; i += kind.nodes + 1) {
      let nodes = numbers.slice(i + 1, i + 1 + kind.nodes);
      if (kind.type === "B32R" && kind.nodes === 3) nodes = [nodes[0], nodes[2], nodes[1]];
      this.elements.push({ kind, number: numbers[i], nodes });
      if (k.parameters.ELSET) this.setNamed("ELSET", k.parameters.ELSET).push(numbers[i]);
    }
  }

  readSet(k) {
    const set = this.setNamed(k.name, k.parameters[k.name]);
    for (const line of k.data.map(fieldsOf)) {
      if ("GENERATE" in k.parameters) {
        const [first, last, step = 1] = line.filter((x) => x !== "").map(Number);
        for (let n = first; n <= last; n += step) set.push(n);
      } else for (const word of line.filter((x) => x !== ""))
        set.push(...(/^\d+$/.test(word) ? [Number(word)] : this.setNamed(k.name, word)));
    }
  }

  hold([set, first, last]) {
    for (const n of this.nodesOf(set))
      for (let dof = Number(first); dof <= Number(last || first); ++dof)
        this.held.set(n, (this.held.get(n) ?? new Set()).add(dof));
  }

  // The node at a place of an element; new ones are held as all are that they lie between.
  nodeAt(element, place) {
    const { kind, nodes } = element, weights = kind.shapes(place);
    const there = weights.findIndex((w) => Math.abs(w - 1) < 1e-12);
    if (there >= 0) return nodes[there];
    const x = [0, 1, 2].map((d) => nodes.reduce((sum, n, i) => sum + weights[i] * this.nodes.get(n)[d], 0));
    const side = kind.on(place).indexOf(true);
    const between = side < 0 ? nodes : kind.sides[side].filter((i) => i < nodes.length).map((i) => nodes[i]);
    const where = side < 0 ? `in ${element.number}` : [...between].sort((a, b) => a - b).join();
    const key = `${where} ${x.map((v) => v.toPrecision(8))}`;
    if (this.made.has(key)) return this.made.get(key);
    const node = this.next++;
    this.made.set(key, node);
    this.nodes.set(node, x);
    const dofs = [1, 2, 3, 4, 5, 6].filter((d) => between.every((n) => this.held.get(n)?.has(d)));
    if (dofs.length > 0) this.held.set(node, new Set(dofs));
    if (nodes.every((n) => this.thickness.has(n)))
      this.thickness.set(node, nodes.reduce((sum, n, i) => sum + weights[i] * this.thickness.get(n), 0));
    return node;
  }

  // One child: corners, then the nodes amid its sides.
  childOf(element, corners) {
    const sides = corners.length === 2 ? [middle(...corners)]
      : corners.map((p, i) => middle(p, corners[(i + 1) % corners.length]));
    const nodes = [...corners, ...sides].map((p) => this.nodeAt(element, p));
    return corners.length === 2 ? [nodes[0], nodes[2], nodes[1]] : nodes;
  }

  text(halvings) {
    const children = new Map(), lines = [];
    let number = 0;
    for (const element of this.elements)
      for (const corners of childrenOf(element.kind, halvings)) {
        lines.push(`*ELEMENT, TYPE=${element.kind.type}`, [++number, ...this.childOf(element, corners)].join(", "));
        children.set(element.number, [...(children.get(element.number) ?? []), number]);
      }
    const nodes = [...this.nodes].map(([n, x]) => [n, ...x].join(", "));
    const sets = (kind, all, numbers) =>
      [...all].filter(([, list]) => list.length > 0)
        .flatMap(([name, list]) => [`*${kind}, ${kind}=${name}`, ...list.flatMap(numbers).map((n) => `${n},`)]);
    const held = [...this.held].flatMap(([n, dofs]) => [...dofs].map((d) => `${n}, ${d}, ${d}`));
    const thick = [...this.thickness].map(([n, t]) => `${n}, ${t}`);
    return ["*NODE, NSET=NALL", ...nodes, ...lines,
      ...sets("ELSET", this.sets.ELSET, (e) => children.get(e) ?? []), ...sets("NSET", this.sets.NSET, (n) => [n]),
      ...(thick.length ? ["*NODAL THICKNESS", ...thick] : []), ...this.rest,
      ...(held.length ? ["*BOUNDARY", ...held] : []), ""].join("\n");
  }
}

export const finerDeck = (text, halvings) => new FinerDeck(text).text(halvings);

if (process.argv[1]?.endsWith("finer_deck.mjs"))
  process.stdout.write(finerDeck(readFileSync(process.argv[2], "latin1"), Number(process.argv[3])));
