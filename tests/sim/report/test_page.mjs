// The page in Chromium: what is there, and that its values are those of the study.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';
import {colours, fileOf, hintOf, rowsOf, section, withPage} from './browser.mjs';
import {markFront} from './sample/runs.mjs';
import {study as sample} from './sample/study.mjs';

/** A third of the runs, and those that others refer to: a page opens for each test. */
function lighter({problems, ...rest}) {
  const needed = (problem) => new Set(problem.drifts.map(({point}) => point));
  return {...rest, problems: problems.map((problem) => ({...problem, points: markFront(problem.points.filter((p) => p.id % 3 === 0 || p.is_default || p.status !== 'ok' || needed(problem).has(p.id)))}))};
}

const study = lighter(sample());
const url = fileOf(study);
const [first] = study.problems;
const k_sections = ['motion', 'error-time', 'error-calls', 'tolerance', 'digit-cost', 'drift-energy', 'drift-constraints', 'formulations', 'numbers', 'projections', 'lanes', 'builds'];

const at = (name, id = '') => `#/${name}${id ? `/${id}` : ''}`;
const columnOf = (value) => value === null ? '–' : value.toExponential(1).replace('+', '');

test('the page is one file that opens with a summary of all problems', () => withPage({url}, async (page) => {
  assert.deepEqual(await page.locator('.problems a').allTextContents(), ['Summary', ...study.problems.map(({name}) => name)]);
  const matrix = await rowsOf(page.locator('.summary > .short'));
  assert.equal(matrix.length, study.problems.length);
  for (const [i, {points}] of study.problems.entries()) {
    const best = points.filter((p) => p.status === 'ok' && p.error <= 1e-6).sort((a, b) => a.time_s - b.time_s)[0];
    assert.ok(matrix[i]['error 1e-6'].includes(best.method) && matrix[i]['error 1e-6'].includes(best.number), matrix[i]['error 1e-6']);
  }
  const rows = await rowsOf((await section(page, 'summary')).locator('.data'));
  assert.equal(rows[0].problem, first.name);
  assert.match(await page.locator('.machine').textContent(), /gauss-sim 0.1.0.*g\+\+ 12.2.0/);
  assert.equal(await page.locator('.interrupted').count(), 0);
}));

test('a study that was interrupted says so above everything', () => withPage({url: fileOf({...study, interrupted: true})}, async (page) => {
  assert.match(await page.locator('header.top .interrupted').textContent(), /was interrupted/);
}));

test('every problem has every section, with a chart or a sentence', () => withPage({url}, async (page) => {
  for (const [i, problem] of study.problems.entries()) {
    await page.goto(url + at(encodeURIComponent(problem.name)));
    await page.locator('h2', {hasText: problem.name}).waitFor();
    const sections = [...k_sections, ...(problem.effects ? ['effects', 'effect-ladder'] : [])];
    assert.deepEqual(await page.locator('main > :not([hidden]) .figure').evaluateAll((all) => all.map((one) => one.dataset.chart)), sections);
    if (i % 4 !== 1) continue;  // one with all that there is, and one without lanes
    for (const id of sections) {
      const found = await section(page, id);
      assert.ok((await found.locator('h3').textContent()).length > 5);
      if (await found.locator('.empty:not([hidden])').count()) continue;
      assert.ok((await found.locator('.takeaway').textContent()).length > 10, id);
      if (id === 'motion') continue;
      assert.ok(await found.locator('.plot svg path').count() > 3, id);
      assert.ok(await found.locator('tbody tr').count() > 0, id);
    }
  }
  const none = page.locator('main > :not([hidden]) [data-chart="lanes"] .empty');
  assert.equal(await none.textContent(), 'No batches were measured.');
}));

