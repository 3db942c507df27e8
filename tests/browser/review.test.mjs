// Going through results: keys, filter, notes, undo, what is kept, handed out and read back.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, describe, it } from 'node:test';
import { fromDisk, inWork, launch, open, pages } from './browser.mjs';

const address = fromDisk(pages.review);
const names = ['layered-1.mesh', 'skirt-1.mesh', 'tshirt-5.mesh'];  // the page's order
let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const current = (page) => page.locator('.item[aria-current=true]').getAttribute('data-name');
const state = async (page, name) => (await page.locator(`[data-name="${name}"] .state`).textContent()).replace(/^[✓✗] /, '');
const press = async (page, ...keys) => { for (const key of keys) await page.keyboard.press(key); };
const save = async (page, button) => {
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator(button).click()]);
  return fs.readFileSync(await download.path(), 'utf8');
};

describe('review', () => {
  it('goes through all by keyboard', async () => {
    const { page, complaints, close } = await open(browser, address);
    assert.equal(await current(page), names[0]);
    await press(page, 'j', 'ArrowRight', 'j');
    assert.equal(await current(page), names[2]);
    await press(page, 'k', 'ArrowLeft');
    assert.equal(await current(page), names[0]);
    await press(page, 'a');
    assert.equal(await current(page), names[1]);
    await press(page, 'r', 'a');
    assert.deepEqual(await Promise.all(names.map((n) => state(page, n))), ['accepted', 'rejected', 'accepted']);
    assert.match(await page.locator('#tally').textContent(), /3 of 3 decided: 2 accepted, 1 rejected/);
    await press(page, 'u', 'u');
    assert.deepEqual(await Promise.all(names.map((n) => state(page, n))), ['accepted', 'undecided', 'undecided']);
    assert.deepEqual(complaints, []);
    await close();
  });

  it('takes back a verdict given twice', async () => {
    const { page, close } = await open(browser, address);
    await press(page, 'a', 'k', 'a');
    assert.equal(await state(page, names[0]), 'undecided');
    await close();
  });

  it('filters by words and by verdict', async () => {
    const { page, close } = await open(browser, address);
    await press(page, '/');
    await page.keyboard.type('skirt layered');
    assert.equal(await page.locator('.item:visible').count(), 1);
    assert.equal(await current(page), names[0]);
    await press(page, 'Escape', 'a');
    await page.locator('#which').selectOption('open');
    assert.deepEqual(await page.locator('.item:visible').evaluateAll((all) => all.map((e) => e.dataset.name)), names.slice(1));
    await page.locator('#filter').fill('no such thing');
    assert.ok(await page.locator('#none-left').isVisible());
    await close();
  });

  it('keeps verdicts and notes, hands them out and reads them back', async () => {
    const note = '-1 cm, "hem"\nsecond line';
    const { page, complaints, close } = await open(browser, address);
    await press(page, 'a', 'n');
    await page.keyboard.type('not this');
    await press(page, 'Escape');
    assert.equal(await page.locator(`[data-name="${names[1]}"] .written`).textContent(), '');
    await press(page, 'n');
    await page.keyboard.type('-1 cm, "hem"');
    await press(page, 'Shift+Enter');
    await page.keyboard.type('second line');
    await press(page, 'Enter', 'r');
    assert.deepEqual(complaints, []);
    await page.reload();
    assert.equal(await state(page, names[1]), 'rejected');
    assert.equal(await page.locator(`[data-name="${names[1]}"] .written`).textContent(), note);
    const [csv, json] = [await save(page, '#save-csv'), await save(page, '#save-json')];
    const { schema, verdicts } = JSON.parse(json);
    assert.equal(schema, 'regarment.review/1');
    assert.deepEqual(verdicts.map(({ result, verdict, note: n }) => [result, verdict, n]),
      [[names[0], 'accepted', ''], [names[1], 'rejected', note], [names[2], '', '']]);
    assert.ok(verdicts.every((v) => /^[0-9a-f]{64}$/.test(v.scan_sha256)));
    // No cell that a spreadsheet would run; quotes doubled.
    assert.ok(csv.includes('"\'-1 cm, ""hem""\nsecond line"'));
    await close();

    for (const [file, text] of [['verdicts.csv', csv], ['verdicts.json', json]]) {
      fs.writeFileSync(inWork(file), text);
      const other = await open(browser, address);
      await other.page.locator('#load-file').setInputFiles(inWork(file));
      await other.page.locator('#tally', { hasText: '2 verdicts taken' }).waitFor();
      assert.equal(await state(other.page, names[1]), 'rejected');
      assert.equal(await other.page.locator(`[data-name="${names[1]}"] .written`).textContent(), note);
      await press(other.page, 'u');
      assert.equal(await state(other.page, names[1]), 'undecided');
      await other.close();
    }
  });

  it('says so when a verdict is about other numbers, and refuses what is none', async () => {
    const { page, close } = await open(browser, address);
    const load = async (text) => {
      fs.writeFileSync(inWork('given.csv'), text);
      await page.locator('#load-file').setInputFiles(inWork('given.csv'));
    };
    await load(`result,verdict,result_digest\n${names[0]},accepted,ffff\nnowhere,accepted,\n`);
    await page.locator('#tally', { hasText: '1 are about results that are not here' }).waitFor();
    assert.equal(await state(page, names[0]), 'undecided; accepted before the result changed');
    await load('a,b\n1,2\n');
    await page.locator('#tally', { hasText: 'cannot be imported' }).waitFor();
    await load(`result,verdict\n${names[0]},maybe\n`);
    await page.locator('#tally', { hasText: "'maybe' is no verdict" }).waitFor();
    await close();
  });

  it('shows one at a time, the keys, and links to the reports', async () => {
    const { page, close } = await open(browser, address);
    await press(page, 'z');
    assert.equal(await page.locator('.item:visible').count(), 1);
    assert.ok(await page.locator('.item:visible .lights .good').first().isVisible());
    await press(page, 'j', 'z');
    assert.equal(await current(page), names[1]);
    assert.equal(await page.locator('.item:visible').count(), 3);
    await press(page, '?');
    assert.ok(await page.locator('#keys').isVisible());
    await press(page, 'Escape');
    assert.ok(!await page.locator('#keys').isVisible());
    for (const link of await page.locator('.item h2 a').evaluateAll((all) => all.map((a) => a.href))) {
      assert.ok(fs.existsSync(new URL(link)), link);
    }
    await press(page, 'o');
    await page.waitForURL(/skirt-1\.mesh\/report\.html$/);
    await close();
  });
});
