// The run of one setup: its operations one after another, and the stock at any time of it.

// So many states of the stock are kept, to go back to.
const kMostSnapshots = 24;
// Chords of arcs as a share of the stock's longer side, and at most [mm].
const kChordShare = 2e-5;
const kMostChord = 0.02;
// Times nearer to each other are one [s].
const kSameTime = 1e-6;
// The clock is asked after so many ways.
const kWaysBetweenLooks = 32;

class SetupRun {
  constructor(setup, tools, step) {
    this.setup = setup;
    this.tools = tools;
    this.step = step;
    const size = Math.max(setup.stock.high[0] - setup.stock.low[0], setup.stock.high[1] - setup.stock.low[1]);
    this.chord = Math.max(0.002, Math.min(kMostChord, kChordShare * size));
    this.field = new StockField(setup.stock, step);
    this.paths = setup.operations.map((operation) => unpackPath(operation, step, this.chord));
    this.starts = [];
    this.length = 0;
    for (const path of this.paths) {
      this.starts.push(this.length);
      this.length += path.times[path.count - 1];
    }
    this.snapshots = new Map();
    this.snapshotEvery = Math.max(1, Math.ceil(this.paths.length / kMostSnapshots));
    this.reset(0);
  }

  /** The class of load that an operation's feeds have for the longest time. */
  usualLoad(operation) {
    const path = this.paths[operation];
    const seconds = new Map();
    for (let i = 1; i < path.count; ++i) {
      if ((path.kinds[i] & kKindBits) === kRapid) continue;
      seconds.set(path.loads[i], (seconds.get(path.loads[i]) || 0) + path.times[i] - path.times[i - 1]);
    }
    let usual = 0;
    for (const [load, time] of seconds) if (time > (seconds.get(usual) || 0)) usual = load;
    return usual;
  }

  /** Begins before an operation, with the stock as the ones before left it. \pre its snapshot, or 0 */
  reset(operation) {
    this.field.restore(this.snapshots.get(operation));
    this.operation = operation;
    this.place = 0;
    this.share = 0;
    this.ended = this.paths.length === 0;
  }

  /** The time that is reached. */
  get time() {
    if (this.ended) return this.length;
    const path = this.paths[this.operation];
    const from = path.times[this.place];
    const to = path.times[Math.min(this.place + 1, path.count - 1)];
    return this.starts[this.operation] + from + this.share * (to - from);
  }

  operationAt(time) {
    let found = 0;
    for (let i = 0; i < this.starts.length; ++i) if (this.starts[i] <= time) found = i;
    return found;
  }

  /** Goes back to the nearest kept state before a time. */
  rewindFor(time) {
    const wanted = this.operationAt(time);
    let nearest = 0;
    for (const operation of this.snapshots.keys())
      if (operation <= wanted && operation > nearest) nearest = operation;
    this.reset(nearest);
  }

  /**
   * Cuts on to a time, or as far as the milliseconds allow; a time that is past asks for a state before it.
   * Returns whether the time is reached.
   */
  goTo(time, milliseconds) {
    if (time < this.time - kSameTime) this.rewindFor(time);
    else this.skipTo(time);
    const stop = performance.now() + milliseconds;
    for (let ways = 1; !this.ended; ++ways) {
      if (this.oneStep(time)) return true;
      if (ways % kWaysBetweenLooks === 0 && performance.now() > stop) return false;
    }
    return true;
  }

  /** Takes a kept state that is nearer to a time to come. */
  skipTo(time) {
    const wanted = this.operationAt(time);
    let nearest = this.operation;
    for (const operation of this.snapshots.keys())
      if (operation <= wanted && operation > nearest) nearest = operation;
    if (nearest > this.operation) this.reset(nearest);
  }

  /** Cuts one way, or goes to the next operation; true where the time is reached. */
  oneStep(time) {
    const path = this.paths[this.operation];
    if (this.place + 1 >= path.count) return this.nextOperation(time);
    const from = path.times[this.place];
    const to = path.times[this.place + 1];
    const wanted = time - this.starts[this.operation];
    const share = wanted >= to - kSameTime ? 1 : Math.max(this.share, (wanted - from) / (to - from));
    this.cutPart(path, this.share, share);
    this.share = share;
    if (share < 1) return true;
    ++this.place;
    this.share = 0;
    return false;
  }

  cutPart(path, from, to) {
    const kind = path.kinds[this.place + 1];
    if ((kind & kKindBits) === kRapid || kind & kInAirBit) return;
    const tool = this.tools.get(this.setup.operations[this.operation].tool);
    if (tool) this.field.cut(wayPoint(path, this.place, from), wayPoint(path, this.place, to), tool.cutter, this.operation + 1);
  }

  /** True where the next one begins later. */
  nextOperation(time) {
    const next = this.operation + 1;
    if (next === this.paths.length) {
      this.ended = time >= this.length - kSameTime;
      return true;
    }
    if (this.starts[next] > time + kSameTime) return true;
    this.operation = next;
    this.place = 0;
    this.share = 0;
    if (next % this.snapshotEvery === 0 && !this.snapshots.has(next)) this.snapshots.set(next, this.field.snapshot());
    return false;
  }

  /** Where the tool's tip is, and how it moves. */
  tip() {
    const path = this.paths[this.operation];
    if (!path) return undefined;
    const place = this.ended ? path.count - 1 : this.place;
    return { at: wayPoint(path, place, this.ended ? 0 : this.share), kind: path.kinds[Math.min(place + 1, path.count - 1)] & kKindBits };
  }
}

/** The point at a share of the way from a place to the next. */
function wayPoint(path, place, share) {
  const from = 3 * place;
  const to = 3 * Math.min(place + 1, path.count - 1);
  return [0, 1, 2].map((axis) => path.places[from + axis] + share * (path.places[to + axis] - path.places[from + axis]));
}
