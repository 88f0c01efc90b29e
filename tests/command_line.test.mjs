// The program as its users start it: what it refuses, what it leaves alone, how it ends.
//
//   node --test command_line.test.mjs   with  PLICA (the program), SOURCE (the tree), WORK (a folder)
import assert from 'node:assert/strict';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { existsSync, linkSync, mkdirSync, readdirSync, readFileSync, renameSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, plica, runner } from './program.mjs';

// A plate on one edge, with a force and motion of its base.
const plate = (more = '', title = 'a plate', variants = '') => `case: plate
title: "${title}"
materials:
  steel: {E: 210 GPa, nu: 0.3, rho: 7850 kg/m3}
parts:
  web:
    type: plate
    material: steel
    corners: [[0, 0, 0], [0.1, 0, 0], [0.1, 0.2, 0], [0, 0.2, 0]]
    thickness: 1 mm
    elements: [4, 6]
supports: [{set: web.edge1, fix: [ux, uy, uz, rx, ry, rz]}]
sensors: [{name: tip, at: [0.1, 0.2, 0]}]
${variants}
analyses:
  static: false
  modes: {count: 4}
  damping: {modal: 1 %}
  error_bars: false
  ${more}
`;
const response = 'response: {base: [z], band: [10 Hz, 300 Hz], points: 30}';

const run = runner(60000);
function shell(cwd, command, input = {}) {
  const { status, stdout, stderr } = spawnSync('sh', ['-c', command], { cwd, encoding: 'utf8',
    env: { ...process.env, ...input }, timeout: 60000 });
  return { status, said: stderr, printed: stdout };
}

test('a run into the folder of the lab deletes none of its files', () => {
  const lab = folder('lab');
  writeFileSync(join(lab, 'case.yaml'), plate());
  const files = ['random_y.csv', 'level_10.csv', 'response_shaker.csv', 'motion_table.csv',
    'levels_2024.csv', 'stress.csv', 'responses.uff', 'mode_shapes.obj', 'error_bars.csv'];
  for (const name of files) writeFileSync(join(lab, name), 'lab data');
  for (const more of [['--geometry', 'obj'], [], ['--geometry', 'obj']]) {
    const { status, said } = run(lab, 'run', 'case.yaml', '--out', '.', '--quiet', ...more);
    assert.equal(status, 0, said);
    for (const name of files) assert.equal(readFileSync(join(lab, name), 'utf8'), 'lab data', name);
    assert.equal(existsSync(join(lab, 'mode_01.obj')), more.length > 0); // of its own it does
  }
});

test('what the machine cannot hold is refused beforehand, with exit code 4 and what to do', () => {
  const lab = folder('memory');
  writeFileSync(join(lab, 'case.yaml'), plate());
  const small = { PLICA_MEMORY: '0.05' };
  const refused = shell(lab, '"$PLICA" run case.yaml --out made', { PLICA: plica, ...small });
  assert.equal(refused.status, 4, refused.said);
  assert.match(refused.said, /210 unknowns\) needs about 0\.11 GB; PLICA_MEMORY is 0\.05 GB\. .*a coarser mesh/s);
  assert.deepEqual(readdirSync(join(lab, 'made')), []);
  const checked = shell(lab, '"$PLICA" check case.yaml', { PLICA: plica, ...small });
  assert.equal(checked.status, 4);
  assert.match(checked.printed, /estimate: 0\.111 GB of 0\.05 GB \(PLICA_MEMORY\)/);
  const json = shell(lab, '"$PLICA" check case.yaml --json', { PLICA: plica, ...small });
  assert.equal(json.status, 4);
  assert.match(JSON.parse(json.printed).too_large, /needs about/);
  assert.equal(run(lab, 'reduce', 'case.yaml', '--out', 'made', '--quiet').status, 1); // no caps

  writeFileSync(join(lab, 'fine.yaml'), plate().replace('[4, 6]', '[2000, 2000]'));
  const began = Date.now();
  const fine = shell(lab, '"$PLICA" run fine.yaml --out made', { PLICA: plica, PLICA_MEMORY: '8' });
  assert.equal(fine.status, 4, fine.said);
  assert.match(fine.said, /a plate of 2000 by 2000 elements needs about 9\.6 GB; PLICA_MEMORY is 8 GB/);
  assert.ok(Date.now() - began < 20000, 'it was meshed first');
  const odd = shell(lab, '"$PLICA" run case.yaml --out made', { PLICA: plica, PLICA_MEMORY: 'much' });
  assert.match(odd.said, /PLICA_MEMORY is 'much', no number above 0/);
});

