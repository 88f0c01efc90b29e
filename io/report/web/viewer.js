// The part, turning, with its modes (three.js): glTF with a morph target per mode, coloured by
// displacement.
import {
  AmbientLight, AxesHelper, Box3, BufferAttribute, Color, DirectionalLight, LineBasicMaterial,
  MeshStandardMaterial, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer, DoubleSide,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

import { element } from './element.js';
import { addSymbols } from './symbols.js';

const period = 1600; // ms of one swing, whatever the frequency
const room = 24, narrowest = 96; // px: between a name and the edge, of a name in lines

function bytes(base64) {
  const text = atob(base64);
  const data = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) data[i] = text.charCodeAt(i);
  return data.buffer;
}

// Colour of a share 0..1, between the stops that the page gives ("#rrggbb").
function scaleOf(stops) {
  const colours = stops.map((stop) => new Color(stop));
  return (share, into) => {
    const at = Math.min(Math.max(share, 0), 1) * (colours.length - 1);
    const low = Math.min(Math.floor(at), colours.length - 2);
    return into.copy(colours[low]).lerp(colours[low + 1], at - low);
  };
}

// Vertex colours by the length of a mode's displacement; plain without a mode.
function paint(objects, mode, scale) {
  const plain = new Color('#9aa4ad');
  const colour = new Color();
  let largest = 0;
  const lengthAt = (shape, i) => Math.hypot(shape.getX(i), shape.getY(i), shape.getZ(i));
  for (const o of objects) {
    const shape = o.geometry.morphAttributes.position?.[mode];
    if (shape) for (let i = 0; i < shape.count; ++i) largest = Math.max(largest, lengthAt(shape, i));
  }
  for (const o of objects) {
    const colours = o.geometry.getAttribute('color');
    const shape = o.geometry.morphAttributes.position?.[mode];
    for (let i = 0; i < colours.count; ++i) {
      const c = shape && largest > 0 ? scale(lengthAt(shape, i) / largest, colour) : plain;
      colours.setXYZ(i, c.r, c.g, c.b);
    }
    colours.needsUpdate = true;
  }
}

// Shares 0..1 of a field, of 16 bits each.
function sharesOf(base64) {
  const view = new DataView(bytes(base64));
  return Float32Array.from({ length: view.byteLength / 2 }, (_, i) => view.getUint16(2 * i, true) / 65535);
}

// Vertex colours by a field on the faces of the shells; lines stay plain.
function paintField(objects, shares, scale) {
  const plain = new Color('#9aa4ad');
  const colour = new Color();
  for (const o of objects) {
    const colours = o.geometry.getAttribute('color');
    const has = o.isMesh && colours.count <= shares.length;
    for (let i = 0; i < colours.count; ++i) {
      const c = has ? scale(shares[i], colour) : plain;
      colours.setXYZ(i, c.r, c.g, c.b);
    }
    colours.needsUpdate = true;
  }
}

function prepare(objects) {
  for (const o of objects) {
    const count = o.geometry.getAttribute('position').count;
    o.geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * count), 3));
    if (o.isMesh) {
      o.geometry.computeVertexNormals();
      o.material = new MeshStandardMaterial({ vertexColors: true, side: DoubleSide,
        roughness: 0.55, metalness: 0.15 });
    } else {
      o.material = new LineBasicMaterial({ vertexColors: true });
    }
    o.frustumCulled = false;
  }
}

class Viewer {
  constructor(figure, data, gltf, renderer) {
    this.figure = figure;
    this.scale = scaleOf(data.colours);
    this.renderer = renderer;
    this.scene = new Scene();
    this.scene.add(gltf.scene, new AmbientLight('#ffffff', 1.4));
    this.camera = new PerspectiveCamera(30, 1, 1e-3, 100);
    const sun = new DirectionalLight('#ffffff', 2.2);
    sun.position.set(0.4, 1, 0.6);
    this.camera.add(sun);
    this.scene.add(this.camera);
    this.part = gltf.scene;
    this.objects = [];
    gltf.scene.traverse((o) => { if (o.isMesh || o.isLineSegments || o.isLine) this.objects.push(o); });
    prepare(this.objects);
    this.tags = this.tagged(data.sensors, data.symbols ?? []);
    this.mode = -1;
    this.amplitude = 1;
    this.phase = 0;
    this.playing = false;
    this.orbit = new OrbitControls(this.camera, renderer.domElement);
    this.orbit.addEventListener('change', () => this.draw());
    this.orbit.addEventListener('start', () => { this.turned = true; });
    this.resize();
    this.home();
    this.show(-1);
    new ResizeObserver(() => this.resize()).observe(renderer.domElement.parentElement);
  }

