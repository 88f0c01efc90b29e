// The rule of includes: a room includes itself and the rooms that its CMake target links, and neither
// folders nor files include each other in a ring. Prints every breach.
//
//   node tests/check_includes.mjs SOURCES BUILD     BUILD/rooms.txt is written by CMake
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';

const [sources, build] = process.argv.slice(2);

// Rooms by their folder, each with what it may include: what it links, and what that links.
function roomsOf(text) {
  const rooms = text.trim().split('\n').map((line) => line.split(' '));
  const byTarget = new Map();
  for (const [folder, target, ...links] of rooms) {
    const below = links.filter((link) => byTarget.has(link));
    byTarget.set(target, { folder, allowed: new Set([folder]) });
    for (const link of below)
      for (const other of byTarget.get(link).allowed) byTarget.get(target).allowed.add(other);
  }
  return new Map([...byTarget.values()].map((room) => [room.folder, room.allowed]));
}

function* filesBelow(folder) {
  for (const entry of readdirSync(join(sources, folder), { withFileTypes: true })) {
    const path = `${folder}/${entry.name}`;
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

const rooms = roomsOf(readFileSync(join(build, 'rooms.txt'), 'utf8'));
// Of nested rooms the inner one.
const byDepth = [...rooms.keys()].sort((a, b) => b.length - a.length);
const roomOf = (path) => byDepth.find((folder) => path.startsWith(`${folder}/`));
const unit = (path) => path.replace(/\.[ch]pp$/, ''); // a header and its source are one
const files = new Map(), folders = new Map(), breaches = [];
const edge = (graph, from, to) => {
  if (from === to) return;
  if (!graph.has(from)) graph.set(from, new Set());
  graph.get(from).add(to);
};

for (const top of new Set([...rooms.keys(), 'app', 'mesher', 'engine'].map((folder) => folder.split('/')[0])))
  for (const path of filesBelow(top)) {
    const room = roomOf(path);
    readFileSync(join(sources, path), 'utf8').split('\n').forEach((line, i) => {
      const included = /^#include "([^"]+)"/.exec(line)?.[1];
      if (!included) return;
      edge(files, unit(path), unit(included));
      edge(folders, dirname(path), dirname(included));
      const other = roomOf(included);
      if (room && !rooms.get(room).has(other))
        breaches.push(`${path}:${i + 1}: ${room} does not link ${other ?? 'any room'}: ${included}`);
    });
  }
for (const ring of ringsOf(files)) breaches.push(`files in a ring: ${ring.join(', ')}`);
for (const ring of ringsOf(folders)) breaches.push(`folders in a ring: ${ring.join(', ')}`);

console.log(`${rooms.size} rooms, ${files.size} files with includes`);
for (const breach of breaches) console.log(breach);
process.exit(breaches.length > 0 || files.size === 0 ? 1 : 0);
