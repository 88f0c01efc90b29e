// How many decks of a folder are read, and what bars the others.
//
//   node tests/decks/study.mjs PLICA FOLDER [--half a|b|both] [--list] [--seconds 20]
//        [--references FOLDER] [--calculix ccx] [--light] [--code abaqus|nastran]
//
// Every deck below FOLDER (.inp .bdf .dat .nas .fem; the same text once, whatever its blanks) becomes
// the only part of a case, which PLICA checks with what it does by default. The halves go by a hash of the path, so
// that one can be set apart unread. --list prints a line per deck: half, code, kinds, verdict, file.
// --light leaves away decks that hold other elements than these.
// --references runs what is read and has a listing of Nastran with a table of real eigenvalues, of
// the name of the deck beside it, or alone of that name below that folder: each of its five lowest frequencies has to have one of
// the twelve lowest of PLICA within 1 %. --calculix does so with Abaqus decks beside CalculiX, on the
// same model with what its first step holds, in a step of *FREQUENCY; where no material has a
// density all have that of 1, in a copy beside the deck for as long as it takes.
import { createHash } from "node:crypto";
import { execFile } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join, relative, resolve } from "node:path";

const [plica, given, ...options] = process.argv.slice(2);
const folder = resolve(given);
const option = (name, otherwise) =>
  options.includes(name) ? options[options.indexOf(name) + 1] : otherwise;
const wanted = option("--half", "both");
const seconds = Number(option("--seconds", 20));

// Kinds of elements that a deck of shells, beams, masses, springs and rigid elements may hold.
const light = {
  abaqus: /^(S3|S3R|S4|S4R|S4R5|S6|S8|S8R|S8R5|STRI3|STRI65|B2[123]H?|B3[123](R|H|OS|OSH)?|T[23]D[23]|MASS|ROTARYI|SPRING[12A]|DCOUP3D|DASHPOT[12A]|M3D[346]|U1|R3D[34]|RB3D2)$/,
  nastran: /^(CQUAD4|CQUADR|CQUAD8|CTRIA3|CTRIAR|CTRIA6|CBAR|CBEAM|CROD|CONROD|CTUBE|CONM[12]|CMASS[1-4]|CELAS[1-4]|CBUSH|CBUSH1D|CSHEAR|CVISC|CDAMP[1-5]|CQUAD[12]|CTRIA[12]|CQDPLT|CTRPLT|CTRBSC|CQDMEM[12]?|CTRMEM|CSHEAR|CTWIST|CONM[12]|CBEND)$/,
};
const nastranElement = /^C(ONM|ONROD|QUAD|TRI|BAR|BEAM|ROD|TUBE|MASS|ELAS|BUSH|SHEAR|VISC|DAMP|QD|TR|HEXA|TETRA|PENTA|PYRA|HBDY|AERO|IHEX|WEDGE|BEND|FAST|WELD|GAP|FLUID|SLOT|AXIF|CONEAX|HEXA|TWIST|HACA|HACB|INTC|RAC|TORDRG|TRAPRG|TRIARG|TRIAAX|TRAPAX|QUADX|TRIAX|IS2D8|PLST|PLSN|DUM|BARAO|BUTT|SEAM|RIVET|EQUADF|SLOT)/;
const notElement = /^(CORD|CTRIAX6$)/;

function kindsOf(code, text) {
  const counts = {};
  const add = (name, n = 1) => (counts[name] = (counts[name] ?? 0) + n);
  if (code === "nastran") {
    const begin = text.search(/^\s*BEGIN/im);
    for (const line of text.slice(begin < 0 ? 0 : begin).split("\n")) {
      const name = line.slice(0, 8).split(",")[0].trim().replace("*", "").toUpperCase();
      if (nastranElement.test(name) && !notElement.test(name) && !/^(CAERO|CTRIAX)/.test(name)) add(name);
      if (/^CTRIAX/.test(name)) add(name);
    }
  } else {
    let type = null;
    for (const line of text.split("\n")) {
      if (line.startsWith("**")) continue;
      if (line.startsWith("*")) {
        type = /^\*ELEMENT\s*,/i.test(line) ? (line.match(/TYPE\s*=\s*([^,\s]+)/i)?.[1] ?? "?").toUpperCase() : null;
      } else if (type) add(type);
    }
  }
  return counts;
}

function* decksBelow(path) {
  for (const name of readdirSync(path).sort()) {
    const file = join(path, name);
    if (statSync(file).isDirectory()) yield* decksBelow(file);
    else if (/\.(inp|bdf|dat|nas|fem)$/i.test(name) && statSync(file).size < 20e6) yield file;
  }
}

