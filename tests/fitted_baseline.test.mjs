// A diagnosis whose case is adjusted to its baseline first, as its users start it.
//
//   node --test fitted_baseline.test.mjs   with  PLICA (the program), WORK (a folder)
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, runner } from './program.mjs';

const run = runner(300000);

// A beam of 0.6 m, 30 x 12 mm, drawn with a modulus of 200 GPa on a root of 100 kNm/rad.
const fit = `fit:
  parameters:
    - {path: materials.steel.E, bounds: [150 GPa, 250 GPa]}
    - {path: ["mount.root.stiffness[3]", "mount.root.stiffness[5]"], bounds: [1e3, 1e6], scale: log}
`;
const beam = (more) => `case: beam
title: A beam on a soft root
materials:
  steel: {E: 200 GPa, nu: 0.3, rho: 7850}
parts:
  beam:
    type: beam
    points: [[0, 0, 0], [0, 150 mm, 0], [0, 300 mm, 0], [0, 450 mm, 0], [0, 600 mm, 0]]
    section: {shape: rectangle, width: 30 mm, depth: 12 mm, material: steel}
    up: [0, 0, 1]
    elements: 6
caps: {root: {of: beam.start}}
mount: {root: {stiffness: [1e9, 1e9, 1e9, 1e5, 1e5, 1e5]}}
${more}analyses:
  static: false
  modes: {count: 10}
  damping: {modal: 1 %}
  error_bars: false
`;

// What was tested has 190 GPa, a root of 4 kNm/rad, and afterwards 0.2 kg on it 237 mm along: roots
// of Timoshenko's beam by transfer matrices (beam_roots.hpp), in z and in x. Each mode is off them by
// about a percent, before as after, and by a thousandth of itself as mounted anew.
const before = { z: [17.3131, 130.037, 396.053, 788.739], x: [21.249, 298.186, 920.657] };
const after = { z: [16.9834, 117.94, 388.811, 752.563], x: [20.6994, 272.309, 908.302] };
const truth = { E: 190e9, root: 4e3, mass: 0.2, at: 0.237 };
const weight = 1.69560;

function measured(states) {
  const modes = (all, state) => Object.entries(all).flatMap(([axis, list]) => list.map((f, i) =>
    `  - {frequency: ${f} Hz, shape: transverse, direction: ${axis}, order: ${i + 1}${state}}`));
  return ['specimen: beam', ...states,
    `mass: [{value: ${weight} kg, state: before}, {value: ${weight + truth.mass} kg, state: after}]`,
    'modes:', ...modes(before, ', state: before'), ...modes(after, ', state: after'), ''].join('\n');
}
const states = (words) => ['states:', `  - {name: before${words}}`, '  - {name: after}'];

function lab(name, more, said) {
  const path = folder(name);
  writeFileSync(join(path, 'case.yaml'), beam(more));
  writeFileSync(join(path, 'measured.yaml'), measured(said));
  return path;
}

const diagnose = (cwd, ...more) => run(cwd, 'diagnose', 'case.yaml', '--measured', 'measured.yaml', '--out', 'made',
  '--threads', '1', '--no-plan', ...more);

