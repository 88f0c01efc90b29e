// What runs take of memory beside what `plica check` foretells, by the way they are solved.
//
//   node bench/memory.mjs PLICA
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const plica = process.argv[2];
const work = mkdtempSync(join(tmpdir(), 'plica-memory-'));
const whole = join(dirname(fileURLToPath(import.meta.url)), 'a2_peer.yaml');
const reduced = join(work, 'reduced.yaml');
writeFileSync(reduced, readFileSync(whole, 'utf8').replace('  static: true', '  static: true\n  reduction: {cutoff: 2000 Hz}'));

const lineOf = (around) => {
  const file = join(work, `line_${around}.yaml`);
  execFileSync(process.execPath, [join(dirname(whole), 'line_case.mjs'), file, '50', `${around}`]);
  return file;
};
const fine = ['parts.bellows.mesh.wall=8', 'parts.bellows.mesh.arc=4'];
const symmetric = 'analyses.symmetry=automatic';
const runs = [
  ...[24, 48, 96, 144].map((around) => [whole, [`parts.bellows.mesh.around=${around}`]]),
  ...[30, 60, 100].map((count) => [whole, [`analyses.modes.count=${count}`]]),
  ...[48, 192, 400, 1000].map((around) => [whole, [symmetric, ...(around > 48 ? fine : []), `parts.bellows.mesh.around=${around}`]]),
  ...[40, 100].map((count) => [whole, [symmetric, ...fine, 'parts.bellows.mesh.around=192', `analyses.modes.count=${count}`]]),
  ...[48, 96].map((around) => [reduced, [`parts.bellows.mesh.around=${around}`, 'analyses.modes.count=30']]),
  ...[192, 576].map((around) => [reduced, [symmetric, `parts.bellows.mesh.around=${around}`, 'analyses.modes.count=30']]),
  ...[48, 400].map((around) => [lineOf(around), []]),
];

console.log('unknowns modes    GB  foretold      s  how');
try {
  for (const [file, set] of runs) {
    const options = set.flatMap((s) => ['--set', s]);
    const check = JSON.parse(execFileSync(plica, ['check', file, '--json', '--only', 'json', ...options], { encoding: 'utf8' }));
    execFileSync(plica, ['run', file, '--threads', '2', '--quiet', '--only', 'json', '--out', join(work, 'out'), ...options], { stdio: 'ignore' });
    const r = JSON.parse(readFileSync(join(work, 'out', 'results.json'), 'utf8'));
    const seconds = Object.values(r.timing).reduce((a, b) => a + b, 0);
    console.log([String(r.model.dofs).padStart(8), String(r.modes.length).padStart(5), (r.peak_memory / 1e9).toFixed(2).padStart(5),
      (check.estimate.memory / 1e9).toFixed(2).padStart(9), seconds.toFixed(1).padStart(6), ` ${r.route}`].join(' '));
  }
} finally {
  rmSync(work, { recursive: true, force: true });
}
