// The report of a life in headless Chromium: the part takes the colours of damage and stress on
// either face, with its scale and the hot spot by name; wide, narrow, dark and on paper.
//
//   node --test life.test.mjs   with  REPORT (an html file), PACKAGES (a node_modules folder),
//                                     PICTURES (a folder for screenshots)
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page, picture, seen, withReport } from './chromium.mjs';

withReport();

// A number of the canvas, and how much of it is coloured rather than grey.
const shown = () => page.evaluate(() => {
  const canvas = document.querySelector('.viewer canvas');
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const data = context.getImageData(0, 0, copy.width, copy.height).data;
  let sum = 0;
  let coloured = 0;
  for (let i = 0; i < data.length; i += 4) {
    sum = (sum * 31 + data[i] + 3 * data[i + 1] + 7 * data[i + 2]) % 4294967291;
    if (data[i + 3] > 0 && Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 60) ++coloured;
  }
  return { sum, coloured: coloured / (copy.width * copy.height) };
});

test('the part takes the colours of a field, with scale and hot spot', async () => {
  const rest = await shown();
  const field = page.getByLabel('field', { exact: true });
  await field.selectOption('0');
  const damage = await shown();
  assert.notEqual(damage.sum, rest.sum);
  assert.ok(damage.coloured > rest.coloured + 0.02, `${damage.coloured} against ${rest.coloured}`);
  assert.match(await page.locator('.viewer .hot').innerText(), /bellows (root|crown) \d+, (inner|outer) face/);
  await page.locator('.viewer').screenshot({ path: picture('life-damage') });
  await field.selectOption('1');
  assert.notEqual((await shown()).sum, damage.sum);
  assert.match(await page.locator('.viewer .scale').innerText(), /MPa/);
  const outer = await shown();
  const face = page.getByLabel('face', { exact: true });
  await face.selectOption((await face.inputValue()) === 'above' ? 'below' : 'above');
  assert.notEqual((await shown()).sum, outer.sum, 'both faces look alike');
  assert.equal(await page.locator('.viewer .hot').count(), 0, 'the hot spot is on the other face');
  await page.locator('.viewer').screenshot({ path: picture('life-stress') });
  await field.selectOption('-1');
  assert.equal((await shown()).sum, rest.sum);
});

test('duties, hot spots and the density of random stress are there', async () => {
  const text = await page.locator('#life').innerText();
  assert.match(text, /factors of 3 on cycles and 1.25 on stress are inside/);
  assert.match(text, /Hot spots/);
  assert.match(text, /RMS .* MPa, 3 sigma/);
  await page.locator('#life').screenshot({ path: picture('life-section') });
  await page.locator('#stress').screenshot({ path: picture('life-stress-section') });
});

test('it holds in a narrow window, in the dark and on paper', async () => {
  for (const [name, width, scheme] of [['narrow', 400, 'light'], ['dark', 1200, 'dark']]) {
    await page.emulateMedia({ colorScheme: scheme, media: 'screen' });
    await page.setViewportSize({ width, height: 900 });
    await page.waitForTimeout(300);
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(over <= 0, `${name}: ${over} px wider than the window`);
    await page.locator('#life').screenshot({ path: picture(name) });
  }
  await page.emulateMedia({ media: 'print', colorScheme: 'light' });
  await page.setViewportSize({ width: 794, height: 1100 });
  assert.equal(await page.locator('.viewer .live').isVisible(), false);
  assert.ok(await page.locator('#life .part svg').first().isVisible());
  await page.locator('#life').screenshot({ path: picture('life-paper') });
  assert.deepEqual(seen.errors, []);
  assert.deepEqual(seen.requests, []);
});
