// Solids and lines of the viewer, as three.js draws them.

/** Twice the signed area: above zero where the loop runs counter-clockwise. */
function signedArea(loop) {
  let sum = 0;
  loop.forEach(([x, y], i) => {
    const [nx, ny] = loop[(i + 1) % loop.length];
    sum += x * ny - nx * y;
  });
  return sum;
}

/** Is a point inside a loop? */
function isInside(x, y, loop) {
  let inside = false;
  loop.forEach(([ax, ay], i) => {
    const [bx, by] = loop[(i + 1) % loop.length];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

function isInRegion(x, y, loops) {
  return loops.filter((loop) => isInside(x, y, loop)).length % 2 === 1;
}

function regionArea(loops) {
  return loops.reduce((sum, loop) => sum + signedArea(loop), 0) / 2;
}

/** A region's components: outer loops with the holes in them. */
function shapesOf(loops) {
  const points = (loop) => loop.map(([x, y]) => new THREE.Vector2(x, y));
  const outer = loops.filter((loop) => loop.length > 2 && signedArea(loop) > 0);
  const shapes = outer.map((loop) => new THREE.Shape(points(loop)));
  for (const hole of loops.filter((loop) => loop.length > 2 && signedArea(loop) < 0)) {
    const around = outer.findIndex((loop) => isInside(hole[0][0], hole[0][1], loop));
    if (around >= 0) shapes[around].holes.push(new THREE.Path(points(hole)));
  }
  return shapes;
}

function prismGeometry(loops, bottom, top) {
  const geometry = new THREE.ExtrudeBufferGeometry(shapesOf(loops), { depth: top - bottom, bevelEnabled: false });
  geometry.translate(0, 0, bottom);
  return geometry;
}

/** Outlines of a region at some heights, as pairs of points. */
function outlineGeometry(loops, heights) {
  const places = [];
  for (const loop of loops)
    loop.forEach(([x, y], i) => {
      const [nx, ny] = loop[(i + 1) % loop.length];
      for (const z of heights) places.push(x, y, z, nx, ny, z);
    });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(places, 3));
  return geometry;
}

function partGeometry(part) {
  const { corners, sides } = unpackPart(part);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
  geometry.setIndex(new THREE.BufferAttribute(sides, 1));
  geometry.computeVertexNormals();
  return geometry;
}

/** A body turned around the tool's axis, from [radius, height] upwards. */
function turnedGeometry(outline) {
  const points = outline.map(([radius, height]) => new THREE.Vector2(Math.max(1e-4, radius), height));
  const geometry = new THREE.LatheBufferGeometry(points, 40);
  geometry.rotateX(Math.PI / 2);
  return geometry;
}

function cylinderOutline([diameter, bottom, top]) {
  const radius = diameter / 2;
  return [[0, bottom], [radius, bottom], [radius, top], [0, top]];
}

/** Cutter, shank and holder, tip at the origin. */
function toolGroup(tool, colours) {
  const group = new THREE.Group();
  const add = (outline, colour) => {
    const material = new THREE.MeshPhongMaterial({ color: colour, side: THREE.DoubleSide, shininess: 60 });
    group.add(new THREE.Mesh(turnedGeometry(outline), material));
  };
  const radius = tool.diameter / 2;
  const full = tool.form[tool.form.length - 1][1];
  const flutes = Math.max(tool.flutes, full);
  add([[0, tool.form[0][1]], ...tool.form, [radius, flutes], [0, flutes]], colours.cutter);
  if (tool.shank[0] > 0 && tool.shank[2] > tool.shank[1]) add(cylinderOutline(tool.shank), colours.shank);
  for (const cylinder of tool.holder) add(cylinderOutline(cylinder), colours.holder);
  return group;
}

/**
 * A path as pairs of points with a colour each; points nearer than `least` to the last one drawn are left out
 * while kind and feed of the moves stay. `places` tells how many pairs there are up to each place of the path.
 */
function pathGeometry(path, colourOf, least) {
  const positions = new Float32Array(6 * path.count);
  const colours = new Uint8Array(6 * path.count);
  const drawnAt = new Uint32Array(path.count);
  let pairs = 0;
  let from = 0;
  for (let i = 1; i < path.count; ++i) {
    const last = i + 1 === path.count || path.kinds[i + 1] !== path.kinds[i] || path.feeds[i + 1] !== path.feeds[i] ||
      path.loads[i + 1] !== path.loads[i];
    if (last || distance(path, from, i) >= least) {
      positions.set(path.places.subarray(3 * from, 3 * from + 3), 6 * pairs);
      positions.set(path.places.subarray(3 * i, 3 * i + 3), 6 * pairs + 3);
      const colour = colourOf(path.kinds[i] & kKindBits, path.feeds[i], path.loads[i]);
      colours.set(colour, 6 * pairs);
      colours.set(colour, 6 * pairs + 3);
      ++pairs;
      from = i;
    }
    drawnAt[i] = pairs;
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions.subarray(0, 6 * pairs), 3));
  geometry.setAttribute("color", new THREE.BufferAttribute(colours.subarray(0, 6 * pairs), 3, true));
  return { geometry, drawnAt, pairs };
}

function distance(path, a, b) {
  return Math.hypot(path.places[3 * a] - path.places[3 * b], path.places[3 * a + 1] - path.places[3 * b + 1],
    path.places[3 * a + 2] - path.places[3 * b + 2]);
}

/** Where the tool begins to go down into material. */
function entryPlaces(path) {
  const places = [];
  const isEntry = (i) => [kRamp, kPlunge].includes(path.kinds[i] & kKindBits) && !(path.kinds[i] & kInAirBit);
  for (let i = 1; i < path.count; ++i)
    if (isEntry(i) && (i === 1 || !isEntry(i - 1))) places.push(...path.places.subarray(3 * i - 3, 3 * i));
  return places;
}

// The stock's surface is one grid whose heights change. Each corner takes the middle of a cell.
const kStockVertex = `
  attribute float height;
  attribute float bottom;
  attribute vec3 tint;
  uniform float section;
  uniform bool underside;
  varying vec3 seen;
  varying vec3 shade;
  varying float thick;
  varying float over;
  void main() {
    float top = min(height, section);
    thick = top - bottom;
    over = height - section;
    shade = tint;
    vec4 place = modelViewMatrix * vec4(position.xy, underside ? bottom : max(top, bottom), 1.0);
    seen = place.xyz;
    gl_Position = projectionMatrix * place;
  }`;
const kStockFragment = `
  uniform vec3 sectionTint;
  uniform float least;
  varying vec3 seen;
  varying vec3 shade;
  varying float thick;
  varying float over;
  void main() {
    if (thick < least) discard;
    vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
    float facing = abs(dot(normal, normalize(vec3(0.25, 0.5, 1.0))));
    vec3 tint = over > 0.0 ? sectionTint : shade;
    gl_FragColor = vec4(tint * (0.35 + 0.65 * facing), 1.0);
  }`;

/** Top and underside of a stock. */
class StockShape {
  constructor(field) {
    this.field = field;
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setAttribute("position", new THREE.BufferAttribute(gridPlaces(field), 3));
    this.height = new THREE.BufferAttribute(field.top, 1).setUsage(THREE.DynamicDrawUsage);
    this.tint = new THREE.BufferAttribute(new Uint8Array(3 * field.top.length), 3, true).setUsage(THREE.DynamicDrawUsage);
    this.geometry.setAttribute("height", this.height);
    this.geometry.setAttribute("bottom", new THREE.BufferAttribute(field.bottom, 1));
    this.geometry.setAttribute("tint", this.tint);
    this.geometry.setIndex(new THREE.BufferAttribute(gridSides(field), 1));
    this.palette = [[160, 168, 176]];
    this.group = new THREE.Group();
    this.top = this.surface(false);
    this.underside = this.surface(true);
    this.group.add(this.top, this.underside);
  }

  surface(underside) {
    const material = new THREE.ShaderMaterial({
      vertexShader: kStockVertex,
      fragmentShader: kStockFragment,
      uniforms: {
        section: { value: 1e9 },
        sectionTint: { value: new THREE.Color(0xd08770) },
        least: { value: 0.02 },
        underside: { value: underside },
      },
      side: THREE.DoubleSide,
      // Paths and part that lie in its surface are seen.
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 2,
      extensions: { derivatives: true },
    });
    const mesh = new THREE.Mesh(this.geometry, material);
    // Its box is not that of its positions, whose heights come later.
    mesh.frustumCulled = false;
    return mesh;
  }

  setSection(height) {
    for (const mesh of [this.top, this.underside]) mesh.material.uniforms.section.value = height;
  }

  /** \param palette  a colour [0..255] for the raw stock and each operation */
  setPalette(palette) {
    this.palette = palette;
    this.field.touchAll();
  }

  /** Brings what was cut since the last time to the picture. */
  update() {
    const { first, last } = this.field.takeTouched();
    if (first > last) return false;
    const from = first * this.field.columns;
    const to = (last + 1) * this.field.columns;
    for (let at = from; at < to; ++at) this.tint.array.set(this.palette[this.field.cutBy[at]], 3 * at);
    for (const [attribute, width] of [[this.height, 1], [this.tint, 3]]) {
      attribute.updateRange = { offset: width * from, count: width * (to - from) };
      attribute.needsUpdate = true;
    }
    return true;
  }

  dispose() {
    this.geometry.dispose();
    for (const mesh of [this.top, this.underside]) mesh.material.dispose();
  }
}

/** The rim stands on the stock's own sides, so that they are upright. */
function gridPlaces(field) {
  const places = new Float32Array(3 * field.columns * field.rows);
  const along = (index, count, low) => low + field.cell * Math.min(count - 2, Math.max(0, index - 0.5));
  for (let row = 0, at = 0; row < field.rows; ++row)
    for (let column = 0; column < field.columns; ++column, at += 3) {
      places[at] = along(column, field.columns, field.low[0]);
      places[at + 1] = along(row, field.rows, field.low[1]);
    }
  return places;
}

function gridSides(field) {
  const sides = new Uint32Array(6 * (field.columns - 1) * (field.rows - 1));
  let at = 0;
  for (let row = 0; row + 1 < field.rows; ++row)
    for (let column = 0; column + 1 < field.columns; ++column, at += 6) {
      const corner = row * field.columns + column;
      sides.set([corner, corner + 1, corner + field.columns, corner + 1, corner + field.columns + 1,
        corner + field.columns], at);
    }
  return sides;
}
