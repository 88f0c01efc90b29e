// Two folders of results, number by number: what differs by more than rounding is printed.
//
//   node tests/same_results.mjs BEFORE AFTER [relative difference, 1e-9] [absolute, 1e-12]
//
// Times, memory, versions and hashes of files are left out. Of the report its words and numbers are
// compared, not the shapes that are drawn; a line that is new or gone is told once.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const [before, after, limit = '1e-9', least = '1e-12'] = process.argv.slice(2);
const changing = /(^|\.)(timing|peak_memory|seconds|version|versions|plica_version|threads|inputs)(\.|$)/;
const leftOut = /^(plica_files\.json|.*\.vtu|.*\.h5|.*\.uff|.*\.png)$/;
let differences = 0;
const say = (text) => {
  if (++differences <= 40) console.log(text);
};

const numberPattern = /[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?/g;
function sameNumber(a, b, largest) {
  return Math.abs(a - b) <= Math.max(Number(least),
    Number(limit) * Math.max(Math.abs(a), Math.abs(b), largest));
}

function sameText(where, a, b) {
  if (a === b) return;
  if (a.replace(numberPattern, '#') !== b.replace(numberPattern, '#')) {
    const i = [...a].findIndex((letter, k) => letter !== b[k]);
    return say(`${where}: "${a.slice(Math.max(0, i - 30), i + 30)}" is now "${b.slice(Math.max(0, i - 30), i + 30)}"`);
  }
  const x = a.match(numberPattern).map(Number), y = b.match(numberPattern).map(Number);
  const k = x.findIndex((value, i) => !sameNumber(value, y[i], 0));
  if (k >= 0) say(`${where}: ${x[k]} is now ${y[k]}`);
}

function same(where, a, b) {
  if (changing.test(where)) return;
  if (typeof a !== typeof b || (a === null) !== (b === null)) return say(`${where}: ${a} is now ${b}`);
  if (typeof a === 'number') return sameNumber(a, b, 0) || say(`${where}: ${a} is now ${b}`);
  if (typeof a === 'string') return sameText(where, a, b);
  if (typeof a !== 'object' || a === null) return a === b || say(`${where}: ${a} is now ${b}`);
  if (Array.isArray(a) && a.every((x) => typeof x === 'number') && Array.isArray(b)) {
    const largest = Math.max(...a.map(Math.abs)); // of a vector its largest number is the measure
    if (a.length !== b.length) return say(`${where}: ${a.length} numbers are now ${b.length}`);
    const k = a.findIndex((x, i) => !sameNumber(x, b[i], largest));
    return k < 0 || say(`${where}[${k}]: ${a[k]} is now ${b[k]}`);
  }
  for (const key of new Set([...Object.keys(a), ...Object.keys(b)]))
    if (!(key in a)) say(`${where}.${key} is new`);
    else if (!(key in b)) say(`${where}.${key} is gone`);
    else same(`${where}.${key}`, a[key], b[key]);
}

// Lines in their order; one that has no counterpart within the next few is new or gone.
function sameLines(name, before, after) {
  const pattern = (line) => line.replace(numberPattern, '#');
  const a = before.split('\n'), b = after.split('\n');
  const near = 6;
  for (let i = 0, j = 0; i < a.length || j < b.length; ++i, ++j) {
    const same = (x, y) => x !== undefined && y !== undefined && pattern(x) === pattern(y);
    if (!same(a[i], b[j])) {
      const added = b.slice(j, j + near).findIndex((line) => same(a[i], line));
      const gone = a.slice(i, i + near).findIndex((line) => same(line, b[j]));
      if (added > 0) for (; !same(a[i], b[j]); ++j) say(`${name}:${j + 1} is new: ${b[j].trim()}`);
      else if (gone > 0) for (; !same(a[i], b[j]); ++i) say(`${name}:${i + 1} is gone: ${a[i].trim()}`);
    }
    sameText(`${name}:${j + 1}`, a[i] ?? '', b[j] ?? '');
  }
}

const wordsOf = (html) =>
  html.replace(/<(script|style|svg)[\s\S]*?<\/\1>/g, '').replace(/<[^>]*>/g, ' ')
    .replace(/Time and memory[\s\S]*/, '').replace(/\d+(\.\d+)? (s|GB|MB)\b/g, '');
const names = new Set([...readdirSync(before), ...readdirSync(after)]);
for (const name of [...names].filter((file) => !leftOut.test(file)).sort()) {
  let a, b;
  try {
    [a, b] = [before, after].map((folder) => readFileSync(join(folder, name), 'utf8'));
  } catch {
    say(`${name} is in one of the folders alone`);
    continue;
  }
  if (name.endsWith('.json')) same(name, JSON.parse(a), JSON.parse(b));
  else if (name.endsWith('.html')) sameLines(name, wordsOf(a), wordsOf(b));
  else sameLines(name, a, b);
}
console.log(`${names.size} files, ${differences} differences beyond ${limit}`);
process.exit(differences > 0 ? 1 : 0);
