// Frequencies of a deck by others: out of a listing of Nastran, and by CalculiX on the same model.
import { execFile } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname } from "node:path";

const above = (all, share) => {
  const top = Math.max(...all, 0);
  return all.filter((f) => f > share * top).sort((a, b) => a - b); // those of free bodies are rounding
};

// --- listings

// Of the table of real eigenvalues.
export function frequenciesOf(listing) {
  const begin = listing.search(/R E A L +E I G E N V A L U E S/);
  if (begin < 0) return [];
  const all = [];
  for (const line of listing.slice(begin).split("\n").slice(1, 400)) {
    const m = line.match(/^\s*\d+\s+\d+\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s*$/);
    const isMode = m && Math.abs(Number(m[2]) / (2 * Math.PI * Number(m[3])) - 1) < 1e-3; // radians and cycles
    if (isMode && Number(m[4]) > 0) all.push(Number(m[3]));
    else if (all.length && /E I G E N V E C T O R|S U B C A S E|SUBCASE/.test(line)) break;
  }
  return above(all, 1e-4);
}

const stemOf = (file) => basename(file).replace(/\.[^.]*$/, "").toLowerCase();

// Listings by the stem of their names: the one beside the deck, or the only one of its name.
export class Listings {
  byStem = new Map();

  constructor(files) {
    for (const file of files)
      if (/\.(f06|out)$/i.test(file)) this.byStem.set(stemOf(file), [...(this.byStem.get(stemOf(file)) ?? []), file]);
  }
  of(deck) {
    const all = this.byStem.get(stemOf(deck)) ?? [];
    return all.find((file) => dirname(file) === dirname(deck)) ?? (all.length === 1 ? all[0] : undefined);
  }
}

// --- CalculiX

// Every material weighs something.
export function withDensity(text) {
  if (/^\*DENSITY/im.test(text)) return text;
  const all = [];
  let elastic = false;
  for (const line of [...text.split(/\r?\n/), "*"]) {
    const isKeyword = line.startsWith("*") && !line.startsWith("**");
    if (elastic && isKeyword) all.push("*DENSITY", "1.");
    if (isKeyword) elastic = /^\*ELASTIC\b/i.test(line);
    all.push(line);
  }
  return all.slice(0, -1).join("\n");
}

// The model of a deck, what its first step holds, equations that any step removes, and a step for its frequencies.
function frequencyDeck(text) {
  const lines = text.split(/\r?\n/), first = lines.findIndex((line) => /^\*STEP\b/i.test(line));
  const model = first < 0 ? lines : lines.slice(0, first), held = [], removed = [];
  let into, ended = false;
  for (const line of first < 0 ? [] : lines.slice(first)) {
    ended ||= /^\*END\s*STEP/i.test(line);
    if (line.startsWith("**")) continue;
    if (/^\*BOUNDARY\b/i.test(line) && !ended) (into = held).push("*BOUNDARY");
    else if (/^\*EQUATION\s*,\s*REMOVE/i.test(line)) (into = removed).push("*EQUATION, REMOVE");
    else if (line.startsWith("*")) into = undefined;
    else into?.push(into === held ? line.split(",").slice(0, 3).join(",") : line);
  }
  const before = removed.length > 0 ? ["*STEP", "*STATIC", "*END STEP"] : []; // CalculiX removes in later ones alone
  return [...model, ...held, ...before, "*STEP", "*FREQUENCY", "20", ...removed, "*END STEP", ""].join("\n");
}

function frequenciesIn(file) {
  if (!existsSync(file)) return []; // it solved nothing
  const all = [];
  const table = readFileSync(file, "latin1").split(/E I G E N V A L U E +O U T P U T/)[1] ?? "";
  for (const line of table.split("\n")) {
    const m = line.match(/^\s*\d+\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s*$/);
    if (m && Number(m[3]) > 0) all.push(Number(m[3]));
    else if (all.length && /P A R T I C I P A T I O N/.test(line)) break;
  }
  return above(all, 1e-5);
}

// `job`: a file without its suffix, for as long as it takes; `folder`: where what is included lies.
export const frequenciesOfCalculix = (ccx, text, job, folder, timeout) =>
  new Promise((done) => {
    writeFileSync(job + ".inp", frequencyDeck(text), "latin1");
    execFile(ccx, ["-i", job], { cwd: folder, timeout, maxBuffer: 1e8 }, () => done(frequenciesIn(job + ".dat")));
  });