test('no command writes over what it reads, by whatever name', () => {
  const lab = folder('inputs');
  writeFileSync(join(lab, 'case.yaml'), plate(response));
  assert.equal(run(lab, 'run', 'case.yaml', '--out', 'made', '--quiet').status, 0);
  renameSync(join(lab, 'made', 'responses.uff'), join(lab, 'frf.uff'));
  writeFileSync(join(lab, 'simulated.yaml'), plate());
  mkdirSync(join(lab, 'hard'));
  linkSync(join(lab, 'frf.uff'), join(lab, 'hard', 'frf.uff'));
  mkdirSync(join(lab, 'soft'));
  symlinkSync('../frf.uff', join(lab, 'soft', 'frf.uff'));
  const before = readFileSync(join(lab, 'frf.uff'), 'utf8');
  for (const [args, name] of [
    [['identify', 'frf.uff', '--out', '.'], './frf.uff'],
    [['identify', 'frf.uff', '--out', 'hard'], 'hard/frf.uff'],
    [['identify', 'frf.uff', '--out', 'soft'], 'soft/frf.uff'],
    [['run', 'simulated.yaml', '--out', '.'], './simulated.yaml'],
  ]) {
    const { status, said } = run(lab, ...args);
    assert.equal(status, 1, args.join(' '));
    assert.ok(said.includes(`${name}: is an input of this command`), said);
  }
  assert.equal(readFileSync(join(lab, 'frf.uff'), 'utf8'), before);
  assert.equal(readFileSync(join(lab, 'simulated.yaml'), 'utf8'), plate());
});

test('the commands keep their files apart in one folder', () => {
  const lab = folder('apart');
  writeFileSync(join(lab, 'case.yaml'), plate(response));
  assert.equal(run(lab, 'run', 'case.yaml', '--quiet').status, 0);
  const out = join(lab, 'out');
  const before = Object.fromEntries(readdirSync(out).filter((n) => n !== 'plica_files.json')
    .map((name) => [name, readFileSync(join(out, name), 'utf8')]));
  const all = new Map(Object.keys(before).map((name) => [name, 'run']));
  for (const args of [['compare', 'out', 'out'], ['identify', 'out/responses.uff'],
    ['diagnose', 'case.yaml', '--pretest'], ['run', 'case.yaml', '--write-deck', 'nastran']]) {
    const { status, said } = run(lab, ...args, '--quiet');
    assert.ok(status === 0 || status === 2, `${args}: ${said}`);
    for (const name of readdirSync(out)) if (!all.has(name)) all.set(name, args[0]);
  }
  for (const name of ['correlation.html', 'identification.html', 'pretest.html', 'model.bdf'])
    assert.ok(all.has(name), `${name} of ${[...all.keys()]}`);
  for (const [name, text] of Object.entries(before))
    assert.equal(readFileSync(join(out, name), 'utf8'), text, name);
});

test('a name that is taken is refused before the work, and an own file that was changed', () => {
  const lab = folder('taken');
  writeFileSync(join(lab, 'case.yaml'), plate());
  mkdirSync(join(lab, 'o'));
  writeFileSync(join(lab, 'o', 'modes.csv'), 'lab data');
  let { status, said } = run(lab, 'run', 'case.yaml', '--out', 'o');
  assert.equal(status, 1);
  assert.match(said, /^o\/modes.csv: is no file that plica wrote.*--out\n$/); // and no stage
  assert.equal(run(lab, 'run', 'case.yaml', '--out', 'p', '--quiet').status, 0);
  writeFileSync(join(lab, 'p', 'modes.csv'), 'of the user');
  ({ status, said } = run(lab, 'run', 'case.yaml', '--out', 'p'));
  assert.equal(status, 1);
  assert.match(said, /p\/modes.csv: was changed since plica wrote it/);
});

test('standard error that cannot be written stops nothing', () => {
  const lab = folder('stderr');
  writeFileSync(join(lab, 'case.yaml'), plate());
  for (const [i, to] of ['2>/dev/full', '2>&-', '2>&- >/dev/null'].entries()) {
    assert.equal(shell(lab, `"$PLICA" run case.yaml --out o${i} ${to}`).status, 0, to);
    assert.ok(existsSync(join(lab, `o${i}`, 'results.json')), to);
  }
  shell(lab, '"$PLICA" run case.yaml --out gone 2>&1 >/dev/null | true'); // nobody reads it
  assert.ok(existsSync(join(lab, 'gone', 'results.json')));
  assert.equal(shell(lab, '"$PLICA" check none.yaml 2>&-').status, 1);
});

