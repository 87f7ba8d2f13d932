// Where the picture is looked at from: views along axes, without perspective, through a device,
// of two designs at once; and that a hand turns devices in all of them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { delos, drawn, picture, range, scenes, settled } from './browser.mjs';
import { box, grab, laboratory, openScene, setValue, test } from './steps.mjs';

const deg = Math.PI / 180;
/** Where the laboratory's cameras stand, by their names; one of them near the floor. */
const low = 'c104321';
const places = Object.fromEntries(
  [...readFileSync(laboratory, 'utf8').matchAll(/name: (c\d+).*?at: \[([^\]]+)\]/g)].map(([, name, at]) => [name, at.split(',').map(Number)]),
);
places[low][2] = 0.5;

/** Where their names stand on the page: as far above each of them. */
const tags = (page) =>
  page.$$eval('.labels .tag', (all) =>
    Object.fromEntries(
      all.filter((e) => e.style.display !== 'none').map((e) => {
        const { x, y, width, height } = e.getBoundingClientRect();
        return [e.textContent, [x + width / 2, y + 2 * height]];
      }),
    ),
  );

/** Straight line of s over t by least squares. @returns slope and the greatest residual */
function fit(t, s) {
  const mean = (v) => v.reduce((a, b) => a + b, 0) / v.length;
  const [mt, ms] = [mean(t), mean(s)];
  const slope = t.reduce((sum, x, i) => sum + (x - mt) * (s[i] - ms), 0) / t.reduce((sum, x) => sum + (x - mt) ** 2, 0);
  return { slope, off: Math.max(...t.map((x, i) => Math.abs(s[i] - ms - slope * (x - mt)))) };
}

/** Of what is seen along which axis: right and up, as an axis and its sign. */
const views = {
  top: [[0, 1], [1, 1]],
  below: [[0, 1], [1, -1]],
  front: [[0, 1], [2, 1]],
  back: [[0, -1], [2, 1]],
  side: [[1, 1], [2, 1]],
  left: [[1, -1], [2, 1]],
};
const keys = { top: '7', below: 'Control+7', front: '1', back: 'Control+1', side: '3', left: 'Control+3' };
const cube = (page, view) => page.locator(`.view-cube [data-view=${view}]`);
const flat = (page) => page.getAttribute('#orthographic', 'aria-pressed').then((text) => text === 'true');

/** How well the picture is one along an axis, to one scale. @returns pixels a metre */
async function measure(page, view) {
  const at = await tags(page);
  const names = Object.keys(at);
  assert.equal(names.length, 8, `all names are seen from ${view}`);
  const [right, up] = views[view].map(([axis, sign], k) => {
    const found = fit(names.map((n) => places[n][axis]), names.map((n) => at[n][k]));
    return { off: found.off, slope: found.slope * sign * (k === 0 ? 1 : -1) };
  });
  return { right, up };
}

await test('along axes, without perspective', [laboratory], async (page) => {
  await settled(page);
  await setValue(page, `devices.${low}.at.z`, '0.5 m');
  for (const view of Object.keys(views)) {
    await page.keyboard.press(keys[view]);
    await drawn(page);
    const { right, up } = await measure(page, view);
    assert.ok(right.slope > 20 && up.slope > 20, `${view}: ${JSON.stringify([right, up])}`);
    assert.ok(Math.max(right.off, up.off) > 10, 'in perspective what is nearer is larger');
  }
  await page.keyboard.press('5');
  await drawn(page);
  assert.ok(await flat(page));
  for (const view of Object.keys(views)) {
    await page.keyboard.press(keys[view]);
    await drawn(page);
    const { right, up } = await measure(page, view);
    assert.ok(Math.max(right.off, up.off) < 1, `${view}: all is to one scale: ${JSON.stringify([right, up])}`);
    assert.ok(Math.abs(right.slope / up.slope - 1) < 0.01, `${view}: ${JSON.stringify([right, up])}`);
  }
  await page.keyboard.press('7');
  await drawn(page);
  await picture(page, 'orthographic-top');
  const before = await tags(page);
  await page.keyboard.press('5');
  await drawn(page);
  assert.ok(!(await flat(page)));
  const near = await tags(page);
  const shift = Object.keys(before).map((n) => Math.hypot(near[n][0] - before[n][0], near[n][1] - before[n][1]));
  assert.ok(Math.max(...shift) < 120, 'with perspective it is about as large');
  await page.keyboard.press('5');
  await drawn(page);
  assert.deepEqual(await tags(page), before, 'back and forth is no change');
});

