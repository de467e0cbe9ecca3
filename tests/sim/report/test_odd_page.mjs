// Studies that are empty, large, broken or meant badly.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';
import {fileOf, section, withPage} from './browser.mjs';
import {random} from './sample/random.mjs';
import {study as sample} from './sample/study.mjs';

const study = sample();
const [first] = study.problems;

test('a page without a study says so', () => withPage({url: fileOf(null, readFileSync(process.env.REPORT_HTML, 'utf8'))}, async (page) => {
  assert.match(await page.locator('.empty').textContent(), /template: nobody has put a study into it/);
}));

test('a study of another format is refused in a sentence', () => withPage({url: fileOf({format: 7, problems: []})}, async (page) => {
  assert.match(await page.locator('.empty').textContent(), /format 1 .* says 7/);
}));

test('a study without problems, and a problem without anything, are shown as what they are', async () => {
  await withPage({url: fileOf({format: 1, problems: []})}, async (page) => assert.match(await page.locator('main').textContent(), /The study has no problems/));
  await withPage({url: fileOf({format: 1, problems: [{name: 'nothing'}]}), hash: '#/nothing'}, async (page) => {
    await page.locator('h2', {hasText: 'nothing'}).waitFor();
    const figures = page.locator('main > :not([hidden]) .figure');
    for (let i = 0; i < await figures.count(); ++i) {
      await figures.nth(i).scrollIntoViewIfNeeded();
      await figures.nth(i).locator('.empty:not([hidden])').waitFor();
      assert.match(await figures.nth(i).locator('.empty').textContent(), /^[A-Z].*\.$/);
    }
    assert.equal(await page.locator('.plot:visible, .data:visible').count(), 0);
  });
});

test('parts that are missing or null leave the others as they are', async () => {
  const torn = {...first, points: first.points.slice(0, 40).map((p, i) => i % 3 === 0 ? {id: p.id, method: p.method, status: p.status, why: p.why, error: p.error, time_s: null} : p),
    drifts: [{point: 999, t: [0, 1], energy: [1e-9, null]}], lanes: null, builds: [], reference: null, outputs: null,
    motion: {t: [0, 1, 2], bodies: [{name: 'lost', position: [null, [0, 0, 1], null]}], reactions: [{name: 'r', at: [null, [0, 0, 0], null], force: [null, null, null]}]}};
  await withPage({url: fileOf({format: 1, machine: null, problems: [torn]}), hash: `#/${first.name}`}, async (page) => {
    for (const id of ['motion', 'error-time', 'tolerance', 'drift-energy', 'lanes']) await section(page, id);
    assert.match(await page.locator('.facts').textContent(), /none: errors are not known/);
    assert.match(await (await section(page, 'drift-energy')).locator('tbody').textContent(), /run 999/);
    assert.match(await page.locator('main > :not([hidden]) [data-chart="error-time"] .note').textContent(), /do not say their time/);
  });
});

test('one problem is what the page opens on, and nothing else can be chosen', () => withPage({url: fileOf({...study, problems: [first]})}, async (page) => {
  assert.equal(await page.locator('h2:visible').textContent(), first.name);
  assert.equal(await page.locator('.problems').count(), 0);
  assert.equal(await page.title(), `${first.name} – what accuracy costs in time`);
  await page.locator('.sections a', {hasText: 'Formulations'}).click();
  await page.waitForFunction(() => document.activeElement?.textContent.startsWith('Formulations'));
  await page.goBack();
  assert.equal(await page.locator('h2:visible').count(), 1);
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('main > :visible').count(), 1);
}));

test('scene and model are called by their names', async () => {
  const scened = {...first, scene: 'swing.yaml', file: 'pendulum.yaml'};
  await withPage({url: fileOf({format: 1, problems: [scened]})}, async (page) => assert.match(await page.locator('.facts').textContent(), /^sceneswing\.yamlmodelpendulum\.yamlmotion/));
  await withPage({url: fileOf({format: 1, problems: [first]})}, async (page) => assert.match(await page.locator('.facts').textContent(), /^modeldouble_pendulum\.yamlmotion/));
});

test('why there is no reference is said where somebody looks for errors', async () => {
  const why = 'the closed form of \'x\' differs from the motion by 0.8 of its range';
  const wrong = {...first, name: 'wrong', why, reference: null, points: [], drifts: [], lanes: []};
  await withPage({url: fileOf({format: 1, problems: [wrong]})}, async (page) => {
    assert.equal(await page.locator('.intro .fault').textContent(), `There is no reference, so no run was measured: ${why}.`);
    await section(page, 'motion');
    assert.equal(await page.locator('.stage canvas').count(), 1, 'the motion is there all the same');
  });
  await withPage({url: fileOf({format: 1, problems: [first, wrong]})}, async (page) => {
    assert.equal(await page.locator('.summary .fault').textContent(), `wrong: there is no reference: ${why}.`);
    assert.deepEqual(await page.locator('.matrix tbody tr').last().locator('td').allTextContents(), Array(4).fill('no reference'));
  });
});

