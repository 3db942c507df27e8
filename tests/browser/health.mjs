// What makes a page sound whatever it shows: valid HTML, and nothing that axe finds.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { HtmlValidate } from 'html-validate';
import { open } from './browser.mjs';

const axe = fs.readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

// Words that say little of a page's health are left to taste: long titles, and characters that HTML
// allows as they are.
export const validator = new HtmlValidate({
  extends: ['html-validate:recommended'],
  rules: { 'long-title': 'off', 'no-raw-characters': ['error', { relaxed: true }], 'void-style': ['error', { style: 'omit' }] },
});

export const violations = async (browser, address, options) => {
  const { page, close } = await open(browser, address, { bypassCSP: true, ...options });
  // Pages of the service have more to fetch.
  await page.waitForLoadState('networkidle');
  await page.evaluate(axe);
  const found = await page.evaluate(async () => (await globalThis.axe.run()).violations
    .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((n) => n.target.join(' ')).join(' | ')}`));
  await close();
  return found;
};
