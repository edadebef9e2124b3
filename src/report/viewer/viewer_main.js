// The viewer itself: what is chosen, what time it is, and what follows from a click or a key.

// Milliseconds of each picture that cutting may take while it plays, and while it only seeks a time; where drawing
// a picture takes longer than that, as long again.
const kCutMilliseconds = 20;
const kSeekMilliseconds = 120;
const kSpeeds = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];
// A setup plays in about so many seconds where nobody asks for another speed.
const kUsualPlaySeconds = 60;
// A press of an arrow key goes so far.
const kKeyShare = 1 / 200;
// A pointer that moves farther between press and release turns the picture [pixels].
const kClickPixels = 4;
// What is cut is paler than the paths over it.
const kPaler = 0.45;
const kViews = { 1: [-1, -1.2, 1.1], 2: [0, -0.001, 1], 3: [0, -1, 0], 4: [1, 0, 0] };

/** What paths and stock are coloured by: name, words, tint. Engagement and power where the page's data has them. */
const kColourings = [
  ["tool", "tool", (viewer, operation) => viewer.tools.get(operation.tool).tint],
  ["move", "kind of move", (viewer, operation, kind) => kKindTints[kind]],
  ["feed", "feed", (viewer, operation, kind, feed) => scaleTint(feed / viewer.fastest)],
  ["operation", "operation", (viewer, operation) => operation.tint],
];
const kLoadColourings = [
  ["engagement", "engagement: blue air, yellow a slot", (viewer, operation, kind, feed, load) => scaleTint(viewer.widthOf(load))],
  ["power", "power: yellow is all of the spindle's", (viewer, operation, kind, feed, load) => scaleTint(viewer.powerOf(load))],
];

/** From blue, nothing, over green to yellow, all. */
function scaleTint(share) {
  const part = Math.min(1, Math.max(0, share));
  return [Math.round(40 + 215 * part * part), Math.round(70 + 150 * part), Math.round(190 - 150 * part)];
}

class Viewer {
  constructor(frame, data) {
    this.frame = frame;
    this.units = new Units(data.inch);
    this.data = data;
    this.tools = new Map(data.tools.map((tool, i) =>
      [tool.id, { ...tool, cutter: cutterOf(tool), tint: kToolTints[i % kToolTints.length] }]));
    this.shown = { stock: true, part: false, fixtures: true, tool: true, path: true, allPaths: false };
    const hasLoads = data.setups.some((setup) => setup.operations.some((operation) => operation.loads !== ""));
    this.colourings = hasLoads ? [...kColourings, ...kLoadColourings] : kColourings;
    this.colouring = this.colourings[0];
    this.look = window.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
    this.chosen = [];
    this.playing = false;
    this.build();
    this.stage = new Stage(this.stageHolder, () => this.ask());
    this.partShape = partGeometry(data.part);
    this.listen();
    this.showSetup(0);
    this.setLook(this.look);
    frame.dataset.ready = "yes";
  }

  // What stands around the picture ------------------------------------------------------------------------

  build() {
    this.stageHolder = element("div", "viewer-stage");
    this.words = element("div", "viewer-words");
    this.words.setAttribute("aria-live", "polite");
    this.operations = new PickList("Operations", (id) => this.chooseOperation(id, true));
    this.features = new PickList("Features", (id) => this.chooseFeatures([id]));
    this.setupChoice = choice("Setup", this.data.setups.map((setup, i) => [i, setup.id]), (i) => this.showSetup(Number(i)));
    this.colourChoice = choice("Colour by", this.colourings.map(([value, words]) => [value, words]), (value) => this.colourBy(value));
    this.checks = {};
    const checks = [["stock", "stock"], ["part", "part"], ["fixtures", "fixtures"], ["tool", "tool"], ["path", "path"],
      ["allPaths", "paths of all operations"]].map(([key, words]) => this.checkFor(key, words));
    this.section = slider("Section along Z", (value) => this.setSection(value));
    this.sectionWords = element("span", "viewer-figure");
    const views = [["Corner", 1], ["Top", 2], ["Front", 3], ["Right", 4]].map(([name, key]) =>
      button(name, "Look from: " + name.toLowerCase(), () => this.lookFrom(key)));
    this.lookButton = button("Dark", "Light or dark", () => this.setLook(this.look === "dark" ? "light" : "dark"));
    const legend = element("span", "viewer-legend", element("span", "viewer-rapid", "— rapids"), " ",
      element("span", "viewer-entry", "● entries"));
    this.frame.append(
      element("div", "viewer-bar", this.setupChoice.label, this.colourChoice.label, ...views, this.lookButton, legend),
      element("div", "viewer-bar", ...checks, element("label", "viewer-section", "Section ", this.section), this.sectionWords),
      element("div", "viewer-body", this.stageHolder,
        element("div", "viewer-side", this.features.element, this.operations.element, this.words)),
      this.buildPlayer(), keyList());
    this.frame.tabIndex = 0;
    this.frame.setAttribute("role", "group");
    this.frame.setAttribute("aria-label", "Viewer: part, stock, tools and paths. Space plays.");
  }