  home() {
    this.turned = false;
    const box = new Box3().setFromObject(this.part);
    const centre = box.getCenter(new Vector3());
    const size = box.getSize(new Vector3()).length() || 1;
    this.orbit.target.copy(centre);
    this.camera.near = size / 100;
    this.camera.far = size * 20;
    const towards = new Vector3(1.2, 0.55, 0.55).normalize();
    this.camera.position.copy(centre).addScaledVector(towards, this.distance(box, centre, towards));
    this.camera.updateProjectionMatrix();
    this.orbit.update();
  }

  // How far away the box fits into the picture.
  distance(box, centre, towards) {
    const right = new Vector3(0, 1, 0).cross(towards).normalize();
    const up = towards.clone().cross(right);
    const high = 0.94 * Math.tan((Math.PI / 360) * this.camera.fov);
    const wide = high * this.camera.aspect;
    let far = 0;
    for (const x of [box.min.x, box.max.x]) for (const y of [box.min.y, box.max.y]) for (const z of [box.min.z, box.max.z]) {
      const p = new Vector3(x, y, z).sub(centre);
      far = Math.max(far, p.dot(towards) + Math.max(Math.abs(p.dot(right)) / wide, Math.abs(p.dot(up)) / high));
    }
    return far;
  }

  // Names at places of the part: sensors, and the ends of its axes.
  tagged(sensors, symbols) {
    const box = new Box3().setFromObject(this.part);
    const size = box.getSize(new Vector3()).length();
    const length = 0.11 * size;
    const corner = new Vector3(box.min.x, box.min.y - 0.08 * size, box.max.z); // glTF: y is up, z is -y of the part
    const axes = new AxesHelper(length);
    axes.setColors('#d55e00', '#0072b2', '#009e73');
    const frame = this.part.getObjectByName('part') ?? this.part; // turns z up
    frame.updateWorldMatrix(true, false);
    this.frame = frame;
    axes.position.copy(frame.worldToLocal(corner.clone()));
    frame.add(axes);
    this.symbols = addSymbols(symbols, frame, size);
    const tag = (name, at, kind) => this.tag(name, at, kind);
    const ends = [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]]].map(([name, along]) =>
      tag(name, new Vector3(...along).multiplyScalar(1.15 * length).add(axes.position), 'axis-name'));
    const told = new Set();
    const names = this.symbols.filter(({ label, name }) => {
      const key = `${label} ${name.toArray()}`;
      const near = (s) => s.name === label && new Vector3(...s.at).distanceTo(name) < 0.02 * size;
      return label && !sensors.some(near) && !told.has(key) && told.add(key);
    });
    return [...ends, ...sensors.map((s) => tag(s.name, new Vector3(...s.at), 'sensor')),
      ...names.map((s) => tag(s.label, s.name.clone(), 'symbol-name'))];
  }

  tag(name, at, kind) {
    const label = element('span', { className: `tag ${kind}` }, name);
    this.renderer.domElement.parentElement.append(label);
    return { label, at: this.frame.localToWorld(at) };
  }

  // A field on the face above or below, its hot spot marked where it lies on that face; null: none.
  showField(field, above) {
    this.spot?.label.remove();
    this.tags = this.tags.filter((t) => t !== this.spot);
    this.spot = undefined;
    if (!field) return this.show(this.mode);
    this.field = field;
    paintField(this.objects, sharesOf(above ? field.above : field.below), this.scale);
    if (field.spot && above === field.spot_above) {
      this.spot = this.tag(field.spot, new Vector3(...field.at), 'sensor hot');
      this.tags.push(this.spot);
    }
    this.draw();
  }

  resize() {
    const stage = this.renderer.domElement.parentElement;
    const width = stage.clientWidth;
    if (!(width > 0)) return;
    const height = Math.round(Math.min(520, Math.max(260, 0.55 * width)));
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.turned === false) this.home(); // the whole part stays in sight
    this.draw();
  }

  show(mode) {
    this.mode = mode;
    paint(this.objects, mode, this.scale);
    this.move();
  }

  // Phase in swings.
  move() {
    const share = this.mode < 0 ? 0 : this.amplitude * (this.playing ? Math.sin(2 * Math.PI * this.phase) : 1);
    for (const o of this.objects)
      o.morphTargetInfluences?.forEach((_, i) => { o.morphTargetInfluences[i] = i === this.mode ? share : 0; });
    for (const s of this.symbols) s.move(this.mode, share);
    this.draw();
  }

  play(on) {
    if (on === this.playing) return;
    this.playing = on;
    let before = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      this.phase += (now - before) / period;
      before = now;
      this.move();
      requestAnimationFrame(step);
    };
    if (on) requestAnimationFrame(step);
    else this.move();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
    const { clientWidth, clientHeight } = this.renderer.domElement;
    for (const { label, at } of this.tags) {
      const p = at.clone().project(this.camera);
      const left = ((p.x + 1) / 2) * clientWidth;
      const free = label.classList.contains('symbol-name'); // no dot of it marks the place
      const shown = free ? Math.min(left, clientWidth - label.offsetWidth - room / 2) : left;
      label.style.transform = `translate(${shown}px, ${((1 - p.y) / 2) * clientHeight}px)`;
      label.style.maxWidth = `${Math.max(clientWidth - left - room, narrowest)}px`;
    }
    this.figure.dataset.frames = String(1 + Number(this.figure.dataset.frames ?? 0));
  }
}

