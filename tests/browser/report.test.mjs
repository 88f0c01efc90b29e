// The report in headless Chromium: loads without an error and without the network, the part turns, a
// mode plays, a plot answers the cursor, paper and dark rooms are served.
//
//   node --test report.test.mjs   with  REPORT (an html file), PACKAGES (a node_modules folder),
//                                       PICTURES (a folder for screenshots)
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { browser, page, picture, report, seen, withReport } from './chromium.mjs';

withReport();

// What the canvas of the part shows: a number that any change of it changes.
const shown = () => page.evaluate(() => {
  const canvas = document.querySelector('.viewer canvas');
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const data = context.getImageData(0, 0, copy.width, copy.height).data;
  let sum = 0;
  let painted = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 0) ++painted;
    sum = (sum * 31 + data[i] + 3 * data[i + 1] + 7 * data[i + 2] + 11 * data[i + 3]) % 4294967291;
  }
  return { sum, share: painted / (copy.width * copy.height) };
});

// Waits until the part was drawn some times more, however slow the machine.
const framesLater = async (more) => {
  const frames = () => page.evaluate(() => Number(document.querySelector('.viewer').dataset.frames));
  const wanted = (await frames()) + more;
  await page.waitForFunction((n) => Number(document.querySelector('.viewer').dataset.frames) >= n, wanted);
};

// Waits until each drawing has the width of its place, however slow the machine.
const fitted = () => page.waitForFunction(() => [...document.querySelectorAll('.live')].every((place) =>
  [...place.querySelectorAll('canvas')].every((c) => Math.abs(c.clientWidth - place.clientWidth) < 2)));

test('the part is drawn', async () => {
  const { share } = await shown();
  assert.ok(share > 0.03, `only ${share} of the canvas is painted`);
  assert.ok(share < 0.9, 'the part fills the canvas');
  await page.locator('.viewer').screenshot({ path: picture('part') });
});

test('the part turns under the mouse and comes back', async () => {
  const before = await shown();
  const box = await page.locator('.viewer canvas').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 140, box.y + box.height / 2 + 60, { steps: 8 });
  await page.mouse.up();
  const turned = await shown();
  assert.notEqual(turned.sum, before.sum);
  await page.getByRole('button', { name: 'view from the start' }).click();
  assert.equal((await shown()).sum, before.sum);
});

test('what is farthest from the test is said first, and the mode that shows it is drawn', async () => {
  const first = page.locator('.verdict').first();
  const words = await first.innerText();
  assert.match(words, /^[!✓]\sFarthest from the test: axial stiffness, .* Drawn: mode \d+, axial 1\./s);
  const mode = Number(/mode (\d+)/.exec(words)[1]);
  assert.equal(await page.getByLabel('mode', { exact: true }).inputValue(), String(mode - 1));
  for (const what of ['.viewer canvas', '.first table']) {
    const box = await page.locator(what).first().boundingBox();
    assert.ok(box.y + box.height < 900, `${what} ends at ${box.y + box.height}`);
  }
  await page.screenshot({ path: picture('first') });
});

test('a mode plays, pauses and shows its displacement', async () => {
  await page.getByLabel('mode', { exact: true }).selectOption('-1');
  const rest = await shown();
  await page.getByLabel('mode', { exact: true }).selectOption('0');
  await framesLater(2);
  const first = await shown();
  assert.notEqual(first.sum, rest.sum);
  let second = first; // a busy machine may show the same phase twice
  for (let frame = 0; frame < 40 && second.sum === first.sum; ++frame) {
    await framesLater(1);
    second = await shown();
  }
  assert.notEqual(first.sum, second.sum, 'the mode does not move');
  await page.getByRole('button', { name: 'pause' }).click();
  const paused = await shown();
  await page.waitForTimeout(200);
  assert.equal((await shown()).sum, paused.sum);
  await page.locator('.viewer').screenshot({ path: picture('mode') });
  await page.getByLabel('amplitude').fill('3');
  assert.notEqual((await shown()).sum, paused.sum);
  await page.getByLabel('mode', { exact: true }).selectOption('-1');
  assert.equal((await shown()).sum, rest.sum, 'at rest is not the part at rest');
});

test('the small picture of a mode plays it', async () => {
  await page.locator('[data-mode="1"]').click();
  assert.equal(await page.getByLabel('mode', { exact: true }).inputValue(), '1');
  await page.getByRole('button', { name: 'pause' }).click();
  await page.getByLabel('mode', { exact: true }).selectOption('-1');
});

