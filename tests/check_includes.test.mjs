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

// A tree of three rooms, `upper` and `lower/nested` on `lower`; files as path: included paths.
function tree(files, t) {
  const root = mkdtempSync(join(tmpdir(), 'plica-includes-'));
  t.after(() => rmSync(root, { recursive: true }));
  writeFileSync(join(root, 'rooms.txt'),
    'lower plica::lower Eigen3::Eigen\nlower/nested plica::nested plica::lower\nupper plica::upper plica::lower\n');
  for (const folder of ['lower', 'lower/nested', 'upper', 'app', 'mesher', 'engine']) mkdirSync(join(root, folder, 'inner'), { recursive: true });
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
