// The rule of includes finds what breaks it, and holds in the sources.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const check = join(process.env.SOURCE, 'tests/check_includes.mjs');
const checked = (sources, build) =>
  spawnSync(process.execPath, [check, sources, build], { encoding: 'utf8' });

// A tree of three rooms, `upper` and `lower/nested` on `lower`, and of what stands above them: a
// program on `upper`, a mesher on `lower`, an engine on what it shares with the program, tests on
// all, sealed ones on `lower` alone; files as path: included paths.
const lists = {
  app: 'add_library(shared a.cpp)\ntarget_link_libraries(shared PUBLIC plica::upper)\n' +
    'add_executable(plica main.cpp) # target_link_libraries(plica PRIVATE mesher)\n' +
    'target_link_libraries(plica PRIVATE shared)\n',
  mesher: 'add_library(mesher_text STATIC)\ntarget_link_libraries(mesher_text\n  PRIVATE plica::lower fmt::fmt)\n',
  engine: 'add_executable(plica-mpi main.cpp)\ntarget_link_libraries(plica-mpi PRIVATE shared)\n',
  bench: 'add_executable(bench bench.cpp)\ntarget_link_libraries(bench PRIVATE plica::lower)\n',
  tests: 'add_library(support STATIC a.cpp)\nadd_executable(all b.cpp)\nforeach(one all)\n' +
    '  target_link_libraries(${one} PRIVATE support mesher_text shared)\nendforeach()\n',
  'tests/sealed': 'add_executable(sealed main.cpp)\ntarget_link_libraries(sealed PRIVATE support plica::lower)\n',
};
function tree(files, t) {
  const root = mkdtempSync(join(tmpdir(), 'plica-includes-'));
  t.after(() => rmSync(root, { recursive: true }));
  writeFileSync(join(root, 'rooms.txt'),
    'lower plica::lower Eigen3::Eigen\nlower/nested plica::nested plica::lower\nupper plica::upper plica::lower\n');
  for (const folder of ['lower', 'lower/nested', 'upper', ...Object.keys(lists)])
    mkdirSync(join(root, folder, 'inner'), { recursive: true });
  for (const [folder, list] of Object.entries(lists)) writeFileSync(join(root, folder, 'CMakeLists.txt'), list);
  for (const [path, included] of Object.entries(files))
    writeFileSync(join(root, path), included.map((other) => `#include "${other}"\n`).join(''));
  return checked(root, root);
}

test('holds in the sources', () => {
  const result = checked(process.env.SOURCE, process.env.BUILD);
  assert.equal(result.status, 0, result.stdout);
});

test('passes what goes down', (t) => {
  const result = tree({ 'upper/a.cpp': ['lower/b.hpp'], 'app/main.cpp': ['upper/a.hpp'] }, t);
  assert.equal(result.status, 0, result.stdout);
});

test('prints an include of a room that is not linked', (t) => {
  const result = tree({ 'lower/b.cpp': ['lower/b.hpp', 'upper/a.hpp'] }, t);
  assert.equal(result.status, 1);
  assert.match(result.stdout, /lower\/b\.cpp:2: lower does not link upper: upper\/a\.hpp/);
});

test('takes a nested room for its own', (t) => {
  const down = tree({ 'lower/nested/a.cpp': ['lower/b.hpp'] }, t);
  assert.equal(down.status, 0, down.stdout);
  const across = tree({ 'upper/a.cpp': ['lower/nested/b.hpp'] }, t);
  assert.equal(across.status, 1);
  assert.match(across.stdout, /upper\/a\.cpp:1: upper does not link lower\/nested: lower\/nested\/b\.hpp/);
});

test('holds what stands above the rooms to what its targets link', (t) => {
  const linked = tree({ 'engine/main.cpp': ['app/a.hpp', 'upper/a.hpp'], 'mesher/a.cpp': ['lower/b.hpp'],
    'tests/b.cpp': ['mesher/a.hpp', 'app/a.hpp', 'c.hpp'], 'tests/c.hpp': ['lower/b.hpp'],
    'tests/sealed/main.cpp': ['tests/c.hpp', 'inner/d.hpp'], 'tests/sealed/inner/d.hpp': ['../main.hpp'],
    'tests/sealed/main.hpp': [] }, t);
  assert.equal(linked.status, 0, linked.stdout);
  const unlinked = tree({ 'app/main.cpp': ['mesher/a.hpp'], 'mesher/a.cpp': ['upper/a.hpp'],
    'bench/bench.cpp': ['app/a.hpp'], 'tests/sealed/main.cpp': ['upper/a.hpp'] }, t);
  assert.equal(unlinked.status, 1);
  for (const breach of ['app/main.cpp:1: app does not link mesher', 'mesher/a.cpp:1: mesher does not link upper',
    'bench/bench.cpp:1: bench does not link app', 'tests/sealed/main.cpp:1: tests/sealed does not link upper'])
    assert.ok(unlinked.stdout.includes(breach), unlinked.stdout);
});

test('prints a ring of files, a header and its source being one', (t) => {
  const result = tree({ 'lower/a.hpp': ['lower/b.hpp'], 'lower/b.cpp': ['lower/a.hpp'] }, t);
  assert.equal(result.status, 1);
  assert.match(result.stdout, /files in a ring: lower\/a, lower\/b/);
});

test('prints a ring of folders', (t) => {
  const result = tree({ 'lower/a.cpp': ['lower/inner/b.hpp'], 'lower/inner/c.cpp': ['lower/d.hpp'] }, t);
  assert.equal(result.status, 1);
  assert.match(result.stdout, /folders in a ring: lower, lower\/inner/);
});
