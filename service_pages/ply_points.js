// Points of a binary PLY file, read in the browser for a quick look: at most kMost of them, spread
// over the file. Nothing for what it does not read (text, lists before the points, other formats).
const kMost = 60000;
const kHeader = 65536;  // bytes
const kPieces = 48;     // places of the file that are read
const kTypes = {
  char: ['Int8', 1], int8: ['Int8', 1], uchar: ['Uint8', 1], uint8: ['Uint8', 1], short: ['Int16', 2], int16: ['Int16', 2],
  ushort: ['Uint16', 2], uint16: ['Uint16', 2], int: ['Int32', 4], int32: ['Int32', 4], uint: ['Uint32', 4],
  uint32: ['Uint32', 4], float: ['Float32', 4], float32: ['Float32', 4], double: ['Float64', 8], float64: ['Float64', 8],
};

const readHeader = async (file) => {
  const text = new TextDecoder('latin1').decode(await file.slice(0, kHeader).arrayBuffer());
  const end = /(?:^|\n)end_header\r?\n/.exec(text);
  if (!/^ply\r?\n/.test(text) || !end) return undefined;
  const lines = text.slice(0, end.index).split(/\r?\n/).map((line) => line.trim().split(/\s+/));
  const format = lines.find(([word]) => word === 'format')?.[1];
  const first = lines.findIndex(([word]) => word === 'element');
  if (!/^binary_(little|big)_endian$/.test(format) || lines[first]?.[1] !== 'vertex') return undefined;
  const rest = lines.slice(first + 1);
  const after = rest.findIndex(([word]) => word === 'element');
  const properties = {};
  let stride = 0;
  for (const [word, type, name] of after < 0 ? rest : rest.slice(0, after)) {
    if (word !== 'property') continue;
    if (!kTypes[type]) return undefined;
    properties[name] = { read: `get${kTypes[type][0]}`, at: stride };
    stride += kTypes[type][1];
  }
  const count = Number(lines[first][2]);
  if (!['x', 'y', 'z'].every((name) => properties[name]) || !(count > 0)) return undefined;
  return { little: format.includes('little'), count, stride, properties, begin: end.index + end[0].length };
};

// {count, points: x y z ..., colours: r g b ... or undefined}; undefined when it cannot be read here.
export const readPoints = async (file) => {
  const head = await readHeader(file);
  if (!head || file.size < head.begin + head.count * head.stride) return undefined;
  const { properties, stride, little, count } = head;
  const names = ['red', 'green', 'blue'].every((name) => properties[name]?.read === 'getUint8') ? ['red', 'green', 'blue'] : [];
  const each = Math.min(Math.ceil(count / kPieces), Math.ceil(kMost / kPieces));
  const [points, colours] = [[], []];
  for (let piece = 0; piece < kPieces; piece += 1) {
    const from = Math.floor(piece * count / kPieces);
    const to = Math.floor((piece + 1) * count / kPieces);
    // Small files whole; of large ones the beginning of each piece, which is spread well enough.
    const stop = count > 4e6 ? Math.min(to, from + each) : to;
    const step = Math.max(1, Math.ceil((stop - from) / each));
    const place = head.begin + from * stride;
    const view = new DataView(await file.slice(place, head.begin + stop * stride).arrayBuffer());
    for (let at = 0; at + stride <= view.byteLength; at += step * stride) {
      const number = (name) => view[properties[name].read](at + properties[name].at, little);
      const point = ['x', 'y', 'z'].map(number);
      if (!point.every(Number.isFinite)) continue;
      points.push(...point);
      colours.push(...names.map(number));
    }
  }
  return points.length > 0 ? { count, points, colours: names.length > 0 ? colours : undefined } : undefined;
};
