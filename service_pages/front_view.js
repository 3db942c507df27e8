// The person from the front, drawn from the points of the report's view (pictures/view.json), so
// that each row of the picture is a height that is known.
const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const kGround = [236, 238, 239];
const kSpot = 2;  // pixels a point of a cloud covers each way

// Where points come to lie: pixels across and down, nearness in metres.
const projected = (data, part, frame) => {
  const steps = new Uint16Array(bytesOf(part.points).buffer);
  const out = new Float32Array(steps.length);
  for (let i = 0; i < steps.length; i += 3) {
    const at = (k) => data.low[k] + steps[i + k] / 65535 * data.size[k];
    out[i] = frame.width / 2 + (at(0) - frame.middle) * frame.scale;
    out[i + 1] = frame.row(at(1));
    out[i + 2] = at(2);
  }
  return out;
};

const rasterise = ({ width, height }, points, triangles, put) => {
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [ax, ay, bx, by, cx, cy] = [points[a], points[a + 1], points[b], points[b + 1], points[c], points[c + 1]];
    const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (area === 0) continue;
    const [left, right] = [Math.max(0, Math.ceil(Math.min(ax, bx, cx))), Math.min(width - 1, Math.floor(Math.max(ax, bx, cx)))];
    const [top, bottom] = [Math.max(0, Math.ceil(Math.min(ay, by, cy))), Math.min(height - 1, Math.floor(Math.max(ay, by, cy)))];
    for (let y = top; y <= bottom; y += 1) {
      for (let x = left; x <= right; x += 1) {
        const u = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area;
        const v = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        put(x, y, points[a + 2] + u * (points[b + 2] - points[a + 2]) + v * (points[c + 2] - points[a + 2]), triangles[t]);
      }
    }
  }
};

const spots = (points, put) => {
  for (let i = 0; i < points.length; i += 3) {
    const [x, y] = [Math.round(points[i]), Math.round(points[i + 1])];
    for (let dy = 1 - kSpot; dy < kSpot; dy += 1) {
      for (let dx = 1 - kSpot; dx < kSpot; dx += 1) put(x + dx, y + dy, points[i + 2], i / 3);
    }
  }
};

// Draws the view; returns what turns heights above the floor (m) into rows (pixels) and back.
export const drawFront = (canvas, data) => {
  const { width, height } = canvas;
  const scale = 0.94 * Math.min(width / data.size[0], height / data.size[1]);
  const middleY = data.low[1] + data.size[1] / 2;
  const frame = {
    width, height, scale, middle: data.low[0] + data.size[0] / 2,
    row: (y) => height / 2 - (y - middleY) * scale,
    metres: (row) => middleY - (row - height / 2) / scale,
  };
  const points = projected(data, data.scan, frame);
  const normals = new Int8Array(bytesOf(data.scan.normals).buffer);
  const labels = bytesOf(data.scan.labels);
  const picture = new ImageData(width, height);
  const nearest = new Float32Array(width * height).fill(-Infinity);
  for (let i = 0; i < width * height; i += 1) picture.data.set([...kGround, 255], 4 * i);
  const put = (x, y, near, source) => {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    const at = y * width + x;
    if (near <= nearest[at]) return;
    nearest[at] = near;
    const light = 0.4 + 0.6 * Math.abs(0.3 * normals[3 * source] + 0.3 * normals[3 * source + 1] + 0.9 * normals[3 * source + 2]) / 127;
    const colour = data.palette[labels[source]];
    for (let k = 0; k < 3; k += 1) picture.data[4 * at + k] = light * colour[k];
  };
  const triangles = new Uint16Array(bytesOf(data.scan.triangles).buffer);
  if (triangles.length > 0) rasterise(canvas, points, triangles, put);
  else spots(points, put);
  canvas.getContext('2d').putImageData(picture, 0, 0);
  return frame;
};
