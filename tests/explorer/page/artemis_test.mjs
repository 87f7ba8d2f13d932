// Figures of Allen's dissertation (2007), sections 4.2 and 4.4, in the page; expected numbers
// were computed by an independent script.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { delos, picture, probed, range, scenes, settled } from './browser.mjs';
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

const setText = async (page, label, text) => {
  await page.fill(`[aria-label="${label}"]`, text);
  await page.press(`[aria-label="${label}"]`, 'Enter');
};

/** Move the slice across an axis to a layer. @returns the range of its values */
async function plane(page, axis, layer) {
  await page.$eval(
    `[aria-label="Place of the slice across ${axis}"]`,
    (input, n) => {
      input.value = String(n);
      input.dispatchEvent(new Event('input'));
    },
    layer,
  );
  return page.$eval(`.slice-range[data-axis=${axis}]`, (e) => [Number(e.dataset.min), Number(e.dataset.max)]);
}

const least = '-1.9 log m'; // below all

// Speakers above the corners of the volume.
await test('node counts', [], async (page) => {
  await openScene(page, '01-acoustic');
  for (const [name, x, y] of [['s1', 0, 0], ['s2', 0.4, 0], ['s3', 0, 0.4], ['s4', 0.4, 0.4]])
    await setValue(page, `devices.${name}.at`, `[${x}, ${y}, 1.0485]`);
  await setValue(page, 'sample.volume', '{min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.01}');
  const [low, high] = (await range(page)).map(Math.log10);
  assert.ok(Math.abs(low + 1.77086) < 6e-6 && Math.abs(high + 1.08771) < 6e-6);
  assert.equal(await between(page, least, '-1.76 log m'), 122);
  assert.equal(await between(page, least, '-1.6 log m'), 20637);
  assert.equal(await between(page, '-1.77 log m', '-1.4 log m'), 59689);
  assert.equal(await between(page, '-1.4 log m', '-1.08 log m'), 76463);
  await page.selectOption('#view-body', 'none');
  for (const [layer, from, to] of [[60, 27.5234e-3, 32.9385e-3], [40, 41.6892e-3, 46.4208e-3]]) {
    const [a, b] = await plane(page, 'z', layer);
    near(a, from, `layer ${layer}`);
    near(b, to, `layer ${layer}`);
  }
});

/** How many values of a field lie between two powers of ten, says the command line. */
function counted(file, sets, from, to) {
  const out = join(mkdtempSync(join(tmpdir(), 'delos-field-')), 'field.json');
  delos('field', file, '--out', out, ...sets);
  const { columns, values } = JSON.parse(readFileSync(out, 'utf8'));
  const k = columns.indexOf('value');
  return values.filter((row) => row[k] >= 10 ** from && row[k] <= 10 ** to).length;
}

