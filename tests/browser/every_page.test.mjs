// What holds for every page, whatever it shows.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, describe, it } from 'node:test';
import { compareWithBaseline, fromDisk, launch, open, pages, serve } from './browser.mjs';
import { validator, violations } from './health.mjs';

const phone = { viewport: { width: 390, height: 844 } };
const dark = { colorScheme: 'dark' };

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

for (const [name, file] of Object.entries(pages)) {
  describe(name, () => {
    it('opens from disk without a complaint or a request', async (t) => {
      const { page, complaints, close } = await open(browser, fromDisk(file));
      const loaded = await page.evaluate(() => performance.getEntriesByType('navigation')[0].loadEventEnd);
      t.diagnostic(`${name}: ${(fs.statSync(file).size / 1e6).toFixed(2)} MB, loaded in ${loaded.toFixed(0)} ms`);
      assert.deepEqual(complaints, []);
      assert.equal(await page.locator('h1').count(), 1);
      await close();
    });

    it('opens from a server, which is asked for nothing else', async () => {
      const server = await serve(path.dirname(file));
      const { complaints, close } = await open(browser, server.address(path.basename(file)));
      assert.deepEqual(complaints, []);
      assert.deepEqual(server.asked, [`/${path.basename(file)}`]);
      await close();
      server.close();
    });

    it('is at most 3 MB', () => assert.ok(fs.statSync(file).size <= 3e6));

    it('is valid HTML', async () => {
      const { results } = await validator.validateFile(file);
      assert.deepEqual(results.flatMap((r) => r.messages.map((m) => `${m.line}: ${m.ruleId}: ${m.message}`)), []);
    });

    for (const [look, options] of [['wide', {}], ['phone', phone], ['dark', dark]]) {
      it(`is clean by axe, ${look}`, async () => {
        assert.deepEqual(await violations(browser, fromDisk(file), options), []);
      });
    }

    it('does not scroll sideways on a phone', async () => {
      const { page, close } = await open(browser, fromDisk(file), phone);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
      await close();
    });

    it('is readable without scripts, and shows no control that needs one', async () => {
      const { page, complaints, close } = await open(browser, fromDisk(file), { javaScriptEnabled: false });
      assert.deepEqual(complaints, []);
      assert.ok((await page.locator('main').textContent()).length > 500);
      assert.ok(await page.locator('main table:visible').count() > 0);
      const dead = page.locator('button:visible, select:visible, canvas:visible, input:visible:not([type=radio])');
      assert.equal(await dead.count(), 0);
      await close();
    });

    it('looks as it did, wide, on a phone, dark and on paper', { skip: ['layered', 'example'].includes(name) }, async () => {
      const small = { deviceScaleFactor: 0.4 };
      for (const [look, options] of [['wide', {}], ['phone', phone], ['dark', dark],
        ['print', { viewport: { width: 720, height: 1000 } }]]) {
        const { page, close } = await open(browser, fromDisk(file), { ...small, ...options });
        if (look === 'print') await page.emulateMedia({ media: 'print' });
        await compareWithBaseline(page, `${name}-${look}`);
        await close();
      }
    });
  });
}
