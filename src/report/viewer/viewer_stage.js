// The picture: camera, lights and all that stands in it.

// Colours of both looks. Those of tools follow one another.
const kLooks = {
  light: { ground: 0xf3f5f7, part: 0x9fb4c7, raw: [172, 180, 188], fixture: 0xb79cc4, feature: 0x0b6e99, stays: 0xc62828,
    section: 0xd9a066, cutter: 0xd4a017, shank: 0x8d99a6, holder: 0x5d6b7a, line: 0x39424c },
  dark: { ground: 0x14191f, part: 0x7f97ad, raw: [128, 138, 148], fixture: 0x8a6b95, feature: 0x4fc3f7, stays: 0xff6b5e,
    section: 0xb9783a, cutter: 0xffca45, shank: 0x9aa7b4, holder: 0x6d7b8a, line: 0xc7d0d9 },
};
const kToolTints = [[86, 156, 214], [230, 159, 0], [78, 171, 110], [204, 121, 167], [213, 122, 60], [122, 134, 214],
  [150, 170, 60], [64, 178, 178], [190, 110, 110], [150, 120, 190]];
const kRapidTint = [214, 39, 40];
const kEntryTint = 0x12b886;
const kKindTints = [kRapidTint, [31, 119, 180], [255, 127, 14], [18, 184, 134], [148, 103, 189]];

// Lengths of a picture as shares of the stock's diagonal.
const kEyeDistance = 2.1;
const kEntryShare = 0.007;
// Of a whole setup's paths, points nearer than this share are left out.
const kSetupPathShare = 1 / 1500;

/** The canvas of a viewer and how it is looked at. */
class Stage {
  constructor(holder, onChange) {
    this.holder = holder;
    this.onChange = onChange;
    this.renderer = new THREE.WebGLRenderer({ antialias: true });
    this.renderer.localClippingEnabled = true;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(32, 1, 1, 1000);
    this.camera.up.set(0, 0, 1);
    holder.append(this.renderer.domElement);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enableKeys = false;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", onChange);
    this.addLights();
    this.clip = new THREE.Plane(new THREE.Vector3(0, 0, -1), 1e9);
    new ResizeObserver(() => this.fit()).observe(holder);
    this.fit();
  }

  addLights() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8090a0, 0.75));
    const lamp = new THREE.DirectionalLight(0xffffff, 0.55);
    lamp.position.set(-0.4, 0.5, 1);
    // It goes with the viewer, so that no side is dark.
    this.camera.add(lamp);
    this.scene.add(this.camera);
  }

  fit() {
    const width = Math.max(1, this.holder.clientWidth);
    const height = Math.max(1, this.holder.clientHeight);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.onChange();
  }

  /** Looks at a stock from a direction. */
  lookFrom(stock, direction) {
    const low = new THREE.Vector3(...stock.low);
    const high = new THREE.Vector3(...stock.high);
    const diagonal = low.distanceTo(high);
    const middle = low.add(high).multiplyScalar(0.5);
    const away = kEyeDistance * diagonal * Math.max(1, 1.25 / this.camera.aspect);
    this.camera.near = diagonal / 200;
    this.camera.far = 20 * diagonal;
    this.camera.position.copy(middle).addScaledVector(new THREE.Vector3(...direction).normalize(), away);
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(middle);
    this.controls.update();
    this.onChange();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }

  /** The ray under a place of the canvas. */
  rayAt(event) {
    const frame = this.renderer.domElement.getBoundingClientRect();
    const place = new THREE.Vector2(2 * (event.clientX - frame.left) / frame.width - 1,
      1 - 2 * (event.clientY - frame.top) / frame.height);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(place, this.camera);
    return caster;
  }
}

/** What of one setup stands in the picture. */
class SetupScene {
  constructor(stage, run, partShape, look) {
    this.stage = stage;
    this.run = run;
    this.setup = run.setup;
    this.group = new THREE.Group();
    const { low, high } = this.setup.stock;
    this.diagonal = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    this.stock = new StockShape(run.field);
    this.part = this.partGroup(partShape);
    this.fixtures = new THREE.Group();
    this.paths = new THREE.Group();
    this.marks = new THREE.Group();
    this.tool = new THREE.Group();
    this.group.add(this.stock.group, this.part, this.fixtures, this.paths, this.marks, this.tool);
    this.setLook(look);
    stage.scene.add(this.group);
  }

