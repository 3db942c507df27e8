// The tables of an evaluation: sorted, filtered, and linked.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, describe, it } from 'node:test';
import { fromDisk, launch, open, pages } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const column = (page, table, index) => page.locator(`${table} tbody tr:visible`)
  .evaluateAll((rows, i) => rows.map((row) => row.cells[i].textContent.trim()), index);
const numbers = (texts) => texts.map((t) => Number(t.replace('\u2212', '-').replace(/[()]/g, '')));
const descends = (values) => values.every((value, i) => i === 0 || value <= values[i - 1]);

describe('evaluation', () => {
  it('sorts numbers and words, either way', async () => {
    const { page, complaints, close } = await open(browser, fromDisk(pages.evaluation));
    const table = '#dimensions table';
    assert.ok(descends(numbers(await column(page, table, 5)).slice(0, 10).map(Math.abs)));
    await page.locator(`${table} th`, { hasText: 'Truth' }).getByRole('button').click();
    assert.ok(descends(numbers(await column(page, table, 2))));
    await page.locator(`${table} th`, { hasText: 'Truth' }).getByRole('button').press('Enter');
    assert.ok(descends(numbers(await column(page, table, 2)).reverse()));
    assert.equal(await page.locator(`${table} th[aria-sort]`).getAttribute('aria-sort'), 'ascending');
    await page.locator(`${table} th`, { hasText: 'Scan' }).getByRole('button').click();
    const scans = await column(page, table, 0);
    assert.deepEqual(scans, [...scans].sort());
    assert.deepEqual(complaints, []);
    await close();
  });

  it('filters a table by words', async () => {
    const { page, close } = await open(browser, fromDisk(pages.evaluation));
    const all = await column(page, '#dimensions table', 0);
    await page.getByLabel('Filter the dimensions').fill('LAYERED sleeve');
    const rows = await column(page, '#dimensions table', 1);
    // By hand: the T-shirt of layered-1 has three dimensions of its sleeves.
    assert.equal(rows.length, 3);
    assert.ok(rows.every((name) => name.includes('sleeve')));
    await page.getByLabel('Filter the dimensions').fill('');
    assert.equal((await column(page, '#dimensions table', 0)).length, all.length);
    await close();
  });

  it('agrees with the table it was given and the CSV it wrote', async () => {
    const { page, close } = await open(browser, fromDisk(pages.evaluation));
    const rows = fs.readFileSync(new URL('evaluation.csv', fromDisk(pages.evaluation)), 'utf8').trim().split('\n');
    assert.equal((await column(page, '#dimensions table', 0)).length, rows.length - 1);
    const head = rows[0].split(',');
    const errors = rows.slice(1).map((row) => row.split(','))
      .filter((row) => row[head.indexOf('truth_observable')] === 'true')
      .map((row) => Number(row[head.indexOf('estimate_cm')]) - Number(row[head.indexOf('truth_cm')]));
    const mae = errors.reduce((sum, e) => sum + Math.abs(e), 0) / errors.length;
    assert.equal(await page.locator('.keys dd').first().evaluate((e) => e.firstChild.textContent), mae.toFixed(2));
    await close();
  });

  it('links to reports that are there, and shows what became better', async () => {
    const { page, close } = await open(browser, fromDisk(pages.evaluation));
    const links = await page.locator('a[href^="fits/"]').evaluateAll((all) => all.map((a) => a.href));
    assert.ok(links.length >= 3);
    for (const link of new Set(links)) assert.ok(fs.existsSync(new URL(link)), link);
    assert.equal(await page.locator('#baseline tbody tr th', { hasText: 'mae_cm' }).first().count(), 1);
    await close();
  });
});
