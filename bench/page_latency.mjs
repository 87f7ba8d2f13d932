// From a slider's event to the new field on the screen, in Debian's Chromium, drawn by the
// processor; and how much of it the server takes. After `cmake --build build/release` and the
// test Page.Installs:  node bench/page_latency.mjs
import { loadavg } from 'node:os';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
process.env.DELOS_PROGRAM ??= `${root}build/release/bin/delos`;
process.env.DELOS_WEB ??= `${root}build/release/tests/explorer/web`;
process.env.DELOS_SCENES ??= `${root}scenes`;
process.env.DELOS_PICTURES ??= `${root}build/release/bench/pictures`;
const { drive, settled } = await import('../tests/explorer/page/browser.mjs');
const { openScene, setValue } = await import('../tests/explorer/page/steps.mjs');

const moves = Array.from({ length: 40 }, (_, k) => k);

/** Scene, device, its slider, and a step that makes about 10⁴ samples of it. */
const cases = [
  ['01-acoustic', 's1', 'r', '0.025'],
  ['02-eight-cameras', 'upper1', 'focal', null],
  ['09-camera-room', 'west', 'focal', null],
];

/** Move a slider as a hand does: each event as soon as the one before is on the screen.
 * @param values of the slider for each event
 * @param told the element and its attribute that say what is shown */
const slide = (page, selector, values, told) =>
  page.evaluate(
    async ([selector, values, [element, attribute]]) => {
      const slider = document.querySelector(selector);
      const numbers = document.querySelector(element);
      const changed = (before) =>
        new Promise((done) => {
          const watch = new MutationObserver(() => {
            if (numbers.dataset[attribute] === before) return;
            watch.disconnect();
            done();
          });
          watch.observe(numbers, { attributes: true });
        });
      // What was asked to be drawn is drawn in the next frame; a task after it comes later.
      const shown = () =>
        new Promise((done) =>
          requestAnimationFrame(() => {
            const { port1, port2 } = new MessageChannel();
            port1.onmessage = done;
            port2.postMessage(null);
          }),
        );
      const times = [];
      for (const value of values) {
        performance.clearResourceTimings();
        const change = changed(numbers.dataset[attribute]);
        const began = performance.now();
        slider.value = String(value);
        slider.dispatchEvent(new Event('input'));
        await change;
        await shown();
        const all = performance.now() - began;
        const server = performance
          .getEntriesByType('resource')
          .filter((e) => /api\/(change|field|shapes)$/.test(e.name))
          .reduce((sum, e) => sum + e.responseStart - e.requestStart, 0);
        times.push([all, server]);
      }
      slider.dispatchEvent(new Event('change'));
      return times;
    },
    [selector, values, told],
  );

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

console.log(`load of the machine at the start: ${loadavg()[0].toFixed(2)}`);
await drive([], async (page) => {
  for (const [scene, device, label, step] of cases) {
    await openScene(page, scene);
    if (step) await setValue(page, 'sample.volume.step', step);
    await page.click(`[data-device=${device}]`);
    await settled(page);
    const samples = await page.textContent('#numbers span:last-child');
    const measure = async (what, selector, values, told) => {
      const times = await slide(page, selector, values, told);
      const [all, server] = [0, 1].map((k) => median(times.slice(5).map((t) => t[k])));
      console.log(`${scene}, ${samples.trim()}, ${what}: median ${all.toFixed(1)} ms, of which the server ${server.toFixed(1)} ms`);
      await settled(page);
    };
    const parameter = () =>
      measure(label, `input[type=range][aria-label^="${label}, "]`, moves.map((k) => 400 + 5 * k), ['#numbers', 'revision']);
    await parameter();
    await page.check('#view-surface');
    await settled(page);
    await measure('level of the surface', '#level', moves.map((k) => 0.2 + 0.01 * k), ['#surface-area', 'area']);
    await parameter();
    await page.uncheck('#view-surface');
  }
});
console.log(`load of the machine at the end: ${loadavg()[0].toFixed(2)}`);