  checkFor(key, words) {
    const made = check(words, this.shown[key], (on) => this.show(key, on));
    this.checks[key] = made.input;
    return made.label;
  }

  buildPlayer() {
    this.playButton = button("Play", "Play or pause", () => this.play(!this.playing));
    this.clock = slider("Time", (value) => this.seek((value / 1000) * this.run.length));
    this.clockFigures = element("span", "viewer-figure");
    this.speedChoice = choice("Speed", kSpeeds.map((speed) => [speed, speed + " ×"]), (value) => this.setSpeed(Number(value)));
    return element("div", "viewer-bar viewer-player", this.playButton,
      button("|◀", "Operation before", () => this.stepOperation(-1)),
      button("▶|", "Next operation", () => this.stepOperation(1)), this.clock, this.clockFigures, this.speedChoice.label);
  }

  // Setups, looks, what is shown --------------------------------------------------------------------------

  showSetup(index) {
    if (this.scene) this.scene.dispose();
    const setup = this.data.setups[index];
    setup.operations.forEach((operation, i) => { operation.tint = kToolTints[i % kToolTints.length]; });
    this.fastest = Math.max(1, ...setup.operations.map((operation) => operation.fastest));
    this.run = new SetupRun(setup, this.tools, this.data.step);
    this.scene = new SetupScene(this.stage, this.run, this.partShape, kLooks[this.look]);
    this.goal = 0;
    this.playing = false;
    this.chosen = [];
    this.setupChoice.select.value = index;
    this.features.fill(setup.features.map((feature) => [feature.id, feature.id + " " + feature.class]));
    this.operations.fill(setup.operations.map((operation) =>
      [operation.id, shortName(operation.id) + " " + operation.tool + " " + shortName(operation.feature) + " " + operation.role]));
    const usual = kSpeeds.findIndex((speed) => this.run.length / speed <= kUsualPlaySeconds);
    this.setSpeed(kSpeeds[usual === -1 ? kSpeeds.length - 1 : usual]);
    for (const key of Object.keys(this.shown)) this.show(key, this.shown[key]);
    this.setSection(1000);
    this.section.value = 1000;
    this.recolour();
    this.lookFrom(1);
    this.shownOperation = undefined;
    this.tellSetup();
    this.ask();
  }

  setLook(look) {
    this.look = look;
    this.frame.classList.toggle("dark", look === "dark");
    this.lookButton.textContent = look === "dark" ? "Light" : "Dark";
    this.frame.dataset.look = look;
    this.scene.setLook(kLooks[look]);
    this.recolour();
    this.scene.showFeatures(this.chosenFeatures());
    this.ask();
  }

  show(key, on) {
    this.shown[key] = on;
    this.checks[key].checked = on;
    const parts = { stock: this.scene.stock.group, part: this.scene.part, fixtures: this.scene.fixtures, tool: this.scene.tool,
      path: this.scene.paths };
    if (parts[key]) parts[key].visible = on;
    if (key === "allPaths") this.showPaths();
    this.ask();
  }

  colourBy(value) {
    this.colouring = this.colourings.find(([name]) => name === value);
    this.colourChoice.select.value = value;
    this.recolour();
  }

  recolour() {
    const [, , tintOf] = this.colouring;
    const { raw } = kLooks[this.look];
    const paler = (tint) => tint.map((value, i) => Math.round(value + kPaler * (raw[i] - value)));
    const byLoad = kLoadColourings.includes(this.colouring);
    const tints = this.run.setup.operations.map((operation, i) =>
      paler(tintOf(this, operation, kFeed, operation.feeds[kFeed], byLoad ? this.run.usualLoad(i) : 0)));
    this.scene.stock.setPalette([raw, ...tints]);
    this.showPaths();
    this.ask();
  }

