// What can be seen of a field: planes, volumes, colours, uncertainty; blind never looks good.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { delos, picture, pictures, pixels, range, scenes, settled } from './browser.mjs';
import { openScene, test } from './steps.mjs';

const shot = async (page, name) => {
  await settled(page);
  await page.waitForTimeout(400);
  await picture(page, name);
  return pixels(page);
};

await test('planes, volumes and colours', [], async (page) => {
  await openScene(page, '01-acoustic');
  const one = await shot(page, 'slice');
  await page.keyboard.press('x');
  await page.keyboard.press('y');
  const three = await shot(page, 'slices');
  assert.ok(three.drawn > 1.05 * one.drawn, 'more planes cover more of the picture');
  for (const axis of ['x', 'y', 'z']) await page.keyboard.press(axis);
  const none = await shot(page, 'no-slice');
  assert.ok(none.drawn < 0.97 * one.drawn, `${JSON.stringify(none)} of ${JSON.stringify(one)}`);
  await page.keyboard.press('Shift+X');
  await page.waitForSelector('.slant');
  const slanted = await shot(page, 'slanted');
  assert.ok(slanted.drawn > 1.02 * none.drawn, 'a slanted plane is drawn');
  await page.click('[aria-label="Take slanted slice 1 away"]');

  await page.selectOption('#view-body', 'volume');
  const cloud = await shot(page, 'cloud');
  assert.ok(cloud.drawn > 1.2 * none.drawn, 'the volume is drawn');
  await page.selectOption('#view-body', 'between');
  await page.fill('[aria-label="Greatest value of the interval, value"]', '30 mm');
  await page.keyboard.press('Enter');
  const between = await shot(page, 'between');
  assert.ok(between.drawn > none.drawn && between.drawn < cloud.drawn);
  await page.selectOption('#view-body', 'none');

  // The surface is the one that the command line draws, also while the level is moved by keys.
  await page.check('#view-surface');
  await page.fill('[aria-label="Level of the surface, value"]', '25 mm');
  await page.keyboard.press('Enter');
  await shot(page, 'surface');
  const surface = () => page.getAttribute('#surface-area', 'data-area').then(Number);
  const { surfaces } = delos('render', join(scenes, '01-acoustic.yaml'), '--surface', '25 mm', '-o', join(pictures, 'surface-render.png'));
  assert.ok(Math.abs((await surface()) / surfaces[0].area - 1) < 1e-9, `${await surface()} of ${surfaces[0].area}`);
  await page.focus('#viewport canvas');
  await page.keyboard.press(']');
  await settled(page);
  assert.notEqual(await surface(), surfaces[0].area);
  await page.uncheck('#view-surface');

  await page.focus('#viewport canvas');
  await page.keyboard.press('z');
  const look = async (name) => {
    await shot(page, name);
    return page.locator('#viewport canvas').screenshot();
  };
  const flat = await look('flat');
  await page.keyboard.press('h');
  assert.ok(await page.isChecked('#view-relief'));
  assert.ok(!flat.equals(await look('relief')), 'the slice is raised');
  await page.keyboard.press('h');
  assert.ok(flat.equals(await look('flat')), 'and flat again');
  await page.keyboard.press('z');

  await page.focus('#viewport canvas');
  await page.keyboard.press('z');
  await page.selectOption('#view-map', 'inferno');
  await page.check('#view-reversed');
  await page.check('#view-logarithmic');
  await page.selectOption('#view-units', 'log10');
  await shot(page, 'inferno');
  assert.match(await page.textContent('.bar-title'), /log₁₀ m/);
  const ends = await page.$$eval('.ticks .end', (all) => all.map((e) => Number(e.textContent)));
  const [low, high] = await range(page);
  assert.ok(Math.abs(ends[0] - Math.log10(low)) < 1e-3 && Math.abs(ends[1] - Math.log10(high)) < 1e-3);
  await page.fill('[aria-label="Colours from"]', '10 mm');
  await page.fill('[aria-label="Colours to"]', '-1 log m');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.deepEqual(await range(page), [0.01, 0.1], 'a range that stays');
});

await test('uncertainty', [], async (page) => {
  await openScene(page, '02-eight-cameras');
  await page.keyboard.press('z');
  await page.keyboard.press('e');
  await page.waitForFunction(() => document.querySelector('#view-lattice').checked);
  const bodies = await shot(page, 'ellipsoids');
  await page.keyboard.press('e');
  const without = await shot(page, 'no-ellipsoids');
  assert.ok(bodies.drawn > 1.01 * without.drawn, `${bodies.drawn} and ${without.drawn}`);
  await page.keyboard.press('b');
  await page.waitForSelector('#blind-regions li', { state: 'attached' });
  await page.click('summary:has-text("Uncertainty")');
  await shot(page, 'blind-regions');
  assert.match(await page.textContent('#blind-regions'), /samples? .*(sees|observed)/);
});

// Scene 13 is blind everywhere: no cloud of it may be bright.
await test('blind in a cloud', [], async (page) => {
  await openScene(page, '13-camera-spots');
  await page.keyboard.press('v');
  const { good, all } = await shot(page, 'blind-cloud');
  assert.ok(good < 0.002 * all, `blind is never drawn as good: ${good}`);
  await openScene(page, '02-eight-cameras');
  await page.selectOption('#view-body', 'between');
  await shot(page, 'between-cameras');
});
