// Sweeps: every row is the run that it stands for, and whatever ends a sweep, it goes on to the same table.
//
//   node --test sweep.test.mjs   with  PLICA (the program), SOURCE (the tree), WORK (a folder)
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { chmodSync, existsSync, mkdirSync, readFileSync, readdirSync, statSync, truncateSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { folder, plica, runner } from './program.mjs';

const run = runner(300000);
const read = (...path) => readFileSync(join(...path), 'utf8');

// Cells of a table without quoted ones, by the names of its columns.
function rows(...path) {
  const [header, ...lines] = read(...path).trimEnd().split('\n');
  const names = header.split(',').map((h) => h.replace(/ \[[^\[\]]*\]$/, ''));
  return lines.map((line) => Object.fromEntries(line.split(',').map((cell, k) => [names[k], cell])));
}
const close = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance * Math.abs(b), `${what}: ${a}, ${b}`);

// A cantilever with a mass at its tip.
const beam = `case: beam
materials: {steel: {E: 210 GPa, nu: 0.3, rho: 7850 kg/m3}}
parts:
  beam:
    type: beam
    points: [[0, 0, 0], [0, 400 mm, 0]]
    elements: 8
    section: {shape: rectangle, material: steel, width: 30 mm, depth: 6 mm}
  tip: {type: mass, at: "beam.point[2]", mass: 200 g}
caps: {root: {of: beam.start}}
mount: {root: rigid}
sensors: [{name: tip, at: [0, 400 mm, 0]}]
analyses:
  static: false
  modes: {count: 3}
  damping: {modal: 1 %}
  response: {base: [z], band: [5 Hz, 200 Hz]}
  error_bars: false
`;

// Two decouplers between pipes, reduced; a liner in one of them, a mount of springs, a soft clamp.
const bellows = (start) => `
    type: bellows
    material: steel
    root_radius: 40 mm
    start: ${start} mm
    profile: [{shape: cuff, length: 5 mm}, {shape: U, count: 6, height: 8 mm, pitch: 6 mm}, {shape: cuff, length: 5 mm}]
    wall: {plies: [0.3 mm]}
    mesh: {around: 20, arc: 2, wall: 2}`;
const pipe = (start, length) => `
    type: bellows
    material: steel
    root_radius: 40 mm
    start: ${start} mm
    profile: [{shape: cuff, length: ${length} mm, elements: 12}]
    wall: {plies: [1.5 mm]}
    mesh: {around: 20, arc: 2, wall: 2}`;
const assembly = `case: line
materials: {steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}}
parts:
  first:${bellows(0)}
  middle:${pipe(46, 200)}
  second:${bellows(246)}
  liner: {type: interlock, along: first, attachment: synchronous, mass: 50 g, radius: 35 mm}
caps:
  left: {of: first.left, mass: 0.2 kg}
  a: {of: [first.right, middle.left], mass: 0.3 kg, inertia: [2 kg cm2, 3 kg cm2, 2 kg cm2, 0, 0, 0], offset: [0, 0, 10 mm]}
  b: {of: [middle.right, second.left], mass: 0.3 kg, stiffness: [5 MN/m, 5 MN/m, 5 MN/m, 5 kNm/rad, 5 kNm/rad, 5 kNm/rad]}
  right: {of: second.right}
mount: {left: {stiffness: [200 kN/m, 300 kN/m, 200 kN/m, 1 kNm/rad, 1 kNm/rad, 1 kNm/rad]}, right: rigid}
analyses:
  static: false
  reduction: {cutoff: 1200 Hz}
  modes: {count: 12}
  error_bars: false
`;

