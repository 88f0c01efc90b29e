// The engine over ranks: what `plica run` finds on the full mesh, on 1, 2 and 4 ranks; and what ends
// or refuses a run says so, and leaves no half-written file.
//
//   node --test engine.test.mjs   with  PLICA, ENGINE (the programs), SOURCE (the tree), WORK (a folder)
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { appendFileSync, chmodSync, copyFileSync, existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, runner } from './program.mjs';

const run = runner(600000);
const engine = process.env.ENGINE;
const as = process.getuid?.() === 0 ? ['--allow-run-as-root'] : [];
const mpirun = (...rest) => {
  const { status, stdout, stderr } = spawnSync('mpirun', ['--oversubscribe', ...as, ...rest],
    { cwd: process.env.WORK, encoding: 'utf8', timeout: 600000, maxBuffer: 1e8 });
  return { status, said: stderr, printed: stdout };
};
const over = (ranks, ...rest) => mpirun('-n', `${ranks}`, engine, ...rest);
const results = (path) => JSON.parse(readFileSync(join(path, 'results.json'), 'utf8'));

// A bellows of five convolutions between a held cap and a sprung one.
const bellows = (change = (text) => text) => change(`case: bellows
materials: {steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}}
parts:
  bellows:
    type: bellows
    material: steel
    root_radius: 65 mm
    profile: [{shape: cuff, length: 5 mm}, {shape: U, count: 5, height: 8 mm, pitch: 6.58 mm}, {shape: cuff, length: 5 mm}]
    wall: {plies: [0.25 mm, 0.25 mm], bond: 0}
    mesh: {around: 24, arc: 2, wall: 2}
caps: {left: {of: bellows.left}, right: {of: bellows.right, mass: 0.3 kg}}
mount: {left: rigid, right: rigid}
sensors: [{name: mid, at: [0, 21 mm, 73 mm]}]
analyses:
  static: true
  symmetry: off
  modes: {count: 14}
  damping: {modal: 1 %}
  response: {base: [y, x], level: 10 m/s2, band: [10 Hz, 900 Hz]}
  stress: {}
  error_bars: false
`);
const write = (name, text) => {
  const path = join(folder(name), 'case.yaml');
  writeFileSync(path, text);
  return path;
};
const near = (a, b, relative, what) => {
  assert.equal(a.length, b.length, what);
  const largest = Math.max(...b.map(Math.abs));
  a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) <= relative * largest, `${what}[${i}]: ${x}, ${b[i]}`));
};

// Numbers of two runs beside each other.
function same(own, other) {
  own.modes.forEach((mode, i) =>
    near([mode.frequency], [other.modes[i]?.frequency ?? NaN], 1e-8, `frequency ${i + 1}`));
  assert.equal(own.modes.length, other.modes.length);
  assert.deepEqual(own.modes.map((m) => [m.shape, m.direction]), other.modes.map((m) => [m.shape, m.direction]));
  assert.equal(own.verification.inertia_count, other.verification.inertia_count);
  assert.equal(own.verification.found, other.verification.found);
  assert.equal(own.verification.passed, true);
  for (const key of ['nodes', 'elements', 'dofs']) assert.equal(own.model[key], other.model[key], key);
  near([own.model.mass], [other.model.mass], 1e-10, 'mass');
}

const outline = (x) =>
  Array.isArray(x) ? x.slice(0, 1).map(outline)
    : x && typeof x === 'object' ? Object.fromEntries(Object.keys(x).sort().map((k) => [k, outline(x[k])])) : typeof x;

test('finds what the program finds on the full mesh, on one, two and four ranks', () => {
  const path = write('bellows', bellows());
  const serial = folder('serial');
  assert.equal(run(process.env.WORK, 'run', path, '--out', serial, '--quiet').status, 0);
  const other = results(serial);
  for (const ranks of [1, 2, 4]) {
    const out = folder(`ranks_${ranks}`);
    const { status, said } = over(ranks, path, '--out', out);
    assert.equal(status, 0, said);
    assert.match(said, /MUMPS, ordering [A-Z]+, /); // that was really used
    const own = results(out);
    same(own, other);
    near(Object.values(own.static).filter((x) => typeof x === 'number'),
      Object.values(other.static).filter((x) => typeof x === 'number'), 1e-8, 'static stiffness');
    own.modes.forEach((mode, i) =>
      near([...mode.effective_mass, own.model.mass], [...other.modes[i].effective_mass, other.model.mass], 1e-6,
        `effective mass ${i + 1}`));
    own.responses.forEach((response, i) => response.peaks.forEach((peak, k) =>
      near([peak.amplitude], [other.responses[i].peaks[k].amplitude], 1e-6, `peak ${k + 1}`)));
    for (const part of ['timing', 'inputs']) delete own[part];
    const { timing, inputs, ...rest } = other;
    assert.deepEqual(outline(own), outline(rest)); // the same keys
    assert.deepEqual(readdirSync(out).sort(), readdirSync(serial).sort());
  }
});

