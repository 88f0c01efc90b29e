// Draws the rooms and what each links as SVG, from the lists that CMake writes.
//
//   node cmake/draw_house.mjs build/rooms.txt docs/pictures/house.svg
import { readFileSync, writeFileSync } from 'node:fs';

const [from, to] = process.argv.slice(2);
const rooms = new Map();
for (const line of readFileSync(from, 'utf8').trim().split('\n')) {
  const [folder, target, ...links] = line.split(' ');
  rooms.set(target, { folder, links: links.filter((link) => rooms.has(link)), row: 0 });
}
const reaches = (target, other) =>
  rooms.get(target).links.some((link) => link === other || reaches(link, other));
for (const room of rooms.values()) { // what another link brings anyway is not drawn
  room.drawn = room.links.filter((link) => !room.links.some((l) => l !== link && reaches(l, link)));
  room.row = 1 + Math.max(-1, ...room.links.map((link) => rooms.get(link).row));
}

const width = 150, height = 34, apart = 26, between = 46;
const rows = [];
for (const room of rooms.values()) (rows[room.row] ??= []).push(room);
const whole = Math.max(...rows.map((row) => row.length)) * (width + apart) + apart;
rows.forEach((row, r) => row.forEach((room, i) => {
  const left = (whole - row.length * (width + apart) + apart) / 2;
  room.x = left + i * (width + apart);
  room.y = 20 + (rows.length - 1 - r) * (height + between);
}));

const lines = [], boxes = [];
for (const room of rooms.values()) {
  for (const link of room.drawn) {
    const below = rooms.get(link);
    const x1 = room.x + width / 2, y1 = room.y + height, x2 = below.x + width / 2, y2 = below.y;
    const bend = (y2 - y1) / 2;
    lines.push(`<path d="M${x1} ${y1}C${x1} ${y1 + bend} ${x2} ${y2 - bend} ${x2} ${y2}"/>`);
  }
  boxes.push(`<rect x="${room.x}" y="${room.y}" width="${width}" height="${height}" rx="4"/>` +
    `<text x="${room.x + width / 2}" y="${room.y + height / 2 + 4}">${room.folder}</text>`);
}
const tall = 40 + rows.length * (height + between) - between;
writeFileSync(to, `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${whole} ${tall}" font-family="sans-serif" font-size="13">
<title>The rooms of Plica: each links what its lines lead down to</title>
<rect width="${whole}" height="${tall}" fill="white"/>
<g fill="none" stroke="#7a8794">${lines.join('\n')}</g>
<g fill="#eef2f6" stroke="#44525f" text-anchor="middle">${boxes.join('\n').replaceAll('<text', '<text fill="#1d252c" stroke="none"')}</g>
</svg>
`);
