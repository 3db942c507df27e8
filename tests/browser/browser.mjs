// What all tests of pages share: the browser, the pages, a server, and how pictures are compared.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { PNG } from 'pngjs';

const folder = process.env.PAGES;

// Where the pages stand that run.sh has made.
export const pages = {
  report: path.join(folder, 'evaluation/fits/skirt-1.mesh/report.html'),
  layered: path.join(folder, 'evaluation/fits/layered-1.mesh/report.html'),
  evaluation: path.join(folder, 'evaluation/evaluation.html'),
  review: path.join(folder, 'review.html'),
  example: path.join(process.env.EXAMPLES, '../evaluation/scans-joint.html'),
  paper: process.env.PAPER,
};
export const fromDisk = (file) => pathToFileURL(file).href;
export const inWork = (name) => path.join(folder, name);

export const launch = () => chromium.launch({
  executablePath: process.env.CHROMIUM,
  // WebGL without a graphics card; no sandbox, since tests often run as root.
  args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader', '--force-color-profile=srgb',
    '--font-render-hinting=none', '--disable-lcd-text'],
});

// A page that notes everything it should not do: complaints on the console, errors, requests.
export const open = async (browser, address, options = {}) => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  const complaints = [];
  page.on('console', (message) => complaints.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
  page.on('request', (request) => {
    const url = request.url();
    if (url !== address && !/^(data|blob):/.test(url)) complaints.push(`request: ${url}`);
  });
  await page.goto(address);
  return { page, complaints, close: () => context.close() };
};

// Serves one folder's files and notes what was asked for.
export const serve = async (root) => {
  const asked = [];
  const server = http.createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    asked.push(name);
    const file = path.join(root, path.normalize(name));
    if (!file.startsWith(root) || !fs.existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { 'Content-Type': 'text/html; charset=utf-8' });
    return fs.createReadStream(file).pipe(response);
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  return { asked, address: (name) => `http://127.0.0.1:${server.address().port}/${name}`, close: () => server.close() };
};

// Means of 8 x 8 pixels: what is left when letters stand a little differently.
const blocksOf = ({ width, height, data }) => {
  const [across, down] = [Math.floor(width / 8), Math.floor(height / 8)];
  const out = new Float64Array(across * down * 3);
  for (let y = 0; y < down * 8; y += 1) {
    for (let x = 0; x < across * 8; x += 1) {
      const block = 3 * (Math.floor(y / 8) * across + Math.floor(x / 8));
      for (let k = 0; k < 3; k += 1) out[block + k] += data[4 * (y * width + x) + k] / 64;
    }
  }
  return out;
};

// The share of 8 x 8 blocks whose mean colour differs by more than 24 of 255; 1 for other sizes.
export const difference = (a, b) => {
  if (a.width !== b.width || a.height !== b.height) return 1;
  const [p, q] = [blocksOf(a), blocksOf(b)];
  let differ = 0;
  for (let i = 0; i < p.length; i += 3) {
    if ([0, 1, 2].some((k) => Math.abs(p[i + k] - q[i + k]) > 24)) differ += 1;
  }
  return differ / (p.length / 3);
};

// One block in twelve may differ: figures change with the method, words wrap elsewhere; a style that
// is lost, a dark page that is light or a missing picture changes far more.
export const kTolerance = 1 / 12;

export const compareWithBaseline = async (page, name) => {
  const bytes = await page.screenshot({ animations: 'disabled' });
  const taken = inWork(`pictures/${name}.png`);
  fs.mkdirSync(path.dirname(taken), { recursive: true });
  fs.writeFileSync(taken, bytes);
  const kept = path.join(process.env.BASELINES, `${name}.png`);
  if (process.env.UPDATE_BASELINES) {
    fs.mkdirSync(path.dirname(kept), { recursive: true });
    fs.copyFileSync(taken, kept);
  }
  const share = difference(PNG.sync.read(fs.readFileSync(kept)), PNG.sync.read(bytes));
  assert.ok(share <= kTolerance, `${taken} differs from ${kept} in ${(100 * share).toFixed(1)} % of its `
    + 'blocks; look at both, and run with UPDATE_BASELINES=1 where the new one is right');
};
