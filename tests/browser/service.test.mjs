// The pages of the service, against `regarment serve` with a data folder of its own: a scan is
// sent, followed, opened, corrected and accepted, as a person would.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { after, before, describe, it } from 'node:test';
import { inWork, launch } from './browser.mjs';
import { validator, violations } from './health.mjs';

const phone = { viewport: { width: 390, height: 844 } };
const scan = path.join(process.env.EXAMPLES, 'skirt-1.mesh.ply');
const kFit = { timeout: 120000 };  // ms for a fit on a machine that has other work
let browser;
let server;
let home;

// The address that it says it listens on.
const serve = () => new Promise((done, fail) => {
  const data = inWork('service-data');
  fs.rmSync(data, { recursive: true, force: true });
  server = spawn(process.env.PROGRAM, ['serve', '--port', '0', '--data', data], { stdio: ['ignore', 'pipe', 'ignore'] });
  server.once('exit', (code) => fail(new Error(`serve ended with ${code}`)));
  createInterface({ input: server.stdout }).once('line', (line) => done(/http:\S+/.exec(line)[0]));
});

before(async () => {
  home = await serve();
  browser = await launch();
});
after(async () => {
  await browser.close();
  const gone = new Promise((done) => { server.once('exit', done); });
  server.kill('SIGTERM');
  await gone;
});