test('standard output that cannot be written ends in 1, with the files there', () => {
  const lab = folder('stdout');
  writeFileSync(join(lab, 'case.yaml'), plate());
  for (const [i, to] of ['>/dev/full', '>&-'].entries()) {
    const { status, said } = shell(lab, `"$PLICA" run case.yaml --out o${i} ${to}`);
    assert.equal(status, 1, to);
    assert.match(said, /standard output cannot be written/);
    assert.ok(existsSync(join(lab, `o${i}`, 'results.json')), to);
  }
  assert.equal(shell(lab, '"$PLICA" schema >/dev/full').status, 1);
  assert.equal(shell(lab, '"$PLICA" --help >/dev/full').status, 1);
});

// A run that stands still from its first word on.
function frozen(cwd, ...args) {
  return new Promise((resolve) => {
    const child = spawn(plica, args, { cwd });
    const ended = new Promise((end) => child.on('close', end));
    child.stdout.resume();
    child.stderr.once('data', () => {
      child.kill('SIGSTOP');
      child.stderr.resume();
      resolve({ child, ended });
    });
  });
}

test('two runs do not mix in one folder, and one that was killed blocks nobody', async () => {
  const lab = folder('two');
  writeFileSync(join(lab, 'a.yaml'), plate(response));
  writeFileSync(join(lab, 'b.yaml'), plate().replace('case: plate', 'case: other'));
  let { child, ended } = await frozen(lab, 'run', 'a.yaml', '--out', 'o');
  const second = run(lab, 'run', 'b.yaml', '--out', 'o');
  child.kill('SIGCONT');
  assert.equal(await ended, 0);
  assert.equal(second.status, 1);
  assert.ok(second.said.includes(`another plica (process ${child.pid}) is writing here`), second.said);
  assert.equal(JSON.parse(readFileSync(join(lab, 'o', 'results.json'), 'utf8')).case, 'plate');
  ({ child, ended } = await frozen(lab, 'run', 'a.yaml', '--out', 'o'));
  child.kill('SIGKILL');
  await ended;
  const third = run(lab, 'run', 'b.yaml', '--out', 'o', '--quiet');
  assert.equal(third.status, 0, third.said);
  assert.equal(JSON.parse(readFileSync(join(lab, 'o', 'results.json'), 'utf8')).case, 'other');
  assert.deepEqual(readdirSync(join(lab, 'o')).filter((name) => name.startsWith('.')), []);
  assert.ok(!existsSync(join(lab, 'o', 'response_z.csv'))); // of the other case
});

test('the report shows the case that was run, also when its file is changed or goes meanwhile', async () => {
  const lab = folder('once');
  const variants = 'variants: [{name: thin, set: {parts.web.thickness: 0.5 mm}}]';
  writeFileSync(join(lab, 'a.yaml'), plate('', 'as it was', variants));
  for (const change of [
    () => writeFileSync(join(lab, 'a.yaml'), plate('', 'changed since', variants).replace('210', '70')),
    () => renameSync(join(lab, 'a.yaml'), join(lab, 'b.yaml'))]) {
    writeFileSync(join(lab, 'a.yaml'), plate('', 'as it was', variants));
    const { child, ended } = await frozen(lab, 'run', 'a.yaml', '--out', 'o');
    change();
    child.kill('SIGCONT');
    assert.equal(await ended, 0);
    const report = readFileSync(join(lab, 'o', 'report.html'), 'utf8');
    assert.ok(report.includes('as it was') && !report.includes('changed since'));
    assert.ok(report.includes('210 GPa') && !report.includes('70 GPa'));
    const rows = readFileSync(join(lab, 'o', 'variants.csv'), 'utf8').trim().split('\n');
    assert.equal(rows.length, 3);
  }
});

test('control characters of names and titles do not reach the terminal', () => {
  const lab = folder('control');
  writeFileSync(join(lab, 'case.yaml'), plate('', 'a\\e[2J\\u009b31m\\u202eplate'));
  const { status, said, printed } = run(lab, 'run', 'case.yaml', '--out', 'o');
  assert.equal(status, 0, said);
  assert.ok(printed.includes('a\\x1b[2J\\xc2\\x9b31m'), printed);
  // eslint-disable-next-line no-control-regex
  assert.doesNotMatch(said + printed, /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u202e]/);
  const wrong = run(lab, 'run', '\u001b[2J.yaml');
  assert.doesNotMatch(wrong.said, /\u001b/);
});

