// The rule of includes: a room includes itself and the rooms that its CMake target links, and neither
// folders nor files include each other in a ring. Programs, their libraries and tests are held to what
// the targets of their folder link, all together. Prints every breach.
//
//   node tests/check_includes.mjs SOURCES BUILD     BUILD/rooms.txt is written by CMake
//
// Not held: which of a folder's targets includes what; rings within tests/; tests/consumer, a project
// of its own; headers of other libraries, in angle brackets.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';

const [sources, build] = process.argv.slice(2);
const above = ['app', 'mesher', 'engine', 'bench', 'tests', 'tests/sealed']; // no rooms
const leftOut = ['tests/consumer'];

// Targets with their folder and what they link: of rooms as CMake says, of what stands above them as
// their CMakeLists.txt does, built or not.
function allTargets() {
  const targets = new Map();
  for (const line of readFileSync(join(build, 'rooms.txt'), 'utf8').trim().split('\n')) {
    const [folder, target, ...links] = line.split(' ');
    targets.set(target, { folder, links });
  }
  for (const folder of above) {
    const text = readFileSync(join(sources, folder, 'CMakeLists.txt'), 'utf8').replace(/#.*/g, '');
    let loop = '', each = [];
    for (const [, command, list] of text.matchAll(/\b(foreach|add_library|add_executable|target_link_libraries)\s*\(([^)]*)\)/g)) {
      const [first, ...words] = list.trim().split(/\s+/);
      if (command === 'foreach') [loop, each] = [`\${${first}}`, words];
      else if (command !== 'target_link_libraries') targets.set(first, { folder, links: [] });
      else for (const target of first === loop ? each : [first]) targets.get(target).links.push(...words);
    }
  }
  return targets;
}

// Folders, each with those that it may include: its own, and what its targets link, and what that
// links.
function foldersOf(targets) {
  const reach = new Map();
  const reached = (name) => {
    if (!reach.has(name)) {
      const { folder, links } = targets.get(name);
      const below = links.filter((link) => targets.has(link)).flatMap((link) => [...reached(link)]);
      reach.set(name, new Set([folder, ...below]));
    }
    return reach.get(name);
  };
  const folders = new Map();
  for (const [name, { folder }] of targets)
    folders.set(folder, new Set([...(folders.get(folder) ?? []), ...reached(name)]));
  return folders;
}

function* filesBelow(folder) {
  for (const entry of readdirSync(join(sources, folder), { withFileTypes: true })) {
    const path = `${folder}/${entry.name}`;
    if (leftOut.includes(path)) continue;
    if (entry.isDirectory()) yield* filesBelow(path);
    else if (/\.[ch]pp$/.test(entry.name)) yield path;
  }
}

// Rings of a graph, each once, as the list of its members (Tarjan's strongly connected components).
function ringsOf(graph) {
  const order = new Map(), low = new Map(), stack = [], rings = [];
  const visit = (node) => {
    order.set(node, order.size);
    low.set(node, order.get(node));
    stack.push(node);
    for (const next of graph.get(node) ?? []) {
      if (!order.has(next)) visit(next);
      if (stack.includes(next)) low.set(node, Math.min(low.get(node), low.get(next)));
    }
    if (low.get(node) !== order.get(node)) return;
    const ring = stack.splice(stack.indexOf(node));
    if (ring.length > 1) rings.push(ring.sort());
  };
  for (const node of graph.keys()) if (!order.has(node)) visit(node);
  return rings;
}

const allowed = foldersOf(allTargets());
// Of nested ones the inner one.
const byDepth = [...allowed.keys()].sort((a, b) => b.length - a.length);
const holding = (path) => byDepth.find((folder) => path.startsWith(`${folder}/`));
// As a compiler looks: beside the file first.
const found = (path, included) => {
  const beside = join(dirname(path), included);
  return existsSync(join(sources, beside)) ? beside : included;
};
const unit = (path) => path.replace(/\.[ch]pp$/, ''); // a header and its source are one
const files = new Map(), folders = new Map(), breaches = [];
let count = 0;
const edge = (graph, from, to) => {
  if (from === to) return;
  if (!graph.has(from)) graph.set(from, new Set());
  graph.get(from).add(to);
};

for (const top of new Set([...allowed.keys()].map((folder) => folder.split('/')[0])))
  for (const path of filesBelow(top)) {
    const own = holding(path);
    readFileSync(join(sources, path), 'utf8').split('\n').forEach((line, i) => {
      const written = /^#include "([^"]+)"/.exec(line)?.[1];
      if (!written) return;
      const included = found(path, written);
      count += 1;
      if (top !== 'tests') {
        edge(files, unit(path), unit(included));
        edge(folders, dirname(path), dirname(included));
      }
      const other = holding(included);
      if (own && !allowed.get(own).has(other))
        breaches.push(`${path}:${i + 1}: ${own} does not link ${other ?? 'any room'}: ${included}`);
    });
  }
for (const ring of ringsOf(files)) breaches.push(`files in a ring: ${ring.join(', ')}`);
for (const ring of ringsOf(folders)) breaches.push(`folders in a ring: ${ring.join(', ')}`);

console.log(`${allowed.size} folders that link, ${count} includes`);
for (const breach of breaches) console.log(breach);
process.exit(breaches.length > 0 || count === 0 ? 1 : 0);
