// A report's own controls: the line between two looks, the looks, the view to turn, paper.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { PNG } from 'pngjs';
import { difference, fromDisk, launch, open, pages } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const line = (page) => page.locator('#pictures').evaluate((e) => e.style.getPropertyValue('--at'));
const seen = async (page) => PNG.sync.read(await page.locator('#view-canvas').screenshot());
// Drawing waits for the next frame; two of them have drawn it.
const frames = (page) => page.evaluate(() => new Promise((resolve) => {
  requestAnimationFrame(() => requestAnimationFrame(resolve));
}));

describe('report', () => {
  it('moves the line by keyboard and by dragging', async () => {
    const { page, complaints, close } = await open(browser, fromDisk(pages.report));
    assert.equal(await line(page), '50%');
    await page.locator('#line-at').focus();
    await page.keyboard.press('End');
    assert.equal(await line(page), '100%');
    const stack = page.locator('.after:visible .stack').first();
    await stack.scrollIntoViewIfNeeded();
    const box = await stack.boundingBox();
    await page.mouse.move(box.x + 0.25 * box.width, box.y + 20);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.75 * box.width, box.y + 20, { steps: 3 });
    await page.mouse.up();
    assert.equal(await line(page), '75%');
    assert.deepEqual(complaints, []);
    await close();
  });

  it('switches looks, left of the line too, and links to them', async () => {
    const { page, close } = await open(browser, `${fromDisk(pages.report)}#look-deviation`);
    assert.ok(await page.locator('.look.deviation').isVisible());
    await page.locator('label[for=look-segmentation]').click();
    assert.ok(await page.locator('.look.segmentation').isVisible());
    assert.ok(!await page.locator('.look.deviation').isVisible());
    assert.match(page.url(), /#look-segmentation$/);
    const over = page.locator('.look.segmentation .over').first();
    const before = await over.getAttribute('src');
    await page.locator('#left-of-line').selectOption({ index: 1 });
    assert.notEqual(await over.getAttribute('src'), before);
    await close();
  });

  it('turns the scan and shows garments', async () => {
    const { page, complaints, close } = await open(browser, fromDisk(pages.layered));
    const canvas = page.locator('#view-canvas');
    await canvas.scrollIntoViewIfNeeded();
    await frames(page);
    const front = await seen(page);
    await canvas.focus();
    for (let i = 0; i < 6; i += 1) await page.keyboard.press('ArrowRight');
    await frames(page);
    const side = await seen(page);
    assert.ok(difference(front, side) > 0.01);
    await page.keyboard.press('0');
    await frames(page);
    assert.equal(difference(front, await seen(page)), 0);
    await page.getByRole('button', { name: 'Back' }).click();
    await frames(page);
    assert.ok(difference(front, await seen(page)) > 0.005);
    await canvas.focus();
    await page.keyboard.press('0');
    await page.locator('#view-scan').uncheck();
    await frames(page);
    const nothing = await seen(page);
    await page.locator('.view-garment').first().check();
    await frames(page);
    assert.ok(difference(nothing, await seen(page)) > 0.01);
    assert.deepEqual(complaints, []);
    await close();
  });

  it('prints on at most six A4 pages', async () => {
    for (const file of [pages.report, pages.layered]) {
      const { page, close } = await open(browser, fromDisk(file));
      const pdf = (await page.pdf({ format: 'A4', preferCSSPageSize: true, printBackground: true })).toString('latin1');
      const count = pdf.match(/\/Type\s*\/Page\b/g).length;
      assert.ok(count >= 1 && count <= 6, `${file}: ${count} pages`);
      await close();
    }
  });
});