// What colours the part: its motion, or a field on one of its faces, with the scale of it.
function fieldControls(viewer, data) {
  const fields = element('select', { ariaLabel: 'field' }, element('option', { value: '-1' }, 'motion'));
  data.fields.forEach((f, i) => fields.append(element('option', { value: String(i) }, f.name)));
  const face = element('select', { ariaLabel: 'face' }, element('option', { value: 'above' }, 'outer face'),
    element('option', { value: 'below' }, 'inner face'));
  const low = element('span', {});
  const high = element('span', {});
  const bar = element('span', { className: 'bar' });
  bar.style.background = `linear-gradient(to right, ${data.colours.join(', ')})`;
  const scale = element('span', { className: 'scale', hidden: true }, low, bar, high);
  const show = () => {
    const field = data.fields[Number(fields.value)] ?? null;
    viewer.showField(field, face.value === 'above');
    scale.hidden = face.hidden = !field;
    if (!field) return;
    low.textContent = field.scale[0];
    high.textContent = `${field.scale[1]} ${field.unit}`.trim();
  };
  fields.addEventListener('change', () => {
    const field = data.fields[Number(fields.value)];
    if (field) face.value = field.spot_above ? 'above' : 'below';
    show();
  });
  face.addEventListener('change', show);
  face.hidden = true;
  const motion = () => { fields.value = '-1'; show(); };
  return { parts: [element('label', {}, 'colour ', fields), face, scale], motion };
}

function controls(viewer, data) {
  const modes = element('select', { ariaLabel: 'mode' }, element('option', { value: '-1' }, 'at rest'));
  data.modes.forEach((name, i) => modes.append(element('option', { value: String(i) }, name)));
  const play = element('button', { type: 'button' }, 'play');
  const amplitude = element('input', { type: 'range', min: '0', max: '3', step: '0.05', value: '1',
    ariaLabel: 'amplitude' });
  const home = element('button', { type: 'button' }, 'view from the start');
  const setPlaying = (on) => {
    viewer.play(on);
    play.textContent = viewer.playing ? 'pause' : 'play';
    play.ariaPressed = String(viewer.playing);
  };
  const coloured = data.fields?.length > 0 ? fieldControls(viewer, data) : null;
  const choose = (mode, playing) => {
    coloured?.motion();
    modes.value = String(mode);
    viewer.show(mode);
    setPlaying(playing && mode >= 0);
  };
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  modes.addEventListener('change', () => choose(Number(modes.value), !still.matches));
  play.addEventListener('click', () => {
    if (viewer.mode < 0 && data.modes.length > 0) choose(0, true);
    else setPlaying(!viewer.playing);
  });
  amplitude.addEventListener('input', () => {
    viewer.amplitude = Number(amplitude.value);
    viewer.move();
  });
  home.addEventListener('click', () => viewer.home());
  // The small picture of a mode plays it.
  document.querySelectorAll('[data-mode]').forEach((picture) => {
    const pick = () => {
      choose(Number(picture.dataset.mode), !still.matches);
      viewer.figure.scrollIntoView({ block: 'nearest' });
    };
    picture.tabIndex = 0;
    picture.addEventListener('click', pick);
    picture.addEventListener('keydown', (event) => { if (event.key === 'Enter') pick(); });
  });
  if (data.first !== undefined) choose(data.first, false); // still: what is said above it
  const parts = data.modes.length > 0 ? [modes, play, element('label', {}, 'amplitude ', amplitude), home]
    : [home];
  return element('div', { className: 'controls' }, ...parts, ...(coloured?.parts ?? []));
}

export function enlivenPart(figure) {
  const data = JSON.parse(figure.querySelector('script[type="application/json"]').textContent);
  let renderer;
  try {
    renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch {
    return; // no WebGL: the drawing stays
  }
  renderer.outputColorSpace = SRGBColorSpace;
  renderer.domElement.setAttribute('role', 'img');
  renderer.domElement.setAttribute('aria-label', 'the part in three dimensions: drag to turn it');
  new GLTFLoader().parse(bytes(data.glb), '', (gltf) => {
    const stage = element('div', { className: 'live' }, renderer.domElement);
    figure.prepend(stage);
    figure.classList.add('is-live');
    const viewer = new Viewer(figure, data, gltf, renderer);
    stage.after(controls(viewer, data));
    figure.viewer = viewer;
  }, (error) => { throw error; });
}
