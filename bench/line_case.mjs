// Writes the case of an exhaust line: pipes and bellows in turn, each a superelement, equal ones reduced once.
//
//   node bench/line_case.mjs OUT.yaml [PARTS] [AROUND]      50 parts of 400 elements around: 10 M unknowns
import { writeFileSync } from 'node:fs';

const [out, parts = '50', around = '400'] = process.argv.slice(2);
const count = Number(parts), mesh = `{around: ${around}, arc: 3, wall: 4}`;
const pipe = { length: 200, profile: '[{shape: cuff, length: 200 mm, elements: 43}]', wall: '{plies: [1.5 mm]}' };
const bellows = { length: 43.68, wall: '{plies: [0.25 mm, 0.25 mm], bond: 0}',
  profile: '[{shape: cuff, length: 2.1 mm}, {shape: U, count: 6, height: 8 mm, pitch: 6.58 mm}, {shape: cuff, length: 2.1 mm}]' };

const names = [], lines = [], sensors = [];
let y = 0;
for (let i = 1; i <= count; ++i) {
  const kind = i % 2 ? pipe : bellows, name = `${i % 2 ? 'pipe' : 'bellows'}_${i}`;
  lines.push(`  ${name}: {type: bellows, material: steel, root_radius: 65 mm, start: ${y.toFixed(2)} mm, profile: ${kind.profile}, wall: ${kind.wall}, mesh: ${mesh}}`);
  if (i % 2) sensors.push(`  - {name: on_${name}, at: [0, ${(y + 100).toFixed(2)} mm, 65 mm]}`);
  names.push(name);
  y += kind.length;
}
const caps = names.slice(1).map((name, i) => `  joint_${i + 1}: {of: [${names[i]}.right, ${name}.left], mass: 0.2 kg}`);
const hangers = names.slice(1).map((_, i) => i + 1).filter((i) => i % 8 === 0);

writeFileSync(out, `# An exhaust line of ${count} superelements; written by bench/line_case.mjs.
case: line
materials:
  steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}
parts:
${lines.join('\n')}
caps:
  engine: {of: ${names[0]}.left}
${caps.join('\n')}
  tail: {of: ${names.at(-1)}.right, mass: 1 kg}
mount:
  engine: rigid
${hangers.map((i) => `  joint_${i}: {stiffness: [20 kN/m, 20 kN/m, 20 kN/m, 0 Nm/rad, 0 Nm/rad, 0 Nm/rad]}`).join('\n')}
sensors:
${sensors.slice(0, 20).join('\n')}
analyses:
  static: false
  reduction: {cutoff: 1000 Hz} # twice the band
  modes: {band: [1 Hz, 500 Hz]}
  damping: {modal: 2 %}
  response: {base: [x, y, z], level: 1 m/s2, band: [5 Hz, 500 Hz]}
  error_bars: false
`);