test('finds the rigid modes of a free body, and modes in a band by slices', () => {
  const free = join(process.env.SOURCE, 'cases/verification/plate_free_fv12.yaml');
  const banded = write('banded', bellows((text) => text.replace('{count: 14}', '{band: [200 Hz, 900 Hz]}')));
  for (const [name, path, settings] of [['free', free, []], ['band', banded, []]]) {
    const serial = folder(`${name}_serial`), out = folder(`${name}_ranks`);
    assert.equal(run(process.env.WORK, 'run', path, '--out', serial, '--quiet', ...settings).status, 0);
    const { status, said } = over(2, path, '--out', out, ...settings);
    assert.equal(status, 0, said);
    if (name === 'band') assert.match(said, /slices: \d+ shifts, eigenvalues below them: 0 /);
    const own = results(out), other = results(serial);
    const elastic = (r) => ({ ...r, modes: r.modes.filter((m) => m.shape !== 'rigid') });
    assert.equal(own.modes.length, other.modes.length);
    assert.equal(own.verification.passed, true);
    own.modes.forEach((mode, i) => assert.equal(mode.shape === 'rigid', other.modes[i].shape === 'rigid'));
    near(elastic(own).modes.map((m) => m.frequency), elastic(other).modes.map((m) => m.frequency), 1e-8, name);
  }
});

test('gives MUMPS more where its workspace is too small', () => {
  const path = write('short', bellows());
  for (const [error, ...small] of [[9, '--workspace=-80'], [19, '--mumps-memory', '2']]) {
    const out = folder(`short_${error}`);
    const { status, said } = over(2, path, '--out', out, ...small);
    assert.equal(status, 0, said);
    assert.match(said, new RegExp(`MUMPS: error -${error}, .*; once more with`));
    assert.match(said, /factor: MUMPS, .* workspace \d+ %, \d retries/);
    same(results(out), results(join(process.env.WORK, 'serial')));
  }
});

test('ends all ranks with a message when one is killed, and leaves what was there', async () => {
  const path = write('killed', bellows((text) => text.replace('around: 24, arc: 2, wall: 2', 'around: 96, arc: 3, wall: 4')
    .replace('count: 5', 'count: 12')));
  const out = folder('killed_out');
  const child = spawn('mpirun', ['--oversubscribe', ...as, '-n', '2', engine, path, '--out', out], { cwd: process.env.WORK });
  let said = '';
  child.stderr.on('data', (data) => (said += data));
  const ended = new Promise((done) => child.on('exit', (code) => done(code)));
  const until = Date.now() + 120000;
  while (!/: (statics|modes)/.test(said) && Date.now() < until) await new Promise((done) => setTimeout(done, 50));
  const ranks = spawnSync('pgrep', ['-P', `${child.pid}`], { encoding: 'utf8' }).stdout.trim().split('\n');
  assert.equal(ranks.length, 2);
  process.kill(Number(ranks[1]), 'SIGKILL');
  assert.notEqual(await ended, 0);
  assert.match(said, /exited on signal 9/);
  assert.deepEqual(readdirSync(out).filter((name) => !name.startsWith('.')), []);
});

test('refuses more ranks than there is work for', () => {
  const path = join(process.env.SOURCE, 'cases/verification/plate_cantilever_fv16.yaml');
  const { status, said } = over(9, path, '--out', folder('many'));
  assert.equal(status, 1, said);
  assert.match(said, /1632 unknowns, too few for 9 ranks; .*at most 8 ranks/);
  assert.equal(said.match(/too few/g).length, 1);
  assert.equal(existsSync(join(process.env.WORK, 'many', 'results.json')), false);
});

test('refuses a model that the memory of a node does not hold', () => {
  const { status, said } = mpirun('-n', '2', '-x', 'PLICA_MEMORY=0.2', engine, write('large', bellows()), '--out', folder('large_out'));
  assert.equal(status, 4, said);
  assert.match(said, /unknowns on 2 ranks need about .* GB on node .*Take more nodes/);
  assert.equal(said.match(/need about/g).length, 1);
});

test('refuses ranks with another program or another case', () => {
  const other = join(folder('other'), 'plica-mpi');
  copyFileSync(engine, other);
  appendFileSync(other, '\n');
  chmodSync(other, 0o755);
  const path = write('two', bellows()), another = write('three', bellows((text) => text.replace('0.3 kg', '0.4 kg').replace('8 mm,', '8.1 mm,')));
  const out = folder('two_out');
  let { status, said } = mpirun('-n', '1', engine, path, '--out', out, ':', '-n', '1', other, path, '--out', out);
  assert.notEqual(status, 0);
  assert.match(said, /rank 1 runs another program/);
  ({ status, said } = mpirun('-n', '1', engine, path, '--out', out, ':', '-n', '1', engine, another, '--out', out));
  assert.notEqual(status, 0);
  assert.match(said, /rank 1 has another mesh than rank 0/);
  assert.equal(existsSync(join(out, 'results.json')), false);
});

