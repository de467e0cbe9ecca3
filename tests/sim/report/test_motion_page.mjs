// The motion in Chromium: it moves, by WebGL and without, follows keys and pointer, and says the forces of the study.

import assert from 'node:assert/strict';
import test from 'node:test';
import {colours, fileOf, section, withPage} from './browser.mjs';
import {study as sample} from './sample/study.mjs';

const {problems, ...rest} = sample();
// Runs do not matter here.
const study = {...rest, problems: problems.map((problem) => ({...problem, points: problem.points.slice(0, 3), drifts: []}))};
const url = fileOf(study);
const crank = study.problems.find(({name}) => name === 'slider_crank');

const stageOf = async (page) => (await section(page, 'motion')).locator('.stage');
const clock = async (page) => Number((await page.locator('main > :not([hidden]) .clock').textContent()).replace(' s', ''));
const differs = async (stage, act) => {
  const before = await stage.screenshot();
  await act();
  return !before.equals(await stage.screenshot());
};

/** Pixels of the first body. */
const blueOf = (page) => page.locator('main > :not([hidden]) canvas').evaluate((canvas) => {
  const pen = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
  pen.drawImage(canvas, 0, 0);
  const {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200 && data[i + 2] > data[i] + 40) ++count;
  return count;
});

for (const [gl, kind] of [[true, 'solid'], [false, 'flat']]) {
  const open = (name, use) => withPage({url, hash: `#/${name}/motion`, gl, options: {viewport: {width: 1000, height: 800}}}, use);

  test(`${kind}: the picture is there, and moves when it is played, and stops`, () => open('double_pendulum', async (page) => {
    const stage = await stageOf(page);
    assert.equal(await stage.getAttribute('data-stage'), kind);
    const {different, drawn} = await colours(page, await stage.locator('canvas').screenshot());
    assert.ok(different > 60 && drawn > 0.01, `${different} colours, ${drawn} drawn`);
    const play = page.locator('main > :not([hidden]) .play');
    assert.ok(await differs(stage, async () => {
      await play.click();
      await page.waitForFunction(() => parseFloat(document.querySelector('main > :not([hidden]) .clock').textContent) > 0.3);
      assert.equal(await play.textContent(), 'Pause');
      await play.click();
    }));
    const stopped = await clock(page);
    await page.waitForTimeout(150);
    assert.equal(await clock(page), stopped);
  }));

  test(`${kind}: keys play, turn, zoom and step`, () => open('slider_crank', async (page) => {
    const stage = await stageOf(page);
    await stage.focus();
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '.', 'ArrowRight', '-']) assert.ok(await differs(stage, () => page.keyboard.press(key)), key);
    assert.equal(await clock(page), Number(crank.motion.t[1].toFixed(2)));
    await page.keyboard.press(',');
    assert.equal(await clock(page), 0);
    await page.keyboard.press(' ');
    await page.waitForFunction(() => parseFloat(document.querySelector('main > :not([hidden]) .clock').textContent) > 0);
    await page.keyboard.press(' ');
    assert.equal(await page.locator('main > :not([hidden]) .play').textContent(), 'Play');
  }));

  test(`${kind}: the pointer turns the view, and arrows and traces can be changed`, () => open('sphere_in_cylinder', async (page) => {
    const stage = await stageOf(page);
    const here = page.locator('main > :not([hidden])');
    const box = await stage.boundingBox();
    assert.ok(await differs(stage, async () => {
      await page.mouse.move(box.x + 100, box.y + 100);
      await page.mouse.down();
      await page.mouse.move(box.x + 160, box.y + 120, {steps: 3});
      await page.mouse.up();
    }));
    assert.ok(await differs(stage, async () => {
      await here.getByLabel('time of the motion in seconds').focus();
      for (let i = 0; i < 9; ++i) await page.keyboard.press('PageUp');
    }), 'the bar of time moves by keys');
    assert.ok(await clock(page) > 2);
    assert.ok(await differs(stage, () => here.getByLabel('Reaction arrows').fill('3')));
    assert.ok(await differs(stage, () => here.getByLabel('Traces of bodies').uncheck()));
    assert.ok(await differs(stage, () => here.getByRole('button', {name: 'First view'}).click()));
  }));
}

/** Pixels of arrows: anywhere, and at the edge of the picture. */
const arrowsOf = (page) => page.locator('main > :not([hidden]) canvas').evaluate((canvas) => {
  const pen = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
  pen.drawImage(canvas, 0, 0);
  const {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
  const found = {all: 0, edge: 0};
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 200 || data[i] < 100 || data[i] < 1.6 * data[i + 1] || data[i] < 3 * data[i + 2]) continue;
    const [x, y] = [(i / 4) % canvas.width, Math.floor(i / 4 / canvas.width)];
    ++found.all;
    if (Math.min(x, y, canvas.width - 1 - x, canvas.height - 1 - y) < 2) ++found.edge;
  }
  return found;
});