  showPaths() {
    const all = this.run.setup.operations.map((operation, i) => i);
    const one = all.length > 0 ? [this.run.operation] : [];
    const [, , tintOf] = this.colouring;
    this.scene.showPaths(this.shown.allPaths ? all : one,
      (operation, kind, feed, load) => (kind === kRapid ? kRapidTint : tintOf(this, operation, kind, feed, load)));
  }

  /** The shares of the diameter and of the spindle's power that a class of load goes up to. */
  widthOf(load) {
    return Math.floor(load / (this.data.power_classes + 1)) / this.data.width_classes;
  }

  powerOf(load) {
    return (load % (this.data.power_classes + 1)) / this.data.power_classes;
  }

  /** \param value  0: the lowest, 1000: nothing is cut away */
  setSection(value) {
    const { low, high } = this.run.setup.stock;
    const part = this.partTop();
    const top = Math.max(high[2], part);
    const height = low[2] + (value / 1000) * (top - low[2]);
    this.scene.setSection(value >= 1000 ? 1e9 : height);
    this.sectionWords.textContent = value >= 1000 ? "whole" : "Z " + this.units.length(height);
    this.ask();
  }

  partTop() {
    return this.run.setup.stock.high[2];
  }

  lookFrom(key) {
    this.stage.lookFrom(this.run.setup.stock, kViews[key]);
  }

  // Time --------------------------------------------------------------------------------------------------

  play(on) {
    if (on && this.run.ended) this.goal = 0;
    this.playing = on && this.run.length > 0;
    this.lastFrame = undefined;
    this.ask();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.speedChoice.select.value = speed;
  }

  stepSpeed(by) {
    const at = kSpeeds.indexOf(this.speed) + by;
    if (kSpeeds[at]) this.setSpeed(kSpeeds[at]);
  }

  seek(time) {
    this.goal = Math.min(this.run.length, Math.max(0, time));
    this.ask();
  }

  stepOperation(by) {
    const at = this.run.operation;
    // Back goes to the start of an operation first.
    const inside = this.goal > this.run.starts[at] + 1;
    const wanted = by < 0 && inside ? at : at + by;
    if (wanted >= this.run.starts.length) this.seek(this.run.length);
    else if (this.run.starts.length > 0) this.seek(this.run.starts[Math.max(0, wanted)]);
  }

  /** Asks for a picture. */
  ask() {
    if (this.asked || !this.scene) return;
    this.asked = true;
    requestAnimationFrame((now) => {
      this.asked = false;
      this.frameAt(now);
    });
  }

  frameAt(now) {
    if (this.playing) {
      const passed = this.lastFrame === undefined ? 0 : Math.min(0.1, (now - this.lastFrame) / 1000);
      this.goal = Math.min(this.run.length, this.goal + passed * this.speed);
      this.lastFrame = now;
    }
    const least = this.playing ? kCutMilliseconds : kSeekMilliseconds;
    const isThere = this.run.goTo(this.goal, Math.max(least, this.drawMilliseconds || 0));
    // Where cutting is slower than the clock, the clock waits.
    if (this.playing && !isThere) this.goal = Math.max(this.run.time, this.goal - 0.1 * this.speed);
    if (this.playing && isThere && this.goal >= this.run.length) this.playing = false;
    const began = performance.now();
    this.follow();
    this.scene.stock.update();
    this.scene.stock.underside.visible = this.stage.camera.position.z < this.run.setup.stock.high[2];
    this.scene.showProgress((id) => this.tools.get(id));
    this.stage.draw();
    this.drawMilliseconds = performance.now() - began;
    this.tellTime(isThere);
    if (this.playing || !isThere) this.ask();
  }

  /** A new operation has another path and other words. */
  follow() {
    const operation = this.run.setup.operations[this.run.operation];
    if (!operation || operation.id === this.shownOperation) return;
    this.shownOperation = operation.id;
    this.operations.mark([operation.id], true);
    if (!this.shown.allPaths) this.showPaths();
    if (this.chosen.length === 0) this.tellOperation(operation);
  }

