// Chromium for the tests of reports, by Playwright from PACKAGES (a node_modules folder).
import { createRequire } from 'node:module';
import { join } from 'node:path';

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

// A page of the size of a screen with a report on it whose part turns, and what is seen of it.
export async function openReport(address) {
  const browser = await launch();
  const page = await browser.newPage({ viewport: { width: 1200, height: 900 } });
  const seen = watch(page);
  await page.goto(address);
  await page.waitForSelector('.viewer.is-live canvas');
  return { browser, page, seen };
}
