// The report of a diagnosis in headless Chromium: its first screen says what, where, how far and
// what to measure next; it loads without an error and without the network.
//
//   node --test diagnosis.test.mjs   with  REPORT (an html file), PACKAGES (a node_modules folder),
//                                          PICTURES (a folder for screenshots)
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page, picture, seen, withReport } from './chromium.mjs';

withReport();

const screen = 900; // px

// Cells of the waterfall, row by row: words, share in percents, interval, probability, bar.
const waterfall = () => page.locator('.answer table tbody tr').evaluateAll((rows) =>
  rows.map((row) => [...row.cells].map((cell) => cell.innerText.trim())));

test('the first screen says the cause, how far it goes and where it sits', async () => {
  await page.screenshot({ path: picture('diagnosis-first') });
  const words = await page.locator('.verdict').first().innerText();
  assert.match(words, /^[!✓]\s.*\d+ % of the gap \[\d+, \d+\]/s);
  for (const what of ['.verdict', '.viewer canvas', '.answer table tbody tr:nth-child(2)']) {
    const box = await page.locator(what).first().boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height < screen, `${what} ends at ${box.y + box.height}`);
  }
});

test('what is told in the waterfall adds up and is marked on the part', async () => {
  const [whole, ...rows] = await waterfall();
  assert.equal(Number(whole[1]), 100);
  const sum = rows.reduce((all, row) => all + Number(row[1].replace('−', '-')), 0);
  assert.ok(Math.abs(sum - 100) <= 0.5 * rows.length, `shares add up to ${sum}`);
  const told = rows.filter(([words]) => /^\d+ /.test(words)).map(([words]) => words.match(/^\d+/)[0]);
  assert.ok(told.length > 0, 'no effect is told');
  const marked = await page.locator('.viewer .tag.sensor').allInnerTexts();
  for (const number of told) assert.ok(marked.includes(number), `${number} is not among ${marked}`);
});

test('what to measure next stands beside it, and evidence below', async () => {
  const y = async (words) => (await page.getByText(words).first().boundingBox()).y;
  const next = await y('To measure next: ');
  assert.ok(next > await y('the gap of the nominal case') && next < await y('What this test can tell apart'));
  const places = await page.locator('#which table').last().locator('tbody tr').first().innerText();
  assert.match(places, /\S+\s+\d/);
});

test('test and models answer the cursor', async () => {
  const plot = page.locator('#responses figure.plot.is-live').first();
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.locator('.u-over').boundingBox();
  await page.mouse.move(box.x + box.width / 3, box.y + box.height / 2);
  const names = await plot.locator('.u-legend .u-label').allInnerTexts();
  const values = await plot.locator('.u-legend .u-value').allInnerTexts();
  assert.ok(['test', 'nominal', 'best'].every((name) => names.includes(name)), names.join(', '));
  assert.ok(values.every((v) => Number(v) > 0), values.join(', '));
});

test('no error was said and nothing was fetched', () => {
  assert.deepEqual(seen, { errors: [], requests: [] });
});
