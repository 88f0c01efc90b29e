// Ctrl-C in a local fit leaves the best design so far, and every step was said.
//
//   node --test interrupted_fit.test.mjs   with  PLICA (the program), CASE (the tutorial), WORK
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

// Fits the case locally and interrupts it when it has made a step.
function interrupted(out) {
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  return new Promise((resolve) => {
    const fit = spawn(process.env.PLICA, ['fit', process.env.CASE, '--out', out]);
    let said = '';
    let sent = false;
    fit.stderr.on('data', (data) => {
      said += data;
      if (!sent && said.includes('step 1, ')) {
        sent = true;
        fit.kill('SIGINT');
      }
    });
    fit.stdout.resume();
    fit.on('close', (code) => resolve({ code, said }));
  });
}

test('the best design so far is written, not the start', async () => {
  const out = process.env.WORK;
  const { code, said } = await interrupted(out);
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