await test('isosurfaces, interval volumes, image planes', [], async (page) => {
  const file = join(scenes, '01-acoustic.yaml');
  const step = 'sample.volume.step';
  await openScene(page, '01-acoustic');
  await setValue(page, step, '0.01');
  await page.check('#view-logarithmic');
  await page.selectOption('#view-units', 'log10');
  await page.uncheck('#view-frusta');
  const pictured = async (name) => {
    await page.focus('#viewport canvas');
    await page.waitForTimeout(1500);
    await picture(page, name);
  };
  await page.keyboard.press('z');
  assert.equal(await between(page, '-1.77 log m', '-1.4 log m'), counted(file, ['--set', `${step}=0.01`], -1.77, -1.4));
  await pictured('artemis-interval-low');
  assert.equal(await between(page, '-1.4 log m', '-1.08 log m'), counted(file, ['--set', `${step}=0.01`], -1.4, -1.08));
  await pictured('artemis-interval-high');

  await page.selectOption('#view-body', 'none');
  await page.check('#view-surface');
  await setText(page, 'Level of the surface, value', '-1.6 log m');
  await pictured('artemis-isosurface');
  await setText(page, 'Level of the surface, value', '-1.76 log m');
  await page.selectOption('#view-body', 'volume');
  await pictured('artemis-isosurface-low');
  await page.selectOption('#view-body', 'none');
  await page.uncheck('#view-surface');
  await page.focus('#viewport canvas');
  for (const axis of ['z', 'x']) await page.keyboard.press(axis);
  await plane(page, 'z', 100);
  await plane(page, 'x', 35);
  await pictured('artemis-planes');
  await page.keyboard.press('z');
  await page.keyboard.press('Shift+X');
  await page.waitForSelector('.slant');
  await settled(page);
  await pictured('artemis-slanted');

  // The region below −1.76 log m lies between 0.228 and 0.192 m below the speakers.
  await page.click('[aria-label="Take slanted slice 1 away"]');
  await page.focus('#viewport canvas');
  await page.keyboard.press('x');
  for (const [z, there] of [[0.98, false], [0.99, true], [1.02, true], [1.025, false]]) {
    await setValue(page, 'sample.volume', `{min: [0, 0, ${z}], max: [0.4, 0.4, ${z}], step: 0.005}`);
    assert.equal(Math.log10((await range(page))[0]) < -1.76, there, `${z} m`);
  }
  await setValue(page, 'sample.volume', '{min: [0.08, 0.08, 0.97], max: [0.32, 0.32, 1.04], step: 0.0025}');
  await page.check('#view-surface');
  await setText(page, 'Level of the surface, value', '-1.76 log m');
  await page.keyboard.press('f');
  await page.focus('#viewport canvas');
  await page.keyboard.press('7');
  await pictured('artemis-pincushion');
});

await test('objects', [join(scenes, '07-torso.yaml')], async (page) => {
  await settled(page);
  await picture(page, 'artemis-torso');
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

  // Section 4.1.4: a surface through the vertices, over x and z; the command line's has its range.
  const file = join(scenes, '07-torso.yaml');
  const folder = mkdtempSync(join(tmpdir(), 'delos-through-'));
  await page.selectOption('#through-method', 'linear');
  await page.selectOption('#through-over', 'y');
  for (const method of ['nearest', 'natural-neighbour']) {
    await page.selectOption('#through-method', method);
    await page.waitForFunction((m) => document.querySelector('#through-words').dataset.method === m, method);
    await settled(page);
    const words = await page.$eval('#through-words', (e) => ({ ...e.dataset }));
    const { through } = delos('render', file, '-o', join(folder, 'torso.png'), '--through', method, '--over', 'y');
    for (const key of ['min', 'max', 'places', 'blind']) assert.equal(Number(words[key]), through[key], `${method}: ${key}`);
  }
  // What is clicked on the lifted surface is the nearest of the vertices.
  await page.fill('#through-relief', '20 cm');
  await page.press('#through-relief', 'Enter');
  await settled(page);
  await picture(page, 'artemis-torso-surface');
  const { x, y, width, height } = await page.locator('#viewport canvas').boundingBox();
  await page.mouse.click(x + 0.41 * width, y + 0.615 * height);
  await page.waitForSelector('#report [data-metric]');
  await settled(page);
  const at = await page.$$eval('form.at input', (inputs) => inputs.map((input) => Number(input.value)));
  const vertices = delos('field', file, '--out', join(folder, 'torso.json')) && JSON.parse(readFileSync(join(folder, 'torso.json'), 'utf8')).values;
  const away = Math.min(...vertices.map((v) => Math.hypot(...at.map((c, k) => c - v[k]))));
  assert.ok(away < 1e-3, `the place asked is ${away} m from the nearest vertex`);
  await page.selectOption('#through-method', 'none');

  await page.selectOption('#metric', 'coverage');
  await settled(page);
  for (const [cameras, vertices] of [[0, 719], [1, 299], [2, 300], [3, 412]])
    assert.equal(await seen(String(cameras - 0.1), String(cameras + 0.1)), vertices, `${cameras} cameras`);
  await picture(page, 'artemis-torso-coverage');
});