test('the case is fitted to the baseline, and the change from it has its effect, size and place', () => {
  const effects = 'diagnose: {effects: [added_mass, local_damage, boundary_compliance]}\n';
  const path = lab('fitted', fit + effects, states(', baseline: true'));
  const { status, said, printed } = diagnose(path, '--fit-baseline', '--add');
  assert.equal(status, 0, said);
  assert.match(said, /fit to the baseline/);
  const d = JSON.parse(readFileSync(join(path, 'made', 'diagnosis.json'), 'utf8'));

  // What was fitted: from the drawn values to the true ones.
  const fitted = (start) => {
    const words = d.assumptions.find((w) => w.startsWith(`fitted to the baseline: ${start} to `));
    assert.ok(words, `${start}: ${d.assumptions}`);
    assert.ok(!words.includes('at a bound'), words);
    return Number(words.match(/ to (\S+) \(SI\)$/)[1]);
  };
  const near = (value, expected, part) =>
    assert.ok(Math.abs(value / expected - 1) < part, `${value} for ${expected}`);
  near(fitted('materials.steel.E from 2e+11'), truth.E, 0.015);
  near(fitted('mount.root.stiffness[3] from 1e+05'), truth.root, 0.05);
  const explained = readFileSync(join(path, 'made', 'explained.yaml'), 'utf8');
  near(Number(explained.match(/steel: \{E: ([^,]+),/)[1]), truth.E, 0.015);
  const springs = explained.match(/root: \{stiffness: \[([^\]]*)\]/)[1].split(',').map(Number);
  assert.equal(springs[3], springs[5]);
  near(springs[3], truth.root, 0.05);
  near(springs[4], 1e5, 1e-9);

  // What the fit left: the percents that each mode is off, in place of 44 %.
  const frequencies = d.baseline.readings.filter((r) => r.name !== 'mass, before');
  assert.equal(frequencies.length, 7);
  for (const r of frequencies) assert.ok(Math.abs(r.nominal / r.measured - 1) < 0.015, JSON.stringify(r));
  assert.ok(d.assumptions.some((w) => /^model error of frequencies: 2 %, as stated \(the baseline shows 0\.\d+ %\)$/
    .test(w)), `${d.assumptions}`);
  assert.deepEqual(d.warnings.filter((w) => w.includes('from those of the baseline')), []);

  // Not counted again.
  assert.equal(d.ledger.readings, 8);
  assert.equal(d.readings.length, 8);
  for (const r of d.readings) assert.match(r.name, /, after$/);

  assert.equal(d.verdict, 'identified', d.headline);
  assert.equal(d.effects.length, 1);
  const [row] = d.ledger.rows;
  assert.equal(row.effects.length, 1);
  const [e] = row.effects;
  assert.deepEqual([e.name, e.place], ['added_mass', 'beam']);
  for (const key of ['mass', 'at'])
    assert.ok(e.interval[key][0] <= truth[key] && truth[key] <= e.interval[key][1], `${key}: ${e.interval[key]}`);
  assert.ok(Math.abs(e.value.at - truth.at) < 0.01, `${e.value.at}`); // 0.257 by the case as drawn
  assert.ok(row.share > 0.95, `${row.share}`);
  assert.match(printed, /fitted to the baseline: materials\.steel\.E from 2e\+11 to /);
  assert.match(printed, /the part after the change\. No gap is solved for/);
  assert.deepEqual(d.advice.filter((a) => a.includes('weigh')), [], 'weighed before and after');
  assert.match(printed, /0\.20 kg that nobody weighed, at beam, 0\.2\d+ m along/);
});

test('without a section `fit`, or a baseline to fit to, it is refused at its line', () => {
  const asked = 'diagnose: {fit_baseline: true}\n';
  const line = (more) => beam(more).split('\n').findIndex((l) => l.startsWith('diagnose:')) + 1;
  const no_fit = 'diagnose\\.fit_baseline: needs a section `fit`; fit: \\{parameters: ';
  const no_baseline = 'diagnose\\.fit_baseline: needs a baseline that differs from the case by no known change';
  const known = ', baseline: true, set: {materials.steel.E: 195 GPa}';
  for (const [name, more, words, flags, expected] of [
    ['no_fit_by_flag', '', ', baseline: true', ['--fit-baseline'], `^case\\.yaml: ${no_fit}`],
    ['no_fit_by_key', asked, ', baseline: true', [], `^case\\.yaml:${line(asked)}: ${no_fit}`],
    ['no_baseline_by_flag', fit, '', ['--fit-baseline'], `^case\\.yaml: ${no_baseline}`],
    ['no_baseline_by_key', fit + asked, '', [], `^case\\.yaml:${line(fit + asked)}: ${no_baseline}`],
    ['known_change', fit + asked, known, [], `^case\\.yaml:${line(fit + asked)}: ${no_baseline}`],
  ]) {
    const path = lab(name, more, states(words));
    const { status, said } = diagnose(path, ...flags);
    assert.equal(status, 1, `${name}: ${said}`);
    assert.match(said, new RegExp(expected, 'm'), name);
    assert.deepEqual(readdirSync(join(path, 'made')), [], name);
  }
});
