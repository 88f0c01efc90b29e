// Fits to what is wanted: optima in closed form, a stiffness by the height of a convolution, and what is refused.
//
//   node --test fit_goals.test.mjs   with  PLICA (the program), SOURCE (the tree), WORK (a folder)
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, runner } from './program.mjs';

const run = runner(500000);
const json = (...path) => JSON.parse(readFileSync(join(...path), 'utf8'));
const value = (fit, path) => fit.parameters.find((p) => p.path === path).after;
function close(a, b, tolerance, what) {
  assert.ok(Math.abs(a - b) <= tolerance * Math.abs(b), `${what}: ${a}, expected ${b}`);
}

// Slender: shear and rotary inertia lower the first mode by less than 1e-4 (Timoshenko; depth / length is 1/250).
const E = 210e9, rho = 7850, L = 1, depth = 4e-3, width = 30e-3;
const cantilever = (fit, d = '6 mm') => `case: cantilever
materials: {steel: {E: 210 GPa, nu: 0.3, rho: 7850 kg/m3}}
parts:
  beam:
    type: beam
    points: [[0, 0, 0], [0, 1 m, 0]]
    elements: 20
    section: {shape: rectangle, material: steel, width: 30 mm, depth: ${d}}
caps: {root: {of: beam.start}}
mount: {root: rigid}
analyses: {static: false, modes: {count: 2}, error_bars: false}
fit:
  parameters:
${fit}
`;
const first = (d) => (1.8751040687 ** 2 / (2 * Math.PI * L * L)) * Math.sqrt((E * d * d) / 12 / rho); // Euler-Bernoulli

test('the lightest cantilever with a first mode of so many hertz', () => {
  for (const start of ['6 mm', '2.5 mm']) { // from where the limit is kept, and from where it is broken
    const cwd = folder(`lightest_${start[0]}`);
    const hertz = first(depth);
    writeFileSync(join(cwd, 'case.yaml'), cantilever(`    - {path: parts.beam.section.depth, bounds: [1 mm, 20 mm]}
    - {path: parts.beam.section.width, bounds: [25 mm, 60 mm]}
  targets: [{quantity: least mass}]
  constraints: [{name: f_transverse >= ${hertz} Hz}]`, start));
    const done = run(cwd, 'fit', 'case.yaml', '--out', 'f');
    assert.equal(done.status, 0, done.said + done.printed);
    const fit = json(cwd, 'f', 'fit.json');
    // f depends on the depth alone: it is at the limit, the width at its bound.
    close(value(fit, 'parts.beam.section.depth'), depth, 3e-4, 'depth');
    close(value(fit, 'parts.beam.section.width'), 25e-3, 1e-6, 'width');
    close(fit.aims[0].after, rho * L * depth * 25e-3, 3e-4, 'mass');
    close(fit.constraints[0].value, hertz, 1e-5, 'frequency');
    assert.equal(fit.parameters[0].sigma, null);
    assert.match(done.printed, /mass \(least\)/);
  }
});

test('the highest first mode of so much mass, and one that is to be met', () => {
  const cwd = folder('highest');
  const mass = rho * L * depth * width;
  writeFileSync(join(cwd, 'case.yaml'), cantilever(`    - {path: parts.beam.section.depth, bounds: [1 mm, 20 mm]}
  targets: [{quantity: most f_transverse}]
  constraints: [{name: mass <= ${mass} kg}]`, '2 mm'));
  assert.equal(run(cwd, 'fit', 'case.yaml', '--out', 'f').status, 0);
  close(value(json(cwd, 'f', 'fit.json'), 'parts.beam.section.depth'), depth, 1e-5, 'depth');
  writeFileSync(join(cwd, 'met.yaml'), cantilever(`    - {path: parts.beam.section.depth, bounds: [1 mm, 20 mm]}
  targets: [{quantity: f_transverse = ${first(depth)} Hz, sigma: 0.1 %}]`));
  assert.equal(run(cwd, 'fit', 'met.yaml', '--out', 'm').status, 0);
  const met = json(cwd, 'm', 'fit.json');
  close(value(met, 'parts.beam.section.depth'), depth, 3e-4, 'depth');
  assert.ok(met.targets[0].goal);
  close(met.parameters[0].sigma, 1e-3 * depth, 0.05, 'as closely as asked'); // f is proportional to the depth
});

const decoupler = readFileSync(join(process.env.SOURCE, 'python', 'examples', 'cases', 'decoupler.yaml'), 'utf8');