  tellTime(isThere) {
    const time = this.run.time;
    this.clock.value = this.run.length > 0 ? (1000 * time) / this.run.length : 0;
    const tip = this.run.tip();
    const move = tip && !this.run.ended ? ", " + kMoveWords[tip.kind] : "";
    this.clockFigures.textContent = clockWords(time) + " of " + clockWords(this.run.length) + move;
    this.clock.setAttribute("aria-valuetext", clockWords(time));
    this.playButton.textContent = this.playing ? "Pause" : "Play";
    const state = this.playing ? "playing" : this.run.ended ? "ended" : isThere ? "paused" : "seeking";
    Object.assign(this.frame.dataset, { state, time: time.toFixed(3), setup: this.run.setup.id,
      operation: this.shownOperation || "", chosen: this.chosen.join(" ") });
  }

  // Words -------------------------------------------------------------------------------------------------

  tellSetup() {
    const { low, high } = this.run.setup.stock;
    const size = [0, 1, 2].map((axis) => this.units.length(high[axis] - low[axis])).join(" × ");
    this.words.replaceChildren(element("p", "", "Setup " + this.run.setup.id + ": stock " + size + ", " +
      this.run.setup.operations.length + " operations, " + clockWords(this.run.length) +
      " at the feeds, without tool changes. Click a feature or an operation."));
  }

  tellOperation(operation) {
    const tool = this.tools.get(operation.tool);
    const feeds = [...kMoveWords.map((words, kind) => [words, operation.feeds[kind]]), ["fastest", operation.fastest]]
      .filter(([, feed]) => feed > 0).map(([words, feed]) => words + " " + this.units.feed(feed)).join(", ");
    const place = operation.line > 0 ? operation.file + ", line " + operation.line : "no program is written";
    this.words.replaceChildren(
      element("p", "", element("b", "", operation.id), " ", operation.feature + ", " + operation.role + ", " + operation.pattern),
      element("p", "", "T" + tool.number + " " + operation.tool + " Ø " + this.units.length(tool.diameter) + ", " + tool.words),
      element("p", "", operation.rpm.toFixed(0) + " rpm; " + feeds),
      element("p", "viewer-place", place), element("div", "viewer-program", operation.program), reportLink(operation.anchor));
  }

  tellFeature(feature) {
    const top = feature.bands[0].top;
    const floor = feature.bands[feature.bands.length - 1].floor;
    const works = this.operationsOf(feature);
    const list = element("ul", "viewer-list", ...works.map((operation) => {
      const pick = button(operation.id + " " + operation.tool + " " + operation.role, "Go to " + operation.id,
        () => this.chooseOperation(operation.id, true));
      return element("li", "", pick);
    }));
    const stays = feature.bands.reduce((count, band) => count + band.stays.length, 0);
    this.words.replaceChildren(
      element("p", "", element("b", "", feature.id), " " + feature.class + ", Z " + this.units.length(top) + " to " +
        this.units.length(floor) + (feature.bands.length > 1 ? ", " + feature.bands.length + " bands" : "")),
      element("p", stays > 0 ? "bad" : "", stays > 0 ? stays + " regions stay, red" : "nothing stays"),
      element("p", "", works.length === 0 ? "no operation" : "Operations:"), list, reportLink(feature.anchor));
  }

  // What is chosen ----------------------------------------------------------------------------------------

  operationsOf(feature) {
    const bands = new Set(feature.bands.map((band) => band.id));
    return this.run.setup.operations.filter((operation) => bands.has(operation.feature));
  }

  chosenFeatures() {
    return this.run.setup.features.filter((feature) => this.chosen.includes(feature.id));
  }

  chooseFeatures(ids) {
    this.chosen = ids;
    this.features.mark(ids, true);
    const features = this.chosenFeatures();
    this.scene.showFeatures(features);
    this.operations.mark(features.length > 0 ? features.flatMap((feature) => this.operationsOf(feature).map((one) => one.id))
      : [this.shownOperation], true);
    if (features.length > 0) this.tellFeature(features[0]);
    this.ask();
  }

  /** \param isJump  goes to its start */
  chooseOperation(id, isJump) {
    const index = this.run.setup.operations.findIndex((operation) => operation.id === id);
    const operation = this.run.setup.operations[index];
    const feature = this.run.setup.features.find((one) => one.bands.some((band) => band.id === operation.feature));
    this.chosen = [];
    this.features.mark(feature ? [feature.id] : [], true);
    this.scene.showFeatures(feature ? [feature] : []);
    if (isJump) this.seek(this.run.starts[index]);
    this.operations.mark([id], true);
    this.tellOperation(operation);
    this.ask();
  }

