// Frequencies of a deck of trusses alone, summed up from its bars: E A / L along each, half its mass at either
// end. Of Abaqus decks with one part; the units are those of the deck.
import { fieldsOf, keywordsOf } from "./finer_deck.mjs";

const isNumber = (word) => /^\d+$/.test(word);

function readTrusses(text) {
  const deck = { nodes: new Map(), bars: new Map(), NSET: new Map(), ELSET: new Map(), held: [], material: new Map() };
  deck.sections = new Map();
  let material, steps = 0, plane = false, cleared = false;
  const members = (kind, word) => (isNumber(word) ? [Number(word)] : (deck[kind].get(word.toUpperCase()) ?? []));
  const add = (kind, name, numbers) => deck[kind].set(name, [...(deck[kind].get(name) ?? []), ...numbers]);
  for (const { name, parameters: p, data } of keywordsOf(text)) {
    if (name === "STEP" && ++steps > 1) break;
    const lines = data.map(fieldsOf), numbers = () => lines.map((l) => l.map(Number));
    if (name === "NODE" && steps === 0)
      for (const [n, x, y, z = 0] of numbers()) {
        deck.nodes.set(n, [x, y || 0, z || 0]);
        if (p.NSET) add("NSET", p.NSET, [n]);
      }
    if (name === "ELEMENT") {
      if (!/^T[23]D[23]$/.test(p.TYPE)) return undefined;
      plane ||= p.TYPE.startsWith("T2");
      for (const [e, ...ends] of numbers()) {
        deck.bars.set(e, ends);
        if (p.ELSET) add("ELSET", p.ELSET, [e]);
      }
    }
    if ((name === "NSET" || name === "ELSET") && steps === 0)
      for (const line of lines) {
        const [first, last, step = 1] = line.filter((w) => w !== "").map(Number);
        const range = () => Array.from({ length: Math.floor((last - first) / step) + 1 }, (_, i) => first + i * step);
        add(name, p[name], "GENERATE" in p ? range() : line.filter((w) => w !== "").flatMap((w) => members(name, w)));
      }
    if (name === "MATERIAL") deck.material.set((material = p.NAME), { E: 0, rho: 1 });
    if (name === "ELASTIC") deck.material.get(material).E = Number(lines[0][0]);
    if (name === "DENSITY") deck.material.get(material).rho = Number(lines[0][0]);
    if (name === "SOLID SECTION")
      for (const e of members("ELSET", p.ELSET)) deck.sections.set(e, [Number(lines[0]?.[0] || 1), p.MATERIAL]);
    if (name === "BOUNDARY" && steps > 0 && p.OP === "NEW" && !cleared) {
      cleared = true;
      deck.held = [];
    }
    if (name === "BOUNDARY")
      for (const [set, from, to] of lines)
        for (const n of members("NSET", set))
          for (let d = Number(from); d <= Math.min(3, Number(to || from)); ++d) deck.held.push(`${n} ${d - 1}`);
  }
  if (plane) for (const n of deck.nodes.keys()) deck.held.push(`${n} 2`);
  return deck;
}

// Eigenvalues of a symmetric matrix, after Jacobi.
function eigenvalues(A) {
  const n = A.length;
  for (let sweep = 0; sweep < 60; ++sweep) {
    let off = 0;
    for (let p = 0; p < n; ++p)
      for (let q = p + 1; q < n; ++q) {
        if (A[p][q] === 0) continue;
        off += A[p][q] ** 2;
        const t = (A[q][q] - A[p][p]) / (2 * A[p][q]), s = Math.sign(t || 1) / (Math.abs(t) + Math.hypot(t, 1));
        const c = 1 / Math.hypot(s, 1), d = s * c;
        for (let k = 0; k < n; ++k) [A[k][p], A[k][q]] = [c * A[k][p] - d * A[k][q], d * A[k][p] + c * A[k][q]];
        for (let k = 0; k < n; ++k) [A[p][k], A[q][k]] = [c * A[p][k] - d * A[q][k], d * A[p][k] + c * A[q][k]];
      }
    if (off < 1e-24 * A.reduce((sum, row, i) => sum + row[i] ** 2, 0)) break;
  }
  return A.map((row, i) => row[i]).sort((a, b) => a - b);
}

// Hz, but for motions without energy; nothing where there is something else than trusses.
export function trussFrequencies(text) {
  const deck = readTrusses(text);
  if (!deck) return undefined;
  const held = new Set(deck.held), number = new Map(), used = new Set([...deck.bars.values()].flat());
  for (const n of used) for (const d of [0, 1, 2]) if (!held.has(`${n} ${d}`)) number.set(`${n} ${d}`, number.size);
  const zeros = () => new Array(number.size).fill(0), K = zeros().map(zeros), M = zeros();
  for (const [e, ends] of deck.bars)
    for (let i = 0; i + 1 < ends.length; ++i) {
      const pair = [ends[i], ends[i + 1]], [a, b] = pair.map((n) => deck.nodes.get(n));
      const L = Math.hypot(...a.map((x, d) => b[d] - x)), [A, name] = deck.sections.get(e);
      const { E, rho } = deck.material.get(name), along = a.map((x, d) => (b[d] - x) / L);
      const rows = pair.flatMap((n, k) => along.map((v, d) => [number.get(`${n} ${d}`), k === 0 ? -v : v]));
      for (const [r, v] of rows)
        if (r !== undefined) {
          M[r] += (rho * A * L) / 2;
          for (const [c, w] of rows) if (c !== undefined) K[r][c] += ((E * A) / L) * v * w;
        }
    }
  const scaled = K.map((row, i) => row.map((k, j) => k / Math.sqrt(M[i] * M[j])));
  const all = eigenvalues(scaled).map((w2) => Math.sqrt(Math.max(w2, 0)) / (2 * Math.PI));
  return all.filter((f) => f > 1e-4 * Math.max(...all)); // a chain moves sideways freely
}
