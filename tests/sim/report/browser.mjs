// A page with a study in Chromium, and what its tests ask for. Where there is no Chromium the tests are skipped, and ctest says so.

import assert from 'node:assert/strict';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after} from 'node:test';
import {pathToFileURL} from 'node:url';
import {pageOf} from './sample/page.mjs';

const {CHROMIUM, REPORT_HTML, TEST_MODULES} = process.env;
if (!CHROMIUM || CHROMIUM.endsWith('-NOTFOUND')) {
  console.log('There is no Chromium (Debian: chromium), so the page is not tested.');
  process.exit(77);
}
const {chromium} = createRequire(join(TEST_MODULES, 'node_modules', 'x.js'))('playwright-core');

const k_flags = ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--disable-dev-shm-usage'];
const k_software_gl = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const k_no_gl = ['--disable-3d-apis'];

const folder = mkdtempSync(join(tmpdir(), 'gauss-report-'));
const browsers = new Map();

after(async () => {
  for (const browser of browsers.values()) await browser.close();
  rmSync(folder, {recursive: true});
});

async function browserWith(gl) {
  if (!browsers.has(gl)) browsers.set(gl, await chromium.launch({executablePath: CHROMIUM, args: [...k_flags, ...(gl ? k_software_gl : k_no_gl)]}));
  return browsers.get(gl);
}

let files = 0;

/** A file with the study in it. */
export function fileOf(study, text) {
  const file = join(folder, `${++files}.html`);
  writeFileSync(file, text ?? pageOf(REPORT_HTML, study));
  return pathToFileURL(file).href;
}

/** What the console says that is no fault: reading a picture back from the graphics is slow, which is what screenshots do. */
const harmless = (text) => /GL Driver Message/.test(text);

/**
 * Opens a page and hands it over; afterwards, it must have had no error and asked for nothing from outside.
 * Without WebGL, unless `gl` says so: software draws it slowly, and charts do not need it.
 * @param {{url: string, hash?: string, gl?: boolean, options?: object, before?: (page: object) => Promise<void>}} how
 */
export async function withPage({url, hash = '', gl = false, options = {}, before = null}, use) {
  const context = await (await browserWith(gl)).newContext({viewport: {width: 1440, height: 1000}, ...options});
  const page = await context.newPage();
  page.setDefaultTimeout(10000);
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.stack ?? String(error)));
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !harmless(message.text()) && faults.push(message.text()));
  page.on('dialog', (dialog) => { faults.push('a dialog'); dialog.dismiss(); });
  page.on('request', (request) => request.url() !== url && !/^(blob|data):/.test(request.url()) && faults.push(`asks for ${request.url()}`));
  try {
    if (before) await before(page);
    await page.goto(url + hash);
    await use(page);
    assert.deepEqual(faults, []);
  } finally {
    await context.close();
  }
}

/** A section of the problem that is shown, in view and drawn. */
export async function section(page, id) {
  const found = page.locator(`main > :not([hidden]) [data-chart="${id}"]`);
  await found.scrollIntoViewIfNeeded();
  await page.locator(`main > :not([hidden]) [data-chart="${id}"]:not([aria-busy="true"])`).locator('.plot svg, .empty:not([hidden]), canvas').first().waitFor({state: 'attached'});
  return found;
}

/** Colours of a picture: how many, and which part is not of the most frequent one. */
export async function colours(page, png) {
  return page.evaluate(async (data) => {
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], {type: 'image/png'}));
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    pen.drawImage(bitmap, 0, 0);
    const pixels = new Uint32Array(pen.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
    const counts = new Map();
    for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
    return {different: counts.size, drawn: 1 - Math.max(...counts.values()) / pixels.length};
  }, png.toString('base64'));
}

/** Rows of a table as {column: text}. */
export const rowsOf = (locator) => locator.locator('table').first().evaluate((table) => {
  const names = [...table.tHead.rows[0].cells].map((cell) => cell.textContent);
  return [...table.tBodies[0].rows].map((row) => Object.fromEntries([...row.cells].map((cell, i) => [names[i], cell.textContent])));
});

/** What a hint says, as {label: value}. */
export const hintOf = (locator) => locator.locator('.hint-text').evaluate((list) => Object.fromEntries([...list.querySelectorAll('dt')].map((term) => [term.textContent, term.nextElementSibling.textContent])));
