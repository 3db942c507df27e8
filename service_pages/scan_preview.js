// Four views of points before they are sent, in a frame that is guessed: good enough to see that it
// is the right file. The service looks closer.
import { make } from './dom.js';

const kSides = [['front', 1, 0], ['left', 0, -1], ['back', -1, 0], ['right', 0, 1]];
const [kWidth, kHeight] = [150, 270];
const kAxes = { x: 0, y: 1, z: 2 };

const quantile = (values, share) => values[Math.min(values.length - 1, Math.floor(share * values.length))];

// Low and high of each axis without stray points.
const spanOf = (points) => [0, 1, 2].map((axis) => {
  const values = Float64Array.from({ length: points.length / 3 }, (_, i) => points[3 * i + axis]).sort();
  return { low: quantile(values, 0.002), high: quantile(values, 0.998), middle: quantile(values, 0.5) };
});

const given = (text) => (/^[+-][xyz]$/.test(text ?? '') ? { axis: kAxes[text[1]], sign: text[0] === '-' ? -1 : 1 } : undefined);

// People are tallest along the height, carry more above its middle than below, are wider than deep,
// and their feet point to the front.
const guessFrame = (points, options) => {
  const span = spanOf(points);
  const length = span.map(({ low, high }) => high - low);
  const tallest = length.indexOf(Math.max(...length));
  const heavy = span[tallest].middle >= (span[tallest].low + span[tallest].high) / 2 ? 1 : -1;
  const up = given(options.up) ?? { axis: tallest, sign: heavy };
  const others = [0, 1, 2].filter((axis) => axis !== up.axis);
  const front = given(options.front);
  const depth = front && front.axis !== up.axis ? front.axis : others[length[others[0]] < length[others[1]] ? 0 : 1];
  const floor = up.sign > 0 ? span[up.axis].low : -span[up.axis].high;
  let [feet, count] = [0, 0];
  for (let i = 0; i < points.length; i += 3) {
    if (up.sign * points[i + up.axis] - floor > 0.05 * length[up.axis]) continue;
    feet += points[i + depth];
    count += 1;
  }
  const forward = count > 0 && feet / count < span[depth].middle ? -1 : 1;
  return { up, front: front && front.axis === depth ? front : { axis: depth, sign: forward }, span };
};

// x to the person's left, y up, z to the front, as the person's own axes.
const placed = (points, { up, front, span }) => {
  const side = 3 - up.axis - front.axis;
  const right = (up.axis + 1) % 3 === front.axis ? 1 : -1;  // up x front = left
  const sign = right * up.sign * front.sign;
  const middle = span.map(({ low, high }) => (low + high) / 2);
  const out = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    out[i] = sign * (points[i + side] - middle[side]);
    out[i + 1] = up.sign * (points[i + up.axis] - middle[up.axis]);
    out[i + 2] = front.sign * (points[i + front.axis] - middle[front.axis]);
  }
  return out;
};

const paint = (canvas, points, colours, [, toFront, toSide], scale, deep) => {
  const picture = new ImageData(kWidth, kHeight);
  const nearest = new Float32Array(kWidth * kHeight).fill(-Infinity);
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    const across = toFront * x + toSide * z;
    const near = toFront * z - toSide * x;
    const [column, row] = [Math.round(kWidth / 2 + across * scale), Math.round(kHeight / 2 - y * scale)];
    if (column < 0 || row < 0 || column >= kWidth - 1 || row >= kHeight - 1) continue;
    const light = 0.55 + 0.45 * Math.min(1, Math.max(0, (near / deep + 1) / 2));
    for (const pixel of [row * kWidth + column, row * kWidth + column + 1, (row + 1) * kWidth + column, (row + 1) * kWidth + column + 1]) {
      if (near <= nearest[pixel]) continue;
      nearest[pixel] = near;
      for (let k = 0; k < 3; k += 1) picture.data[4 * pixel + k] = light * (colours ? colours[i + k] : [120, 140, 150][k]);
      picture.data[4 * pixel + 3] = 255;
    }
  }
  canvas.getContext('2d').putImageData(picture, 0, 0);
};

// Draws `read` (ply_points.js) from four sides into `box`.
export const drawPreview = (box, read, options) => {
  const frame = guessFrame(read.points, options);
  const points = placed(read.points, frame);
  const lengths = frame.span.map(({ low, high }) => high - low);
  const scale = Math.min(0.94 * kHeight / lengths[frame.up.axis],
    0.94 * kWidth / Math.max(...lengths.filter((_, axis) => axis !== frame.up.axis)));
  box.replaceChildren(...kSides.map((side) => {
    const canvas = make('canvas', { width: kWidth, height: kHeight });
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', `The scan, perhaps from the ${side[0]}`);
    paint(canvas, points, read.colours, side, scale, lengths[frame.front.axis] / 2);
    return make('figure', {}, canvas, make('figcaption', { textContent: side[0] }));
  }));
};
