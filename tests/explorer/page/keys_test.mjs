// Everything by the keyboard: choosing, moving by numbers, commands by name.
import assert from 'node:assert/strict';
import { delos, drawn, picture, range, settled } from './browser.mjs';
import { box, grab, laboratory, save, test } from './steps.mjs';

const metres = async (page, name) => Number((await box(page, name).inputValue()).replace(' m', ''));
const degrees = async (page, name) => Number((await box(page, name).inputValue()).replace(' deg', ''));
const undoable = async (page) => !(await page.isDisabled('[aria-label="Undo (Ctrl Z)"]'));

await test('moved by numbers', [laboratory], async (page) => {
  await settled(page);
  await page.keyboard.press('j');
  const [x, y, z, yaw] = [await metres(page, 'x'), await metres(page, 'y'), await metres(page, 'z'), await degrees(page, 'yaw')];
  await page.keyboard.type('gz-0.25');
  assert.match(await page.textContent('#hand'), /Move along z: -0.25 m/);
  await settled(page);
  await picture(page, 'typed');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.ok(Math.abs((await metres(page, 'z')) - (z - 0.25)) < 1e-4);
  assert.equal(await metres(page, 'x'), x);
  assert.equal(await page.textContent('#hand'), '');

  await page.keyboard.type('rz15');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.ok(Math.abs((await degrees(page, 'yaw')) - (yaw + 15)) < 1e-2);

  await page.keyboard.type('gx1.5');
  await settled(page);
  assert.ok(Math.abs((await metres(page, 'x')) - (x + 1.5)) < 1e-4);
  await page.keyboard.press('Escape');
  await settled(page);
  assert.ok(Math.abs((await metres(page, 'x')) - x) < 1e-4, 'Esc takes it back');

  // Twice: along the device's own axis, which is of unit length.
  await page.keyboard.type('gzz0.5');
  await page.keyboard.press('Enter');
  await settled(page);
  const way = Math.hypot((await metres(page, 'x')) - x, (await metres(page, 'y')) - y, (await metres(page, 'z')) - (z - 0.25));
  assert.ok(Math.abs(way - 0.5) < 1e-3, `${way}`);
  const saved = await save(page, 'typed.yaml');
  const { min, max } = delos('field', saved);
  assert.deepEqual(await range(page), [min.value, max.value]);
  for (let k = 0; k < 3; ++k) await page.keyboard.press('Control+z');
  await settled(page);
  assert.ok(!(await undoable(page)), 'three movements, three steps');
});

await test('a drag that is taken back', [laboratory], async (page) => {
  await settled(page);
  await page.click('[data-device=c104334]');
  await drawn(page);
  const place = () => Promise.all(['x', 'y', 'z'].map((axis) => metres(page, axis)));
  const before = await place();
  const tag = await page.locator('.tag.selected').boundingBox();
  const hand = { x: tag.x + tag.width / 2 + 2, y: tag.y + tag.height / 2 - 20 };
  await grab(page, hand.x, hand.y);
  for (let k = 1; k <= 5; ++k) await page.mouse.move(hand.x, hand.y - 8 * k);
  await page.waitForFunction(() => Number(document.querySelector('#numbers').dataset.revision) > 0);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  assert.deepEqual(await place(), before, 'it stands where it stood');
  assert.ok(!(await undoable(page)), 'and nothing is left to undo');
});

await test('commands by name', [laboratory], async (page) => {
  await settled(page);
  await page.keyboard.press('Control+k');
  await page.keyboard.type('next dev');
  await picture(page, 'commands');
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('[data-device][aria-pressed=true]').count(), 1);
  await drawn(page);
  await page.keyboard.press('0');
  await page.waitForTimeout(300);
  await picture(page, 'through');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+k');
  await page.keyboard.type('devices.*.rate = 50');
  await page.keyboard.press('Enter');
  await settled(page);
  const { min, max } = delos('field', laboratory, '--set', 'devices.*.rate=50');
  assert.deepEqual(await range(page), [min.value, max.value], 'any value by its path');
  await page.keyboard.press('Control+k');
  await page.keyboard.press('Escape');
  await page.keyboard.press('?');
  await picture(page, 'keys');
});
