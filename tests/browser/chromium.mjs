// Chromium for the tests of reports, by Playwright from PACKAGES (a node_modules folder).
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

const { chromium } = createRequire(join(process.env.PACKAGES, 'x.js'))('playwright-core');

const patience = 120_000; // ms: a drawing takes long where nothing helps to draw

const start = () => chromium.launch({
  executablePath: '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--no-first-run'],
});

// A browser whose pages wait as long as a slow machine needs.
export async function launch() {
  const browser = await start();
  const newPage = browser.newPage.bind(browser);
  browser.newPage = async (options) => {
    const page = await newPage(options);
    page.setDefaultTimeout(patience);
    return page;
  };
  return browser;
}

// Errors that a page says and addresses that it asks for, as they come.
export function watch(page) {
  const seen = { errors: [], requests: [] };
  page.on('console', (message) => { if (message.type() === 'error') seen.errors.push(message.text()); });
  page.on('pageerror', (error) => seen.errors.push(String(error)));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) seen.requests.push(request.url());
  });
  return seen;
}

// REPORT on a page of the size of a screen, its part turning, while the tests of a file run; and what is
// seen of it.
export let browser;
export let page;
export let seen;
export const report = () => pathToFileURL(process.env.REPORT).href;
export function withReport() {
  before(async () => {
    browser = await launch();
    page = await browser.newPage({ viewport: { width: 1200, height: 900 } });
    seen = watch(page);
    await page.goto(report());
    await page.waitForSelector('.viewer.is-live canvas');
  });
  after(async () => { await browser?.close(); });
}

// Where a screenshot of that name goes, in PICTURES.
export const picture = (name) => join(process.env.PICTURES, `${name}.png`);
