// A search in the page: steered while it runs, kept, taken back, and gone on with by the
// command line, which says the same numbers.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { axeSource, delos, picture, pictures, scenes, settled } from './browser.mjs';
import { box, number, openScene, save, test } from './steps.mjs';

/** A copy of a scene, where a study can stand beside it. */
function roomOf(scene) {
  const folder = join(pictures, 'search');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const file = join(folder, `${scene}.yaml`);
  cpSync(join(scenes, `${scene}.yaml`), file);
  return { file, study: join(folder, 'room.study') };
}

const phase = (page) => page.getAttribute('#search-status', 'data-phase');
const reached = (page, ...phases) =>
  page.waitForFunction((all) => all.includes(document.querySelector('#search-status').dataset.phase), phases);
const incumbents = (page, least) =>
  page.waitForFunction((n) => document.querySelectorAll('[data-incumbent]').length >= n, least);
const undoable = async (page) => !(await page.isDisabled('[aria-label="Undo (Ctrl Z)"]'));
const metres = async (page, name) => {
  const text = await box(page, name).inputValue();
  return Number(text.replace(/ m?m$/, '')) * (text.endsWith(' mm') ? 1e-3 : 1);
};
const place = async (page) => [await metres(page, 'x'), await metres(page, 'y'), await metres(page, 'z')];

/** Wait until the layout is what was found. */
const follows = async (page) => {
  await page.waitForTimeout(300);
  await settled(page);
};

const room = roomOf('10-better-speakers');

await test('searched, locked, paused, gone on, kept', [room.file], async (page) => {
  await settled(page);
  const before = await number(page, 'mean');
  await page.keyboard.press('s');
  await page.waitForSelector('[data-variable]');
  assert.equal(await page.locator('[data-variable]').count(), 6);
  await page.click('text=How');
  await page.fill('#search-starts', '40');
  await page.fill('#search-study', 'room.study');
  await page.click('[data-device=s1]');
  await page.click('#search-start');
  await incumbents(page, 3);
  await follows(page);
  assert.ok((await number(page, 'mean')) < before, 'the layout moves as it improves');
  await picture(page, 'search');

  await page.click('[data-lock="devices.s1"]');
  await page.waitForFunction(() => document.querySelectorAll('.variable.locked').length === 3);
  await page.waitForFunction(() => document.querySelector('.curve svg').getAttribute('aria-label').endsWith('round 2'));
  await follows(page);
  const locked = await place(page);
  assert.equal(await phase(page), 'running', 'it goes on from there');

  await page.click('#search-pause');
  await reached(page, 'paused');
  await follows(page);
  assert.deepEqual(await place(page), locked, 'what is locked stays');
  const paused = delos('study', room.study, 'show');
  assert.deepEqual(paused.acts.map((a) => a.verb), ['lock', 'inject'], 'it goes on from what was looked at');
  assert.equal(paused.acts[0].argument, 'devices.s1');
  assert.deepEqual(paused.rounds.map((r) => r.ended), [true, false]);

  await page.keyboard.press('Escape');
  await page.keyboard.press('Shift+s'); // goes on
  await reached(page, 'running', 'waiting');
  await page.click('[data-device=s1]');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Shift+k'); // stops, and keeps the best
  await reached(page, 'paused', 'ended');
  await follows(page);
  await page.click('[data-device=s1]');
  assert.deepEqual(await place(page), locked);
  const kept = await number(page, 'mean');
  assert.ok(kept < before);
  const file = await save(page, 'searched.yaml');
  assert.equal(delos('field', file).mean, kept, 'the command line says the same');

  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await number(page, 'mean'), before, 'one step');
  assert.ok(!(await undoable(page)));
  await page.keyboard.press('Control+y');
  await settled(page);
  assert.equal(await number(page, 'mean'), kept);
  await page.reload();
  await settled(page);
  assert.equal(await number(page, 'mean'), kept, 'a reload loses nothing');
});

const begun = roomOf('10-better-speakers');

await test('begun in the page, ended by the command line', [begun.file], async (page) => {
  await settled(page);
  await page.keyboard.press('s');
  await page.waitForSelector('[data-variable]');
  await page.click('text=How');
  await page.fill('#search-starts', '6');
  await page.fill('#search-seed', '3');
  await page.fill('#search-study', '../room.study');
  await page.click('#search-start');
  await page.waitForSelector('.message[data-mood=bad]:not(:empty)');
  assert.ok(!existsSync(join(pictures, 'room.study')), 'nothing outside the folder of the scene');
  await page.fill('#search-study', 'room.study');
  await page.click('#search-start');
  await incumbents(page, 2);
  await page.click('#search-pause');
  await reached(page, 'paused', 'ended');
  assert.equal(await phase(page), 'paused');
  await page.click('#search-reject');
  await settled(page);
  assert.equal(await number(page, 'mean'), delos('field', begun.file).mean, 'taken back');
}, 1);
const resumed = delos('study', begun.study, 'resume');
const alone = delos('optimize', begun.file, '--starts', '6', '--seed', '3');
assert.deepEqual(resumed.variables, alone.variables, 'as if it had never stopped');
assert.equal(resumed.best, alone.best);

