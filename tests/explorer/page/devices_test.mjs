// Devices are added, copied, mirrored and taken away; everything can be undone; what is saved
// evaluates to the same numbers.
import assert from 'node:assert/strict';
import { picture, range, settled } from './browser.mjs';
import { box, laboratory, number, rangeOf, save, test } from './steps.mjs';

const names = (page) => page.$$eval('[data-device]', (all) => all.map((b) => b.dataset.device));
const chosen = (page) => page.getAttribute('[data-device][aria-pressed=true]', 'data-device');

await test('one device more and one fewer', [laboratory], async (page) => {
  await settled(page);
  const first = await names(page);
  const before = await number(page, 'mean');

  await page.click('#add-device');
  await page.waitForSelector('[data-type=camera]');
  assert.ok((await page.locator('.type-card').count()) >= 18, 'all plugins are offered');
  await picture(page, 'palette');
  await page.click('[data-type=camera][data-preset="OptiTrack Prime 13"]');
  await page.waitForSelector('[data-device=camera_2]');
  await settled(page);
  assert.equal(await chosen(page), 'camera_2', 'the new one is chosen');
  assert.ok((await number(page, 'mean')) < before, 'one camera more is better');
  await box(page, 'z').fill('2.7 m');
  await box(page, 'z').press('Enter');
  await settled(page);

  await page.focus('#viewport canvas');
  await page.keyboard.press('Escape');
  await page.keyboard.press('m'); // nothing is chosen: nothing happens
  await page.click('[data-device=c104321]');
  await page.getByText('Mirror x', { exact: true }).click();
  await page.waitForSelector('[data-device=c104321_2]');
  await page.focus('#viewport canvas');
  await page.keyboard.press('d');
  await page.waitForSelector('[data-device=c104321_3]');
  await settled(page);
  await page.click('[data-device=c104334]');
  await page.focus('#viewport canvas');
  await page.keyboard.press('Delete');
  await page.waitForSelector('[data-device=c104334]', { state: 'detached' });
  await settled(page);
  assert.equal(await page.locator('.inspector h2').count(), 0, 'what is gone is not chosen');
  await picture(page, 'devices');

  const all = await names(page);
  assert.deepEqual(all, [...first.filter((n) => n !== 'c104334'), 'camera_2', 'c104321_2', 'c104321_3']);
  const now = await range(page);
  assert.deepEqual(now, rangeOf(await save(page, 'devices.yaml')), 'the command line says the same');

  for (let k = 0; k < 5; ++k) await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await names(page), first);
  assert.deepEqual(await range(page), rangeOf(laboratory));
  for (let k = 0; k < 5; ++k) await page.keyboard.press('Control+y');
  await settled(page);
  assert.deepEqual(await names(page), all);
  await page.reload();
  await settled(page);
  assert.deepEqual(await names(page), all, 'a reload loses nothing');
  assert.deepEqual(await range(page), now);
});

await test('what cannot be added', [laboratory], async (page) => {
  await settled(page);
  await page.click('#add-device');
  // Its example reads two states, and the room has six.
  await page.click('[data-type=linear][data-preset=""]');
  await page.waitForSelector('.message[data-mood=bad]:not(:empty)');
  assert.ok((await page.textContent('.message')).length > 20, 'says why');
  assert.ok(await page.isDisabled('[aria-label="Undo (Ctrl Z)"]'), 'and all is as it was');
}, 1);

await test('arrays', [laboratory], async (page) => {
  await settled(page);
  const count = () => page.locator('[data-device]').count();
  await page.click('[data-device=c104325]');
  await page.focus('#viewport canvas');
  await page.keyboard.press('Shift+D');
  await page.fill('#array-copies', '3');
  await page.getByLabel('x', { exact: true }).last().fill('-50 cm');
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-device=c104325_4]');
  await settled(page);
  assert.equal(await count(), 11);
  await picture(page, 'row');
  const x = Number((await box(page, 'x').inputValue()).replace(' m', ''));
  assert.ok(x < 2.05 && x > 0.5, `one of the copies is chosen: ${x}`);
  const saved = await save(page, 'row.yaml');
  assert.deepEqual(await range(page), rangeOf(saved));
  await page.focus('#viewport canvas');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await count(), 8, 'one step');

  await page.click('[data-device=c104325]');
  await page.getByText('Array…', { exact: true }).click();
  await page.check('#array-circle');
  await page.fill('#array-copies', '5');
  await page.getByText('Make them', { exact: true }).click();
  await page.waitForSelector('[data-device=c104325_6]');
  await settled(page);
  await page.focus('#viewport canvas');
  await page.keyboard.press('7');
  await page.waitForTimeout(300);
  await picture(page, 'circle');
  assert.equal(await count(), 13);
});
