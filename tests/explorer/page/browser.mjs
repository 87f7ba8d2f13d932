// The real page in Debian's Chromium, against the real server.
import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** Where the page's packages are installed. */
const web = createRequire(join(process.env.DELOS_WEB, 'package.json'));
const { chromium } = web('playwright-core');
export const axeSource = web('axe-core').source;

export const scenes = process.env.DELOS_SCENES;
export const pictures = process.env.DELOS_PICTURES;

/** What the command line prints as JSON. */
export const delos = (...words) =>
  JSON.parse(execFileSync(process.env.DELOS_PROGRAM, [...words, '--json'], { encoding: 'utf8' }));

/** The server, until `end`. */
async function serve(words) {
  const server = spawn(process.env.DELOS_PROGRAM, ['explore', '--no-open', ...words]);
  const address = await new Promise((found, lost) => {
    server.stdout.on('data', (text) => {
      const match = /http:\S+/.exec(String(text));
      if (match) found(match[0]);
    });
    server.on('exit', (code) => lost(new Error(`the server ended with ${code}`)));
  });
  const end = () =>
    new Promise((ended) => {
      server.removeAllListeners('exit');
      server.on('exit', ended);
      server.kill('SIGINT');
    });
  return { address, end };
}

// Nothing that asks the network, and WebGL drawn by the processor.
const flags = [
  '--no-sandbox',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-dev-shm-usage',
];

/** Let `steps` drive a page in a browser of its own.
 * @param options of the browser, besides
 * @returns what the page complained of, and which addresses it asked for */
async function inBrowser(address, steps, options = {}) {
  mkdirSync(pictures, { recursive: true });
  const profile = mkdtempSync(join(tmpdir(), 'delos-browser-'));
  const complaints = [];
  const asked = [];
  let browser;
  try {
    browser = await chromium.launchPersistentContext(profile, {
      executablePath: '/usr/bin/chromium',
      headless: true,
      args: flags,
      viewport: { width: 1280, height: 720 },
      colorScheme: 'dark',
      acceptDownloads: true,
      ...options,
    });
    const page = browser.pages()[0] ?? (await browser.newPage());
    page.setDefaultTimeout(40_000);
    page.on('console', (m) => {
      if (m.type() === 'error') complaints.push(m.text());
    });
    page.on('pageerror', (error) => complaints.push(String(error.stack)));
    page.on('request', (request) => asked.push(request.url()));
    await page.goto(address);
    await steps(page);
  } finally {
    await browser?.close();
    rmSync(profile, { recursive: true, force: true });
  }
  return { complaints, asked };
}

/** Open a file. */
export const openFile = inBrowser;

/** Open the page of a server, let `steps` drive it, and end everything.
 * @returns the server's exit code and what the page complained of */
export async function drive(words, steps) {
  const server = await serve(words);
  let code;
  let complaints;
  try {
    ({ complaints } = await inBrowser(server.address, steps));
  } finally {
    code = await server.end();
  }
  return { code, complaints };
}

/** Wait until nothing is being worked out, and the field is the whole one. */
export const settled = (page) =>
  page.waitForFunction(
    () =>
      document.body.dataset.busy === 'false' &&
      document.body.dataset.shaping !== 'true' &&
      document.querySelector('#numbers').dataset.level === 'full',
  );

/** Wait until the picture shows what was asked of it: handles are found where they were last
 * drawn. */
export const drawn = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );

/** A picture for people to look at; the processor draws volumes slowly. */
export const picture = (page, name) =>
  page.screenshot({ path: join(pictures, `${name}.png`), timeout: 100_000 });

/** What the colour bar says it runs from and to. */
export const range = (page) =>
  page.$eval('#colour-bar', (bar) => [Number(bar.dataset.min), Number(bar.dataset.max)]);

/** Numbers of the probe, by metric; null where there is none. */
export const probed = (page) =>
  page.$$eval('#report [data-metric]', (rows) =>
    Object.fromEntries(
      rows.map((row) => [row.dataset.metric, row.dataset.value === '' ? null : Number(row.dataset.value)]),
    ),
  );

/** How many pixels of the picture are none of the background's, of the bright yellow of good
 * samples, and how many there are. */
export const pixels = (page) =>
  page.evaluate(() => {
    const canvas = document.querySelector('#viewport canvas');
    const copy = document.createElement('canvas');
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let drawn = 0;
    let good = 0;
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
      if (Math.abs(r - data[0]) + Math.abs(g - data[1]) + Math.abs(b - data[2]) > 24) ++drawn;
      if (r > 180 && g > 190 && b < 70) ++good;
    }
    return { drawn, good, all: data.length / 4 };
  });
