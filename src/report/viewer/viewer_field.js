// The stock as heights over a grid, and what a tool cuts from it.

/** A setup's stock: top and bottom of every cell. A rim of empty cells stands around it, for its sides. */
class StockField {
  constructor(stock, step) {
    this.cell = stock.cell;
    this.low = stock.low;
    this.columns = stock.columns + 2;
    this.rows = stock.rows + 2;
    this.arriving = this.padded(unpackHeights(stock.top, stock.columns * stock.rows, step), stock);
    this.bottom = this.padded(unpackHeights(stock.bottom, stock.columns * stock.rows, step), stock);
    this.top = this.arriving.slice();
    // Which operation cut a cell last, from 1 on; 0: none.
    this.cutBy = new Uint16Array(this.top.length);
    this.touchAll();
  }

  padded(inner, stock) {
    const heights = new Float32Array(this.columns * this.rows).fill(stock.low[2]);
    for (let row = 0; row < stock.rows; ++row)
      heights.set(inner.subarray(row * stock.columns, (row + 1) * stock.columns), (row + 1) * this.columns + 1);
    return heights;
  }

  /** Rows that changed since the last look. */
  takeTouched() {
    const touched = { first: this.firstTouched, last: this.lastTouched };
    this.firstTouched = this.rows;
    this.lastTouched = -1;
    return touched;
  }

  touchAll() {
    this.firstTouched = 0;
    this.lastTouched = this.rows - 1;
  }

  snapshot() {
    return { top: this.top.slice(), cutBy: this.cutBy.slice() };
  }

  restore(snapshot) {
    this.top.set(snapshot ? snapshot.top : this.arriving);
    if (snapshot) this.cutBy.set(snapshot.cutBy);
    else this.cutBy.fill(0);
    this.touchAll();
  }

  /** Top at a place; nothing where no material is. */
  heightAt(x, y) {
    const column = Math.floor((x - this.low[0]) / this.cell) + 1;
    const row = Math.floor((y - this.low[1]) / this.cell) + 1;
    if (column < 0 || row < 0 || column >= this.columns || row >= this.rows) return undefined;
    const at = row * this.columns + column;
    return this.top[at] > this.bottom[at] ? this.top[at] : undefined;
  }

  /** Cuts what a tool sweeps on a straight way. */
  cut(from, to, tool, operation) {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    // The cells around a long slanting way are mostly beside it: it is cut in pieces.
    const pieces = Math.max(1, Math.ceil(length / Math.max(4 * tool.radius, 24 * this.cell)));
    let start = from;
    for (let i = 1; i <= pieces; ++i) {
      const share = i / pieces;
      const end = [0, 1, 2].map((axis) => from[axis] + share * (to[axis] - from[axis]));
      this.cutPiece(start, end, tool, operation);
      start = end;
    }
  }

  cutPiece(from, to, tool, operation) {
    const cell = this.cell;
    const radius = tool.radius;
    // Centre of the first cell beyond the rim.
    const x0 = this.low[0] - 0.5 * cell;
    const y0 = this.low[1] - 0.5 * cell;
    const firstColumn = Math.max(1, Math.ceil((Math.min(from[0], to[0]) - radius - x0) / cell));
    const lastColumn = Math.min(this.columns - 2, Math.floor((Math.max(from[0], to[0]) + radius - x0) / cell));
    const firstRow = Math.max(1, Math.ceil((Math.min(from[1], to[1]) - radius - y0) / cell));
    const lastRow = Math.min(this.rows - 2, Math.floor((Math.max(from[1], to[1]) + radius - y0) / cell));
    if (firstRow > lastRow || firstColumn > lastColumn) return;
    const dx = to[0] - from[0];
    const dy = to[1] - from[1];
    const dz = to[2] - from[2];
    const length2 = dx * dx + dy * dy;
    const lowest = Math.min(from[2], to[2]);
    for (let row = firstRow; row <= lastRow; ++row) {
      const py = y0 + row * cell - from[1];
      for (let column = firstColumn; column <= lastColumn; ++column) {
        const at = row * this.columns + column;
        if (this.top[at] <= lowest) continue;
        const px = x0 + column * cell - from[0];
        const height = heightLeft(px, py, dx, dy, dz, length2, from[2], tool);
        if (height < this.top[at]) {
          // What is cut right through has no top above its bottom.
          this.top[at] = Math.max(height, this.bottom[at]);
          this.cutBy[at] = operation;
        }
      }
    }
    this.firstTouched = Math.min(this.firstTouched, firstRow);
    this.lastTouched = Math.max(this.lastTouched, lastRow);
  }
}

/**
 * How high material stays at a place (px, py from the way's start) beside a straight way: infinite where the
 * tool does not come. A flat cutter is taken at the lowest of its places that reach there, others at the
 * nearest one.
 */
function heightLeft(px, py, dx, dy, dz, length2, z, tool) {
  const radius2 = tool.radius * tool.radius;
  if (length2 < 1e-12) {
    const distance2 = px * px + py * py;
    return distance2 > radius2 ? Infinity : z + Math.min(0, dz) + formHeight(tool, distance2);
  }
  const foot = (px * dx + py * dy) / length2;
  const nearest = Math.min(1, Math.max(0, foot));
  const ax = px - nearest * dx;
  const ay = py - nearest * dy;
  const distance2 = ax * ax + ay * ay;
  if (distance2 > radius2) return Infinity;
  if (!tool.flat || dz === 0) return z + nearest * dz + formHeight(tool, distance2);
  const bx = px - foot * dx;
  const by = py - foot * dy;
  const reach = Math.sqrt(Math.max(0, (radius2 - bx * bx - by * by) / length2));
  return z + dz * (dz < 0 ? Math.min(1, foot + reach) : Math.max(0, foot - reach));
}

const kFormSteps = 64;

/** How high the cutter's edge stands over its tip at a distance from its axis. */
function formHeight(tool, distance2) {
  if (tool.flat) return 0;
  const step = Math.sqrt(distance2) / tool.radius * kFormSteps;
  return tool.heights[Math.min(kFormSteps, Math.round(step))];
}

/** A tool of the page's data with what cutting asks of it. */
function cutterOf(tool) {
  const radius = Math.max(0.01, tool.diameter / 2);
  const flat = tool.form.every(([, height]) => height < 1e-6);
  const heights = new Float32Array(kFormSteps + 1);
  for (let i = 0; i <= kFormSteps; ++i) heights[i] = outlineHeight(tool.form, (i / kFormSteps) * radius);
  return { radius, flat, heights };
}

/** Height of an outline of [radius, height] at a radius: 0 on the flat of the tip. */
function outlineHeight(outline, radius) {
  if (radius <= outline[0][0]) return outline[0][1];
  for (let i = 1; i < outline.length; ++i) {
    const [r0, h0] = outline[i - 1];
    const [r1, h1] = outline[i];
    if (radius <= r1) return r1 > r0 ? h0 + ((radius - r0) / (r1 - r0)) * (h1 - h0) : h1;
  }
  return outline[outline.length - 1][1];
}