test('methods of which no run was begun are in no filter, key or table, and the facts say why', () => {
  const refused = (method, why, more = {}) => ({id: 0, method, number: 'double', formulation: first.points[0].formulation, projection: first.points[0].projection, tolerance: 1e-6, step: null,
    status: 'refused', why, error: null, time_s: null, calls: null, pareto: false, ...more});
  const points = [...first.points.filter(({number}) => number === 'double'), refused('bogus_late', 'beyond the time that the study was given'), refused('bogus_late2', 'beyond the time that the study was given'),
    refused('bogus_unfit', 'it has constraints'), refused('taylor', 'no compiler', {number: 'float'})].map((point, i) => ({...point, id: i + 1}));
  return withPage({url: fileOf({...study, problems: [{...first, points, drifts: []}]})}, async (page) => {
    for (const id of ['error-time', 'error-calls', 'tolerance', 'numbers']) await section(page, id);
    const content = await page.locator('.filters, .figure').allTextContents();
    assert.doesNotMatch(content.join(), /bogus/);
    assert.equal(await page.locator('.filters').getByRole('checkbox', {name: /^taylor/}).count(), 1);
    const facts = await page.locator('.facts').evaluate((list) => [...list.children].map((one) => one.textContent));
    const unmade = points.filter(({status}) => status === 'refused').length;
    assert.equal(facts[facts.indexOf('not run') + 1].replace(/\n\d+ beside runs, .*?: [^.]*\./, ''),
      [`${unmade} settings.`, '4 that charts leave out:', '– methods bogus_late, bogus_late2: beyond the time that the study was given', '– method bogus_unfit: it has constraints', '– number type float: no compiler'].join('\n'));
  });
});

const k_bad = '</script><img src=x onerror="window.harmed=1"><!--$&';

test('names that are meant badly stay text', () => {
  const bad = (text) => `${text}${k_bad}`;
  const run = (p) => ({...p, method: bad(p.method), number: bad(p.number), formulation: bad(p.formulation), why: bad(p.why), worst_output: bad('out'), drift: {[bad('energy')]: 1e-9}});
  const problem = {...first, name: bad('pendulum'), about: bad('about'), file: bad('file'), outputs: [{name: bad('x'), unit: bad('m'), range: 1}], reference: {kind: bad('k'), methods: [bad('m')], agreement: 1},
    points: first.points.slice(0, 60).map(run), drifts: first.drifts.map((drift) => ({...drift, [bad('spin')]: drift.energy})), lanes: [{number: bad('d'), lanes: 4, threads: 1, trajectories_per_s: 1, ratio: 1}],
    builds: [{formulation: bad('f'), number: bad('n'), generate_s: 1, compile_s: 1, operations: 3}],
    motion: {...first.motion, bodies: first.motion.bodies.map((body) => ({...body, name: bad(body.name)})), reactions: first.motion.reactions.map((one) => ({...one, name: bad(one.name), body: bad('b'), unit: bad('N')}))}};
  return withPage({url: fileOf({...study, tool: bad('tool'), machine: {processor: bad('p')}, problems: [problem]}), hash: `#/${encodeURIComponent(problem.name)}`}, async (page) => {
    assert.equal(await page.locator('h2:visible').textContent(), problem.name);
    for (const figure of await page.locator('main > :not([hidden]) .figure').all()) {
      await figure.scrollIntoViewIfNeeded();
      await page.waitForTimeout(50);
      if (!await figure.locator('.plot:visible').count()) continue;
      await figure.locator('.plot').focus();
      await page.keyboard.press('ArrowRight');
    }
    const found = await section(page, 'error-time');
    await found.locator('.plot').focus();
    await page.keyboard.press('Home');
    assert.ok((await found.locator('.hint-text').textContent()).includes(k_bad));
    assert.deepEqual(await page.evaluate(() => [window.harmed, document.images.length, document.scripts.length]), [undefined, 0, 3]);
  });
});

test('two thousand runs are drawn within three seconds', async () => {
  const rand = random(5);
  const points = Array.from({length: 2000}, (_, i) => ({...first.points[i % first.points.length], id: i + 1, error: first.points[i % first.points.length].error && first.points[i % first.points.length].error * (0.5 + rand())}));
  const url = fileOf({...study, problems: [{...first, points}]});
  // Time of the page's own thread, from its beginning: on a busy machine the clock on the wall says something else.
  let session;
  const before = async (page) => {
    session = await page.context().newCDPSession(page);
    await session.send('Performance.enable', {timeDomain: 'threadTicks'});
  };
  await withPage({url, hash: `#/${first.name}/error-time`, before}, async (page) => {
    await section(page, 'error-time');
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
    const spent = (await session.send('Performance.getMetrics')).metrics.find(({name}) => name === 'TaskDuration').value;
    assert.ok(await page.locator('main > :not([hidden]) [data-chart="error-time"] .plot svg path').count() >= 2000);
    assert.ok(spent > 0.05 && spent < 3, `${spent} s`);
    console.log(`# 2000 runs: ${spent.toFixed(2)} s`);
  });
});

test('names that are alike keep pages of their own', () => withPage({url: fileOf({...study, problems: [first, {...first, about: 'the second'}]}), hash: `#/${first.name}-2`}, async (page) => {
  assert.equal(await page.locator('.lead:visible').textContent(), 'the second');
}));