const decks = [];
const seen = new Set();
for (const file of decksBelow(folder)) {
  const text = readFileSync(file, "latin1");
  const hash = createHash("md5").update(text.replace(/\s+/g, " ")).digest("hex");
  if (seen.has(hash)) continue;
  seen.add(hash);
  const code = /\.inp$/i.test(file) && !/^\s*(BEGIN\s+BULK|CEND)/im.test(text) ? "abaqus" : "nastran";
  if (code === "nastran" ? !/^\s*GRID/im.test(text) : !/^\*NODE\b(?!\s*(PRINT|FILE|OUTPUT))/im.test(text)) continue;
  const kinds = kindsOf(code, text);
  if (Object.keys(kinds).length === 0) continue;
  const path = relative(folder, file);
  const half = parseInt(createHash("md5").update(path).digest("hex")[0], 16) % 2 ? "b" : "a";
  if (wanted !== "both" && half !== wanted) continue;
  const isLight = Object.keys(kinds).every((k) => light[code].test(k));
  if (options.includes("--light") && !isLight) continue;
  if (option("--code", code) !== code) continue;
  decks.push({ file, path, code, kinds, half, light: isLight });
}

const scratch = mkdtempSync(join(tmpdir(), "decks-"));
const caseOf = (deck, modes) =>
  `case: deck\nparts:\n  all: {type: deck, file: ${JSON.stringify(deck.heavy ?? deck.file)}, length_unit: 1 m, mass_unit: 1 kg}\n` +
  `analyses: {static: false, modes: {count: ${modes}}}\n`;
const check = (deck, number) =>
  new Promise((done) => {
    const name = join(scratch, `${number}.yaml`);
    writeFileSync(name, caseOf(deck, 1));
    execFile(plica, ["check", name], { timeout: seconds * 1000, maxBuffer: 1e8 }, (error, out, err) => {
      deck.text = out + err;
      deck.code_of_exit = error ? (error.killed ? "time" : (error.code ?? error.signal)) : 0;
      done();
    });
  });

// --- agreement with listings

function* filesBelow(path) {
  for (const name of readdirSync(path).sort()) {
    const file = join(path, name);
    if (statSync(file).isDirectory()) yield* filesBelow(file);
    else yield file;
  }
}

// Frequencies above 1e-4 of the highest: those of free bodies are rounding.
function frequenciesOf(listing) {
  const begin = listing.search(/R E A L +E I G E N V A L U E S/);
  if (begin < 0) return [];
  const all = [];
  for (const line of listing.slice(begin).split("\n").slice(1, 400)) {
    const m = line.match(/^\s*\d+\s+\d+\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s*$/);
    if (m && Number(m[4]) > 0) all.push(Number(m[3]));
    else if (all.length && /E I G E N V E C T O R|S U B C A S E|SUBCASE/.test(line)) break;
  }
  const top = Math.max(...all, 0);
  return all.filter((f) => f > 1e-4 * top).sort((a, b) => a - b);
}

// Listings by the stem of their names: the one beside the deck, or the only one of its name.
const listings = new Map();
const stemOf = (file) => basename(file).replace(/\.[^.]*$/, "").toLowerCase();
if (options.includes("--references"))
  for (const file of filesBelow(option("--references")))
    if (/\.(f06|out)$/i.test(file)) listings.set(stemOf(file), [...(listings.get(stemOf(file)) ?? []), file]);
function listingOf(deck) {
  const all = listings.get(stemOf(deck.file)) ?? [];
  const beside = all.filter((file) => dirname(file) === dirname(deck.file));
  return beside[0] ?? (all.length === 1 ? all[0] : undefined);
}

// --- agreement with CalculiX

// Every material weighs something.
function withDensity(text) {
  if (/^\*DENSITY/im.test(text)) return text;
  const all = [];
  let elastic = false;
  for (const line of [...text.split(/\r?\n/), "*"]) {
    if (elastic && line.startsWith("*") && !line.startsWith("**")) all.push("*DENSITY", "1.");
    if (line.startsWith("*") && !line.startsWith("**")) elastic = /^\*ELASTIC\b/i.test(line);
    all.push(line);
  }
  return all.slice(0, -1).join("\n");
}

// The model of a deck, what its first step holds, and its frequencies.
function frequencyDeck(text) {
  const lines = text.split(/\r?\n/), first = lines.findIndex((line) => /^\*STEP\b/i.test(line));
  const model = first < 0 ? lines : lines.slice(0, first), held = [];
  let inside = false;
  for (const line of first < 0 ? [] : lines.slice(first)) {
    if (/^\*END\s*STEP/i.test(line)) break;
    if (line.startsWith("**")) continue;
    if (line.startsWith("*")) {
      inside = /^\*BOUNDARY\b/i.test(line);
      if (inside) held.push("*BOUNDARY");
    } else if (inside) held.push(line.split(",").slice(0, 3).join(","));
  }
  return [...model, ...held, "*STEP", "*FREQUENCY", "20", "*END STEP", ""].join("\n");
}

