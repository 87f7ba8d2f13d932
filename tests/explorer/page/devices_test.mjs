// Devices are added, copied, mirrored and taken away; everything can be undone; what is saved
// evaluates to the same numbers.
import assert from 'node:assert/strict';
import { axeSource, drawn, picture, range, settled } from './browser.mjs';
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

await test('what cannot be added, and a room by hand', [laboratory], async (page) => {
  await settled(page);
  await page.click('#add-device');
  // Its example reads two states, and the room has six.
  await page.click('[data-type=linear][data-preset=""]');
  await page.waitForSelector('.message[data-mood=bad]:not(:empty)');
  assert.ok((await page.textContent('.message')).length > 20, 'says why');
  assert.ok(await page.isDisabled('[aria-label="Undo (Ctrl Z)"]'), 'and all is as it was');
  await page.click('dialog[open] [aria-label="Close"]', { timeout: 2000 }).catch(() => {});
  const first = await range(page);
  const mean = await number(page, 'mean');

  // A body, by the keyboard alone: added, chosen, sized by a number, moved by typing.
  await page.focus('#viewport canvas');
  await page.keyboard.press('w');
  await page.waitForSelector('#room [aria-label="What to add to occluders"]', { state: 'attached' });
  await page.click('#room details[data-part=occluders] > summary');
  await page.focus('#room [aria-label="Add to occluders"]');
  await page.keyboard.press('Enter');
  const part = '#room details[data-part="occluders.box"]';
  await page.waitForSelector(`${part}[open]`);
  await settled(page);
  const corner = page.locator(`${part} fieldset`, { has: page.locator('legend', { hasText: /^min$/ }) }).locator('input[type=text]');
  await corner.first().fill('-1.5 m');
  await corner.first().press('Enter');
  await settled(page);
  await page.focus('#viewport canvas');
  for (const key of ['g', 'x', '0', '.', '2', '5', 'Enter']) await page.keyboard.press(key);
  await settled(page);
  assert.equal(await corner.first().inputValue(), '-1.25 m', 'its corner has moved with it');
  assert.ok((await number(page, 'mean')) > mean, 'it hides');

  // A region, drawn from above.
  await page.keyboard.press('7');
  await drawn(page);
  await page.selectOption('#paint-what', 'region');
  await page.click('#paint');
  const { x, y, width, height } = await page.locator('#viewport canvas').boundingBox();
  await page.mouse.move(x + 0.45 * width, y + 0.45 * height);
  await page.mouse.down();
  await page.mouse.move(x + 0.55 * width, y + 0.6 * height, { steps: 4 });
  await page.mouse.up();
  await page.waitForSelector('#room details[data-part="regions.region"][open]');
  await settled(page);
  await page.fill('[aria-label="Name of regions.region"]', 'door');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#room details[data-part="regions.door"][open]');
  await settled(page);
  await page.keyboard.press('Escape');
  await page.focus('#viewport canvas');
  await page.keyboard.press('f');
  await drawn(page);
  await picture(page, 'room');
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => window.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'] }));
  assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).join(', ')}`), [], 'contrast and names');

  assert.deepEqual(await range(page), rangeOf(await save(page, 'room.yaml')), 'the command line says the same');
  for (let k = 0; k < 5; ++k) await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await number(page, 'mean'), mean);
  assert.ok(await page.isDisabled('[aria-label="Undo (Ctrl Z)"]'), 'each is a step: all are taken back');
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