test('the table has all runs with the values of the study, and CSV has all digits', () => withPage({url, hash: at(first.name, 'error-time')}, async (page) => {
  const found = await section(page, 'error-time');
  await found.getByRole('button', {name: /^Show all/}).click();
  const rows = await rowsOf(found);
  assert.equal(rows.length, first.points.length);
  const wanted = first.points.map((p) => `${p.method} ${p.number} ${p.projection} ${columnOf(p.error)} ${p.steps ?? '–'}`.replace(/\d{5,}/, (n) => n)).sort();
  assert.deepEqual(rows.map((r) => `${r.method} ${r['number type']} ${r.projection} ${r.error} ${r.steps.replace(/\u202f/g, '')}`).sort(), wanted);
  assert.equal(rows.filter(({marks}) => marks.includes('front')).length, first.points.filter(({pareto}) => pareto).length);
  assert.equal(rows.filter(({marks}) => marks.includes('default')).length, 1);
  await found.getByRole('button', {name: 'Copy'}).click();
  await found.getByText(`${first.points.length} rows copied`).waitFor();
  const [download] = await Promise.all([page.waitForEvent('download'), found.getByRole('button', {name: 'CSV'}).click()]);
  assert.equal(download.suggestedFilename(), `${first.name}-error-time.csv`);
  const lines = readFileSync(await download.path(), 'utf8').trimEnd().split('\r\n').map((line) => line.split(','));
  const column = lines[0].indexOf('error');
  assert.deepEqual(lines.slice(1).map((line) => Number(line[column] || 'NaN')).sort(), first.points.map(({error}) => error ?? NaN).sort());
}));

test('hovering shows a run, in the colour of its method, where its error and time say', () => withPage({url, hash: at(first.name, 'error-time')}, async (page) => {
  const found = await section(page, 'error-time');
  const symbols = found.locator('.plot svg path[fill="#00875a"]');
  const seen = [];
  for (let i = 0; i < await symbols.count() && seen.length < 6; ++i) {
    const box = await symbols.nth(i).boundingBox();
    if (!box || box.width > 20) continue;
    const middle = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(...middle);
    await page.waitForTimeout(60);
    if (!await found.locator('.hint-text').isVisible()) continue;
    const hint = await hintOf(found);
    if (hint.method === 'taylor') seen.push({middle, hint});
  }
  assert.ok(seen.length >= 4, `${seen.length} symbols found`);
  for (const {hint} of seen) assert.ok(first.points.some((p) => p.method === 'taylor' && columnOf(p.error) === Number(hint.error).toExponential(1).replace('+', '') && p.calls === Number(hint.calls.replace(/\u202f/g, ''))), JSON.stringify(hint));
  // On an axis of powers, distances go with logarithms. Hints have two digits of an error: 2 pixels.
  const [low, high] = [seen[0], seen[seen.length - 1]];
  const decade = (high.middle[0] - low.middle[0]) / Math.log10(Number(low.hint.error) / Number(high.hint.error));
  assert.ok(decade > 10);
  for (const {middle, hint} of seen) assert.ok(Math.abs(middle[0] - low.middle[0] - decade * Math.log10(Number(low.hint.error) / Number(hint.error))) < 3);
}));

/** Symbols that a label of a chart lies over, by their paths. */
const hiddenBy = (found, label) => found.locator('.plot svg').evaluate((svg, text) => {
  const labels = [...svg.querySelectorAll('text')].filter((one) => one.textContent === text).map((one) => one.getBoundingClientRect());
  if (labels.length !== 1) return [`${labels.length} labels`];
  const [{left, right, top, bottom}] = labels;
  const symbols = [...svg.querySelectorAll('path')].filter((path) => { const {width, height} = path.getBoundingClientRect(); return width > 3 && width < 16 && Math.abs(width - height) < 4; });
  if (symbols.length < 40) return ['no symbols'];
  // Boxes of text are higher than its letters.
  return symbols.filter((path) => { const box = path.getBoundingClientRect(); return box.right > left && box.left < right && box.bottom > top + 2 && box.top < bottom - 2; }).map((path) => path.outerHTML);
}, label);

for (const width of [1440, 800]) {
  test(`labels hide no run, ${width} pixels wide`, () => withPage({url, hash: at(first.name), options: {viewport: {width, height: 1000}}}, async (page) => {
    for (const id of ['error-time', 'error-calls', 'tolerance']) {
      const found = await section(page, id);
      for (const label of ['default', 'no result']) assert.deepEqual(await hiddenBy(found, label), [], `${id}: ${label}`);
      const band = await found.locator('.plot svg path[fill="#f3eeee"]').boundingBox();
      const label = await found.locator('.plot svg text', {hasText: /^no result$/}).boundingBox();
      assert.ok(label.y + label.height <= band.y + 3, 'what has no result may stand anywhere in its band');
    }
  }));
}

