// Reports as files: a scene's and a study's, opened without a server.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { axeSource, delos, openFile, picture, pictures, pixels, drawn, scenes } from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'delos-report-'));
const run = (...words) => execFileSync(process.env.DELOS_PROGRAM, words, { cwd: folder, stdio: 'pipe' });
const evil = '</script><img src=x onerror=alert(1)>';
const samples = 'sample={volume: {min: [-3, -4.2, 0], max: [1.6, 3.4, 2], step: 0.4}}';
const lab = join(scenes, '06-furnished-lab.yaml');

/** A cell of a table, as a number. */
const number = (page, table, row, column) =>
  page.$eval(`#${table} tr[data-row="${row}"] [data-column="${column}"]`, (cell) => Number(cell.dataset.value));

async function accessible(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => window.axe.run());
  assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes[0].html}`), []);
}

async function seen(page, name) {
  await drawn(page);
  const { drawn: some, all } = await pixels(page);
  assert.ok(some > 0.02 * all, `${some} of ${all} pixels are drawn`);
  await accessible(page);
  await picture(page, name);
  const pdf = await page.pdf({ path: join(pictures, `${name}.pdf`), format: 'A4' });
  assert.ok(pdf.toString('latin1').match(/\/Type \/Page\b(?!s)/g).length > 2);
}

async function sceneReport(page) {
  assert.equal(await page.$eval('h1', (e) => e.textContent), evil);
  const field = delos('field', lab, '--set', samples);
  for (const [row, value] of [['least', field.min.value], ['mean', field.mean], ['median', field.median], ['greatest', field.max.value], ['observable samples', field.observable]])
    assert.equal(await number(page, 'figures', row, field.metric.name), value, row);
  await seen(page, 'report-scene');

  // It can be turned, sliced and painted, and devices can be chosen.
  const before = await pixels(page);
  await page.click('[aria-label="Slice across x"]');
  await drawn(page);
  assert.notDeepEqual(await pixels(page), before);
  await page.click('[aria-label="Look from above (7)"]');
  await page.click('.devices button');
  const chosen = await page.$eval('.devices [aria-pressed="true"]', (b) => b.dataset.device);
  assert.equal(await page.$eval('#chosen h2', (e) => e.textContent), chosen);
  const theme = () => page.$eval('html', (e) => e.dataset.theme);
  const was = await theme();
  await page.click('[aria-label="Dark or light"]');
  assert.notEqual(await theme(), was);
  await drawn(page);
  await accessible(page);
  await picture(page, 'report-scene-chosen');
  // What nobody could answer isn't offered.
  for (const missing of ['#add-device', '#metric', '#search-open', '[aria-label="Add a slanted slice"]', '.probe'])
    assert.equal(await page.$(missing), null, missing);
}

async function studyReport(page) {
  const study = delos('study', join(folder, 's.study'));
  assert.equal(await number(page, 'rounds', '1', 'evaluations'), study.rounds[0].evaluations);
  assert.equal(await number(page, 'rounds', '1', 'to'), study.rounds[0].best);
  run('study', 's.study', 'best', 'best.yaml');
  const best = delos('field', join(folder, 'best.yaml'));
  const mean = await number(page, 'figures', 'mean', 'after');
  assert.ok(Math.abs(mean / best.mean - 1) < 1e-9, `${mean}, ${best.mean}`);
  await seen(page, 'report-study');
  await page.click('[data-compare="difference"]');
  await drawn(page);
  assert.ok((await page.$eval('#colour-bar', (bar) => bar.textContent)).includes('change of'));
  await picture(page, 'report-study-difference');
}

/** On paper no table is cut, and the pictures stand instead of the canvas. */
async function onPaper(page) {
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.isVisible('.interactive'), false);
  const stills = await page.$$eval('.stills img', (all) => all.map((img) => img.getBoundingClientRect().width > 0 && img.naturalWidth > 0));
  assert.ok(stills.length >= 4 && stills.every(Boolean), String(stills));
  await page.setViewportSize({ width: 680, height: 900 }); // A4 within its margins
  const cut = await page.$$eval('article table, article svg', (all) => all.filter((e) => e.getBoundingClientRect().right > document.documentElement.clientWidth + 1).map((e) => e.id || e.className.baseVal));
  assert.deepEqual(cut, []);
}

try {
  run('report', lab, '-o', 'scene.html', '--set', samples, '--set', `name=${evil}`);
  run('optimize', join(scenes, '10-better-speakers.yaml'), '--evaluations', '60', '--starts', '2', '--samples', '100', '--study', 's.study');
  run('report', 's.study', '-o', 'study.html');
  for (const [file, steps] of [['scene.html', sceneReport], ['study.html', studyReport]]) {
    const address = pathToFileURL(join(folder, file)).href;
    const { complaints, asked } = await openFile(address, async (page) => {
      await steps(page);
      await onPaper(page);
    });
    assert.deepEqual(complaints, []);
    assert.deepEqual(asked.filter((url) => url !== address && !url.startsWith('data:') && !url.startsWith('blob:')), []);
  }
  // Without scripts the pictures and the answer are there.
  const { complaints } = await openFile(
    pathToFileURL(join(folder, 'scene.html')).href,
    async (page) => {
      assert.ok(await page.isVisible('.stills img'));
      assert.equal(await page.$eval('noscript h1', (e) => e.textContent), evil);
    },
    { javaScriptEnabled: false },
  );
  assert.deepEqual(complaints, []);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
