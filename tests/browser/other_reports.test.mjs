// Reports of other kinds in headless Chromium: each loads without an error and without the network,
// and each of its plots answers the cursor.
//
//   node --test other_reports.test.mjs   with  REPORTS (html files, a semicolon between them; the
//                                              folder of each is its name), PACKAGES, PICTURES
import assert from 'node:assert/strict';
import { basename, dirname } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { launch, picture, watch } from './chromium.mjs';

const reports = Object.fromEntries(
  process.env.REPORTS.split(';').map((file) => [basename(dirname(file)), pathToFileURL(file).href]));

let browser;
before(async () => { browser = await launch(); });
after(async () => { await browser?.close(); });

// Opens a report, gives its page to `look`, and asks that nothing was wrong.
async function open(name, look) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 900 } });
  const seen = watch(page);
  await page.goto(reports[name]);
  await page.waitForSelector('figure.plot.is-live');
  await look(page);
  await page.screenshot({ path: picture(name), fullPage: true });
  assert.deepEqual(seen, { errors: [], requests: [] });
  await page.close();
}

// Names in the legend of a plot, and their values under the cursor at a third of the width.
async function read(plot) {
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.locator('.u-over').boundingBox();
  await plot.page().mouse.move(box.x + box.width / 3, box.y + box.height / 2);
  const names = await plot.locator('.u-legend .u-label').allInnerTexts();
  const values = await plot.locator('.u-legend .u-value').allInnerTexts();
  return { names, values };
}

test('the response of a bolted lap stands beside its test', async () => {
  await open('bolted_lap', async (page) => {
    const { names, values } = await read(page.locator('#response figure.plot.is-live').first());
    const shown = Object.fromEntries(names.map((name, i) => [name, Number(values[i])]));
    assert.ok(shown['joint z'] > 0 && shown['test joint z, 1 m/s2'] > 0, JSON.stringify(shown));
    // Half a metre long, with a torsion mode, in which its nodes rest and its skin moves.
    await page.waitForSelector('.viewer.is-live canvas');
    const far = await page.evaluate(() => document.querySelector('.viewer').viewer.camera.position.length());
    assert.ok(far > 0.3 && far < 5, `seen from ${far} m`);
  });
});

test('each level of excitation is a curve that answers', async () => {
  await open('levels', async (page) => {
    const plots = page.locator('#levels figure.plot.is-live');
    assert.ok(await plots.count() > 0);
    const { names, values } = await read(plots.first());
    assert.ok(names.length > 3, names.join(', '));
    assert.ok(values.slice(1).filter((v) => Number(v) > 0).length > 1, values.join(', '));
  });
});

test('a superelement shows its dynamic stiffness', async () => {
  await open('superelement', async (page) => {
    const { names, values } = await read(page.locator('#stiffness figure.plot.is-live'));
    assert.equal(names.length, 5, names.join(', ')); // frequency and four curves
    assert.ok(values.every((v) => Number(v) > 0), values.join(', '));
  });
});