test('a label stays free when the window changes', () => withPage({url, hash: at(first.name, 'error-time')}, async (page) => {
  const found = await section(page, 'error-time');
  await page.setViewportSize({width: 700, height: 900});
  await page.waitForFunction(() => document.querySelector('main > :not([hidden]) [data-chart="error-time"] .plot svg').getBoundingClientRect().width < 700);
  assert.deepEqual(await hiddenBy(found, 'default'), []);
}));

test('arrow keys go from run to run, and say all settings aloud', () => withPage({url, hash: at(first.name, 'error-time')}, async (page) => {
  const found = await section(page, 'error-time');
  await found.locator('.plot').focus();
  await page.keyboard.press('End');
  assert.match((await hintOf(found)).status, /^(failed|refused)$/, 'what has no result comes last');
  await page.keyboard.press('Home');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
  const hint = await hintOf(found);
  const run = first.points.filter((p) => p.status === 'ok' && p.method === 'prince8' && p.number === 'double').sort((a, b) => b.error - a.error)[5];
  assert.equal(Number(hint.error).toExponential(1), run.error.toExponential(1));
  assert.equal(hint.calls.replace(/\u202f/g, ''), String(run.calls));
  for (const label of ['library', 'formulation', 'code', 'projection', 'engine', 'tolerance', 'worst output', 'steps', 'time', 'drift of energy']) assert.ok(hint[label], label);
  assert.match(await found.locator('[aria-live]').textContent(), /^method prince8, library Boost.Odeint/);
  await page.keyboard.press('Escape');
  await found.locator('.hint-text').waitFor({state: 'hidden'});
}));

test('curves that are left out at first come by a button, and go again', () => {
  const some = first.points.filter(({status, error}) => status === 'ok' && error > 0).slice(0, 9);
  const t = Array.from({length: 50}, (_, i) => i / 5);
  const drifts = some.map(({id}, run) => ({point: id, t, energy: t.map((time) => time * 10 ** (run - 14))}));
  return withPage({url: fileOf({...study, problems: [{...first, drifts}]}), hash: at(first.name, 'drift-energy')}, async (page) => {
    const found = await section(page, 'drift-energy');
    const curves = () => found.locator('.key li').count();
    assert.equal(await curves(), 6);
    await found.getByRole('button', {name: 'Draw all 9 curves'}).click();
    assert.equal(await curves(), 9);
    await page.keyboard.press('Enter');  // the button has kept the focus
    assert.equal(await curves(), 6);
    assert.equal((await rowsOf(found)).length, 9);
    for (const [i, number] of ['1', '9'].entries()) assert.equal(await found.locator('.plot svg text', {hasText: new RegExp(`^${number}$`)}).count(), 1, String(i));
  });
});

test('filters act on all charts and tables, and can be taken back', () => withPage({url, hash: at(first.name, 'error-time')}, async (page) => {
  const here = page.locator('main > :not([hidden])');
  const found = await section(page, 'error-time');
  const before = await found.locator('.takeaway').textContent();
  assert.match(before, /taylor/);
  await here.getByRole('checkbox', {name: /taylor/}).uncheck();
  const runs = first.points.filter(({status}) => status !== 'refused');
  const left = runs.filter(({method}) => method !== 'taylor').length;
  assert.equal(await here.getByRole('status').first().textContent(), `${left} of ${runs.length} runs`);
  const facts = await here.locator('.facts').textContent();
  assert.ok(facts.includes(`runs${runs.length}, ${runs.filter(({status}) => status === 'ok').length} of them with a result; `), facts);
  assert.ok(facts.includes(`not run${first.points.length - runs.length} settings`), facts);
  const counts = await here.locator('[data-filter="method"] small').allTextContents();
  assert.equal(counts.reduce((sum, text) => sum + Number(text), 0), runs.length);
  assert.notEqual(await found.locator('.takeaway').textContent(), before);
  assert.equal((await rowsOf(found)).filter(({method}) => method === 'taylor').length, 0);
  assert.ok((await rowsOf(found))[0].marks.includes('front'), 'the front is that of the runs that are left');
  for (const id of ['error-calls', 'digit-cost', 'drift-energy', 'numbers']) assert.equal((await rowsOf(await section(page, id)).catch(() => [])).filter((row) => Object.values(row).some((text) => text.includes('taylor'))).length, 0, id);
  for (const name of ['double', 'long double', 'float128']) await here.getByRole('checkbox', {name: new RegExp(`^${name} `)}).uncheck();
  assert.match(await (await section(page, 'error-time')).locator('.empty').textContent(), /^No runs are left/);
  await here.getByRole('button', {name: 'Show all', exact: true}).click();
  await section(page, 'error-time');
  assert.equal(await found.locator('.takeaway').textContent(), before);
}));