test('no table holds a cell that a spreadsheet would execute', () => {
  const lab = folder('cells');
  writeFileSync(join(lab, 'case.yaml'), plate('', 'x', `variants:
  - {name: "=cmd|' /C calc'!A0", set: {parts.web.thickness: 2 mm}}
  - {name: "@SUM(1)", set: {parts.web.thickness: 3 mm}}
  - {name: "+1+2, three", set: {parts.web.thickness: 4 mm}}`));
  assert.equal(run(lab, 'run', 'case.yaml', '--out', 'o', '--quiet').status, 0);
  const text = readFileSync(join(lab, 'o', 'variants.csv'), 'utf8');
  assert.match(text, /^'=cmd\|/m);
  for (const name of readdirSync(join(lab, 'o')).filter((n) => n.endsWith('.csv')))
    assert.doesNotMatch(readFileSync(join(lab, 'o', name), 'utf8'), /(^|,)"?[=+@]/m, name);
});

test('pipes are refused as inputs and not waited for', () => {
  const lab = folder('pipes');
  for (const name of ['p.yaml', 'p.uff', 'p.csv', 'p.mat', 'p.json', 'p.inp'])
    execFileSync('mkfifo', [join(lab, name)]);
  writeFileSync(join(lab, 'case.yaml'), plate());
  for (const args of [['run', 'p.yaml'], ['check', 'p.yaml'], ['identify', 'p.yaml'],
    ['identify', 'p.uff'], ['identify', 'p.csv'], ['identify', 'p.mat'], ['compare', 'p.yaml', 'p.yaml'],
    ['diagnose', 'case.yaml', '--measured', 'p.yaml']]) {
    const { status, said } = run(lab, ...args);
    assert.equal(status, 1, `${args.join(' ')}: ${said}`);
    assert.match(said, /p\.[a-z]+: /);
  }
});

const deck = (name) => `case: c
parts: {a: {type: deck, file: ${name}, length_unit: m, mass_unit: kg}}
analyses: {static: false, modes: {count: 2}}
`;

test('sets of sets and files that include two others do not double', () => {
  const lab = folder('double');
  let text = `*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
*ELEMENT,TYPE=S4,ELSET=E
1,1,2,3,4
*SHELL SECTION,ELSET=E,MATERIAL=M
0.01
*MATERIAL,NAME=M
*ELASTIC
2e11,0.3
*DENSITY
7800
*NSET,NSET=N0
1
*ELSET,ELSET=L0
1
`;
  for (let i = 1; i < 40; ++i)
    text += `*NSET,NSET=N${i}\nN${i - 1},N${i - 1}\n*ELSET,ELSET=L${i}\nL${i - 1},L${i - 1}\n`;
  writeFileSync(join(lab, 'sets.inp'), text);
  writeFileSync(join(lab, 'sets.yaml'), deck('sets.inp'));
  const { status, said } = run(lab, 'check', 'sets.yaml');
  assert.equal(status, 0, said);
  for (const [ending, include] of [['inp', '*INCLUDE,INPUT='], ['bdf', 'INCLUDE ']]) {
    for (let i = 0; i < 19; ++i) {
      const line = `${include}${i + 1}.${ending}\n`;
      writeFileSync(join(lab, `${i}.${ending}`), line + line);
    }
    writeFileSync(join(lab, `19.${ending}`), '');
    writeFileSync(join(lab, `${ending}.yaml`), deck(`0.${ending}`));
    const files = run(lab, 'check', `${ending}.yaml`);
    assert.equal(files.status, 1);
    assert.match(files.said, /more than 1000 files are included/);
  }
});

test('200 000 keys are read in seconds', () => {
  const lab = folder('keys');
  const many = (f) => Array.from({ length: 200000 }, (_, i) => f(i)).join('');
  writeFileSync(join(lab, 'top.yaml'), plate() + many((i) => `k${i}: 1\n`));
  writeFileSync(join(lab, 'set.yaml'),
    plate('', 'x', `variants: [{name: v, set: {${many((i) => `k${i}: 1, `)}}}]`));
  writeFileSync(join(lab, 'materials.yaml'),
    plate().replace('materials:\n', `materials:\n${many((i) => i < 10000
      ? `  m${i}: {E: 1 GPa, nu: 0.3, rho: 1000}\n` : '')}`));
  for (const [name, status] of [['top', 1], ['set', 1], ['materials', 0]]) {
    const start = Date.now();
    const done = run(lab, 'check', `${name}.yaml`);
    assert.equal(done.status, status, done.said.slice(0, 300));
    assert.ok(Date.now() - start < 20000, `${name}: ${Date.now() - start} ms`);
    assert.ok(done.said.length < 20000);
  }
});

test('a column of another code page is identified and written', () => {
  const lab = folder('latin');
  const rows = [];
  for (let f = 5; f <= 60; f += 0.25) { // one mode at 20 Hz, 2 %
    const a = 400 - f * f, b = 2 * 0.02 * 20 * f, d = a * a + b * b;
    rows.push(`${f},${(-f * f * a) / d},${(f * f * b) / d}`);
  }
  const head = Buffer.from('frequency [Hz],K\u00f6rper x real,K\u00f6rper x imaginary\n', 'latin1');
  writeFileSync(join(lab, 'frf.csv'), Buffer.concat([head, Buffer.from(rows.join('\n') + '\n')]));
  const { status, said, printed } = run(lab, 'identify', 'frf.csv', '--out', 'o');
  assert.equal(status, 0, said);
  assert.match(printed, /\b20\.0/);
  const json = JSON.parse(readFileSync(join(lab, 'o', 'identification.json'), 'utf8'));
  assert.equal(json.responses[0], 'K\u00f6rper.x');
});

test('a full disk is an error that leaves what was there', () => {
  const lab = folder('full');
  writeFileSync(join(lab, 'case.yaml'), plate(response));
  assert.equal(run(lab, 'run', 'case.yaml', '--out', 'o', '--quiet').status, 0);
  const before = readdirSync(join(lab, 'o'));
  // A limit of 5 kB on every file stands for the disk.
  for (const more of ['', '--geometry msh', '--geometry stl', '--geometry glb', '--geometry uff']) {
    const { status, said } = shell(lab, `ulimit -f 10; "$PLICA" run case.yaml --out o --quiet ${more}`);
    assert.equal(status, 1, said);
    assert.match(said, /o\/.*cannot/);
    assert.deepEqual(readdirSync(join(lab, 'o')), before);
  }
  const reduced = shell(lab, 'ulimit -f 10; "$PLICA" init pipe && ulimit -f 1; "$PLICA" init two');
  assert.equal(reduced.status, 1);
  assert.ok(!existsSync(join(lab, 'two.yaml')));
});

test('make takes names with blanks and quotes', () => {
  const lab = folder('make it');
  writeFileSync(join(lab, "a 'b.yaml"), plate());
  const { status, stdout, stderr } = spawnSync('make', ['-o', 'program', 'run',
    `CASE=${join(lab, "a 'b.yaml")}`, `OUT=${join(lab, 'o ut')}`],
  { cwd: process.env.SOURCE, encoding: 'utf8', env: { ...process.env, DISPLAY: '', WAYLAND_DISPLAY: '' } });
  assert.equal(status, 0, stdout + stderr);
  assert.ok(existsSync(join(lab, 'o ut', 'report.html')));
});

test('doubts about a case are said when it fails, too', () => {
  const lab = folder('doubts');
  // Walls far thicker than their elements, and a model that is held everywhere.
  writeFileSync(join(lab, 'case.yaml'), plate().replace('thickness: 1 mm', 'thickness: 60 mm')
    .replace('{set: web.edge1,', '{set: web.all,'));
  const { status, said } = run(lab, 'run', 'case.yaml', '--out', 'o');
  assert.notEqual(status, 0);
  assert.match(said, /warning: .* wall of 60 mm/);
});

test('a folder stands for the one case in it', () => {
  const lab = folder('one_case');
  mkdirSync(join(lab, 'pipe'));
  writeFileSync(join(lab, 'pipe', 'measured.yaml'), 'specimen: plate\n');
  const none = run(lab, 'check', 'pipe');
  assert.equal(none.status, 1);
  assert.match(none.said, /pipe: has no case in it; .*one case file/);
  writeFileSync(join(lab, 'pipe', 'any_name.yaml'), plate());
  assert.equal(run(lab, 'run', 'pipe', '--quiet', '--out', 'made').status, 0);
  assert.ok(existsSync(join(lab, 'made', 'results.json')));
  writeFileSync(join(lab, 'pipe', 'other.yaml'), plate());
  const several = run(lab, 'run', 'pipe', '--quiet', '--out', 'made');
  assert.equal(several.status, 1);
  assert.match(several.said, /pipe: has several cases in it; .*any_name\.yaml, other\.yaml/);
  writeFileSync(join(lab, 'pipe', 'pipe.yaml'), plate()); // the one with its name goes first
  assert.equal(run(lab, 'run', 'pipe', '--quiet', '--out', 'made').status, 0);
});