test('a grid is in order, and its rows are the runs that they stand for', () => {
  const cwd = folder('grid');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  const swept = run(cwd, 'sweep', 'case.yaml', '--out', 's', '--vary', 'parts.beam.section.depth=5mm:7mm:3',
    '--vary', 'parts.tip.mass=0.1,0.3', '--result', 'modes[0].frequency', '--result', 'responses[base=z].peaks[0].amplitude',
    '--result', 'headline.mass');
  assert.equal(swept.status, 0, swept.said);
  assert.match(swept.printed, /6 variants, 0 failed/);
  const table = rows(cwd, 's', 'sweep.csv');
  assert.deepEqual(table.map((r) => [r['parts.beam.section.depth'], r['parts.tip.mass']].map(Number)),
    [[0.005, 0.1], [0.005, 0.3], [0.006, 0.1], [0.006, 0.3], [0.007, 0.1], [0.007, 0.3]]);
  for (const k of [1, 4]) {
    const alone = run(cwd, 'run', 'case.yaml', '--out', `r${k}`, '--only', 'json', '--set',
      `parts.beam.section.depth=${table[k]['parts.beam.section.depth']}`, '--set', `parts.tip.mass=${table[k]['parts.tip.mass']}`);
    assert.equal(alone.status, 0, alone.said);
    assert.deepEqual(readdirSync(join(cwd, `r${k}`)).sort(), ['plica_files.json', 'results.json']);
    const results = JSON.parse(read(cwd, `r${k}`, 'results.json'));
    close(Number(table[k]['modes[0].frequency']), results.modes[0].frequency, 1e-9, 'frequency');
    close(Number(table[k]['responses[base=z].peaks[0].amplitude']), results.responses[0].peaks[0].amplitude, 1e-9, 'peak');
    assert.ok(results.assumptions.some((a) => a.includes('parts.tip.mass = ')));
  }
});

