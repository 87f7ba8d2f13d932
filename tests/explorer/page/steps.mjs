// What tests of the page have in common: steps of a hand, and numbers of the command line.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { delos, drive, pictures, scenes, settled } from './browser.mjs';

export const laboratory = join(scenes, '05-optitrack-lab.yaml');
export const at = '0,0,1.5';

/** @param refusals of the server, which the browser tells the console of */
export async function test(name, words, steps, refusals = 0) {
  const began = Date.now();
  const { code, complaints } = await drive(words, steps);
  const refused = complaints.filter((text) => /status of 4(00|22)/.test(text));
  assert.equal(refused.length, refusals);
  assert.deepEqual(complaints.filter((text) => !refused.includes(text)), [], 'the console is silent');
  assert.equal(code, 0, 'Ctrl-C ends the server with exit code 0');
  console.log(`${name}: ${((Date.now() - began) / 1000).toFixed(1)} s`);
}

export const metricsOf = (file) =>
  Object.fromEntries(
    Object.entries(delos('point', file, '--at', at).metrics)
      .map(([name, { value }]) => [name, value])
      .filter(([name, value]) => name !== 'footprint' || value !== null),
  );

export const rangeOf = (file) => {
  const { min, max } = delos('field', file);
  return [min.value, max.value];
};

export async function probe(page) {
  const inputs = await page.$$('form.at input');
  for (const [k, number] of at.split(',').entries()) await inputs[k].fill(number);
  await page.click('form.at button');
  await page.waitForSelector('#report [data-metric]');
  await settled(page);
}

export async function save(page, name) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.click('[aria-label="Save as a scene file"]'),
  ]);
  const file = join(pictures, name);
  await download.saveAs(file);
  return file;
}

/** The text box of a parameter of the chosen device. */
export const box = (page, label) => page.getByLabel(label, { exact: true }).first();
export const slider = (page, label) => page.locator(`input[type=range][aria-label^="${label}, "]`);

/** Press on a handle of the gizmo. */
export async function grab(page, x, y) {
  await page.mouse.move(x, y);
  await page.waitForFunction(() => document.querySelector('#viewport canvas').style.cursor === 'grab');
  await page.mouse.down();
}

/** Drag by the hand: press on the element, move, let go. */
export async function dragSlider(page, label, part) {
  await slider(page, label).scrollIntoViewIfNeeded();
  const { x, y, width, height } = await slider(page, label).boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  for (let k = 1; k <= 8; ++k)
    await page.mouse.move(x + width * (0.5 + ((part - 0.5) * k) / 8), y + height / 2);
  await page.mouse.up();
}

/** Open a scene from the list. */
export async function openScene(page, scene) {
  const before = await page.title();
  if (before !== 'Delos') await page.click('#scene'); // else it asks by itself
  await page.click(`[data-scene="${scene}"]`);
  await page.waitForFunction((n) => document.title !== n, before);
  await settled(page);
}

/** Set any value of the scene, by the palette of commands. */
export async function setValue(page, path, value) {
  await page.keyboard.press('Control+k');
  await page.fill('dialog.command input', `${path} = ${value}`);
  await page.keyboard.press('Enter');
  await settled(page);
}

/** A number of the strip below the picture. */
export const number = (page, name) =>
  page.$eval(`#numbers [data-number="${name}"]`, (e) => Number(e.dataset.value));
