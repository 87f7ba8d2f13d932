// Figures of Allen's dissertation (2007), sections 4.2 and 4.4, in the page; expected numbers
// were computed by an independent script.
import assert from 'node:assert/strict';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { picture, probed, range, scenes, settled } from './browser.mjs';
import { box, number, openScene, setValue, test } from './steps.mjs';

/** Figure 4.5, left. */
const figure = join(mkdtempSync(join(tmpdir(), 'delos-figure-')), 'figure-4.5.yaml');
writeFileSync(
  figure,
  `delos: 1
motion: {type: position_velocity, q: [0.3951529079, 0.3951529079, 0.10745377401]}
sample: {volume: {min: [0, 0, 0], max: [4, 4, 3], step: 0.2}}
devices:
  - {name: S1, type: acoustic_range, rate: 50 Hz, at: [0.5, 0.5, 3.5], params: {r: 0.005}}
  - {name: S2, type: acoustic_range, rate: 50 Hz, at: [3.5, 0.5, 3.5], params: {r: 0.005}}
  - {name: S3, type: acoustic_range, rate: 50 Hz, at: [0.5, 3.5, 3.5], params: {r: 0.005}}
  - {name: S4, type: acoustic_range, rate: 50 Hz, at: [3.5, 3.5, 3.5], params: {r: 0.005}}
`,
);

const near = (actual, expected, what) =>
  assert.ok(Math.abs(actual - expected) < 6e-8, `${what}: ${actual}, expected ${expected}`);

async function type(page, label, value) {
  await box(page, label).fill(value);
  await box(page, label).press('Enter');
  await settled(page);
}

await test('sliders and text boxes', [figure], async (page) => {
  await settled(page);
  for (const [k, x] of [2, 2, 1.5].entries()) await page.locator('form.at input').nth(k).fill(String(x));
  await page.click('form.at button');
  await page.waitForSelector('#report [data-metric]');
  await page.click('[data-device=S1]');
  const fields = {
    0.001: [0.0546679, 0.0975366, 0.1662362],
    0.005: [0.0596795, 0.1030847, 0.1662362],
    0.006: [0.0604981, 0.1050498, 0.1724601],
  };
  for (const [r, eigmax, sigma_z] of [
    [0.001, 0.0756313, 0.0459509],
    [0.003, 0.0756313, 0.0492723],
    [0.005, 0.0756313, 0.0515054],
    [0.006, 0.0782414, 0.0523881],
  ]) {
    await type(page, 'r', String(r));
    const point = await probed(page);
    near(point.eigmax, eigmax, `eigmax at r = ${r}`);
    near(point.sigma_z, sigma_z, `sigma_z at r = ${r}`);
    if (!fields[r]) continue;
    const [least, greatest] = await range(page);
    near(least, fields[r][0], `least at r = ${r}`);
    near(await number(page, 'mean'), fields[r][1], `mean at r = ${r}`);
    near(greatest, fields[r][2], `greatest at r = ${r}`);
  }
  await type(page, 'r', '0.005');
  await page.click('[data-device=S2]');
  await type(page, 'r', '0.007');
  near(await number(page, 'mean'), 0.1070106, 'mean at R2 = 0.007');
  near((await range(page))[1], 0.1781414, 'greatest at R2 = 0.007');
  await type(page, 'r', '0.005');

  // Section 4.1.3: one control raises and lowers all sensors.
  await page.check('#all-of-type');
  for (const [z, least, mean] of [
    ['3.0 m', 0.0581949, 0.1002542],
    ['4.0 m', 0.0581949, 0.1141907],
    ['3.5 m', 0.0596795, 0.1030847],
  ]) {
    await type(page, 'z', z);
    near((await range(page))[0], least, `least at z = ${z}`);
    near(await number(page, 'mean'), mean, `mean at z = ${z}`);
  }
});

const between = async (page, from, to) => {
  await page.selectOption('#view-body', 'between');
  for (const [label, text] of [['Greatest', to], ['Least', from]]) {
    await page.fill(`[aria-label="${label} value of the interval, value"]`, text);
    await page.press(`[aria-label="${label} value of the interval, value"]`, 'Enter');
  }
  return Number(await page.getAttribute('#between-count', 'data-count'));
};

