// Ctrl-C in a search leaves the best so far: the design of a local fit, and every step was said; the
// ledger of a diagnosis.
//
//   node --test interrupted_search.test.mjs   with  PLICA (the program), CASE (the tutorial), WORK
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

// Runs a command on the case and interrupts it once it has said a word.
function interrupted(command, word, out) {
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  return new Promise((resolve) => {
    const search = spawn(process.env.PLICA, [command, process.env.CASE, '--out', out]);
    let said = '';
    let sent = false;
    search.stderr.on('data', (data) => {
      said += data;
      if (!sent && said.includes(word)) {
        sent = true;
        search.kill('SIGINT');
      }
    });
    search.stdout.resume();
    search.on('close', (code) => resolve({ code, said }));
  });
}

test('the best design so far is written, not the start', async () => {
  const out = join(process.env.WORK, 'fit');
  const { code, said } = await interrupted('fit', 'step 1, ', out);
  assert.equal(code, 130, said);
  assert.match(said, /step 0, \d+ evaluations, cost /);
  const fit = JSON.parse(readFileSync(join(out, 'fit.json'), 'utf8'));
  assert.ok(fit.cost.after < fit.cost.before, `${fit.cost.before} to ${fit.cost.after}`);
  assert.notEqual(fit.parameters[0].after, fit.parameters[0].before);
  assert.ok(fit.warnings.some((w) => w.includes('the best values so far')), fit.warnings);
  const designs = readFileSync(join(out, 'designs.csv'), 'utf8').trim().split('\n').slice(1);
  const cells = designs.map((line) => line.split(',').map(Number));
  assert.equal(fit.cost.after, Math.min(...cells.map((c) => c.at(-1))));
  assert.equal(fit.parameters[0].after, cells[0][0]);
  assert.match(readFileSync(join(out, 'fitted.yaml'), 'utf8'), new RegExp(`${cells[0][0]}`));
});

test('a diagnosis says what came nearest, and that it is no more than that', async () => {
  const out = join(process.env.WORK, 'diagnose');
  const { code, said } = await interrupted('diagnose', ': fits', out);
  assert.equal(code, 130, said);
  const diagnosis = JSON.parse(readFileSync(join(out, 'diagnosis.json'), 'utf8'));
  assert.equal(diagnosis.verdict, 'unknown');
  assert.match(diagnosis.headline, /^Stopped before /);
  assert.match(diagnosis.warnings[0], /stopped before all effects were tried/);
  const shares = diagnosis.ledger.rows.map((row) => row.share);
  const sum = shares.reduce((a, b) => a + b, 0);
  assert.ok(Math.abs(sum - 1) < 1e-9, `${sum}`);
});

test('before there is anything to keep, it stops', async () => {
  const out = join(process.env.WORK, 'early');
  const { code, said } = await interrupted('diagnose', 'nominal case', out);
  assert.equal(code, 130, said);
  assert.throws(() => readFileSync(join(out, 'diagnosis.json')));
});