  chooseNothing() {
    this.chooseFeatures([]);
    this.tellSetup();
  }

  /** The feature at a place of the stock: of several the one whose floor is nearest below. */
  pick(event) {
    const place = this.scene.placeOnStock(this.stage.rayAt(event).ray);
    if (!place) return this.chooseNothing();
    const slack = 0.002 * this.scene.diagonal;
    let best;
    for (const feature of this.run.setup.features)
      for (const band of feature.bands) {
        if (place.z > band.top + slack || place.z < band.floor - slack) continue;
        if (!isInRegion(place.x, place.y, unpackLoops(band.loops, this.data.step))) continue;
        if (!best || band.floor > best.floor + slack) best = { feature, floor: band.floor };
      }
    return best ? this.chooseFeatures([best.feature.id]) : this.chooseNothing();
  }

  // Mouse and keys ----------------------------------------------------------------------------------------

  listen() {
    const canvas = this.stage.renderer.domElement;
    canvas.setAttribute("aria-hidden", "true");
    canvas.addEventListener("pointerdown", (event) => {
      this.pressed = { x: event.clientX, y: event.clientY };
      this.frame.focus({ preventScroll: true });
    });
    canvas.addEventListener("pointerup", (event) => {
      const from = this.pressed;
      this.pressed = undefined;
      if (from && Math.hypot(event.clientX - from.x, event.clientY - from.y) < kClickPixels && event.button === 0) this.pick(event);
    });
    // The wheel scrolls the page until the viewer is in use.
    this.stage.controls.enableZoom = false;
    this.frame.addEventListener("focusin", () => { this.stage.controls.enableZoom = true; });
    this.frame.addEventListener("focusout", () => { this.stage.controls.enableZoom = false; });
    this.frame.addEventListener("keydown", (event) => this.onKey(event));
  }

  onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const own = ["INPUT", "SELECT", "BUTTON", "SUMMARY", "A"].includes(event.target.tagName);
    // Lists, sliders and buttons keep the keys that are theirs.
    if (own && (event.key.length > 1 || event.key === " ")) return;
    const act = this.keyActs()[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  keyActs() {
    const toggle = (key) => () => this.show(key, !this.shown[key]);
    const names = this.colourings.map(([name]) => name);
    return {
      " ": () => this.play(!this.playing),
      ArrowLeft: () => this.seek(this.goal - kKeyShare * this.run.length),
      ArrowRight: () => this.seek(this.goal + kKeyShare * this.run.length),
      PageUp: () => this.stepOperation(-1),
      PageDown: () => this.stepOperation(1),
      Home: () => this.seek(0),
      End: () => this.seek(this.run.length),
      "+": () => this.stepSpeed(1),
      "-": () => this.stepSpeed(-1),
      1: () => this.lookFrom(1),
      2: () => this.lookFrom(2),
      3: () => this.lookFrom(3),
      4: () => this.lookFrom(4),
      s: toggle("stock"),
      p: toggle("part"),
      x: toggle("fixtures"),
      h: toggle("tool"),
      t: toggle("path"),
      r: toggle("allPaths"),
      c: () => this.colourBy(names[(names.indexOf(this.colouring[0]) + 1) % names.length]),
      l: () => this.setLook(this.look === "dark" ? "light" : "dark"),
      Escape: () => this.chooseNothing(),
    };
  }
}

/** "O3" of "S1.O3". */
function shortName(id) {
  const point = id.indexOf(".");
  return point < 0 ? id : id.slice(point + 1);
}

function reportLink(anchor) {
  const link = element("a", "", "in this report");
  link.setAttribute("href", "#" + anchor);
  return element("p", "", link);
}

function hasWebGl() {
  const canvas = document.createElement("canvas");
  try {
    return Boolean(canvas.getContext("webgl") || canvas.getContext("experimental-webgl"));
  } catch (error) {
    return false;
  }
}

function startViewer() {
  const message = document.getElementById("viewer-message");
  if (!hasWebGl()) {
    message.textContent = "This browser shows no 3D pictures (WebGL is missing or switched off), so there is no viewer. " +
      "All else of this page works without.";
    return;
  }
  message.remove();
  const data = JSON.parse(document.getElementById("data-viewer").textContent);
  new Viewer(document.getElementById("viewer-frame"), data);
}

startViewer();
