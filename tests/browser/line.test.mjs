// The report of an exhaust line in headless Chromium: what is seen without scrolling, one colour per
// sensor, legends that show the lines; wide, narrow, dark, on paper.
//
//   node --test line.test.mjs   with  REPORT (an html file), PACKAGES (a node_modules folder),
//                                     PICTURES (a folder for screenshots)
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page, picture, seen, withReport } from './chromium.mjs';

withReport();

const below = async (what) => {
  const box = await page.locator(what).first().boundingBox();
  return box.y + box.height;
};

test('picture, verdict and numbers stand on the first screen', async () => {
  for (const [width, height] of [[1200, 900], [1440, 800]]) {
    await page.setViewportSize({ width, height });
    await page.waitForFunction(() => {
      const [place, canvas] = [document.querySelector('.viewer .live'), document.querySelector('.viewer canvas')];
      return Math.abs(canvas.clientWidth - place.clientWidth) < 2;
    });
    await page.screenshot({ path: picture(`line-first-${width}`) });
    for (const what of ['.verdict', '.viewer canvas', '.first table'])
      assert.ok(await below(what) < height, `${what} ends at ${await below(what)} of ${height}`);
  }
  await page.setViewportSize({ width: 1200, height: 900 });
});

test('the line fills its picture and all names are in it, none over another', async () => {
  const names = await page.locator('.viewer .live > .tag:not(.axis-name)').evaluateAll((tags) =>
    tags.map((t) => ({ text: t.textContent, box: t.getBoundingClientRect().toJSON() })));
  for (const name of ['behind', 'muffler', 'tail', 'engine', 'hanger_front', 'hanger_rear'])
    assert.equal(names.filter((n) => n.text === name).length, 1, name);
  const stage = await page.locator('.viewer .live').boundingBox();
  for (const { text, box } of names) {
    assert.ok(box.x >= stage.x && box.right <= stage.x + stage.width + 1, text);
    assert.ok(box.y >= stage.y && box.bottom <= stage.y + stage.height + 1, text);
    for (const other of names)
      if (other.text !== text)
        assert.ok(box.right < other.box.x || other.box.right < box.x || box.bottom < other.box.y + 2
          || other.box.bottom < box.y + 2, `${text} over ${other.text}`);
  }
  const { wide, high } = await page.evaluate(() => {
    const canvas = document.querySelector('.viewer canvas');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const data = context.getImageData(0, 0, copy.width, copy.height).data;
    let [left, right, top, bottom] = [copy.width, 0, copy.height, 0];
    for (let y = 0; y < copy.height; ++y)
      for (let x = 0; x < copy.width; ++x)
        if (data[4 * (y * copy.width + x) + 3] > 0) {
          [left, right] = [Math.min(left, x), Math.max(right, x)];
          [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
        }
    return { wide: (right - left) / copy.width, high: (bottom - top) / copy.height };
  });
  assert.ok(Math.max(wide, high) > 0.7, `${wide} wide, ${high} high`);
});

test('a sensor has one colour in all plots, the legend shows the line, axes have quantity and unit', async () => {
  const plots = await page.locator('figure.plot.is-live').evaluateAll((figures) => figures.map((f) => {
    const data = JSON.parse(f.querySelector('script').textContent);
    const rows = [...f.querySelectorAll('.u-legend .u-series')].slice(1).filter((r) => !r.hidden);
    return { ...data, grids: null,
      curves: data.curves.map(({ name, colour, dashes, faint }) => ({ name, colour, dashes, faint })),
      legend: rows.map((r) => ({ name: r.querySelector('.u-label').textContent,
        border: getComputedStyle(r.querySelector('.u-marker')).borderTop })) };
  }));
  assert.ok(plots.length >= 6);
  const colours = new Map();
  for (const plot of plots) {
    assert.match(plot.abscissa, /^[a-z ]+, (Hz|s|rpm)$/);
    assert.match(plot.ordinate, /, (m\/s²|°|Hz|\(m\/s²\)²\/Hz)/);
    assert.doesNotMatch(plot.ordinate, /m\/s2/);
    assert.ok(plot.curves.filter((c) => !c.faint).length <= 6, plot.label);
    assert.equal(plot.legend.length, plot.curves.filter((c) => c.name).length, plot.label);
    for (const row of plot.legend) assert.match(row.border, /^2px (solid|dashed|dotted) /, plot.label);
    for (const c of plot.curves) {
      const sensor = /^(behind|muffler|tail) [xyz]$/.exec(c.name)?.[1];
      if (!sensor) continue;
      assert.equal(c.colour, colours.get(sensor) ?? c.colour, `${c.name} of ${plot.label}`);
      colours.set(sensor, c.colour);
    }
    assert.equal(new Set(plot.curves.filter((c) => !c.faint && c.name)
      .map((c) => `${c.colour} ${c.dashes}`)).size, plot.curves.filter((c) => !c.faint && c.name).length,
    `two curves alike in ${plot.label}`);
  }
  assert.equal(new Set(colours.values()).size, 3);
  assert.ok(plots.some((p) => p.ordinate === 'phase, °'));
  const text = await page.locator('#response').innerText();
  assert.match(text, /3 σ/);
  await page.locator('#response').screenshot({ path: picture('line-response') });
});

test('turned and near, the crowns are round', async () => {
  const box = await page.locator('.viewer canvas').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2 - 40, { steps: 4 });
  await page.mouse.up();
  await page.evaluate(() => { // before the bellows, which is 0.2 m behind the engine
    const { viewer } = document.querySelector('.viewer');
    const target = viewer.frame.localToWorld(viewer.orbit.target.clone().set(0, 0.19, 0));
    viewer.orbit.target.copy(target);
    viewer.camera.position.copy(target).add(viewer.camera.position.clone().set(0.25, 0.12, 0.1));
    viewer.orbit.update();
    viewer.draw();
  });
  await page.locator('.viewer').screenshot({ path: picture('line-crowns') });
  // Two elements to a quarter of an arc: normals of neighbours, between which the shading is smooth,
  // differ by its half.
  const worst = await page.evaluate(() => {
    const { viewer } = document.querySelector('.viewer');
    let most = 0;
    for (const o of viewer.objects.filter((x) => x.isMesh)) {
      const n = o.geometry.getAttribute('normal');
      const at = o.geometry.index;
      for (let i = 0; i < at.count; i += 3)
        for (const [a, b] of [[0, 1], [1, 2], [2, 0]]) {
          const [p, q] = [at.getX(i + a), at.getX(i + b)];
          const dot = n.getX(p) * n.getX(q) + n.getY(p) * n.getY(q) + n.getZ(p) * n.getZ(q);
          most = Math.max(most, (180 / Math.PI) * Math.acos(Math.min(1, Math.abs(dot))));
        }
    }
    return most;
  });
  assert.ok(worst < 55, `${worst} deg between neighbours`);
  await page.getByRole('button', { name: 'view from the start' }).click();
});

test('on paper the part, its names and the tables are whole', async () => {
  await page.setViewportSize({ width: 690, height: 980 });
  await page.emulateMedia({ media: 'print' });
  const size = await page.locator('.viewer .part text.tag').first().evaluate((t) =>
    t.getBoundingClientRect().height);
  assert.ok(size > 8, `names ${size} px high`);
  await page.screenshot({ path: picture('line-paper') });
  await page.emulateMedia({ media: 'screen' });
});

test('narrow and dark', async () => {
  await page.setViewportSize({ width: 420, height: 800 });
  const [inside, wide] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
  assert.ok(wide <= inside + 1, `${wide} in ${inside}`);
  await page.screenshot({ path: picture('line-narrow') });
  await page.setViewportSize({ width: 1200, height: 900 });
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.screenshot({ path: picture('line-dark') });
  await page.emulateMedia({ colorScheme: 'light' });
});

test('no error was said and nothing was fetched', () => {
  assert.deepEqual(seen, { errors: [], requests: [] });
});