// Pipe, bellows and pipe between a held cap and a sprung one, by superelements.
const line = (change = (text) => text) => change(`case: line
materials: {steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}}
parts:
  front: {type: bellows, material: steel, root_radius: 65 mm, profile: [{shape: cuff, length: 150 mm, elements: 12}], wall: {plies: [1.5 mm]}, mesh: {around: 24, arc: 2, wall: 2}}
  bellows: {type: bellows, material: steel, root_radius: 65 mm, start: 150 mm, profile: [{shape: cuff, length: 2 mm}, {shape: U, count: 5, height: 8 mm, pitch: 6.58 mm}, {shape: cuff, length: 2 mm}], wall: {plies: [0.25 mm, 0.25 mm], bond: 0}, mesh: {around: 24, arc: 2, wall: 2}}
  rear: {type: bellows, material: steel, root_radius: 65 mm, start: 186.9 mm, profile: [{shape: cuff, length: 150 mm, elements: 12}], wall: {plies: [1.5 mm]}, mesh: {around: 24, arc: 2, wall: 2}}
  liner: {type: interlock, along: bellows, attachment: synchronous, mass: 0.1 kg, radius: 60 mm}
caps:
  left: {of: front.left}
  one: {of: [front.right, bellows.left], mass: 0.2 kg}
  two: {of: [bellows.right, rear.left], mass: 0.2 kg}
  right: {of: rear.right, mass: 0.3 kg}
mount: {left: rigid, right: {stiffness: [40 kN/m, 40 kN/m, 40 kN/m, 1 kNm/rad, 1 kNm/rad, 1 kNm/rad]}}
sensors: [{name: mid, at: [0, 168 mm, 73 mm]}, {name: end, at: [0, 300 mm, 65 mm], mass: 20 g}]
analyses:
  static: false
  reduction: {cutoff: 3000 Hz}
  modes: {count: 16}
  damping: {modal: 1 %, loss_factors: [{of: liner, value: 2 %}]}
  response: {base: [y, x], level: 10 m/s2, band: [10 Hz, 700 Hz], referee: 5}
  error_bars: false
`);

test('reduces sub-structures over ranks, and puts a direct solution beside the responses', () => {
  for (const [name, change] of [['symmetric', (t) => t], ['plain', (t) => t.replace('  static: false', '  static: false\n  symmetry: off')]]) {
    const path = write(name, line(change)), serial = folder(`${name}_serial`);
    assert.equal(run(process.env.WORK, 'run', path, '--out', serial, '--quiet').status, 0);
    const other = results(serial);
    for (const ranks of name === 'plain' ? [2] : [1, 2, 4]) {
      const out = folder(`${name}_${ranks}`);
      const { status, said } = over(ranks, path, '--out', out);
      assert.equal(status, 0, said);
      assert.match(said, /4 reductions, of each rank: |3 reductions, of each rank: /);
      const own = results(out);
      same(own, other);
      assert.deepEqual(own.reduction, other.reduction);
      own.modes.forEach((mode, i) => {
        near([...mode.effective_mass, own.model.mass], [...other.modes[i].effective_mass, other.model.mass], 1e-8, `effective mass ${i + 1}`);
        near([mode.damping], [other.modes[i].damping], 1e-8, `damping ${i + 1}`);
        assert.equal(mode.place, other.modes[i].place);
      });
      own.responses.forEach((response, i) => {
        const beside = other.responses[i];
        response.peaks.forEach((peak, k) => near([peak.amplitude], [beside.peaks[k].amplitude], 1e-8, `peak ${k + 1}`));
        assert.equal(response.direct.length, 5);
        response.direct.forEach((check, k) => {
          near([check.frequency], [beside.direct[k].frequency], 1e-8, `direct ${k + 1}`);
          assert.ok(Math.abs(check.difference - beside.direct[k].difference) < 1e-8, `${check.difference}, ${beside.direct[k].difference}`);
        });
      });
      for (const part of ['timing', 'inputs']) delete own[part];
      const { timing, inputs, ...rest } = other;
      assert.deepEqual(outline(own), outline(rest)); // the same keys
      assert.deepEqual(readdirSync(out).sort(), readdirSync(serial).sort());
    }
  }
});

test('says once what it does not do, and what is wrong with a case', () => {
  const say = (change) => over(2, write('wrong', bellows(change)), '--out', folder('wrong_out'));
  for (const [change, words] of [
    [(text) => text.replace('symmetry: off', 'symmetry: required'), /analyses\.symmetry: the engine solves the full mesh/],
    [(text) => text.replace('symmetry: off', 'reduction: {cutoff: 1 Hz}').replace(/ {2}response: .*\n/, ''), /analyses\.reduction\.cutoff: leaves nothing that could move/],
    [(text) => text.replace('E: 193 GPa', 'Ee: 193 GPa'), /did you mean/],
  ]) {
    const { status, said } = say(change);
    assert.equal(status, 1, said);
    assert.match(said, words);
    assert.equal(said.match(new RegExp(words.source, 'g')).length, 1);
  }
});
