// A run of superelements that writes JSON alone recovers no fields of all nodes: every number is that of
// the run that does.
//
//   node --test shapes_left_out.test.mjs   with  PLICA (the program), SOURCE (the tree), WORK (a folder)
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, runner } from './program.mjs';

const run = runner(300000);
const node = (...args) => spawnSync(process.execPath, args, { encoding: 'utf8', timeout: 300000 });

const line = (at, parts, change = (text) => text, around = 24) => {
  const file = join(at, 'line.yaml');
  const made = node(join(process.env.SOURCE, 'bench/line_case.mjs'), file, `${parts}`, `${around}`);
  assert.equal(made.status, 0, made.stderr);
  const before = readFileSync(file, 'utf8'), after = change(before);
  writeFileSync(file, after);
  return file;
};

const put = (text, what, by) => {
  assert.ok(text.includes(what), what);
  return text.replace(what, by);
};

// The results.json of a run with and of one without the shapes of all nodes, number by number.
const sameNumbers = (at, file, ...options) => {
  for (const [out, ...only] of [['whole'], ['seen', '--only', 'json']]) {
    const { status, said } = run(at, 'run', file, '--out', `all_${out}`, '--quiet', ...only, ...options);
    assert.equal(status, 0, said);
    folder(join(at.slice(process.env.WORK.length + 1), out));
    copyFileSync(join(at, `all_${out}`, 'results.json'), join(at, out, 'results.json'));
  }
  assert.ok(existsSync(join(at, 'all_whole', 'modes.vtu')) && !existsSync(join(at, 'all_seen', 'modes.vtu')));
  const compared = node(join(process.env.SOURCE, 'tests/same_results.mjs'), join(at, 'whole'), join(at, 'seen'), '1e-9', '1e-10');
  assert.equal(compared.status, 0, compared.stdout);
  return JSON.parse(readFileSync(join(at, 'seen', 'results.json'), 'utf8'));
};

test('modes, places and responses of a line, by symmetry', () => {
  const at = folder('line');
  const { modes, responses, verification } = sameNumbers(at, line(at, 7));
  assert.equal(verification.passed, true);
  assert.ok(modes.some((mode) => mode.place), 'no mode is told from another by its part');
  assert.ok(responses[0].peaks.length > 3);
});

test('with liners, losses by part, forces on a set, by the full mesh', () => {
  const at = folder('more');
  const file = line(at, 3, (text) => {
    text = put(text, 'caps:\n', '  liner: {type: interlock, along: bellows_2, attachment: synchronous, mass: 0.1 kg, radius: 60 mm}\ncaps:\n');
    text = put(text, 'damping: {modal: 2 %}', 'damping: {modal: 1 %, loss_factors: [{of: bellows_2, value: 3 %}, {of: liner, value: 1 %}]}');
    text = put(text, 'static: false', 'static: false\n  symmetry: off');
    text = put(text, 'base: [x, y, z],', 'base: [y], forces: [{name: tap, at: pipe_3.right, direction: z}],');
    return put(text, 'band: [1 Hz, 500 Hz]', 'count: 12');
  });
  sameNumbers(at, file);
});

test('the memory that is asked for hardly grows with modes', () => {
  const at = folder('memory');
  const file = line(at, 5, (text) => text, 96);
  const need = (...more) => JSON.parse(run(at, 'check', file, '--json', ...more).printed).estimate.memory;
  const modes = (count) => ['--set', `analyses.modes={count: ${count}}`];
  const grown = (...more) => need(...modes(200), ...more) - need(...modes(20), ...more);
  assert.ok(grown('--only', 'json') > 0 && grown('--only', 'json') < grown() / 3, `${grown('--only', 'json')}, ${grown()}`);
});