test('a heading sorts its column, up, down, and back', () => withPage({url, hash: at(first.name, 'error-time')}, async (page) => {
  const found = await section(page, 'error-time');
  await found.getByRole('button', {name: /^Show all/}).click();
  const heading = found.getByRole('columnheader', {name: 'calls'});
  const shown = async () => (await rowsOf(found)).map((row) => row['calls'] ?? row['calls ↑'] ?? row['calls ↓']).filter((text) => text !== '–').map((text) => Number(text.replace(/\u202f/g, '')));
  const unsorted = await shown();
  await heading.getByRole('button').click();
  assert.equal(await heading.getAttribute('aria-sort'), 'ascending');
  assert.deepEqual(await shown(), [...unsorted].sort((a, b) => a - b));
  await page.keyboard.press('Enter');  // the heading has kept the focus
  assert.equal(await heading.getAttribute('aria-sort'), 'descending');
  assert.deepEqual(await shown(), [...unsorted].sort((a, b) => b - a));
  await page.keyboard.press('Enter');
  assert.deepEqual(await shown(), unsorted);
}));

test('the keyboard reaches everything, and shows where it is', () => withPage({url, hash: at('lagrange_top')}, async (page) => {
  await page.locator('h2', {hasText: 'lagrange_top'}).waitFor();
  for (const id of [...k_sections, 'effects', 'effect-ladder']) await section(page, id);  // all are drawn now, and nothing more comes in between
  await page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
  const seen = new Set();
  for (let i = 0; i < 220; ++i) {
    await page.keyboard.press('Tab');
    const here = await page.evaluate(() => {
      const node = document.activeElement;
      if (node === document.body) return null;
      const style = getComputedStyle(node);
      const list = [...document.querySelectorAll('*')];
      return {at: list.indexOf(node), name: `${node.tagName}.${node.className} ${(node.textContent || node.getAttribute('aria-label') || '').slice(0, 30)}`, outlined: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2};
    });
    if (!here || seen.has(here.name + here.at)) break;
    assert.ok(here.outlined, `${here.name} has no visible focus`);
    seen.add(here.name + here.at);
  }
  const wanted = await page.evaluate(() => [...document.querySelectorAll('main > :not([hidden]) :is(a[href], button, input, select, summary, [tabindex="0"])')].filter((node) => !node.disabled && node.checkVisibility()).length);
  assert.ok(seen.size >= wanted + 1 + study.problems.length, `${seen.size} of ${wanted}`);
  assert.ok([...seen][0].includes('skip'), 'the first is the link that skips the head');
}));

test('dark colours are the system\'s or chosen, and charts follow', () => withPage({url, hash: at(first.name, 'error-time'), options: {colorScheme: 'light'}}, async (page) => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const found = await section(page, 'error-time');
  assert.equal(await ground(), 'rgb(246, 247, 248)');
  assert.ok(await found.locator('.plot svg path[fill="#00875a"]').count() > 0);
  await page.getByRole('button', {name: 'Dark colours'}).click();
  assert.equal(await ground(), 'rgb(15, 20, 25)');
  assert.ok(await found.locator('.plot svg path[fill="#2fc797"]').count() > 0);
  assert.equal(await page.getByRole('button', {name: 'Dark colours'}).getAttribute('aria-pressed'), 'true');
  await page.reload();
  assert.equal(await ground(), 'rgb(15, 20, 25)', 'the choice is kept');
}));