const height = 'parts.bellows.profile[1].height';
// A fit of the height of the convolutions; what a run of its own says of the design that was found.
function fitted(name, analyses, goal, limit) {
  const cwd = folder(name);
  writeFileSync(join(cwd, 'case.yaml'), `${decoupler}${analyses}
fit:
  parameters: [{path: "${height}", bounds: [6 mm, 13 mm]}]
  targets: [{quantity: "${goal}"}]
  constraints: [{name: "${limit}"}]
`);
  const done = run(cwd, 'fit', 'case.yaml', '--out', 'f');
  assert.equal(done.status, 0, done.said + done.printed);
  const fit = json(cwd, 'f', 'fit.json');
  assert.ok(fit.evaluations <= 60, `${fit.evaluations} evaluations`);
  assert.ok(fit.warnings.some((w) => w === `constraint '${limit}' holds the design`), fit.warnings.join());
  const found = value(fit, height);
  assert.ok(found > 6.01e-3 && found < 12.9e-3, `${found}`);
  const alone = run(cwd, 'run', 'case.yaml', '--out', 'r', '--only', 'json', '--set', `${height}=${found}`);
  assert.equal(alone.status, 0, alone.said);
  return { fit, results: json(cwd, 'r', 'results.json') };
}
const life = (stroke) => `  life: {curve: {type: bellows}, strokes: [{name: starts, axial: ${stroke}, count: 10000}]}`;

test('the lowest convolution whose stress range stays below a limit', () => {
  const { results } = fitted('stress', life('2 mm'), `least ${height}`, 'life_starts <= 150 MPa');
  close(results.headline.life_starts, 150e6, 1e-5, 'stress range');
});

test('the lowest convolution that lives as long as it has to', () => {
  const { results, fit } = fitted('life', life('6 mm'), `least ${height}`, 'damage <= 1');
  close(results.life.spots[0].damage, 1, 1e-4, 'damage');
  close(fit.constraints[0].value, 1, 1e-4, 'damage of the fit');
});

test('the softest bellows whose first axial mode is not below 250 Hz', () => {
  const { results, fit } = fitted('hertz', '', 'least k_axial', 'f_axial >= 250 Hz');
  close(results.headline.f_axial, 250, 1e-5, 'frequency');
  close(results.static.k_axial, fit.aims[0].after, 1e-6, 'stiffness');
});

test('the softest bellows of so much mass', () => {
  const { results } = fitted('mass', '', 'least k_axial', 'mass <= 0.46 kg');
  close(results.headline.mass, 0.46, 1e-5, 'mass');
});

test('the height of a convolution for a stiffness, from either side', () => {
  const cwd = folder('bellows');
  const heights = [7, 12].map((start) => {
    writeFileSync(join(cwd, 'case.yaml'), `${decoupler}
fit:
  parameters: [{path: "parts.bellows.profile[1].height", bounds: [6 mm, 13 mm]}]
  targets: [{quantity: k_axial = 50 kN/m}]
`);
    const done = run(cwd, 'fit', 'case.yaml', '--out', `f${start}`, '--only', 'json', '--set', `parts.bellows.profile[1].height=${start} mm`);
    assert.equal(done.status, 0, done.said + done.printed);
    return value(json(cwd, `f${start}`, 'fit.json'), 'parts.bellows.profile[1].height');
  });
  close(heights[0], heights[1], 1e-4, 'heights');
  const done = run(cwd, 'run', 'case.yaml', '--out', 'r', '--only', 'json', '--set', `parts.bellows.profile[1].height=${heights[0]}`);
  assert.equal(done.status, 0, done.said);
  close(json(cwd, 'r', 'results.json').static.k_axial, 50e3, 1e-3, 'stiffness');
});

test('goals and limits that mean nothing are refused at their lines', () => {
  const cwd = folder('refused');
  const lines = (fit) => {
    writeFileSync(join(cwd, 'case.yaml'), cantilever(`    - {path: parts.beam.section.depth, bounds: [1 mm, 20 mm]}
${fit}`));
    const { status, said } = run(cwd, 'fit', 'case.yaml', '--out', 'f');
    assert.equal(status, 1, said);
    return said;
  };
  assert.match(lines('  targets: [{quantity: f_axal = 5 Hz}]'), /case\.yaml:15: fit\.targets\[0\]\.quantity: there is no quantity 'f_axal'; did you mean 'f_axial'/);
  assert.match(lines('  targets: [{quantity: f_axial = 5 kg}]'), /kg/);
  assert.match(lines('  targets: [{quantity: f_axial >= 5 Hz}]'), /is a limit; constraints/);
  assert.match(lines('  targets: [{quantity: least mas}]'), /there is no quantity 'mas'/);
  assert.match(lines('  targets: [{quantity: k_axial = 5 kN/m}]'), /the model gives no 'k_axial'/);
  assert.match(lines('  targets: [{quantity: least mass}]\n  constraints: [{name: heavy}]'), /constraints\[0\]\.name: has no sum to limit/);
  assert.match(lines('  targets: [{quantity: least mass}]\n  constraints: [{name: mass <= 3 kg, max: 2}]'), /is limited by its name already/);
  assert.match(lines(''), /has nothing to fit to/);
});
