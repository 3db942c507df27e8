// The view one can turn. Where there is no WebGL it stays hidden; the pictures show the same.
{
  const section = document.getElementById('view');
  const canvas = document.getElementById('view-canvas');
  const painter = section && makePainter(canvas);

  const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));

  const start = (data) => {
    const placed = (text) => {
      const steps = new Uint16Array(bytesOf(text).buffer);
      return Float32Array.from(steps, (step, i) => data.low[i % 3] + step / 65535 * data.size[i % 3]);
    };
    const meshOf = (part) => painter.mesh(placed(part.points), new Int8Array(bytesOf(part.normals).buffer),
      new Uint16Array(bytesOf(part.triangles).buffer));

    const labels = bytesOf(data.scan.labels);
    const values = bytesOf(data.scan.values);
    const scale = bytesOf(data.scale);
    const grey = data.palette[0];
    const colourOf = {
      labels: (i) => data.palette[labels[i]],
      values: (i) => (values[i] === 255 ? grey : scale.subarray(3 * values[i], 3 * values[i] + 3)),
      clay: () => grey,
    };
    const filled = (count, colour) => {
      const out = new Uint8Array(3 * count);
      for (let i = 0; i < count; ++i) out.set(colour(i), 3 * i);
      return out;
    };

    const scan = meshOf(data.scan);
    const garments = data.garments.map((part) => {
      const mesh = meshOf(part);
      const colour = data.palette[part.label].map((c) => Math.round(c * 0.8));
      painter.paint(mesh, filled(bytesOf(part.points).length / 6, () => colour));
      return { mesh, box: section.querySelector(`.view-garment[value="${part.label}"]`) };
    });
    const colours = document.getElementById('view-colours');
    const scanBox = document.getElementById('view-scan');
    if (!values.length) colours.querySelector('[value="values"]').remove();

    const middle = data.low.map((low, k) => low + data.size[k] / 2);
    const home = { turn: 0, tilt: 0, scale: 1.9 / data.size[1] };
    let camera = { ...home };
    let asked = false;

    const draw = () => {
      asked = false;
      const [a, b] = [camera.turn, camera.tilt].map((degrees) => degrees * Math.PI / 180);
      const [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
      // By column: first about the upright axis, then about the level one across.
      const turn = [ca, sb * sa, -cb * sa, 0, cb, sb, sa, -sb * ca, cb * ca];
      const shown = garments.filter(({ box }) => box.checked).map(({ mesh }) => mesh);
      painter.draw(scanBox.checked ? [scan, ...shown] : shown, { turn, middle, scale: camera.scale });
    };
    const redraw = () => {
      if (!asked) requestAnimationFrame(draw);
      asked = true;
    };
    const go = (change) => {
      camera = { ...camera, ...change };
      camera.tilt = Math.max(-90, Math.min(90, camera.tilt));
      camera.scale = Math.max(home.scale / 3, Math.min(home.scale * 12, camera.scale));
      redraw();
    };
    const fit = () => {
      const sharp = Math.min(2, window.devicePixelRatio || 1);
      canvas.width = Math.round(canvas.clientWidth * sharp);
      canvas.height = Math.round(canvas.clientHeight * sharp);
      redraw();
    };
    const recolour = () => {
      painter.paint(scan, filled(labels.length, colourOf[colours.value]));
      redraw();
    };

    const keys = {
      ArrowLeft: () => go({ turn: camera.turn - 15 }),
      ArrowRight: () => go({ turn: camera.turn + 15 }),
      ArrowUp: () => go({ tilt: camera.tilt + 15 }),
      ArrowDown: () => go({ tilt: camera.tilt - 15 }),
      '+': () => go({ scale: camera.scale * 1.25 }),
      '=': () => go({ scale: camera.scale * 1.25 }),
      '-': () => go({ scale: camera.scale / 1.25 }),
      0: () => go(home),
    };
    canvas.addEventListener('keydown', (event) => {
      if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      keys[event.key]();
    });
    canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons !== 1) return;
      go({ turn: camera.turn + event.movementX / 2, tilt: camera.tilt + event.movementY / 2 });
    });
    section.addEventListener('click', (event) => {
      const to = event.target.dataset.turn;
      if (to !== undefined) go({ turn: -Number(to), tilt: 0 });
    });
    section.addEventListener('change', recolour);
    canvas.addEventListener('webglcontextlost', () => { section.hidden = true; });
    section.hidden = false;
    new ResizeObserver(fit).observe(canvas);
    recolour();
  };

  if (painter) start(JSON.parse(document.getElementById('view-data').textContent));
}
