// The moves of an operation as a chain of short straight ways with their times.

// Kinds of moves, as toolpath.h numbers them.
const kRapid = 0;
const kFeed = 1;
const kSlot = 2;
const kRamp = 3;
const kPlunge = 4;
const kMoveWords = ["rapid", "feed", "slot", "ramp", "plunge"];

// Bits of a packed move's first byte.
const kKindBits = 0x07;
const kArcBit = 0x08;
const kCcwBit = 0x10;
const kInAirBit = 0x20;
const kHeightBit = 0x40;
const kFeedBit = 0x80;

/** Points that come one by one, in arrays that grow. */
class GrowingPath {
  constructor(start) {
    this.count = 1;
    this.places = new Float32Array(3 * 1024);
    this.kinds = new Uint8Array(1024);
    this.times = new Float64Array(1024);
    this.feeds = new Float32Array(1024);
    this.loads = new Uint8Array(1024);
    this.load = 0;
    this.places.set(start);
  }

  add(x, y, z, kind, time, feed) {
    if (this.count === this.kinds.length) this.grow();
    this.places[3 * this.count] = x;
    this.places[3 * this.count + 1] = y;
    this.places[3 * this.count + 2] = z;
    this.kinds[this.count] = kind;
    this.times[this.count] = time;
    this.feeds[this.count] = feed;
    this.loads[this.count] = this.load;
    ++this.count;
  }

  grow() {
    for (const name of ["places", "kinds", "times", "feeds", "loads"]) {
      const longer = new this[name].constructor(2 * this[name].length);
      longer.set(this[name]);
      this[name] = longer;
    }
  }
}

/** Angle an arc turns by; a whole turn where it ends where it starts. */
function turnOf(arc, ccw) {
  const full = 2 * Math.PI;
  let turn = arc.to - arc.from;
  if (ccw) while (turn <= 1e-9) turn += full;
  else while (turn >= -1e-9) turn -= full;
  return turn;
}

/** Adds an arc from the last point to `to` as chords that stay within `chord` of it. */
function addArc(path, to, centre, head, feed, chord) {
  const last = 3 * (path.count - 1);
  const from = [path.places[last], path.places[last + 1], path.places[last + 2]];
  const startRadius = Math.hypot(from[0] - centre[0], from[1] - centre[1]);
  const endRadius = Math.hypot(to[0] - centre[0], to[1] - centre[1]);
  const arc = {
    from: Math.atan2(from[1] - centre[1], from[0] - centre[0]),
    to: Math.atan2(to[1] - centre[1], to[0] - centre[0]),
  };
  const turn = turnOf(arc, (head & kCcwBit) !== 0);
  const most = 2 * Math.acos(Math.max(0, 1 - chord / Math.max(chord, startRadius)));
  const pieces = Math.max(1, Math.ceil(Math.abs(turn) / Math.max(0.05, most)));
  const length = Math.hypot(turn * startRadius, to[2] - from[2]);
  const began = path.times[path.count - 1];
  const speed = feed / 60;
  for (let i = 1; i <= pieces; ++i) {
    const share = i / pieces;
    const radius = startRadius + share * (endRadius - startRadius);
    const angle = arc.from + share * turn;
    path.add(centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle),
      from[2] + share * (to[2] - from[2]), kindOf(head), began + (share * length) / speed, feed);
  }
}

/** A move's kind, with its bit of moving in air. */
function kindOf(head) {
  return head & (kKindBits | kInAirBit);
}

function addLine(path, to, head, feed) {
  const last = 3 * (path.count - 1);
  const length = Math.hypot(to[0] - path.places[last], to[1] - path.places[last + 1], to[2] - path.places[last + 2]);
  path.add(to[0], to[1], to[2], kindOf(head), path.times[path.count - 1] + (60 * length) / feed, feed);
}

/** The classes of moves' loads, told as runs of equal ones; 0 where none are told. */
class LoadReader {
  constructor(text) {
    this.reader = new NumberReader(text);
    this.left = 0;
    this.load = 0;
  }

  next() {
    if (this.left === 0 && this.reader.at < this.reader.bytes.length) {
      this.left = this.reader.number();
      this.load = this.reader.number();
    }
    if (this.left > 0) --this.left;
    return this.load;
  }
}

/**
 * The operation's path: places (x, y, z each), kinds, feeds and classes of load (of the way to each place) and times in
 * seconds from the operation's start. All have `count` entries.
 */
function unpackPath(operation, step, chord) {
  const reader = new NumberReader(operation.path);
  const at = [reader.number(), reader.number(), reader.number()];
  const path = new GrowingPath(at.map((steps) => steps * step));
  const loads = new LoadReader(operation.loads);
  let own = 0;
  for (let left = operation.moves; left > 0; --left) {
    const head = reader.byte();
    path.load = loads.next();
    if (head & kFeedBit) own = reader.number();
    const before = [at[0], at[1]];
    at[0] += reader.number();
    at[1] += reader.number();
    if (head & kHeightBit) at[2] += reader.number();
    const to = at.map((steps) => steps * step);
    const kind = head & kKindBits;
    // A feed that is not told would stand still for ever.
    const feed = Math.max(1, kind !== kRapid && own > 0 ? own : operation.feeds[kind]);
    if (head & kArcBit) {
      const centre = [(before[0] + reader.number()) * step, (before[1] + reader.number()) * step];
      addArc(path, to, centre, head, feed, chord);
    } else {
      addLine(path, to, head, feed);
    }
  }
  return path;
}

/** The last place that is reached by a time. */
function placeAt(path, time) {
  let low = 0;
  let high = path.count - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (path.times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}
