// Draws the ninety bellows as docs/pictures/ejma_ninety.svg: shells over EJMA's S5 + S6, and the
// axial stiffness, over C2, a line for every C1.
//
//   build/tests/plica_tests --gtest_filter='EjmaSweepSlow.shells_beside*' > table.txt
//   node tests/draw_ejma_sweep.mjs table.txt docs/pictures/ejma_ninety.svg
import { readFileSync, writeFileSync } from 'node:fs';

const [table, out] = process.argv.slice(2);
const rows = readFileSync(table, 'utf8').split('\n')
  .filter((line) => /^\| \d/.test(line))
  .map((line) => line.split('|').slice(1, -1).map(Number));
if (rows.length < 60) throw new Error(`${table} has ${rows.length} bellows, at least 60 are wanted`);

const colours = { 0.2: '#0072b2', 0.3: '#56b4e9', 0.4: '#009e73', 0.5: '#e69f00', 0.6: '#d55e00' };
const quantities = [[3, 'axial stiffness'], [4, 'S5 + S6, axial, inner'], [5, 'S5 + S6, axial, whole'],
  [6, 'S5 + S6, lateral'], [7, 'S5 + S6, angular']];
const [wide, high, left, top] = [200, 190, 44, 40];
const low = 0.6, most = 1.5;
const x = (C2) => (C2 / 3.2) * (wide - 20);
const y = (ratio) => high - 30 - ((ratio - low) / (most - low)) * (high - 40);
const text = (at, up, words, more = '') => `<text x="${at}" y="${up}" font-size="11" ${more}>${words}</text>`;

const panel = ([column, name], slenderness, px, py) => {
  let svg = `<g transform="translate(${px} ${py})">` + text(0, 0, `${name}, Dm/w = ${slenderness}`);
  for (let r = low; r <= most + 1e-9; r += 0.1) {
    const one = Math.abs(r - 1) < 1e-9;
    svg += `<line x1="0" x2="${wide - 20}" y1="${y(r)}" y2="${y(r)}" stroke="${one ? '#555' : '#ddd'}"/>`;
    if (Math.round(r * 10) % 2 === 0) svg += text(-6, y(r) + 4, r.toFixed(1), 'text-anchor="end" fill="#555"');
  }
  for (const C2 of [1, 2, 3]) svg += text(x(C2), high - 14, String(C2), 'text-anchor="middle" fill="#555"');
  svg += text((wide - 20) / 2, high - 2, 'C2', 'text-anchor="middle" fill="#555"');
  for (const [C1, colour] of Object.entries(colours)) {
    const own = rows.filter((r) => r[0] === slenderness && r[1] === Number(C1));
    svg += `<polyline fill="none" stroke="${colour}" stroke-width="1.5" points="${own
      .map((r) => `${x(r[2]).toFixed(1)},${y(r[column]).toFixed(1)}`).join(' ')}"/>`;
    for (const r of own) svg += `<circle cx="${x(r[2]).toFixed(1)}" cy="${y(r[column]).toFixed(1)}" r="2" fill="${colour}"/>`;
  }
  return `${svg}</g>`;
};

const width = left + quantities.length * wide, height = top + 2 * high + 30;
let svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="sans-serif">`
  + `<rect width="${width}" height="${height}" fill="#fff"/>`
  + text(left, 16, `Shells over EJMA, ${rows.length} bellows of eight convolutions; C1:`);
Object.entries(colours).forEach(([C1, colour], i) => {
  svg += `<line x1="${380 + 60 * i}" x2="${396 + 60 * i}" y1="12" y2="12" stroke="${colour}" stroke-width="3"/>`
    + text(400 + 60 * i, 16, C1);
});
[20, 8].forEach((slenderness, row) => quantities.forEach((quantity, i) => {
  svg += panel(quantity, slenderness, left + i * wide, top + row * (high + 14));
}));
writeFileSync(out, `${svg}</svg>\n`);
