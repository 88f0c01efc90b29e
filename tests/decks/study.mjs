// How many decks of a folder are read, what bars the others, and how near those that are read lie to others.
//
//   node tests/decks/study.mjs PLICA FOLDER [--half a|b|both] [--list] [--seconds 20]
//        [--references FOLDER] [--calculix ccx] [--light] [--code abaqus|nastran] [--only PATTERN]
//
// Every deck below FOLDER (.inp .bdf .dat .nas .fem; the same text once, whatever its blanks) becomes the only
// part of a case, which PLICA checks with what it does by default. The halves go by a hash of the path, so that
// one can be set apart unread. --list prints a line per deck: half, code, kinds, verdict, file.
// --light leaves away decks that hold other elements than shells, beams, masses, springs and rigid ones, --only
// those whose path below FOLDER does not match.
// --references runs what is read and has a listing of Nastran with a table of real eigenvalues, of the name of
// the deck beside it, or alone of that name below that folder: each of its five lowest frequencies has to have
// one of the twelve lowest of PLICA within 1 %. --calculix does so with Abaqus decks beside CalculiX, on the same
// model with what its first step holds, in a step of *FREQUENCY; where no material has a density all have that of
// 1. Those beyond 1 % are computed by both once more (reasons.mjs).
import { createHash } from "node:crypto";
import { execFile } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, relative, resolve } from "node:path";
import { isLight, kindsOf } from "./deck_kinds.mjs";
import { reasonOf, reasonOfListing } from "./reasons.mjs";
import { frequenciesOf, frequenciesOfCalculix, Listings, withDensity } from "./references.mjs";

const [plica, given, ...options] = process.argv.slice(2);
const folder = resolve(given);
const option = (name, otherwise) => (options.includes(name) ? options[options.indexOf(name) + 1] : otherwise);
const wanted = option("--half", "both"), calculix = option("--calculix", "");
const patience = 1000 * Number(option("--seconds", 20));
const within = 0.01;

function* filesBelow(path) {
  for (const name of readdirSync(path).sort()) {
    const file = join(path, name);
    if (statSync(file).isDirectory()) yield* filesBelow(file);
    else yield file;
  }
}

const md5 = (text) => createHash("md5").update(text).digest("hex");

function decksBelow(path) {
  const decks = [], seen = new Set();
  for (const file of filesBelow(path)) {
    if (!/\.(inp|bdf|dat|nas|fem)$/i.test(file) || statSync(file).size >= 20e6) continue;
    const text = readFileSync(file, "latin1"), hash = md5(text.replace(/\s+/g, " "));
    const found = seen.has(hash) ? undefined : kindsOf(file, text);
    seen.add(hash);
    if (!found) continue;
    const name = relative(path, file), half = parseInt(md5(name)[0], 16) % 2 ? "b" : "a";
    decks.push({ file, path: name, half, ...found, light: isLight(found.code, found.kinds) });
  }
  return decks.filter((d) => (wanted === "both" || d.half === wanted) && option("--code", d.code) === d.code &&
    (d.light || !options.includes("--light")) && new RegExp(option("--only", "")).test(d.path));
}

const decks = decksBelow(folder), scratch = mkdtempSync(join(tmpdir(), "decks-"));
const listings = new Listings(options.includes("--references") ? filesBelow(option("--references")) : []);

const caseOf = (file, modes) =>
  `case: deck\nparts:\n  all: {type: deck, file: ${JSON.stringify(file)}, length_unit: 1 m, mass_unit: 1 kg}\n` +
  `analyses: {static: false, modes: {count: ${modes}}}\n`;

const plicaSays = (words, timeout) =>
  new Promise((done) =>
    execFile(plica, words, { timeout, maxBuffer: 1e8 }, (error, out, err) =>
      done({ text: out + err, code: error ? (error.killed ? "time" : (error.code ?? error.signal)) : 0 })));

async function check(deck, number) {
  const name = join(scratch, `${number}.yaml`);
  writeFileSync(name, caseOf(deck.file, 1));
  const { text, code } = await plicaSays(["check", name], patience);
  Object.assign(deck, { text, exit: code });
}

// Twelve of a deck, or why there are none.
async function ours(file, job) {
  writeFileSync(`${job}.yaml`, caseOf(file, 12));
  const { text } = await plicaSays(["run", `${job}.yaml`, "--out", job, "--quiet"], 3 * patience);
  try {
    const all = JSON.parse(readFileSync(join(job, "results.json"), "utf8")).modes;
    return { found: all.map((mode) => mode.frequency) };
  } catch {
    return { found: [], why: text.slice(0, 500) };
  }
}