const calculix = option("--calculix", "");
const frequenciesOfCalculix = (deck, number) =>
  new Promise((done) => {
    const name = join(scratch, `ccx${number}`);
    writeFileSync(name + ".inp", frequencyDeck(readFileSync(deck.heavy ?? deck.file, "latin1")), "latin1");
    const settings = { cwd: dirname(deck.file), timeout: 3 * seconds * 1000, maxBuffer: 1e8 };
    execFile(calculix, ["-i", name], settings, () => {
      let all = [];
      try {
        const table = readFileSync(name + ".dat", "latin1").split(/E I G E N V A L U E +O U T P U T/)[1] ?? "";
        for (const line of table.split("\n")) {
          const m = line.match(/^\s*\d+\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s*$/);
          if (m && Number(m[3]) > 0) all.push(Number(m[3]));
          else if (all.length && /P A R T I C I P A T I O N/.test(line)) break;
        }
      } catch { /* it solved nothing */ }
      const top = Math.max(...all, 0);
      done(all.filter((f) => f > 1e-5 * top).sort((a, b) => a - b));
    });
  });

async function theirFrequencies(deck, number) {
  const listing = listingOf(deck);
  if (listing) return frequenciesOf(readFileSync(listing, "latin1"));
  if (!calculix || deck.code !== "abaqus" || deck.code_of_exit !== 0 || !deck.light) return [];
  const text = readFileSync(deck.file, "latin1"), heavy = withDensity(text);
  if (heavy !== text) {
    deck.heavy = join(dirname(deck.file), `with_density_${number}.inp`);
    writeFileSync(deck.heavy, heavy, "latin1");
  }
  return frequenciesOfCalculix(deck, number);
}

const compare = async (deck, number) => {
  const theirs = (await theirFrequencies(deck, number)).slice(0, 5);
  await ours(deck, number, theirs);
  if (deck.heavy) rmSync(deck.heavy);
};

const ours = (deck, number, theirs) =>
  new Promise((done) => {
    if (deck.code_of_exit !== 0 || !deck.light || theirs.length === 0) return done();
    const name = join(scratch, `${number}.yaml`), out = join(scratch, `${number}`);
    writeFileSync(name, caseOf(deck, 12));
    execFile(plica, ["run", name, "--out", out, "--quiet"], { timeout: 3 * seconds * 1000, maxBuffer: 1e8 }, (error, text, err) => {
      deck.compared = true;
      try {
        const found = JSON.parse(readFileSync(join(out, "results.json"), "utf8")).modes.map((m) => m.frequency);
        const miss = theirs.map((f) => found.reduce((best, x) => Math.min(best, Math.abs(x / f - 1)), Infinity));
        deck.worst = Math.max(...miss);
        deck.lowest = [theirs[0], found.find((x) => x > 1e-3 * theirs[0])];
      } catch {
        deck.worst = Infinity;
        deck.text = (error ? text + err : "").slice(0, 500);
      }
      done();
    });
  });

async function twoAtATime(work) {
  let next = 0;
  const worker = async () => {
    while (next < decks.length) await work(decks[next], next++);
  };
  await Promise.all([worker(), worker()]);
}
await twoAtATime(check);
if (listings.size > 0 || calculix) await twoAtATime(compare);
rmSync(scratch, { recursive: true });

const share = (part, whole) => `${part} of ${whole}` + (whole ? ` (${((100 * part) / whole).toFixed(0)} %)` : "");
for (const code of ["abaqus", "nastran"])
  for (const half of ["a", "b"]) {
    const all = decks.filter((d) => d.code === code && d.half === half);
    if (all.length === 0) continue;
    const own = all.filter((d) => d.light);
    const read = (list) => list.filter((d) => d.code_of_exit === 0).length;
    const whole = own.filter((d) => !/has no stiffness|has no \*|there is no (material|PSHELL|property|PROD|PBUSH)|there is no file/.test(d.text ?? ""));
    console.log(`${code} half ${half}: ${all.length} decks, read ${share(read(all), all.length)}; ` +
      `of shells, beams, masses, springs alone ${own.length}, read ${share(read(own), own.length)}; ` +
      `of those with all their materials, properties and files ${share(read(whole), whole.length)}`);
    const compared = own.filter((d) => d.compared);
    if (compared.length)
      console.log(`  frequencies within 1 % of their reference: ${share(compared.filter((d) => d.worst <= 0.01).length, compared.length)}`);
    const odd = all.filter((d) => ![0, 1].includes(d.code_of_exit));
    if (odd.length) console.log(`  neither read nor refused: ${odd.map((d) => d.path + " " + d.code_of_exit).join(", ")}`);
  }
if (options.includes("--list"))
  for (const d of decks)
    console.log([d.half, d.code, d.light ? "light" : "other", d.code_of_exit, d.path,
      d.compared ? `worst ${d.worst} lowest ${d.lowest}` : "", d.code_of_exit || d.worst === Infinity ? d.text.replaceAll("\n", " | ").slice(0, 1200) : ""].join("\t"));