test('where the system is dark, the page is', () => withPage({url, options: {colorScheme: 'dark'}}, async (page) => {
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(15, 20, 25)');
}));

test('a link leads to its chart, and back leads back', () => withPage({url, hash: at('slider_crank', 'lanes')}, async (page) => {
  const heading = page.locator('main > :not([hidden]) [data-chart="lanes"] h3');
  await page.waitForFunction(() => document.activeElement?.textContent.startsWith('Batch lanes'));
  const box = await heading.boundingBox();
  assert.ok(box.y >= 0 && box.y < 1000);
  await page.locator('main > :not([hidden]) .sections a', {hasText: 'Formulations'}).click();
  await page.waitForFunction(() => document.activeElement?.textContent.startsWith('Formulations'));
  await page.goBack();
  await page.waitForFunction(() => document.activeElement?.textContent.startsWith('Batch lanes'));
  assert.equal(await page.title(), 'slider_crank – what accuracy costs in time');
}));

test('a picture of the page is not blank', () => withPage({url, hash: at(first.name, 'error-time')}, async (page) => {
  const found = await section(page, 'error-time');
  const {different, drawn} = await colours(page, await found.locator('.plot').screenshot());
  assert.ok(different > 200 && drawn > 0.03 && drawn < 0.6, `${different} colours, ${drawn} drawn`);
  assert.ok((await colours(page, await page.screenshot())).different > 500);
}));

test('a narrow window needs no scrolling to the side', () => withPage({url, hash: at(first.name), options: {viewport: {width: 390, height: 800}}}, async (page) => {
  for (const id of ['error-time', 'digit-cost', 'builds']) await section(page, id);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
}));

test('a table that is cut off shows on which side it goes on, and keys scroll it', () => withPage({url, hash: at(first.name, 'error-time'), options: {viewport: {width: 1300, height: 1000}}}, async (page) => {
  const frame = (await section(page, 'error-time')).locator('.sideways');
  const shadows = () => frame.evaluate((node) => ['::before', '::after'].map((part) => Number(getComputedStyle(node, part).opacity)));
  const shown = async (wanted) => {
    await page.waitForFunction(([node, sides]) => ['::before', '::after'].every((part, i) => Number(getComputedStyle(node, part).opacity) === sides[i]), [await frame.elementHandle(), wanted]);
    assert.deepEqual(await shadows(), wanted);
  };
  const region = frame.getByRole('region');
  const hint = frame.locator('xpath=..').locator('.sideways-hint');
  assert.ok(await region.evaluate(({scrollWidth, clientWidth}) => scrollWidth > clientWidth), 'else there is nothing to test');
  await shown([0, 1]);
  assert.match(await hint.textContent(), /scroll it sideways/);
  assert.ok(await hint.isVisible());
  await region.focus();
  await page.keyboard.press('ArrowRight');
  await shown([1, 1]);
  await region.evaluate((node) => { node.scrollLeft = node.scrollWidth; });
  await shown([1, 0]);
  const fits = (await section(page, 'lanes')).locator('.sideways');
  assert.equal(await fits.evaluate((node) => node.className), 'sideways');
  assert.equal(await fits.locator('xpath=..').locator('.sideways-hint').isVisible(), false);
}));

test('paper has all problems, charts and tables, and is light', () => withPage({url: fileOf({...study, problems: study.problems.slice(1, 3)}), options: {colorScheme: 'dark'}}, async (page) => {
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('.problem:visible').count(), 2);
  assert.equal(await page.locator('.problem .figure:visible').count(), 2 * k_sections.length);
  assert.ok(await page.locator('.problem .plot svg:visible').count() >= 2 * (k_sections.length - 3));
  assert.ok(await page.locator('.problem tbody tr:visible').count() > 150);
  assert.equal(await page.locator('.side:visible, .tools:visible, .theme:visible').count(), 0);
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(255, 255, 255)');
  for (const canvas of await page.locator('canvas').all()) assert.ok((await colours(page, await canvas.screenshot())).different > 20);
  await page.emulateMedia({media: 'screen'});
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await page.locator('.problem:visible').count(), 0);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
}));
