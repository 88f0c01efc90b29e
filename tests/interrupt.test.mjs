// Ctrl-C leaves what was finished, says so, and corrupts nothing.
//
//   node --test interrupt.test.mjs   with  PLICA (the program), CASE (pipe A2), WORK (a folder)
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

// Runs the case and interrupts it when its progress says a word.
function interrupted(word, out) {
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
        run.kill('SIGINT');
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
