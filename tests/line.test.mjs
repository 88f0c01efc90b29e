// An exhaust line as its users have it: cases of `plica init`, changed; modes of a test that go from
// one command to the next without pasting.
//
//   node --test line.test.mjs   with  PLICA (the program), WORK (a folder)
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, runner } from './program.mjs';

const run = runner(200000);

const good = (cwd, ...args) => {
  const result = run(cwd, ...args);
  assert.equal(result.status, 0, `plica ${args.join(' ')}: ${result.said}`);
  return result;
};

test('modes that `identify` writes are read by compare, fit and diagnose as they are', () => {
  const at = folder('identified');
  good(at, 'init', 'beam.yaml', '--kind', 'measured');
  good(at, 'run', 'beam.yaml', '--out', 'truth', '--quiet', '--no-error-bars');
  writeFileSync(join(at, 'lab.yaml'), `specimen: beam
source: a run in place of a test
sensors: [{name: tip, at: [0, 600 mm, 0], axes: [x, y, z]}]
frf: [{file: truth/responses.uff, base: z}]
`);
  assert.match(good(at, 'identify', 'lab.yaml', '--out', 'lab').printed,
    /Modes for compare, fit and diagnose: lab\/measured\.yaml/);
  assert.match(good(at, 'compare', 'truth', 'lab/measured.yaml', '--out', 'compared').printed,
    /transverse 1 in z +33\.7\d+ +33\.72\d .* 1\.00 +shape/);
  const soft = readFileSync(join(at, 'beam.yaml'), 'utf8').replace('E: 205 GPa', 'E: 180 GPa');
  writeFileSync(join(at, 'soft.yaml'), `${soft}
fit:
  parameters: [{path: materials.steel.E, bounds: [150 GPa, 250 GPa]}]
`);
  const fitted = good(at, 'fit', 'soft.yaml', '--set', 'measured=lab/measured.yaml', '--out', 'fitted');
  const modulus = /materials\.steel\.E +\S+ +(\S+)/.exec(fitted.printed);
  assert.ok(Math.abs(Number(modulus?.[1]) / 205e9 - 1) < 0.005, fitted.printed);
  good(at, 'diagnose', 'beam.yaml', '--measured', 'lab', '--out', 'diagnosed', '--quiet');
  const gap = JSON.parse(readFileSync(join(at, 'diagnosed', 'diagnosis.json'), 'utf8'));
  assert.ok(JSON.stringify(gap).includes('33.7'), 'the identified mode is none of its readings');
});