await test('the cube', [laboratory], async (page) => {
  await settled(page);
  await setValue(page, `devices.${low}.at.z`, '0.5 m');
  await picture(page, 'view-cube');
  await page.click('#orthographic');
  for (const view of ['top', 'front', 'left']) {
    await page.keyboard.press('f');
    await drawn(page);
    await cube(page, view).click();
    await drawn(page);
    const { right, up } = await measure(page, view);
    assert.ok(right.slope > 20 && up.slope > 20 && Math.max(right.off, up.off) < 1, `a click on ${view}`);
  }
  for (const view of ['back', 'side', 'below']) {
    await cube(page, view).focus();
    await page.keyboard.press('Enter');
    await drawn(page);
    assert.ok((await measure(page, view)).right.slope > 20, `by the keyboard: ${view}`);
  }
  // From the front, twelve steps to the right of 15 degrees are half a turn.
  await cube(page, 'front').focus();
  await page.keyboard.press('Enter');
  for (let k = 0; k < 12; ++k) await page.keyboard.press('ArrowRight');
  await drawn(page);
  const back = await measure(page, 'back');
  assert.ok(back.right.slope > 20 && back.right.off < 1, JSON.stringify(back));
});

/** Turn the hand on a ring by an angle, degrees, clockwise positive as seen. */
async function turn(page, from, by) {
  const at = (await tags(page))[low];
  const ring = 67; // pixels: two thirds of the eye's own ring
  const around = (d) => [at[0] + ring * Math.cos(d * deg), at[1] + ring * Math.sin(d * deg)];
  await grab(page, ...around(from));
  for (let k = 1; k <= 10; ++k) await page.mouse.move(...around(from + (by * k) / 10));
  await page.mouse.up();
  await settled(page);
  await drawn(page);
}

// The device stands as the room does, so that each view has one of its rings as a circle; it
// turns by as much as the hand. From above clockwise is a negative yaw, from the front a positive
// pitch (y is away from the eye), from the right a negative roll.
await test('rings from views along axes', [laboratory], async (page) => {
  await settled(page);
  await page.click(`[data-device=${low}]`);
  const angle = async (name) => Number((await box(page, name).inputValue()).replace(' deg', ''));
  const angles = () => Promise.all(['roll', 'pitch', 'yaw'].map(angle));
  for (const name of ['roll', 'pitch', 'yaw']) {
    await box(page, name).fill('0 deg');
    await box(page, name).press('Enter');
    await settled(page);
  }
  await page.focus('#viewport canvas');
  await page.keyboard.press('r');
  await page.keyboard.press('Enter'); // by the hand, not by numbers
  for (const orthographic of [false, true]) {
    if (orthographic) await page.keyboard.press('5');
    for (const [key, which, sign] of [['7', 2, -1], ['1', 1, 1], ['3', 0, -1], ['Control+7', 2, 1]]) {
      await page.keyboard.press(key);
      await drawn(page);
      const by = orthographic ? -50 : 35;
      await turn(page, 40, by);
      const now = await angles();
      now.forEach((a, k) => {
        const wanted = k === which ? sign * by : 0;
        assert.ok(Math.abs(a - wanted) < 2.5, `${orthographic} ${key}: ${now}, wanted ${wanted} of ${k}`);
      });
      if (key === '1') await picture(page, `ring-${orthographic ? 'orthographic' : 'perspective'}`);
      await page.keyboard.press('Control+z');
      await settled(page);
      await drawn(page);
      assert.ok((await angles()).every((a) => Math.abs(a) < 1e-6), 'one step');
    }
  }
});

/** Keep what a part of the picture shows, in the page: it is much. */
async function keep(page, name, part = 'all') {
  await settled(page);
  for (let k = 0; k < 2; ++k) await drawn(page);
  await page.evaluate(([name, part]) => {
    const source = document.querySelector('#viewport canvas');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [source.width, source.height];
    const context = copy.getContext('2d');
    context.drawImage(source, 0, 0);
    const half = Math.floor(copy.width / 2);
    const [x, w] = part === 'left' ? [0, half] : part === 'right' ? [half, half] : [0, copy.width];
    (window.kept ??= {})[name] = context.getImageData(x, 0, w, copy.height).data;
  }, [name, part]);
}
/** Which part of the pixels' numbers differ. */
const differ = (page, a, b) =>
  page.evaluate(([a, b]) => window.kept[a].reduce((sum, x, i) => sum + (Math.abs(x - window.kept[b][i]) > 8), 0) / window.kept[a].length, [a, b]);