// A page that notes errors, refused requests, and requests to anywhere else.
const visit = async (address, options = {}) => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  const complaints = [];
  page.on('console', (message) => { if (message.type() !== 'verbose') complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
  page.on('request', (request) => {
    if (!request.url().startsWith(`${home}/`) && !/^(data|blob):/.test(request.url())) complaints.push(`request: ${request.url()}`);
  });
  await page.goto(home + address);
  return { page, complaints, close: () => context.close() };
};

const api = async (address) => (await fetch(`${home}/v1${address}`)).json();
const post = async (address, body) => (await fetch(`${home}/v1${address}`, { method: 'POST', body,
  headers: typeof body === 'string' ? { 'Content-Type': 'application/json' } : {} })).json();
const newest = async () => (await api('/jobs?limit=1')).jobs[0];

const submit = async (page, file, garment) => {
  await page.locator('#scan').setInputFiles(file);
  await page.locator('.garment-card', { hasText: garment }).click();
  await page.locator('#submit button.main').click();
  await page.waitForURL(/\/jobs\/[0-9a-f]{24}$/);
};

describe('service', () => {
  it('refuses to send nothing, and says what is missing', async () => {
    const { page, complaints, close } = await visit('/');
    await page.locator('.garment-card').first().waitFor();
    await page.locator('#submit button.main').click();
    await page.locator('#sending', { hasText: 'Choose a scan first' }).waitFor();
    await page.locator('#scan').setInputFiles(scan);
    await page.locator('#submit button.main').click();
    await page.locator('#sending', { hasText: 'at least one garment' }).waitFor();
    assert.equal(await page.locator('#no-jobs').isVisible(), true);
    assert.deepEqual(complaints, []);
    await close();
  });

  it('previews a binary PLY upright from four sides, and says so of other files', async () => {
    const { page, complaints, close } = await visit('/');
    await page.locator('#scan').setInputFiles(scan);
    await page.locator('#preview-sides canvas').nth(3).waitFor();
    // Where something is drawn: a person fills the height, and head and feet are narrower than the
    // arms held away from the body between them.
    const widths = await page.locator('#preview-sides canvas').first().evaluate((canvas) => {
      const { width, height } = canvas;
      const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
      return Array.from({ length: height }, (_, y) => {
        const filled = Array.from({ length: width }, (__, x) => x).filter((x) => data[4 * (y * width + x) + 3] > 0);
        return filled.length > 0 ? filled.at(-1) - filled[0] : 0;
      });
    });
    const filled = widths.map((w, y) => [w, y]).filter(([w]) => w > 0).map(([, y]) => y);
    assert.ok(filled.at(-1) - filled[0] > 0.85 * widths.length);
    const widest = widths.indexOf(Math.max(...widths));
    assert.ok(widest > 0.25 * widths.length && widest < 0.65 * widths.length);
    fs.writeFileSync(inWork('words.obj'), 'v 0 0 0\n');
    await page.locator('#scan').setInputFiles(inWork('words.obj'));
    await page.locator('#preview-words', { hasText: 'No preview of this format' }).waitFor();
    assert.deepEqual(complaints, []);
    await close();
  });

  it('takes a scan, shows progress that moves, and the result', async () => {
    const { page, complaints, close } = await visit('/');
    await submit(page, scan, 'Skirt');
    const shown = await page.evaluate(() => new Promise((done) => {
      const values = [];
      const bar = document.getElementById('progress');
      const look = () => {
        if (bar.value > (values.at(-1) ?? 0)) values.push(bar.value);
        if (document.querySelector('.measures, .state-box.poor')) done(values);
        else requestAnimationFrame(look);
      };
      look();
    }));
    assert.ok(shown.length >= 3, `progress was ${shown}`);
    assert.ok(shown.every((value) => value <= 1));
    const { id } = await newest();
    const stored = await api(`/jobs/${id}/result.json`);
    const cells = await page.locator('.measures .value').allTextContents();
    assert.deepEqual(cells.map((text) => Number(text.replace(/[()]/g, ''))),
      stored.garments[0].measurements.map((m) => Number(m.value_cm.toFixed(1))));
    assert.match(await page.locator('#state-title').textContent(), /dimensions measured/);
    const [report] = await Promise.all([page.waitForNavigation(), page.locator('#links a.main').click()]);
    assert.equal(report.status(), 200);
    await page.locator('h1', { hasText: 'Skirt' }).waitFor();
    assert.deepEqual(complaints, []);
    await close();
  });

  it('corrects the waist on the picture and keeps both results', async () => {
    const first = await newest();
    const { page, complaints, close } = await visit(`/jobs/${first.id}/correct`);
    const line = page.locator('.edge-line', { hasText: 'waist' });
    await line.waitFor();
    const field = page.getByLabel('waist', { exact: true });
    const before = Number(await field.inputValue());
    const edge = (await api(`/jobs/${first.id}/result.json`)).garments[0].edges.find(({ name }) => name === 'waist');
    assert.equal(before, Number(edge.height_cm.toFixed(1)));
    const { x, y, height } = await line.boundingBox();
    await page.mouse.move(x + 40, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + height / 2 - 6, { steps: 3 });
    await page.mouse.up();
    const dragged = Number(await field.inputValue());
    assert.ok(dragged > before + 0.5 && dragged < before + 4, `${before} became ${dragged}`);
    await line.press('Shift+ArrowDown');
    assert.equal(Number(await field.inputValue()), Number((dragged - 1).toFixed(1)));
    await page.getByLabel('Length', { exact: true }).fill('54');
    await page.locator('#fit').click();
    await page.locator('#changes tr').first().waitFor(kFit);
    const second = await newest();
    assert.equal(second.source, first.id);
    assert.deepEqual(second.options, { hint: { 'skirt.waist_edge': Number((dragged - 1).toFixed(1)) }, fix: { 'skirt.length': 54 } });
    const row = page.locator('#changes tr', { hasText: 'Length' });
    assert.equal(await row.locator('[data-name=Now]').textContent(), '54.0');
    assert.match(await row.locator('th').textContent(), /given, held/);
    assert.match(page.url(), new RegExp(`${second.id}/correct$`));
    await page.locator('#decide [data-verdict=rejected]').click();
    await page.locator('#new-state', { hasText: 'rejected' }).waitFor();
    assert.equal((await api(`/jobs/${second.id}`)).review.verdict, 'rejected');
    await page.locator('#decide [data-verdict=rejected]').click();
    await page.locator('#new-state', { hasText: 'no verdict yet' }).waitFor();
    assert.equal((await api(`/jobs/${second.id}`)).review, null);
    await page.locator('#decide [data-verdict=rejected]').click();
    await page.locator('#new-state', { hasText: 'rejected' }).waitFor();
    assert.equal((await api(`/jobs/${first.id}`)).review, null);
    assert.deepEqual(complaints, []);
    await close();
  });

  it("drags a T-shirt's cuff on its own side of the picture", async () => {
    const body = new FormData();
    for (const [name, value] of Object.entries({ garments: '["tshirt"]', options: '{"method":"direct"}' })) body.append(name, value);
    body.append('scan', new Blob([fs.readFileSync(path.join(process.env.EXAMPLES, 'tshirt-5.mesh.ply'))]), 't.ply');
    const { id } = await post('/jobs', body);
    await (await fetch(`${home}/v1/jobs/${id}/events`)).text();
    const { page, complaints, close } = await visit(`/jobs/${id}/correct`);
    const line = page.locator('.edge-line', { hasText: 'left cuff' });
    await line.waitFor();
    const picture = await page.locator('#front').boundingBox();
    const { x, y, width, height } = await line.boundingBox();
    // The left arm of somebody who looks at us is on our right.
    assert.ok(x > picture.x + picture.width / 2);
    assert.equal(await page.locator('.edge-line').count(), 3);
    const field = page.getByLabel('left cuff', { exact: true });
    const before = Number(await field.inputValue());
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2, y + height / 2 + 20, { steps: 3 });
    await page.mouse.up();
    const dragged = Number(await field.inputValue());
    assert.ok(dragged < before - 3, `${before} became ${dragged}`);
    await page.locator('#fit').click();
    await page.locator('#changes tr').first().waitFor(kFit);
    const now = await newest();
    assert.deepEqual(now.options, { hint: { 'tshirt.left_cuff_edge': dragged } });
    const edge = (await api(`/jobs/${now.id}/result.json`)).garments[0].edges.find(({ name }) => name === 'left_cuff');
    assert.ok(Math.abs(edge.height_cm - dragged) < 3, `${dragged} became ${edge.height_cm}`);
    assert.deepEqual(complaints, []);
    for (const one of [id, now.id]) await fetch(`${home}/v1/jobs/${one}`, { method: 'DELETE' });
    await close();
  });

  it('accepts by keyboard in the review queue, which then is empty', async () => {
    const { page, complaints, close } = await visit('/review');
    await page.locator('.item .state').first().waitFor();
    assert.equal(await page.locator('.item').count(), 1);
    const id = await page.locator('.item').getAttribute('data-job');
    const posted = page.waitForResponse((answer) => answer.url().endsWith('/review') && answer.request().method() === 'POST');
    await page.keyboard.press('a');
    await posted;
    assert.equal((await api(`/jobs/${id}`)).review.verdict, 'accepted');
    const answered = (method) => page.waitForResponse((answer) => answer.url().endsWith('/review') && answer.request().method() === method);
    const [undone] = await Promise.all([answered('DELETE'), page.keyboard.press('u')]);
    assert.equal(undone.status(), 200);
    assert.equal((await api(`/jobs/${id}`)).review, null);
    await Promise.all([answered('POST'), page.keyboard.press('a')]);
    await page.reload();
    await page.locator('#waiting', { hasText: 'No result waits' }).waitFor();
    assert.deepEqual(complaints, []);
    await close();
  });

  it('says in words why a scan failed, and deletes when asked twice', async () => {
    const broken = inWork('broken.ply');
    fs.writeFileSync(broken, fs.readFileSync(scan).subarray(0, 20000));
    const { page, close } = await visit('/');
    await submit(page, broken, 'T-shirt');
    await page.locator('#state-title', { hasText: 'could not be measured' }).waitFor(kFit);
    assert.ok((await page.locator('#state-words').textContent()).length > 20);
    await page.locator('#delete').click();
    await page.locator('#delete-not').click();
    await page.locator('#delete').click();
    await page.locator('#delete-sure').click();
    await page.waitForURL(`${home}/`);
    await page.locator('#jobs tr').first().waitFor();
    assert.equal(await page.locator('#jobs', { hasText: 'broken.ply' }).count(), 0);
    await close();
  });

  it('makes one page of the finished fits of a batch', async () => {
    const [batch, body] = [await post('/batches', '{"name":"of one"}'), new FormData()];
    for (const [name, value] of Object.entries({ garments: '["skirt"]', options: '{"method":"direct"}', batch: batch.id })) body.append(name, value);
    body.append('scan', new Blob([fs.readFileSync(scan)]), path.basename(scan));
    const { id } = await post('/jobs', body);
    await (await fetch(`${home}/v1/jobs/${id}/events`)).text();
    const { page, complaints, close } = await visit('/evaluate');
    await page.locator('#batch option', { hasText: 'of one' }).waitFor({ state: 'attached' });
    await page.locator('#batch').selectOption(batch.id);
    await page.locator('#truth').setInputFiles(path.join(process.env.EXAMPLES, 'ground_truth.csv'));
    await page.locator('#compare button.main').click();
    await page.locator('#rows tr').nth(3).waitFor();
    const errors = await page.locator('#rows [data-name="Error, cm"]').allTextContents();
    await page.locator('#make-page').click();
    await page.waitForURL(/\/jobs\/[0-9a-f]{24}$/);
    await page.locator('#links a.main').click(kFit);
    const link = page.locator(`a[href="/v1/jobs/${id}/report"]`).first();
    await link.waitFor();
    const worst = Math.max(...errors.map((text) => Math.abs(Number(text.replace('\u2212', '-')))));
    assert.ok((await page.locator('body').textContent()).includes(worst.toFixed(1)), `no error of ${worst}`);
    assert.deepEqual(complaints, []);
    await close();
  });

  it('finds jobs by their words', async () => {
    const { page, complaints, close } = await visit('/');
    await page.locator('#jobs tr').nth(1).waitFor();
    await page.locator('#text').fill('no such scan');
    await page.locator('#no-jobs').waitFor();
    await page.locator('#text').fill('skirt-1');
    await page.locator('#jobs tr').nth(1).waitFor();
    await page.locator('#reviewed').selectOption('verdict=rejected');
    await page.locator('#jobs tr').nth(1).waitFor({ state: 'detached' });
    assert.equal(await page.locator('#jobs tr').count(), 1);
    assert.deepEqual(complaints, []);
    await close();
  });

  for (const kind of ['/', '/jobs/ID', '/jobs/ID/correct', '/review', '/evaluate']) {
    it(`${kind} is valid HTML, clean by axe, and does not scroll sideways`, async () => {
      const address = kind.replace('ID', (await newest()).id);
      const { results } = await validator.validateString(await (await fetch(home + address)).text());
      assert.deepEqual(results.flatMap((r) => r.messages.map((m) => `${m.line}: ${m.ruleId}: ${m.message}`)), []);
      for (const options of [{}, phone, { colorScheme: 'dark' }]) {
        assert.deepEqual(await violations(browser, home + address, options), []);
      }
      const { page, close } = await visit(address, phone);
      await page.waitForLoadState('networkidle');
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
      await close();
    });
  }

  // The last one: from here on nobody is served without a key.
  it('asks for a key where there are keys, and takes none that is wrong', async () => {
    const { key } = JSON.parse(execFileSync(process.env.PROGRAM,
      ['key', 'add', 'browser', '--scope', 'admin', '--data', inWork('service-data'), '--json'], { encoding: 'utf8' }));
    // The server looks for new keys now and then.
    while ((await fetch(`${home}/v1/jobs`)).status !== 401);
    const { page, close } = await visit('/');
    const ask = async (text) => {
      await page.locator('#key').fill(text);
      await page.locator('#sign-in-form button').click();
    };
    await page.locator('#sign-in[open]').waitFor();
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('#jobs tr').count(), 0);
    await ask('no key at all');
    await page.locator('#key-problem', { hasText: 'key' }).waitFor();
    await ask(key);
    await page.locator('#jobs tr').first().waitFor();
    assert.equal(await page.locator('#sign-in').isVisible(), false);
    await page.locator('#leave button').click();
    await page.locator('#sign-in[open]').waitFor();
    await close();
  });
});
