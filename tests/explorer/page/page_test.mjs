// A newcomer's first minute: one click shows a coloured room, one drag changes it, and the
// numbers are those of the command line.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { axeSource, delos, drawn, picture, pixels, probed, range, scenes, settled } from './browser.mjs';
import { box, dragSlider, grab, laboratory, metricsOf, openScene, probe, rangeOf, save, test } from './steps.mjs';

await test('first minute', [], async (page) => {
  await picture(page, 'start');
  assert.ok((await page.locator('.scenes button').count()) >= 20, 'it offers the scenes');
  await page.click('[data-scene="05-optitrack-lab"]');
  await settled(page);
  await picture(page, 'laboratory');
  assert.deepEqual(await range(page), rangeOf(laboratory));
  const seen = await pixels(page);
  assert.ok(seen.drawn > 0.08 * seen.all, `the room is drawn: ${JSON.stringify(seen)}`);
  assert.ok(seen.good > 0.04 * seen.all, `it is coloured: ${JSON.stringify(seen)}`);
  assert.equal(await page.getAttribute('#verdict', 'data-least'), 'c104334');

  await page.focus('[data-device=c104334]');
  await page.keyboard.press('Enter');
  await probe(page);
  assert.deepEqual(await probed(page), metricsOf(laboratory));
  await picture(page, 'probe');

  await dragSlider(page, 'focal', 0.75);
  await settled(page);
  const changed = await probed(page);
  assert.notDeepEqual(changed, metricsOf(laboratory));
  const file = await save(page, 'slid.yaml');
  assert.deepEqual(changed, metricsOf(file), 'the numbers are those of delos point');
  assert.deepEqual(await range(page), rangeOf(file), 'and of delos field');

  await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await probed(page), metricsOf(laboratory), 'a drag is undone at once');
  assert.ok(await page.isDisabled('[aria-label="Undo (Ctrl Z)"]'), 'it was one step');
  await page.keyboard.press('Control+y');
  await settled(page);
  assert.deepEqual(await probed(page), changed);

  await page.reload();
  await settled(page);
  assert.deepEqual(await range(page), rangeOf(file), 'a reload loses nothing');
  await page.click('[aria-label="Undo (Ctrl Z)"]');
  await settled(page);
  assert.deepEqual(await range(page), rangeOf(laboratory));
});

await test('a camera in the hand', [laboratory], async (page) => {
  await settled(page);
  await page.click('[data-device=c104334]');
  await drawn(page);
  const before = Number((await box(page, 'z').inputValue()).replace(' m', ''));
  const tag = await page.locator('.tag.selected').boundingBox();
  // The upright arrow of the gizmo begins above the icon.
  const hand = { x: tag.x + tag.width / 2 + 2, y: tag.y + tag.height / 2 - 20 };
  await grab(page, hand.x, hand.y);
  let followed = 0;
  let revision = '';
  for (let k = 1; k <= 10; ++k) {
    await page.mouse.move(hand.x, hand.y - 5 * k);
    await page.waitForTimeout(60);
    const now = await page.getAttribute('#numbers', 'data-revision');
    followed += now !== revision;
    revision = now;
  }
  await picture(page, 'dragged');
  await page.mouse.up();
  await settled(page);
  assert.ok(followed >= 4, `the field follows while it moves: ${followed} times`);
  const after = Number((await box(page, 'z').inputValue()).replace(' m', ''));
  assert.ok(after > before + 0.2, `${before} to ${after} m`);
  const file = await save(page, 'dragged.yaml');
  assert.deepEqual(await range(page), rangeOf(file));

  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(Number((await box(page, 'z').inputValue()).replace(' m', '')), before);
  assert.ok(await page.isDisabled('[aria-label="Undo (Ctrl Z)"]'), 'one drag, one step');
  const back = await page.locator('.tag.selected').boundingBox();
  assert.ok(Math.abs(back.y - tag.y) < 1, 'the icon and its gizmo go back, too');
});

// About the eye's own axis, which in a view from above is nearly the room's upright one.
await test('a camera that turns', [laboratory], async (page) => {
  await settled(page);
  await page.click('[data-device=c104334]');
  await page.getByText('top', { exact: true }).click();
  await page.keyboard.press('r');
  await drawn(page);
  const angle = async (name) => Number((await box(page, name).inputValue()).replace(' deg', ''));
  const before = await Promise.all(['roll', 'pitch', 'yaw'].map(angle));
  const z = await box(page, 'z').inputValue();
  const tag = await page.locator('.tag.selected').boundingBox();
  const icon = { x: tag.x + tag.width / 2, y: tag.y + tag.height / 2 + 24 };
  const ring = 100; // pixels: the gizmo is as large in every view
  const around = (degrees) => [
    icon.x - ring * Math.cos((degrees * Math.PI) / 180),
    icon.y - ring * Math.sin((degrees * Math.PI) / 180),
  ];
  await grab(page, ...around(0));
  for (let degrees = 3; degrees <= 30; degrees += 3) await page.mouse.move(...around(degrees));
  await picture(page, 'turned');
  await page.mouse.up();
  await settled(page);
  const after = await Promise.all(['roll', 'pitch', 'yaw'].map(angle));
  assert.ok(Math.abs(after[2] - before[2]) > 10, `the yaw turns: ${before} to ${after}`);
  assert.ok(Math.abs(after[0] - before[0]) < 5, `the roll stays: ${before} to ${after}`);
  assert.equal(await box(page, 'z').inputValue(), z, 'it stands where it stood');
  assert.deepEqual(await range(page), rangeOf(await save(page, 'turned.yaml')));
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await Promise.all(['roll', 'pitch', 'yaw'].map(angle)), before);
  assert.deepEqual(await range(page), rangeOf(laboratory));
});