await test('through a device, and two designs with one camera', [laboratory], async (page) => {
  await settled(page);
  await page.click('[data-device=c104334]');
  await page.focus('#viewport canvas');
  await page.keyboard.press('5');
  await page.keyboard.press('0');
  await keep(page, 'one');
  const moved = async () => {
    await keep(page, 'now');
    return differ(page, 'one', 'now');
  };
  await page.keyboard.press('j');
  assert.ok((await moved()) > 0.02, 'through the next one');
  await page.keyboard.press('k');
  assert.equal(await moved(), 0);
  await box(page, 'yaw').fill('20 deg');
  await box(page, 'yaw').press('Enter');
  assert.ok((await moved()) > 0.02, 'it looks where the device looks now');
  await page.focus('#viewport canvas');
  await page.keyboard.press('Control+z');
  assert.equal(await moved(), 0);

  await page.keyboard.press('p');
  await page.waitForSelector('#difference [data-difference=mean]');
  await page.keyboard.press('c');
  const halves = async () => {
    await keep(page, 'left', 'left');
    await keep(page, 'right', 'right');
    return differ(page, 'left', 'right');
  };
  assert.ok((await halves()) < 0.002, 'both halves look through it');
  await picture(page, 'beside-through');
  await page.keyboard.press('Escape');
  assert.ok(await flat(page), 'and then without perspective again');
  await page.keyboard.press('Escape');
  for (const key of ['f', '7', '1']) {
    await page.keyboard.press(key);
    assert.ok((await halves()) < 0.002, `one camera for both: ${key}`);
  }
  await page.keyboard.press('5');
  assert.ok((await halves()) < 0.002);

  // The design is the right half, and its handles work there.
  await page.keyboard.press('f');
  await page.click('[data-device=c104334]');
  await settled(page);
  await drawn(page);
  const z = Number((await box(page, 'z').inputValue()).replace(' m', ''));
  const [x, y] = (await tags(page)).c104334;
  await grab(page, x + 2, y - 40);
  for (let k = 1; k <= 5; ++k) await page.mouse.move(x + 2, y - 40 - 8 * k);
  await page.mouse.up();
  await settled(page);
  await picture(page, 'beside-moved');
  assert.ok(Number((await box(page, 'z').inputValue()).replace(' m', '')) > z + 0.2);
});

await test('a volume without perspective', [], async (page) => {
  await openScene(page, '01-acoustic');
  await page.selectOption('#view-body', 'between');
  await page.focus('#viewport canvas');
  await page.keyboard.press('5');
  await settled(page);
  await page.waitForTimeout(400);
  await picture(page, 'orthographic-volume');
});

await test('slopes of the metric', [], async (page) => {
  await openScene(page, '01-acoustic');
  await page.click('[data-device=s1]');
  await page.fill('#sensitivity', 'devices.s1.params.r');
  await page.keyboard.press('Enter');
  await settled(page);
  await page.waitForFunction(() => /slope of eigmax per devices.s1.params.r in/.test(document.querySelector('.bar-title').textContent));
  const [low, high] = await range(page);
  assert.equal(low, -high, 'no influence is in the middle of the bar');
  assert.equal(await page.textContent('#colour-bar .zero'), '0');
  // More noise is never better: over all samples the slope is at most what all four speakers'
  // slopes come to by Euler's theorem, 3/8 of eigmax over r.
  const { max } = delos('field', join(scenes, '01-acoustic.yaml'));
  assert.ok(high > 0 && high < (0.375 * max.value) / 0.005, `${high}`);
  await picture(page, 'sensitivity');
  await page.fill('#sensitivity', 'devices.s1.params.nothing');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.message[data-mood=bad]:not(:empty)');
  await settled(page);
  assert.equal(await page.inputValue('#sensitivity'), '', 'of what there isn\'t, none');
}, 1);

await test('slanted cuts through a difference', [laboratory], async (page) => {
  await settled(page);
  await page.keyboard.press('p');
  await page.waitForSelector('#difference [data-difference=mean]');
  await page.keyboard.press('z');
  await page.keyboard.press('Shift+X');
  await page.waitForSelector('.slant');
  const pale = await pixelsOf(page);
  assert.ok(pale > 5000, `a cut on which nothing differs: ${pale}`);
  await page.click('[data-device=c104332]');
  await box(page, 'z').fill('0.4 m');
  await box(page, 'z').press('Enter');
  await settled(page);
  await drawn(page);
  await picture(page, 'slanted-difference');
  const still = await pixelsOf(page);
  assert.ok(still < 0.85 * pale, `where it differs it is no longer pale: ${still} of ${pale}`);
});

/** How many pixels are as pale as no difference. */
async function pixelsOf(page) {
  await keep(page, 'pale');
  return page.evaluate(() => {
    const { pale } = window.kept;
    let count = 0;
    for (let i = 0; i < pale.length; i += 4) count += Math.min(pale[i], pale[i + 1], pale[i + 2]) > 236;
    return count;
  });
}