for (const [gl, kind] of [[true, 'solid'], [false, 'flat']]) {
  test(`${kind}: arrows are in the first view at any time, also those that are cut or within a body`, () => {
    const inside = {...crank, name: 'inside', motion: {...crank.motion, bodies: crank.motion.bodies.slice(1).map((body) => ({...body, shape: {kind: 'box', size: [2.4, 2.4, 2.4]}})),
      reactions: crank.motion.reactions.map((one) => ({...one, force: one.force.map((_, i) => [0, 0, i === 3 ? 10 : 4])}))}};
    const pages = [...study.problems.filter(({name}) => ['double_pendulum', 'four_bar'].includes(name)), inside];
    return withPage({url: fileOf({...study, problems: pages}), hash: '#/double_pendulum/motion', gl, options: {viewport: {width: 1000, height: 800}}}, async (page) => {
      for (const {name, motion} of pages) {
        await page.goto(page.url().replace(/#.*/, `#/${name}/motion`));
        await stageOf(page);
        const here = page.locator('main > :not([hidden])');
        const {t, reactions} = motion;
        const strength = (time) => Math.max(...reactions.map(({force}) => Math.hypot(...force[t.findIndex((one) => one >= time)] ?? [0])));
        let seen = 0;
        const strongest = reactions.map(({force}) => force.map((one) => one ? Math.hypot(...one) : 0)).map((sizes) => t[sizes.indexOf(Math.max(...sizes))]);
        for (const time of [...[0.1, 0.35, 0.5, 0.65].map((part) => part * t[t.length - 1]), ...strongest, 0.5 * strongest[0]]) {
          await here.getByLabel('time of the motion in seconds').evaluate((bar, value) => { bar.step = 'any'; bar.value = value; bar.dispatchEvent(new Event('input')); }, time);
          const {all, edge} = await arrowsOf(page);
          assert.equal(edge, 0, `${name} ${time}`);
          if (strength(time) < 0.3 * strength(strongest[0])) continue;
          assert.ok(all > 30, `${name} ${time}: ${all} pixels`);
          ++seen;
        }
        assert.ok(seen >= 1);
        assert.equal(await here.locator('.cut').count(), name === 'double_pendulum' ? 1 : 0);
      }
    });
  });

  test(`${kind}: the camera follows what goes far, unless the whole path is asked for`, () => withPage({url, hash: '#/rolling_disc/motion', gl, options: {viewport: {width: 1000, height: 800}}}, async (page) => {
    const stage = await stageOf(page);
    const camera = page.locator('main > :not([hidden])').getByLabel('Camera');
    assert.equal(await camera.inputValue(), 'follow');
    await page.locator('main > :not([hidden])').getByLabel('Traces of bodies').uncheck();
    const near = await blueOf(page);
    assert.ok(await differs(stage, () => camera.selectOption('whole')));
    assert.ok(await blueOf(page) < near / 4, 'a disc that is followed is larger than one on its way');
    await stage.focus();
    await page.keyboard.press('f');
    assert.equal(await camera.inputValue(), 'follow', 'a key does the same');
    assert.equal(await blueOf(page), near);
    assert.match(await stage.getAttribute('aria-label'), /f follows the mechanism or holds its whole path/);
  }));
}

test('what stays where it is has no such choice', () => withPage({url, hash: '#/four_bar/motion'}, async (page) => {
  await stageOf(page);
  assert.equal(await page.locator('main > :not([hidden])').getByLabel('Camera').count(), 0);
}));

test('the forces of the study stand beside the picture, also where one is missing', () => withPage({url, hash: '#/slider_crank/motion'}, async (page) => {
  const here = page.locator('main > :not([hidden])');
  const {t, reactions: [guide]} = crank.motion;
  await (await stageOf(page)).focus();
  for (let i = 0; i < 10; ++i) await page.keyboard.press('.');
  assert.equal(await here.locator('.reactions dt').textContent(), 'guide on slider');
  assert.equal(await here.locator('.reactions dd').textContent(), `${Math.abs(guide.force[10][2]).toFixed(2)} N`);
  for (let i = 10; i < guide.force.indexOf(null); ++i) await page.keyboard.press('.');
  assert.equal(await here.locator('.reactions dd').textContent(), 'not known');
  const largest = Math.max(...guide.force.filter(Boolean).map((force) => Math.hypot(...force)));
  assert.match(await here.locator('[data-chart="motion"] .takeaway').textContent(), new RegExp(`guide, ${Number(largest.toPrecision(3))} N at`));
  assert.ok(t.length > 100);
}));

test('a motion without reactions says so, and speed can be chosen', () => withPage({url, hash: '#/lagrange_top/motion'}, async (page) => {
  const here = page.locator('main > :not([hidden])');
  assert.equal(await here.locator('[data-chart="motion"] .takeaway').textContent(), 'No reaction is known as a force on a body, so that none is drawn.');
  await here.getByLabel('speed').selectOption('10');
  await here.locator('.play').click();
  await page.waitForFunction(() => parseFloat(document.querySelector('main > :not([hidden]) .clock').textContent) > 2, null, {timeout: 3000});
}));
