// A design beside the one that it came from: the difference, its zero, and numbers that the
// command line knows too.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { delos, picture, pictures, range, scenes, settled } from './browser.mjs';
import { box, laboratory, openScene, save, test } from './steps.mjs';

const difference = (page) =>
  page.$$eval('#difference [data-difference]', (all) =>
    Object.fromEntries(all.map((e) => [e.dataset.difference, Number(e.dataset.value)])),
  );

await test('against what is pinned', [laboratory], async (page) => {
  await settled(page);
  await page.click('#pin');
  await page.waitForSelector('#difference [data-difference=mean]');
  assert.deepEqual(await difference(page), { mean: 0, least: 0, greatest: 0, better: 0, gained: 0, lost: 0 });

  await page.click('[data-device=c104332]');
  await box(page, 'z').fill('0.4 m');
  await box(page, 'z').press('Enter');
  await settled(page);
  await picture(page, 'difference');
  const now = await difference(page);
  const [low, high] = await range(page);
  assert.equal(low, -high, 'no difference is in the middle of the bar');
  assert.equal(await page.textContent('#colour-bar .zero'), '0');

  const saved = await save(page, 'compared.yaml');
  const answer = delos('compare', laboratory, saved).difference;
  assert.equal(now.mean, answer.mean);
  assert.equal(now.least, answer.min);
  assert.equal(now.greatest, answer.max);
  assert.equal(now.better, answer.improved_fraction);
  assert.ok(Math.abs(high - Math.max(-now.least, now.greatest)) < 1e-12);

  await page.click('[data-compare=beside]');
  await settled(page);
  await page.waitForTimeout(300);
  await picture(page, 'beside');
  const halves = await page.evaluate(() => {
    const canvas = document.querySelector('#viewport canvas');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const half = Math.floor(copy.width / 2);
    return [0, half].map((x) => {
      const { data } = context.getImageData(x, 0, half, copy.height);
      let sum = 0;
      for (let i = 0; i < data.length; i += 4) sum += data[i + 1];
      return sum;
    });
  });
  assert.ok(halves.every((sum) => sum > 0) && halves[0] !== halves[1], 'two rooms that differ');

  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal((await difference(page)).mean, 0, 'back where it was pinned');
  await page.reload();
  await settled(page);
  assert.equal(await page.textContent('#pin'), 'Unpin', 'a reload keeps what is pinned');
  await page.click('#pin');
  await settled(page);
  assert.ok(await page.isHidden('#difference'));
});

await test('what is lost and gained', [], async (page) => {
  await openScene(page, '02-eight-cameras');
  await page.click('#pin');
  await page.click('[data-device=lower1]');
  await page.focus('#viewport canvas');
  await page.keyboard.press('Delete');
  await settled(page);
  const { lost, gained } = await difference(page);
  assert.ok(lost > 0 && gained === 0);
  assert.match(await page.textContent('#colour-bar'), new RegExp(`seen only before: ${lost}`));
  await picture(page, 'lost');
  const without = await save(page, 'without.yaml');
  const before = delos('field', join(scenes, '02-eight-cameras.yaml')).finite;
  assert.equal(lost, before - delos('field', without).finite);
  writeFileSync(join(pictures, 'lost.txt'), String(lost));
});
