// What the page brings along, unpacked: viewer_data.cpp and packed_path.cpp wrote it.

/** The bytes of a base64 text. */
function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Reads whole numbers of seven bits a byte, the sign in the lowest bit. */
class NumberReader {
  constructor(text) {
    this.bytes = bytesOf(text);
    this.at = 0;
  }

  byte() {
    return this.bytes[this.at++];
  }

  number() {
    let value = 0;
    let scale = 1;
    for (;;) {
      const byte = this.byte();
      // Shifts would stop at 32 bits.
      value += (byte & 0x7f) * scale;
      if (byte < 0x80) break;
      scale *= 0x80;
    }
    const half = Math.floor(value / 2);
    return value % 2 === 1 ? -half - 1 : half;
  }
}

/** Loops of [x, y] in mm. */
function unpackLoops(text, step) {
  const reader = new NumberReader(text);
  const loops = [];
  for (let left = reader.number(); left > 0; --left) {
    const loop = [];
    let x = 0;
    let y = 0;
    for (let corners = reader.number(); corners > 0; --corners) {
      x += reader.number();
      y += reader.number();
      loop.push([x * step, y * step]);
    }
    loops.push(loop);
  }
  return loops;
}

/** Heights in mm, told as runs of equal ones. */
function unpackHeights(text, count, step) {
  const reader = new NumberReader(text);
  const heights = new Float32Array(count);
  let height = 0;
  for (let i = 0; i < count;) {
    const end = i + reader.number();
    height += reader.number();
    heights.fill(height * step, i, end);
    i = end;
  }
  return heights;
}

/** Corners and triangles of the part, in part coordinates. */
function unpackPart(part) {
  const shares = new Uint16Array(bytesOf(part.places).buffer);
  const corners = new Float32Array(shares.length);
  for (let i = 0; i < shares.length; ++i) {
    const axis = i % 3;
    corners[i] = part.low[axis] + (shares[i] / 65535) * (part.high[axis] - part.low[axis]);
  }
  const reader = new NumberReader(part.sides);
  const sides = new Uint32Array(part.triangles * 3);
  let corner = 0;
  for (let i = 0; i < sides.length; ++i) {
    corner += reader.number();
    sides[i] = corner;
  }
  return { corners, sides };
}