test('a plot answers the cursor, zooms and changes its axes', async () => {
  const plot = page.locator('figure.plot.is-live').first();
  await plot.scrollIntoViewIfNeeded();
  const legend = plot.locator('.u-legend');
  const over = plot.locator('.u-over');
  const box = await over.boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + box.height / 2);
  const values = async () => (await legend.locator('.u-value').allInnerTexts()).map(Number);
  const here = await values();
  assert.ok(here.length > 1 && here.every((v) => Number.isFinite(v) && v > 0), String(here));
  await page.mouse.move(box.x + 0.6 * box.width, box.y + box.height / 2);
  const there = await values();
  assert.ok(there[0] > here[0]);
  assert.notEqual(there[1], here[1]);
  await plot.screenshot({ path: picture('plot') });
  const range = () => plot.evaluate((f) => [f.plot.scales.x.min, f.plot.scales.x.max, f.plot.scales.y.distr]);
  const [low, high] = await range();
  await page.mouse.move(box.x + 0.4 * box.width, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  const zoomed = await range();
  assert.ok(zoomed[1] - zoomed[0] < 0.3 * (high - low));
  await plot.getByRole('button', { name: 'ordinate logarithmic' }).click();
  assert.equal((await range())[2], 1);
  await plot.getByRole('button', { name: 'abscissa logarithmic' }).click();
  await plot.screenshot({ path: picture('plot-axes') });
  await plot.getByRole('button', { name: 'abscissa logarithmic' }).click();
  await plot.getByRole('button', { name: 'ordinate logarithmic' }).click();
  assert.equal((await range())[2], 3);
});

test('what the cursor reads is what the page was given', async () => {
  const [read, given] = await page.locator('figure.plot.is-live').first().evaluate((f) => {
    const data = JSON.parse(f.querySelector('script').textContent);
    const grid = data.grids[data.curves[0].grid];
    const i = Math.floor(grid.length / 3);
    f.plot.setCursor({ left: f.plot.valToPos(grid[i], 'x'), top: 10 });
    const at = f.plot.cursor.idx;
    return [[f.plot.data[0][at], f.plot.data[1][at]], [grid[i], data.curves[0].values[i]]];
  });
  assert.deepEqual(read, given);
});

test('on paper the drawings stand, not the controls', async () => {
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('.viewer .part').isVisible(), true);
  assert.equal(await page.locator('.viewer canvas').isVisible(), false);
  assert.equal(await page.locator('figure.plot > svg').first().isVisible(), true);
  assert.equal(await page.locator('.controls').first().isVisible(), false);
  await page.pdf({ path: picture('paper').replace('.png', '.pdf'), format: 'A4' });
  await page.emulateMedia({ media: 'screen' });
});

test('a dark room is served', async () => {
  await page.emulateMedia({ colorScheme: 'dark' });
  const [paper, ink] = await page.evaluate(() => {
    const light = (colour) => colour.match(/\d+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0);
    const body = getComputedStyle(document.body);
    return [light(body.backgroundColor), light(body.color)];
  });
  assert.ok(paper < 150 && ink > 500);
  await page.evaluate(() => scrollTo(0, 0));
  await page.screenshot({ path: picture('dark') });
  await page.emulateMedia({ colorScheme: 'light' });
});

test('a narrow window needs no scrolling sideways', async () => {
  await page.setViewportSize({ width: 420, height: 800 });
  const [inside, wide] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
  assert.ok(wide <= inside + 1, `${wide} in ${inside}`); // whether the drawings have followed or not
  await fitted();
  await page.screenshot({ path: picture('narrow') });
  await page.setViewportSize({ width: 1200, height: 900 });
  await fitted();
  await page.screenshot({ path: picture('whole'), fullPage: true });
});

test('no error was said and nothing was fetched', () => {
  assert.deepEqual(seen, { errors: [], requests: [] });
});

test('without scripts the drawings stand', async () => {
  const plain = await browser.newPage({ javaScriptEnabled: false });
  await plain.goto(report());
  assert.equal(await plain.locator('.viewer .part').isVisible(), true);
  assert.equal(await plain.locator('figure.plot > svg').first().isVisible(), true);
  await plain.close();
});