test('the commands that a starter names run as they stand there', () => {
  const at = folder('starters');
  assert.match(run(at, 'init', 'measured.yaml', '--kind', 'measured').said,
    /measured\.yaml: is what the file beside it is called; another name/);
  good(at, 'init', 'beam.yaml', '--kind', 'measured');
  const named = ['beam.yaml', 'measured.yaml'].flatMap((name) =>
    [...readFileSync(join(at, name), 'utf8').matchAll(/^# +plica (\S.*?)(?: {2,}.*)?$/gm)]);
  assert.ok(named.length >= 4, String(named));
  for (const [, command] of named)
    if (!command.startsWith('fit ')) good(at, ...command.split(' ')); // the starter has no `fit`
});

test('what ends and inputs cannot be is refused with its place and what would be right', () => {
  const at = folder('bad');
  good(at, 'init', 'line.yaml', '--kind', 'line');
  const line = readFileSync(join(at, 'line.yaml'), 'utf8');
  const refused = (name, what, by, said) => {
    assert.ok(line.includes(what), what);
    writeFileSync(join(at, `${name}.yaml`), line.replace(what, by));
    const result = run(at, 'check', `${name}.yaml`);
    assert.equal(result.status, 1, `${name}: ${result.said}`);
    assert.match(result.said, said);
  };
  const first = '- {move: [engine], direction: y}';
  refused('no_motion', first, '- {move: [engine, hanger_rear]}',
    /line\.yaml|no_motion\.yaml:\d+: analyses\.response\.base\[0\]\.direction: is missing/);
  refused('phase_alone', first, '- {move: [engine], direction: y, amplitude: 0, phase: 90 deg}',
    /base\[0\]\.amplitude: is zero, and the end has a phase; leave the end out, or give an amplitude/);
  refused('phase_without_amplitude', first, '- {move: [engine], direction: y, phase: 90 deg}',
    /phase_without_amplitude\.yaml:\d+: analyses\.response\.base\[0\]\.phase: is of an end without amplitude/);
  refused('phase_with', first,
    '- {move: [engine], direction: y, with: [{move: [hanger_rear], direction: y, phase: 90 deg}]}',
    /base\[0\]\.with\[0\]\.phase: is of an end without amplitude.*amplitude: 1/s);
  refused('words_behind', first, `${first}\n      - x`, /base\[1\]: .*behind a map.*words first, then maps/s);
  refused('motion_behind', first, '- x\n      - {move: [nowhere], direction: y}',
    /motion_behind\.yaml:\d+: analyses\.response\.base\[1\]\.move: /);
  const spectra = (real, imaginary) => `level: 5 m/s2
    together: [{name: both, inputs: [{of: engine_y}, {of: engine_z}], spectra: [{frequency: 2 Hz, real: ${real}, imaginary: ${imaginary}}, {frequency: 250 Hz, real: [1, 0, 0, 1]}]}]`;
  refused('not_hermitian', 'level: 5 m/s2', spectra('[1, 0.5, 0.5, 1]', '[0, 0.1, 0.1, 0]'),
    /spectra\[0\]: is not Hermitian: entry \(b, a\) must be the conjugate of \(a, b\)/);
  refused('not_positive', 'level: 5 m/s2', spectra('[1, 2, 2, 1]', '[0, 0, 0, 0]'),
    /spectra\[0\]: is not positive: no signals have such coherences/);
});

test('a line of one\'s own: two decouplers, a hanger anywhere, a heavier muffler, phases, a run-up', () => {
  const at = folder('own');
  good(at, 'init', 'line.yaml', '--kind', 'line');
  let text = readFileSync(join(at, 'line.yaml'), 'utf8');
  const change = (what, by) => {
    assert.ok(text.includes(what), what);
    text = text.replace(what, by);
  };
  change('mesh: {accuracy: 2 %}', 'mesh: {around: 24, arc: 2, wall: 2}');
  change('  rear:\n', `  second:
    type: bellows
    material: steel
    start: 1500 mm
    root_radius: 40 mm
    profile: [{shape: cuff, length: 4 mm}, {shape: U, count: 6, height: 6 mm, pitch: 6 mm}, {shape: cuff, length: 4 mm}]
    wall: {plies: [0.2 mm, 0.2 mm], bond: 0.5}
    mesh: {around: 24, arc: 2, wall: 2}
    places: {heat_shield: {at: [17 mm, 1522 mm, 43 mm]}}
  shield: {type: mass, at: second.heat_shield, mass: 50 g}
  tail_pipe:
    type: beam
    points: [[0, 1544 mm, 0], [0, 1844 mm, 0]]
    elements: 8
    section: {shape: pipe, material: steel, radius: 40 mm, thickness: 1.5 mm}
    places: {hook: {at: [0, 1777 mm, 0]}}
  rear:
`);
  change('mass: 9 kg', 'mass: 11.5 kg');
  change('hanger_rear: {of: rear.end}', `weld_second: {of: [rear.end, second.left]}
  weld_tail: {of: [second.right, tail_pipe.start]}
  hanger_rear: {of: tail_pipe.hook}`);
  change('damping: {loss_factor: 12 %}', 'damping: {maxwell: [{share: 0.3, time: 5 ms}]}');
  change('- {move: [engine], direction: z}', `- {move: [engine], direction: z}
      - {name: roll, move: [engine], direction: z, with: [{move: [hanger_front], direction: z, amplitude: 0.2, phase: 120 deg}]}`);
  change('- {move: [engine], direction: y}', '- x # the base, beside motions of ends\n      - {move: [engine], direction: y}');
  change('- {name: tail, at: [0, 1500 mm, 0]}', '- {name: tail, at: [0, 1844 mm, 40 mm]}');
  writeFileSync(join(at, 'line.yaml'), text);
  const { printed } = good(at, 'run', 'line.yaml', '--out', 'out', '--no-error-bars');
  for (const said of [/Proved, no mode/, /Ends moved: roll/, /Orders through modes/, /RMS m\/s2/, /first axial mode/])
    assert.match(printed, said);
  const results = JSON.parse(readFileSync(join(at, 'out', 'results.json'), 'utf8'));
  assert.ok(results.sensors.every((s) => s.distance < 1e-6), JSON.stringify(results.sensors));
});

test('dynamic stiffness takes values set by hand, and states of the case by name', () => {
  const at = folder('stiffness');
  writeFileSync(join(at, 'case.yaml'), `case: rod
parts:
  rod:
    type: beam
    points: [[0, 0, 0], [0, 800 mm, 0]]
    elements: 8
    section: {shape: general, EA: 4 MN, EI: 900 N m2, GJ: 500 N m2, mass_per_length: 1 kg/m,
      rotary_inertia_per_length: 1e-6, polar_inertia_per_length: 2e-6}
caps: {left: {of: rod.start}, right: {of: rod.end}}
mount: {left: rigid, right: rigid}
states: {pulled: {offset: {right: {move: [0, 0.1 mm, 0]}}}}
analyses: {error_bars: false}
`);
  const axial = (...more) => {
    good(at, 'stiffness', 'case.yaml', '--frequencies', '0', '--out', 'out', '--quiet', ...more);
    return readFileSync(join(at, 'out', 'transfer_stiffness.csv'), 'utf8').replace(/"(.*), (.*)"/g, '$1; $2')
      .split('\n').map((line) => line.split(','))
      .filter((cells) => cells[4] === 'y').map((cells) => [cells[0], Number(cells[12])]);
  };
  const near = (x, y) => assert.ok(Math.abs(x / y - 1) < 1e-6, `${x} ${y}`);
  near(axial()[0][1], 5e6); // EA / L
  near(axial('--set', 'parts.rod.section.EA=8 MN')[0][1], 1e7);
  assert.deepEqual(axial('--states', '0,pulled', '--offsets', '0,y=1mm').map(([state]) => state),
    ['at rest', 'left moved by 1 mm in y', 'pulled',
      'pulled; left moved by 1 mm in y']);
  const refused = (said, ...more) => {
    const result = run(at, 'stiffness', 'case.yaml', '--out', 'out', ...more);
    assert.equal(result.status, 1, result.said);
    assert.match(result.said, said);
  };
  refused(/case\.yaml:\d+: states: there is no state 'puled'; did you mean 'pulled'/, '--states', 'puled');
  refused(/--states: 'pulled' is there twice/, '--states', 'pulled,pulled');
});