test('the table in HDF5 is the table in CSV, a data set a column, with its unit', () => {
  const cwd = folder('hdf5');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  const swept = run(cwd, 'sweep', 'case.yaml', '--out', 's', '--vary', 'parts.tip.mass=0.1,-1,0.3', '--result', 'modes[0].frequency');
  assert.equal(swept.status, 0, swept.said);
  const script = `
import h5py, json, sys
def text(x): return x.decode() if isinstance(x, bytes) else x
def plain(d): return [None if x != x else x for x in d] if d.dtype.kind == 'f' else [x.decode() if isinstance(x, bytes) else int(x) for x in d]
with h5py.File(sys.argv[1]) as f:
    print(json.dumps({k: {'unit': text(d.attrs.get('unit')), 'rows': plain(d[()])} for k, d in f.items()}))`;
  const { status, stdout, stderr } = spawnSync('/usr/bin/python3', ['-c', script, join(cwd, 's', 'sweep.h5')], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  const h5 = JSON.parse(stdout);
  const [header] = read(cwd, 's', 'sweep.csv').split('\n', 1);
  assert.equal(Object.keys(h5).length, header.split(',').length);
  const columns = Object.entries(h5), of = (path) => columns.find(([name]) => name.startsWith(path))[1];
  assert.deepEqual([of('parts.tip.mass').unit, of('modes[0].frequency').unit], ['kg', 'Hz']);
  assert.deepEqual(of('parts.tip.mass').rows.map(Number), [0.1, -1, 0.3]);
  const table = rows(cwd, 's', 'sweep.csv');
  for (const k of [0, 2]) assert.equal(of('modes[0].frequency').rows[k], Number(table[k]['modes[0].frequency']));
  assert.equal(of('modes[0].frequency').rows[1], null);
  assert.deepEqual(of('status').rows, ['ok', 'failed', 'ok']);
  assert.match(of('reason').rows[1], /parts\.tip\.mass/);
});

// Euler-Bernoulli with shear and rotary inertia small: f of a cantilever grows with its depth.
test('a variant that fails is a row with its reason, and the others are there', () => {
  const cwd = folder('failures');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  writeFileSync(join(cwd, 'variants.csv'), 'parts.tip.mass,parts.tap.mass\n0.1,\n-1,\n3 mm,\n,\n0.2,1\n');
  const swept = run(cwd, 'sweep', 'case.yaml', '--out', 's', '--table', 'variants.csv');
  assert.equal(swept.status, 0, swept.said);
  assert.match(swept.printed, /5 variants, 3 failed/);
  const text = read(cwd, 's', 'sweep.csv').split('\n');
  assert.match(text[1], /^1,0.1,,[\d.]+,.*,ok,$/);
  assert.match(text[2], /^2,-1,,(,)*failed,.*parts\.tip\.mass/);
  assert.match(text[3], /^3,3 mm,/);
  assert.match(text[4], /^4,,,[\d.]+.*,ok,$/); // what the case says
  assert.match(text[5], /failed,.*tap/);
  const counts = JSON.parse(read(cwd, 's', 'sweep.json'));
  assert.deepEqual([counts.ok, counts.failed, counts.missing], [2, 3, 0]);
  const none = run(cwd, 'sweep', 'case.yaml', '--out', 'n', '--vary', 'parts.tip.mass=-1,-2');
  assert.equal(none.status, 1);
  assert.match(none.said, /every variant failed/);
});

test('an assembly that changes at its ends alone gives the numbers of whole runs', () => {
  const cwd = folder('assembly');
  writeFileSync(join(cwd, 'case.yaml'), assembly);
  writeFileSync(join(cwd, 'variants.csv'), 'caps.a.mass,mount.left.stiffness[1],caps.b.stiffness[1],caps.right.mass\n' +
    '0.3,300 kN/m,5 MN/m,\n0.5,50 kN/m,1 MN/m,0.1\n0,900 kN/m,20 MN/m,\n');
  const wanted = [...Array(12).keys()].flatMap((i) => [`modes[${i}].frequency`, `modes[${i}].effective_mass[1]`,
    `modes[${i}].effective_mass[0]`]);
  const swept = run(cwd, 'sweep', 'case.yaml', '--out', 's', '--table', 'variants.csv', '--jobs', '2',
    ...['model.mass', 'verification.passed', 'verification.inertia_count', 'headline.f_axial', 'headline.f_transverse',
      'headline.f_torsion', ...wanted].flatMap((path) => ['--result', path]));
  assert.equal(swept.status, 0, swept.said);
  const table = rows(cwd, 's', 'sweep.csv');
  for (const [k, row] of table.entries()) {
    const set = ['caps.a.mass', 'mount.left.stiffness[1]', 'caps.b.stiffness[1]', 'caps.right.mass']
      .filter((path) => row[path] !== '').flatMap((path) => ['--set', `${path}=${row[path]}`]);
    const alone = run(cwd, 'run', 'case.yaml', '--out', `r${k}`, '--only', 'json', ...set);
    assert.equal(alone.status, 0, alone.said);
    const whole = JSON.parse(read(cwd, `r${k}`, 'results.json'));
    assert.equal(row['verification.passed'], '1');
    assert.equal(Number(row['verification.inertia_count']), whole.verification.inertia_count);
    close(Number(row['model.mass']), whole.model.mass, 1e-9, 'mass');
    for (const name of ['f_axial', 'f_transverse', 'f_torsion'])
      close(Number(row[`headline.${name}`]), whole.headline[name], 1e-9, name);
    for (let i = 0; i < 12; ++i) {
      close(Number(row[`modes[${i}].frequency`]), whole.modes[i].frequency, 1e-9, `mode ${i + 1}`);
      assert.ok(Math.abs(Number(row[`modes[${i}].effective_mass[1]`]) - whole.modes[i].effective_mass[1]) < 1e-7 * whole.model.mass);
    }
  }
});

const varied = ['--vary', 'parts.tip.mass=0.05:0.5', '--design', 'latin', '--count', '120'];

test('Latin hypercubes fill every stretch once, Sobol sequences are those of Joe and Kuo', () => {
  const cwd = folder('designs');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  for (const [design, count] of [['latin', 40], ['sobol', 7]]) {
    const swept = run(cwd, 'sweep', 'case.yaml', '--out', design, '--design', design, '--count', `${count}`,
      '--vary', 'parts.tip.mass=0:1', '--vary', 'parts.beam.section.depth=1mm:10mm:log');
    assert.equal(swept.status, 0, swept.said);
  }
  const latin = rows(cwd, 'latin', 'sweep.csv');
  for (const share of [(r) => Number(r['parts.tip.mass']), (r) => Math.log10(Number(r['parts.beam.section.depth']) / 1e-3)])
    assert.deepEqual(latin.map((r) => Math.floor(40 * share(r))).sort((a, b) => a - b), [...Array(40).keys()]);
  // The first points of the sequence in two dimensions (Joe & Kuo 2008, direction numbers new-joe-kuo-6).
  const points = [[0.5, 0.5], [0.75, 0.25], [0.25, 0.75], [0.375, 0.375], [0.875, 0.875], [0.625, 0.125], [0.125, 0.625]];
  for (const [k, row] of rows(cwd, 'sobol', 'sweep.csv').entries()) {
    close(Number(row['parts.tip.mass']), points[k][0], 1e-12, `point ${k}`);
    close(Number(row['parts.beam.section.depth']), 1e-3 * 10 ** points[k][1], 1e-9, `point ${k}`);
  }
});

test('whatever ends it, a sweep goes on to the same table, with any number of jobs and shards', async () => {
  const cwd = folder('restart');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  const sweep = (out, ...more) => run(cwd, 'sweep', 'case.yaml', '--out', out, ...varied, ...more);
  assert.equal(sweep('whole', '--jobs', '1').status, 0);
  const expected = read(cwd, 'whole', 'sweep.csv');
  const lines = (out) => (existsSync(join(cwd, out, 'runs.jsonl')) ? read(cwd, out, 'runs.jsonl').split('\n').length - 2 : 0);
  for (const signal of ['SIGKILL', 'SIGINT']) {
    const child = spawn(plica, ['sweep', 'case.yaml', '--out', signal, ...varied, '--jobs', '2'], { cwd, stdio: 'ignore' });
    const ended = new Promise((resolve) => child.on('close', (code, by) => resolve(code ?? by)));
    while (lines(signal) < 10) await new Promise((resolve) => setTimeout(resolve, 2));
    child.kill(signal);
    const how = await ended;
    const done = lines(signal);
    assert.ok(done >= 10 && done < 120, `${done} of 120 after ${how}`);
    assert.equal(how, signal === 'SIGINT' ? 130 : signal);
    if (signal === 'SIGINT') assert.equal(rows(cwd, signal, 'sweep.csv').filter((r) => r.status === 'missing').length, 120 - done);
    if (signal === 'SIGKILL') truncateSync(join(cwd, signal, 'runs.jsonl'), statSync(join(cwd, signal, 'runs.jsonl')).size - 20);
    assert.equal(sweep(signal, '--jobs', '2').status, 0);
    assert.equal(read(cwd, signal, 'sweep.csv'), expected);
  }
  const before = read(cwd, 'whole', 'runs.jsonl');
  assert.equal(sweep('whole').status, 0);
  assert.equal(read(cwd, 'whole', 'runs.jsonl'), before, 'what was run is not run again');

  for (const shard of ['1/3', '3/3']) assert.equal(sweep('shards', '--shard', shard).status, 0);
  const holes = sweep('shards', '--shard', '1/3', '--collect');
  assert.match(holes.printed, /120 variants, 0 failed, 40 not run yet \(of shard 2\/3\)/);
  assert.equal(rows(cwd, 'shards', 'sweep.csv').filter((r) => r.reason === 'not run yet').length, 40);
  assert.equal(sweep('shards').status, 0); // all that is missing
  assert.equal(read(cwd, 'shards', 'sweep.csv'), expected);

  const size = readdirSync(join(cwd, 'whole')).reduce((sum, name) => sum + statSync(join(cwd, 'whole', name)).size, 0);
  assert.ok(size < 2048 * 120, `${size / 120} bytes a run`);
});

test('damaged, foreign and busy files of a sweep are said', async () => {
  const cwd = folder('files');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  const sweep = (out, ...more) => run(cwd, 'sweep', 'case.yaml', '--out', out, '--vary', 'parts.tip.mass=0.1,0.2', ...more);
  assert.equal(sweep('a').status, 0);
  const table = read(cwd, 'a', 'sweep.csv');
  const [first, one, two] = read(cwd, 'a', 'runs.jsonl').split('\n');
  writeFileSync(join(cwd, 'a', 'runs.jsonl'), `${first}\n${one.slice(0, 30)}\n${two}\n`);
  const mended = sweep('a');
  assert.equal(mended.status, 0);
  assert.match(mended.said, /runs\.jsonl has lines that cannot be read/);
  assert.equal(read(cwd, 'a', 'sweep.csv'), table);
  mkdirSync(join(cwd, 'b'));
  writeFileSync(join(cwd, 'b', 'runs.jsonl'), 'runs of a car\n');
  const foreign = sweep('b');
  assert.equal(foreign.status, 1);
  assert.match(foreign.said, /runs\.jsonl: is no file of a sweep/);
  assert.equal(read(cwd, 'b', 'runs.jsonl'), 'runs of a car\n');
  const long = ['--vary', 'parts.tip.mass=0.1:0.3:2000']; // goes on while the second asks
  const child = spawn(plica, ['sweep', 'case.yaml', '--out', 'c', ...long, '--jobs', '1'], { cwd, stdio: 'ignore' });
  const ended = new Promise((resolve) => child.on('close', resolve));
  while (!existsSync(join(cwd, 'c', 'runs.jsonl'))) await new Promise((resolve) => setTimeout(resolve, 2));
  const second = run(cwd, 'sweep', 'case.yaml', '--out', 'c', ...long);
  child.kill('SIGINT');
  await ended;
  assert.equal(second.status, 1);
  assert.match(second.said, /another plica is running this sweep/);
});

test('words that mean nothing are refused before anything runs', () => {
  const cwd = folder('words');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  for (const [words, wrong] of [
    [['--vary', 'parts.tip.mass=0.1:0.2'], /is no range of a grid/],
    [['--vary', 'parts.tip.mass=0.2:0.1:3'], /ends below its start/],
    [['--vary', 'parts.tip.mass=0:1:3:log'], /reaches zero/],
    [['--vary', 'parts.tip.mass=1mm:2mm:3'], /mm/],
    [['--vary', 'parts.tap.mass=1,2'], /there is no 'parts.tap.mass'.*tip/],
    [['--vary', 'parts.tip.mass'], /has no path or no values/],
    [['--vary', 'variants=1,2'], /changes no run/],
    [['--vary', 'parts.tip.mass=1,2', '--vary', 'parts.tip.mass=1,2'], /varies twice/],
    [['--vary', 'parts.tip.mass=0.1:0.2', '--design', 'sobol'], /--count: is missing/],
    [['--vary', 'parts.tip.mass=1,2', '--result', 'modes[x'], /is no path of results.json/],
    [['--vary', 'parts.tip.mass=1,2', '--shard', '3/2'], /is no share/],
    [[], /--vary: is missing/]]) {
    const refused = run(cwd, 'sweep', 'case.yaml', '--out', 's', ...words);
    assert.equal(refused.status, 1, words.join(' '));
    assert.match(refused.said, wrong);
    assert.ok(!existsSync(join(cwd, 's')), words.join(' '));
  }
  const gap = run(cwd, 'sweep', 'case.yaml', '--out', 'g', '--vary', 'parts.tip.mass=0.1,0.2', '--result', 'modes[9].frequency');
  assert.equal(gap.status, 0);
  assert.match(gap.said, /2 of 2 variants have no number at modes\[9\]\.frequency/);
});

test('the recipes of the docs, with stand-ins for sbatch and parallel', () => {
  const recipes = [...read(process.env.SOURCE, 'docs', 'sweep.md').matchAll(/```sh\n([\s\S]*?)```/g)].map((m) => m[1]);
  assert.equal(recipes.length, 2);
  const tables = recipes.map((recipe, k) => {
    const cwd = folder(`recipe${k}`);
    writeFileSync(join(cwd, 'case.yaml'), assembly);
    const bin = join(cwd, 'bin');
    mkdirSync(bin);
    // As the manuals have it: sbatch runs the script once a task of --array, parallel the command once a word after :::.
    writeFileSync(join(bin, 'sbatch'), `#!/bin/sh
range=$(sed -n 's/^#SBATCH --array=//p' "$1")
export SLURM_CPUS_PER_TASK=$(sed -n 's/^#SBATCH --cpus-per-task=//p' "$1") SLURM_ARRAY_TASK_COUNT=$((\${range#*-} - \${range%-*} + 1))
for SLURM_ARRAY_TASK_ID in $(seq "\${range%-*}" "\${range#*-}"); do export SLURM_ARRAY_TASK_ID; sh "$1" & all="$all $!"; done
for task in $all; do wait $task || exit 1; done
`);
    writeFileSync(join(bin, 'parallel'), `#!/bin/sh
command=
while [ "$1" != ::: ]; do command="$command '$1'"; shift; done
shift
for word; do sh -c "$(echo "$command" | sed "s/{}/$word/")" & all="$all $!"; done
for task in $all; do wait $task || exit 1; done
`);
    for (const name of ['sbatch', 'parallel']) chmodSync(join(bin, name), 0o755);
    writeFileSync(join(cwd, 'sweep.sbatch'), recipe);
    const env = { ...process.env, PATH: `${bin}:${dirname(plica)}:${process.env.PATH}` };
    const words = recipe.includes('#SBATCH') ? ['sbatch', 'sweep.sbatch'] : ['sh', 'sweep.sbatch'];
    const done = spawnSync(words[0], words.slice(1), { cwd, env, encoding: 'utf8', timeout: 300000 });
    assert.equal(done.status, 0, done.stderr);
    assert.deepEqual(readdirSync(join(cwd, 'table')).filter((name) => name.startsWith('runs')).length, 4);
    const table = rows(cwd, 'table', 'sweep.csv');
    assert.deepEqual(table.map((r) => r.status), Array(8).fill('ok'));
    return read(cwd, 'table', 'sweep.csv');
  });
  assert.equal(tables[0], tables[1]);
});

test('messages as JSON: every line is one object, errors have their key; checks as JSON', () => {
  const cwd = folder('messages');
  writeFileSync(join(cwd, 'case.yaml'), beam);
  writeFileSync(join(cwd, 'wrong.yaml'), beam.replace('nu: 0.3', 'nu: 3').replace('elements: 8', 'elemens: 8'));
  const lines = (said) => said.trimEnd().split('\n').map((line) => JSON.parse(line));
  const good = run(cwd, 'sweep', 'case.yaml', '--out', 's', '--vary', 'parts.tip.mass=0.1,0.2', '--messages', 'json');
  assert.equal(good.status, 0);
  const last = lines(good.said).filter((m) => m.kind === 'progress').at(-1);
  assert.match(last.stage, /2 of 2 variants/);
  assert.equal(last.share, 1);
  const wrong = lines(run(cwd, 'run', 'wrong.yaml', '--out', 'r', '--messages=json').said);
  assert.ok(wrong.every((m) => m.kind === 'error' && m.line > 0 && m.file === 'wrong.yaml'));
  assert.deepEqual(wrong.map((m) => m.key), ['materials.steel.nu', 'parts.beam.elemens']);
  assert.equal(lines(run(cwd, 'run', 'case.yaml', '--no-such', '--messages', 'json').said)[0].kind, 'failure');
  assert.equal(lines(run(cwd, 'rum', '--messages', 'json').said)[0].kind, 'failure');
  const check = run(cwd, 'check', 'case.yaml', '--json');
  assert.equal(check.status, 0, check.said);
  assert.ok(JSON.parse(check.printed).model.nodes >= 9);
  const bad = run(cwd, 'check', 'wrong.yaml', '--json');
  assert.equal(bad.status, 1);
  assert.equal(bad.said, '');
  assert.deepEqual(JSON.parse(bad.printed).problems.map((p) => p.key), ['materials.steel.nu', 'parts.beam.elemens']);
  const set = run(cwd, 'check', 'case.yaml', '--set', 'parts.tip.mas=1');
  assert.equal(set.status, 1);
  assert.match(set.said, /parts\.tip\.mas.*mass/);
});