await test('isosurfaces, interval volumes, image planes', [], async (page) => {
  await openScene(page, '01-acoustic');
  await setValue(page, 'sample.volume.step', '0.01');
  await page.check('#view-logarithmic');
  await page.selectOption('#view-units', 'log10');
  const [low, high] = (await range(page)).map(Math.log10);
  near(low / 1e3, -1.77086 / 1e3, 'least');
  near(high / 1e3, -1.08771 / 1e3, 'greatest');
  const least = '-1.771 log m';
  const pictured = async (name) => {
    await page.focus('#viewport canvas');
    await page.waitForTimeout(1500);
    await picture(page, name);
  };

  assert.equal(await between(page, least, '-1.76 log m'), 122);
  assert.equal(await between(page, least, '-1.6 log m'), 20637);
  for (const axis of ['z']) await page.keyboard.press(axis);
  assert.equal(await between(page, '-1.77 log m', '-1.4 log m'), 59689);
  await page.focus('#viewport canvas');
  await page.keyboard.press('z');
  await pictured('figure-4.9-left');
  assert.equal(await between(page, '-1.4 log m', '-1.08 log m'), 76463);
  await pictured('figure-4.9-right');

  await page.selectOption('#view-body', 'none');
  const level = async (text) => {
    await page.check('#view-surface');
    await page.fill('[aria-label="Level of the surface, value"]', text);
    await page.press('[aria-label="Level of the surface, value"]', 'Enter');
  };
  await level('-1.6 log m');
  await pictured('figure-4.8-right');
  await level('-1.76 log m');
  await page.selectOption('#view-body', 'volume');
  await pictured('figure-4.8-left');
  await page.selectOption('#view-body', 'none');
  await page.uncheck('#view-surface');

  const plane = async (axis, at) => {
    await page.$eval(
      `[aria-label="Place of the slice across ${axis}"]`,
      (input, n) => {
        input.value = String(n);
        input.dispatchEvent(new Event('input'));
      },
      at,
    );
    return page.$eval(`.slice-range[data-axis=${axis}]`, (e) => [Number(e.dataset.min), Number(e.dataset.max)]);
  };
  await page.keyboard.press('z');
  const upper = await plane('z', 60);
  near(upper[0], 27.5234e-3, 'plane z = 0.6');
  near(upper[1], 32.9385e-3, 'plane z = 0.6');
  await page.keyboard.press('x');
  await plane('x', 35);
  await pictured('figure-4.10-left');
  const lower = await plane('z', 40);
  near(lower[0], 41.6892e-3, 'plane z = 0.4');
  near(lower[1], 46.4208e-3, 'plane z = 0.4');
  await page.keyboard.press('z');
  await pictured('figure-4.10-right');
});

await test('objects', [join(scenes, '07-torso.yaml')], async (page) => {
  await settled(page);
  await picture(page, 'figure-4.12-left');
  // Two cameras and three make two bands, which the colours must keep apart.
  const seen = async (from, to) => between(page, from, to);
  assert.equal(await seen('294.38 um', '308.89 um'), 412);
  assert.equal(await seen('339.07 um', '446.77 um'), 300);
  const [worst, best] = await page.$eval('.strip', (strip) => {
    const stops = [...getComputedStyle(strip).backgroundImage.matchAll(/rgb\((\d+), (\d+), (\d+)\)/g)].map((m) => m.slice(1).map(Number));
    const at = (part) => stops[Math.round(part * (stops.length - 1))];
    const part = (v) => (v - 294.386) / (446.76 - 294.386);
    return [at(part(339.071)), at(part(308.889))];
  });
  const apart = Math.hypot(...worst.map((c, k) => c - best[k]));
  assert.ok(apart > 40, `the bands' colours are ${apart} apart`);
  await page.selectOption('#metric', 'coverage');
  await settled(page);
  for (const [cameras, vertices] of [[0, 719], [1, 299], [2, 300], [3, 412]])
    assert.equal(await seen(String(cameras - 0.1), String(cameras + 0.1)), vertices, `${cameras} cameras`);
  await picture(page, 'figure-4.12-right');
});