await test('numbers that are typed, and refused', [laboratory], async (page) => {
  await settled(page);
  await page.click('[data-device=c104321]');
  await box(page, 'focal').fill('12 mm');
  await box(page, 'focal').press('Enter');
  await settled(page);
  const typed = delos('field', laboratory, '--set', 'devices.c104321.params.focal=12 mm');
  assert.deepEqual(await range(page), [typed.min.value, typed.max.value]);

  await box(page, 'focal').fill('-1 mm');
  await box(page, 'focal').press('Enter');
  await page.waitForSelector('.message[data-mood=bad]:not(:empty)');
  assert.match(await page.textContent('.message'), /focal: -0.001 m is below the least value/);
  await page.keyboard.press('Tab');
  assert.equal(await box(page, 'focal').inputValue(), '12 mm', 'it stays as it was');

  const revision = () => page.getAttribute('#numbers', 'data-revision');
  await box(page, 'focal').pressSequentially('34');
  await box(page, 'focal').press('Control+z');
  await page.keyboard.type('grxyz7');
  assert.equal(await revision(), '1', 'while one types, keys are for the text');
  await page.keyboard.press('Escape');
  assert.equal(await box(page, 'focal').inputValue(), '12 mm');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await box(page, 'focal').inputValue(), '6.8 mm', 'else they undo');
  await page.keyboard.press('Control+y');
  await settled(page);

  await page.selectOption('#metric', 'coverage');
  await settled(page);
  const coverage = delos('field', laboratory, '--metric', 'coverage', '--set', 'devices.c104321.params.focal=12 mm');
  assert.deepEqual(await range(page), [coverage.min.value, coverage.max.value]);
  await picture(page, 'coverage');
}, 1);

await test('other kinds of rooms', [], async (page) => {
  await openScene(page, '01-acoustic');
  await page.check('#view-surface');
  await page.check('#view-logarithmic');
  await page.click('[aria-label="Slice across x"]');
  await page.keyboard.press('y');
  await picture(page, 'surface');
  assert.ok((await pixels(page)).drawn > 0.03 * (await pixels(page)).all);

  await openScene(page, '06-furnished-lab');
  await picture(page, 'furnished');
  await page.focus('#viewport canvas');
  await page.keyboard.press('Shift+C');
  await settled(page);
  const [near, cells] = (await page.textContent('#cell-count')).match(/\d+/g).map(Number);
  const { stdout } = spawnSync(process.env.DELOS_PROGRAM, ['field', join(scenes, '06-furnished-lab.yaml')], { encoding: 'utf8' });
  assert.ok(stdout.includes(`${cells} leaf cells`), `${cells}: ${stdout}`);
  assert.ok(near > 0 && near < cells);
  await picture(page, 'cells');
  await page.uncheck('#view-cells');
  await page.click('[aria-label="Dark or light"]');
  await picture(page, 'light');
  await page.click('[aria-label="Dark or light"]');

  await openScene(page, '07-torso');
  assert.deepEqual(await range(page), rangeOf(join(scenes, '07-torso.yaml')));
  await openScene(page, 'hiball/six-lepd');
  await picture(page, 'hiball');
  await page.click('[data-device=hiball]');

  // All blind: nothing of it may be bright.
  await openScene(page, '13-camera-spots');
  await picture(page, 'blind');
  const { good, all } = await pixels(page);
  assert.ok(good < 0.002 * all, `blind is never drawn as good: ${good}`);
});

await test('for everybody', [laboratory], async (page) => {
  await settled(page);
  await page.click('[data-device=c104321]');
  await probe(page);
  for (const theme of ['dark', 'light']) {
    assert.equal(await page.getAttribute('html', 'data-theme'), theme);
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    assert.equal(overflow, 0, 'all is within 1280 pixels');
    await page.evaluate(axeSource);
    const { violations } = await page.evaluate(() =>
      window.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'] }),
    );
    const said = violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).join(', ')}`);
    assert.deepEqual(said, [], `contrast and names, ${theme}`);
    await page.click('[aria-label="Dark or light"]');
  }
});

// Dissertation, section 4.1.3: one slider raises and lowers all sensors.
await test('all of a kind', [join(scenes, '01-acoustic.yaml')], async (page) => {
  await settled(page);
  await page.click('[data-device=s1]');
  await page.check('#all-of-type');
  await box(page, 'z').fill('1.5 m');
  await box(page, 'z').press('Enter');
  await settled(page);
  await box(page, 'rate').fill('100 Hz');
  await box(page, 'rate').press('Enter');
  await settled(page);
  const sets = ['s1', 's2', 's3', 's4'].flatMap((s) => [
    '--set', `devices.${s}.at.z=1.5`, '--set', `devices.${s}.rate=100 Hz`,
  ]);
  const { min, max } = delos('field', join(scenes, '01-acoustic.yaml'), ...sets);
  assert.deepEqual(await range(page), [min.value, max.value]);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z'); // at once: neither is lost
  await settled(page);
  assert.deepEqual(await range(page), rangeOf(join(scenes, '01-acoustic.yaml')));
});