  /** Its front as it is; its inside, which a section opens, in one colour. */
  partGroup(geometry) {
    const group = new THREE.Group();
    const clippingPlanes = [this.stage.clip];
    group.add(new THREE.Mesh(geometry, new THREE.MeshPhongMaterial({ side: THREE.FrontSide, clippingPlanes, shininess: 20 })));
    group.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.BackSide, clippingPlanes })));
    group.matrixAutoUpdate = false;
    group.matrix.fromArray(this.setup.placement);
    return group;
  }

  setLook(look) {
    this.look = look;
    this.stage.renderer.setClearColor(look.ground);
    this.part.children[0].material.color.setHex(look.part);
    this.part.children[1].material.color.setHex(look.section);
    for (const mesh of [this.stock.top, this.stock.underside]) mesh.material.uniforms.sectionTint.value.setHex(look.section);
    this.addFixtures();
    this.toolId = undefined;
  }

  addFixtures() {
    clear(this.fixtures);
    for (const fixture of this.setup.fixtures) {
      const loops = unpackLoops(fixture.loops, this.run.step);
      const material = new THREE.MeshPhongMaterial({ color: this.look.fixture, transparent: true, opacity: 0.55, depthWrite: false });
      this.fixtures.add(new THREE.Mesh(prismGeometry(loops, fixture.bottom, fixture.top), material));
      this.fixtures.add(new THREE.LineSegments(outlineGeometry(loops, [fixture.bottom, fixture.top]),
        new THREE.LineBasicMaterial({ color: this.look.line })));
    }
  }

  /** Cuts the picture open at a height; above all: whole. */
  setSection(height) {
    this.stage.clip.constant = height;
    this.stock.setSection(height);
  }

  /** \param operations  indices whose paths are shown; one alone is shown with every point */
  showPaths(operations, colourOf) {
    clear(this.paths);
    const least = operations.length > 1 ? kSetupPathShare * this.diagonal : 0;
    this.drawn = operations.map((index) => this.addPath(index, colourOf, least));
  }

  addPath(index, colourOf, least) {
    const path = this.run.paths[index];
    const drawn = pathGeometry(path, (kind, feed, load) => colourOf(this.setup.operations[index], kind, feed, load), least);
    const ahead = new THREE.BufferGeometry();
    for (const name of ["position", "color"]) ahead.setAttribute(name, drawn.geometry.getAttribute(name));
    const material = { vertexColors: THREE.VertexColors, transparent: true };
    const done = new THREE.LineSegments(drawn.geometry, new THREE.LineBasicMaterial({ ...material, opacity: 0.95 }));
    const rest = new THREE.LineSegments(ahead, new THREE.LineBasicMaterial({ ...material, opacity: 0.28 }));
    const entries = new THREE.BufferGeometry();
    entries.setAttribute("position", new THREE.Float32BufferAttribute(entryPlaces(path), 3));
    const dots = new THREE.Points(entries, new THREE.PointsMaterial({ color: kEntryTint, size: kEntryShare * this.diagonal }));
    for (const line of [done, rest, dots]) line.frustumCulled = false;
    this.paths.add(done, rest, dots);
    return { index, ...drawn, ahead };
  }

  /** What is done of the paths that are shown, and the tool where it is. */
  showProgress(toolOf) {
    for (const path of this.drawn || []) {
      const place = path.index < this.run.operation || this.run.ended ? path.drawnAt.length - 1
        : path.index > this.run.operation ? 0 : this.run.place;
      const pairs = path.drawnAt[Math.min(place, path.drawnAt.length - 1)];
      path.geometry.setDrawRange(0, 2 * pairs);
      path.ahead.setDrawRange(2 * pairs, Infinity);
    }
    const tip = this.run.tip();
    if (!tip) return;
    const tool = toolOf(this.setup.operations[this.run.operation].tool);
    if (tool && tool.id !== this.toolId) {
      clear(this.tool);
      this.tool.add(toolGroup(tool, this.look));
      this.toolId = tool.id;
    }
    this.tool.position.set(...tip.at);
  }

  /** Marks features: outlines and floors, red what stays. */
  showFeatures(features) {
    clear(this.marks);
    for (const feature of features) for (const band of feature.bands) this.addMark(feature, band);
  }

  addMark(feature, band) {
    const loops = unpackLoops(band.loops, this.run.step);
    const floor = new THREE.MeshBasicMaterial({ color: this.look.feature, transparent: true, opacity: 0.35, depthWrite: false,
      side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: -2 });
    const shape = new THREE.Mesh(new THREE.ShapeBufferGeometry(shapesOf(loops)), floor);
    shape.position.z = band.floor + 0.0005 * this.diagonal;
    const lines = new THREE.LineSegments(outlineGeometry(loops, [band.floor, band.top]),
      new THREE.LineBasicMaterial({ color: this.look.feature }));
    this.marks.add(shape, lines);
    for (const text of band.stays) {
      const stays = unpackLoops(text, this.run.step);
      if (stays.length === 0) continue;
      const mesh = new THREE.Mesh(new THREE.ShapeBufferGeometry(shapesOf(stays)),
        new THREE.MeshBasicMaterial({ color: this.look.stays, side: THREE.DoubleSide }));
      mesh.position.z = band.floor + 0.001 * this.diagonal;
      this.marks.add(mesh);
    }
  }

  /** Where a ray meets the stock as it is now: it is walked along in steps of half a cell. */
  placeOnStock(ray) {
    const field = this.run.field;
    const { low, high } = this.setup.stock;
    const box = new THREE.Box3(new THREE.Vector3(...low), new THREE.Vector3(...high).addScalar(1e-3));
    const from = ray.intersectBox(box, new THREE.Vector3());
    if (!from) return undefined;
    const along = ray.direction.clone().multiplyScalar(0.5 * field.cell);
    const at = box.containsPoint(ray.origin) ? ray.origin.clone() : from;
    for (let steps = 4 * this.diagonal / field.cell; steps > 0; --steps) {
      const height = field.heightAt(at.x, at.y);
      const shown = height === undefined ? undefined : Math.min(height, this.stage.clip.constant);
      if (shown !== undefined && at.z <= shown) return { x: at.x, y: at.y, z: shown };
      at.add(along);
      if (at.z < low[2] - field.cell) break;
    }
    return undefined;
  }

  dispose() {
    for (const group of [this.fixtures, this.paths, this.marks, this.tool]) clear(group);
    this.stock.dispose();
    for (const mesh of this.part.children) mesh.material.dispose();
    this.stage.scene.remove(this.group);
  }
}

/** Takes all out of a group and frees what the graphics card keeps of it. */
function clear(group) {
  group.traverse((item) => {
    if (item === group || !item.geometry) return;
    item.geometry.dispose();
    item.material.dispose();
  });
  while (group.children.length > 0) group.remove(group.children[0]);
}
