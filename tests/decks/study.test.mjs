// The tools of the study of decks, on decks of a few lines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { isLight, kindsOf } from "./deck_kinds.mjs";
import { finerDeck } from "./finer_deck.mjs";
import { reasonOf, reasonOfListing, withDiameters } from "./reasons.mjs";
import { frequenciesOf, withDensity } from "./references.mjs";
import { trussFrequencies } from "./trusses.mjs";

const plate = `*NODE, NSET=ALL
1, 0, 0
2, 2, 0
3, 2, 1
4, 0, 1
*ELEMENT, TYPE=S4, ELSET=WALL
1, 1, 2, 3, 4
*NSET, NSET=ROOT
1, 4
*NODAL THICKNESS
1, 1.
2, 3.
3, 3.
4, 1.
*MATERIAL, NAME=M
*ELASTIC
1., 0.3
*SHELL SECTION, ELSET=WALL, MATERIAL=M, NODAL THICKNESS
1.
*BOUNDARY
ROOT, 1, 6
`;
const rod = (ends) => `*NODE\n1, 0\n2, 1\n3, 2\n*ELEMENT, TYPE=T3D2, ELSET=E\n${ends}` +
  "*MATERIAL, NAME=M\n*ELASTIC\n4.\n" +
  "*DENSITY\n1.\n*SOLID SECTION, ELSET=E, MATERIAL=M\n5.\n*BOUNDARY\n1, 1, 3\n2, 2, 3\n3, 2, 3\n";

const below = (text, keyword) => text.slice(text.indexOf(keyword)).split("\n").slice(1)
  .reduce((all, line) => (all.done || line.startsWith("*") ? { ...all, done: true } : { lines: [...all.lines, line] }),
    { lines: [] }).lines;
const count = (text, pattern) => text.match(pattern)?.length ?? 0;

test("a shell becomes one of eight nodes, then four, held where its edge is", () => {
  const same = finerDeck(plate, 0), halved = finerDeck(plate, 1);
  assert.equal(count(same, /TYPE=S8R/g), 1);
  assert.equal(below(same, "*NODE,").length, 8);
  assert.equal(count(halved, /TYPE=S8R/g), 4);
  assert.equal(below(halved, "*NODE,").length, 21);
  assert.equal(below(halved, "*BOUNDARY").filter((line) => line).length, 5 * 6); // five nodes of the edge
  const thickness = below(halved, "*NODAL THICKNESS").map((line) => line.split(",").map(Number));
  const places = new Map(below(halved, "*NODE,").map((line) => line.split(",").map(Number)).map(([n, x]) => [n, x]));
  for (const [node, t] of thickness) assert.ok(Math.abs(t - (1 + places.get(node))) < 1e-12);
  assert.throws(() => finerDeck("*PART, NAME=A\n" + plate, 0), /PART/);
});

test("trusses alone are summed up as masses and springs", () => {
  const two = trussFrequencies(rod("1, 1, 2\n2, 2, 3\n")); // w = 2 c sin((2 k - 1) pi / 8), c = 2
  for (const k of [0, 1]) {
    const closed = (2 * Math.sin(((2 * k + 1) * Math.PI) / 8)) / Math.PI;
    assert.ok(Math.abs(two[k] / closed - 1) < 1e-12);
  }
  assert.equal(trussFrequencies(plate), undefined);
});

test("a radius alone is a diameter in CalculiX", () => {
  const text = "*BEAM SECTION, ELSET=A, MATERIAL=M, SECTION=CIRC\n2.5\n0, 1, 0\n";
  assert.match(withDiameters(text), /\n5\n/);
  assert.equal(withDiameters(text.replace("2.5", "2., 3.")), text.replace("2.5", "2., 3."));
});

test("a reason is said with what the nets say of it", async () => {
  const gaps = [0.2, 0.05, 0.008];
  const by = await reasonOf(plate, 0.3, [], 0.01, async () => gaps.shift());
  assert.deepEqual(by, { kind: "within 1 % on a finer net of S8R, S6, B32R", gaps: "30 %, 20 %, 5.0 %, 0.80 %" });
  assert.equal((await reasonOf(plate, 0.3, [], 0.01, async () => 0.3)).kind, "not by the net");
  assert.equal((await reasonOf(plate, 0.3, [], 0.01, async () => undefined)).kind, "not solved on finer nets");
  assert.equal(reasonOfListing("SOL 103\nASET,1,123\n", [1]).kind, "a listing of a model reduced to a few points");
  assert.equal(reasonOfListing("SOL 103\n", [1]), undefined);
});

test("of a listing the lines of modes count", () => {
  const mode = (n, hertz) => ` ${n} ${n} ${(2 * Math.PI * hertz) ** 2} ${2 * Math.PI * hertz} ${hertz} 1.0 5.0\n`;
  const listing = "R E A L   E I G E N V A L U E S\n" + mode(1, 3) + mode(2, 7) + " 3 3 4.0 5.0 2.0 1.0 0.0\n";
  assert.deepEqual(frequenciesOf(listing), [3, 7]);
});

test("decks are told apart by what they hold", () => {
  assert.deepEqual(kindsOf("a.inp", plate), { code: "abaqus", kinds: { S4: 1 } });
  const nastran = kindsOf("a.bdf", "GRID,1\nCHEXA,1\nCQUAD4,2\nCORD2R,1\n");
  assert.deepEqual(nastran, { code: "nastran", kinds: { CHEXA: 1, CQUAD4: 1 } });
  assert.ok(!isLight("nastran", nastran.kinds) && isLight("abaqus", { S4: 1 }));
  assert.match(withDensity(plate), /\*ELASTIC\n1., 0.3\n\*DENSITY\n1.\n/);
});