await test('a study of the command line, gone on with in the page', [begun.file], async (page) => {
  await settled(page);
  await page.keyboard.press('s');
  await page.waitForSelector('[data-variable]');
  await page.click('text=How');
  await page.fill('#search-study', 'room.study');
  await page.click('#search-start');
  await reached(page, 'ended');
  await follows(page);
  const file = await save(page, 'ended.yaml');
  const text = execFileSync(process.env.DELOS_PROGRAM, ['study', begun.study, 'best', join(pictures, 'best.yaml')], { encoding: 'utf8' });
  assert.equal(text, '');
  assert.equal(delos('field', file).mean, delos('field', join(pictures, 'best.yaml')).mean);
});

await test('a hand while it runs, and designs of before', [roomOf('10-better-speakers').file], async (page) => {
  await settled(page);
  await page.keyboard.press('s');
  await page.waitForSelector('[data-variable]');
  await page.click('text=How');
  await page.fill('#search-starts', '40');
  await page.click('#search-start');
  await incumbents(page, 3);
  await page.click('[data-device=s2]');
  await settled(page);
  await box(page, 'r').fill('0.001'); // a better speaker, which no search would give
  await box(page, 'r').press('Enter');
  await page.waitForFunction(() => document.querySelector('.curve svg').getAttribute('aria-label').endsWith('round 2'));
  await page.click('#search-pause');
  await reached(page, 'paused');
  await follows(page);
  assert.equal(await box(page, 'r').inputValue(), '0.001', 'it stays as the hand has made it');
  await page.click('[data-incumbent="1 0"]');
  await follows(page);
  assert.equal(await metres(page, 'z'), 1.0485, 'the first of all: where it began');
  assert.equal(await box(page, 'r').inputValue(), '0.001');
  await picture(page, 'search-hand');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.notEqual(await metres(page, 'z'), 1.0485);

  // One term more, and a constraint that is refused until it says what it is about.
  const terms = '.search details[data-part="objective.terms"]';
  await page.click('.search details[data-part=objective] > summary');
  await page.click(`${terms} > summary`);
  await page.click('[aria-label="Add to objective.terms"]');
  await page.waitForSelector(`${terms} details[data-part="objective.terms.1"]`);
  await settled(page);
  await page.click('#plot-terms');
  await page.waitForSelector('.terms-plot circle');
  const words = await page.getAttribute('.terms-plot svg', 'aria-label');
  assert.match(words, /^mean eigmax against p-norm of eigmax of \d+ designs/);
  assert.equal(await page.locator('.terms-plot circle').count(), await page.locator('[data-incumbent]').count());
  const places = await page.$$eval('.terms-plot circle', (all) => all.map((c) => [Number(c.dataset.x), Number(c.dataset.y)]));
  assert.ok(places.every(([x, y]) => x >= y), 'no mean is above the 8-norm');
  await picture(page, 'terms');
  await page.click('.search details[data-part=constraints] > summary');
  await page.selectOption('[aria-label="What to add to constraints"]', { label: 'inside' });
  await page.click('[aria-label="Add to constraints"]');
  await page.waitForSelector('.message[data-mood=bad]:not(:empty)');
  assert.match(await page.textContent('.message'), /there is no region ''; the scene declares none/);
}, 1);

await test('by the keyboard alone, in both themes', [], async (page) => {
  await openScene(page, '12-ceiling-anchors');
  await page.keyboard.press('s');
  await page.waitForSelector('[data-variable]');
  await page.click('text=How');
  await page.fill('#search-seconds', '20');
  await page.focus('#search-start');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#search-status[data-phase=ended]');
  assert.match(await page.textContent('#search-status'), /30 candidates/);
  for (const theme of ['dark', 'light']) {
    await picture(page, `selection-${theme}`);
    await page.evaluate(axeSource);
    const { violations } = await page.evaluate(() =>
      window.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'] }),
    );
    const said = violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).join(', ')}`);
    assert.deepEqual(said, [], `contrast and names, ${theme}`);
    await page.click('[aria-label="Dark or light"]');
  }
  await page.focus('#search-accept');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelectorAll('[data-device]').length === 30);
  await settled(page);
  const file = await save(page, 'chosen.yaml');
  assert.equal(delos('field', file).mean, await number(page, 'mean'));
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => document.querySelectorAll('[data-device]').length === 1);
});
