// That the comparison of pictures sees what it should, and only that.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { it } from 'node:test';
import { PNG } from 'pngjs';
import { difference, kTolerance } from './browser.mjs';

const kept = (name) => PNG.sync.read(fs.readFileSync(path.join(process.env.BASELINES, `${name}.png`)));

// `to` where `inside` is true, else the picture's own pixels.
const painted = (picture, to, inside) => {
  const out = new PNG(picture);
  picture.data.copy(out.data);
  for (let i = 0; i < picture.width * picture.height; i += 1) {
    if (inside(i % picture.width, Math.floor(i / picture.width))) out.data.fill(to, 4 * i, 4 * i + 3);
  }
  return out;
};

it('tells another look, another page and another size apart', () => {
  assert.ok(difference(kept('report-wide'), kept('report-dark')) > kTolerance);
  assert.ok(difference(kept('report-wide'), kept('review-wide')) > kTolerance);
  assert.equal(difference(kept('report-wide'), kept('report-phone')), 1);
});

it('counts the blocks that changed', () => {
  const plain = painted(new PNG({ width: 80, height: 40 }), 200, () => true);
  assert.equal(difference(plain, plain), 0);
  assert.equal(difference(plain, painted(plain, 90, (x, y) => x < 8 && y < 16)), 2 / 50);
  // A thin line is less than a block's mean tells.
  assert.equal(difference(plain, painted(plain, 90, (x) => x === 3)), 0);
});