const furthest = (theirs, found) =>
  Math.max(...theirs.map((f) => found.reduce((best, x) => Math.min(best, Math.abs(x / f - 1)), Infinity)));

// The text of a deck in both programs; `beside` the deck, whose folder has what it includes.
async function both(text, beside, job, ofCalculix = text) {
  const own = join(beside, `with_density_${md5(job).slice(0, 8)}.inp`);
  writeFileSync(own, text, "latin1");
  const [theirs, { found, why }] = await Promise.all(
    [frequenciesOfCalculix(calculix, ofCalculix, `${job}c`, beside, 3 * patience), ours(own, job)]);
  rmSync(own);
  return { theirs: theirs.slice(0, 5), found, why };
}

async function compare(deck, number) {
  if (deck.exit !== 0 || !deck.light) return;
  const job = join(scratch, `${number}`), listing = listings.of(deck.file);
  const pair = { theirs: [], found: [] };
  if (listing) {
    pair.theirs = frequenciesOf(readFileSync(listing, "latin1")).slice(0, 5);
    if (pair.theirs.length > 0) Object.assign(pair, await ours(deck.file, job));
  } else if (calculix && deck.code === "abaqus")
    Object.assign(pair, await both(withDensity(readFileSync(deck.file, "latin1")), dirname(deck.file), job));
  if (pair.theirs.length === 0) return;
  deck.compared = true;
  deck.worst = furthest(pair.theirs, pair.found);
  deck.lowest = [pair.theirs[0], pair.found.find((x) => x > 1e-3 * pair.theirs[0])];
  if (pair.why) deck.text = pair.why;
  if (deck.worst <= within) return;
  if (listing) {
    deck.reason = reasonOfListing(readFileSync(deck.file, "latin1"), pair.theirs);
    return;
  }
  const again = async (text, ofCalculix) => {
    const { theirs, found } = await both(withDensity(text), dirname(deck.file), `${job}r`, withDensity(ofCalculix));
    return theirs.length > 0 && found.length > 0 ? furthest(theirs, found) : undefined;
  };
  deck.reason = await reasonOf(readFileSync(deck.file, "latin1"), deck.worst, pair.found, within, again);
}

async function twoAtATime(work) {
  let next = 0;
  const worker = async () => {
    while (next < decks.length) await work(decks[next], next++);
  };
  await Promise.all([worker(), worker()]);
}
await twoAtATime(check);
if (listings.byStem.size > 0 || calculix) await twoAtATime(compare);
rmSync(scratch, { recursive: true });

const share = (part, whole) => `${part} of ${whole}` + (whole ? ` (${((100 * part) / whole).toFixed(0)} %)` : "");
const incomplete = /has no stiffness|has no \*|there is no (material|PSHELL|property|PROD|PBUSH)|there is no file/;

function print(code, half, all) {
  const own = all.filter((d) => d.light), whole = own.filter((d) => !incomplete.test(d.text ?? ""));
  const read = (list) => share(list.filter((d) => d.exit === 0).length, list.length);
  console.log(`${code} half ${half}: ${all.length} decks, read ${read(all)}; ` +
    `of shells, beams, masses, springs alone ${own.length}, read ${read(own)}; ` +
    `of those with all their materials, properties and files ${read(whole)}`);
  const compared = own.filter((d) => d.compared), reasons = new Map();
  if (compared.length)
    console.log("  frequencies within 1 % of their reference: " +
      share(compared.filter((d) => d.worst <= within).length, compared.length));
  for (const { reason } of compared.filter((d) => d.reason))
    reasons.set(reason.kind, (reasons.get(reason.kind) ?? 0) + 1);
  for (const [kind, count] of [...reasons].sort()) console.log(`  beyond, ${kind}: ${count}`);
  const odd = all.filter((d) => ![0, 1].includes(d.exit));
  if (odd.length) console.log(`  neither read nor refused: ${odd.map((d) => d.path + " " + d.exit).join(", ")}`);
}

const lineOf = (d) => [d.half, d.code, d.light ? "light" : "other", d.exit, d.path,
  d.compared ? `worst ${d.worst} lowest ${d.lowest}` : "", d.reason ? `${d.reason.kind}: ${d.reason.gaps}` : "",
  d.exit !== 0 || d.worst === Infinity ? d.text.replaceAll("\n", " | ").slice(0, 1200) : ""].join("\t");

for (const code of ["abaqus", "nastran"])
  for (const half of ["a", "b"]) {
    const all = decks.filter((d) => d.code === code && d.half === half);
    if (all.length > 0) print(code, half, all);
  }
if (options.includes("--list")) for (const d of decks) console.log(lineOf(d));
