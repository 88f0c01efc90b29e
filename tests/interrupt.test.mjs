// Ctrl-C and SIGTERM leave what was finished, say so, and corrupt nothing.
//
//   node --test interrupt.test.mjs   with  PLICA (the program), CASE (pipe A2), WORK (a folder)
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

// Runs the case and interrupts it when its progress says a word.
function interrupted(word, out, signal = 'SIGINT') {
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  return new Promise((resolve) => {
    const run = spawn(process.env.PLICA, ['run', process.env.CASE, '--out', out]);
    let said = '';
    let sent = false;
    run.stderr.on('data', (data) => {
      said += data;
      if (!sent && said.includes(word)) {
        sent = true;
        run.kill(signal);
      }
    });
    run.stdout.resume();
    run.on('close', (code) => resolve({ code, said }));
  });
}

test('in the variants: the run is written, and says what is left out', async () => {
  const out = join(process.env.WORK, 'late');
  const { code, said } = await interrupted('height 7 mm', out);
  assert.equal(code, 130, said);
  assert.match(said, /\d+ %, \d+ s left/);
  const results = JSON.parse(readFileSync(join(out, 'results.json'), 'utf8'));
  assert.ok(results.modes.length >= 12);
  assert.ok(results.warnings.some((w) => w.includes('stopped by Ctrl-C')));
  assert.match(readFileSync(join(out, 'report.html'), 'utf8'), /stopped by Ctrl-C/);
  assert.deepEqual(readdirSync(out).filter((name) => name.includes('tmp')), []);
});

test('before the run is finished: nothing is written', async () => {
  const out = join(process.env.WORK, 'early');
  const { code, said } = await interrupted('mesh', out);
  assert.equal(code, 130, said);
  assert.match(said, /no file was written/);
  assert.ok(!existsSync(join(out, 'results.json')));
  assert.deepEqual(readdirSync(out), []);
});

test('SIGTERM is as Ctrl-C, with its own exit code', async () => {
  const out = join(process.env.WORK, 'terminated');
  const { code, said } = await interrupted('mesh', out, 'SIGTERM');
  assert.equal(code, 143, said);
  assert.match(said, /no file was written/);
  assert.deepEqual(readdirSync(out), []);
});

// The mesher of this test never ends by itself; it says in a file that it runs.
test('a file of geometry that is being meshed is given up at once', async () => {
  for (const [signal, expected] of [['SIGINT', 130], ['SIGTERM', 143]]) {
    const folder = join(process.env.WORK, signal);
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
    const pid = join(folder, 'pid');
    writeFileSync(join(folder, 'mesher'), `#!/bin/sh\necho $$ > ${pid}.new; mv ${pid}.new ${pid}\nexec sleep 1000\n`, { mode: 0o755 });
    writeFileSync(join(folder, 'a.stl'), 'solid a\nendsolid a\n');
    writeFileSync(join(folder, 'a.yaml'), `case: a
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850 kg/m3}}
parts: {a: {type: surface, material: steel, thickness: 1 mm, file: a.stl, unit: 1 mm, element_size: 5 mm}}
analyses: {static: false, modes: {count: 2}}
`);
    const run = spawn(process.env.PLICA, ['run', join(folder, 'a.yaml'), '--out', join(folder, 'out')], {
      env: { ...process.env, PLICA_MESHER: join(folder, 'mesher') },
    });
    let said = '';
    run.stderr.on('data', (data) => (said += data));
    run.stdout.resume();
    const closed = new Promise((resolve) => run.on('close', resolve));
    while (!existsSync(pid)) await new Promise((resolve) => setTimeout(resolve, 5));
    const worker = Number(readFileSync(pid, 'utf8'));
    run.kill(signal);
    assert.equal(await closed, expected, said);
    assert.match(said, /stopped before "a.stl"; no file was written/);
    assert.throws(() => process.kill(worker, 0), { code: 'ESRCH' });
    assert.deepEqual(readdirSync(join(folder, 'out')), []);
  }
});
