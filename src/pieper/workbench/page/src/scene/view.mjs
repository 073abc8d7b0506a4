// The window into space: renderer, camera, standard views and ground. Draws only when something changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { tell } from '../store.mjs';
import { colours } from '../theme.mjs';
import { Quality, drawnInSoftware } from './quality.mjs';

const FOV = 32;
const directions = { iso: [1, -1.25, 0.62], front: [1, 0, 0], side: [0, -1, 0], top: [0, -0.0001, 1] };

export const scene = new THREE.Scene();
export const camera = new THREE.PerspectiveCamera(FOV, 1, 0.01, 100);
camera.up.set(0, 0, 1);
export let renderer, controls;
let host,
  quality,
  pending = false,
  awake = false,
  drawn = 0;

/** Ask for a picture; many requests within a frame make one. */
export function invalidate() {
  if (pending || !awake) return;
  pending = true;
  requestAnimationFrame(draw);
}
function draw(now = performance.now()) {
  pending = false;
  quality.moving(now);
  paint();
}
const before = [];
/** Have something put in its place before every picture. */
export const beforeEach = (f) => before.push(f);
function paint() {
  for (const f of before) f();
  renderer.render(scene, camera);
  drawn += 1;
}
/** From now on there is something to show. */
export function wake() {
  awake = true;
  invalidate();
}
/** Draw now and look at the picture before the browser takes it away. */
export function withPicture(f) {
  paint();
  return f(renderer.domElement);
}
export const picturesDrawn = () => drawn;
/** Whether the processor draws. */
export const bySoftware = () => Boolean(quality?.software);

scene.fog = new THREE.Fog('#fff', 1, 10);

/**
 * A canvas of the host's size with its context. Without an alpha channel: an opaque picture spares the browser drawing what
 * lies under it and mixing the two. At its size from the start: every change of size is a question to the graphics process,
 * and where the processor draws, each of them waits in line.
 */
function contextOf(antialias) {
  const canvas = document.createElement('canvas');
  canvas.width = host.clientWidth || 1;
  canvas.height = host.clientHeight || 1;
  const context = canvas.getContext('webgl2', {
    alpha: false,
    antialias,
    stencil: true,
    powerPreference: 'high-performance',
  });
  if (!context) throw new Error('This browser offers no WebGL 2, which the picture needs.');
  // None of the extensions that three.js asks for is used here, and asking is again a question each.
  const offered = context.getExtension.bind(context);
  context.getExtension = (name) => (used.has(name) ? offered(name) : null);
  return context;
}
const used = new Set(['WEBGL_debug_renderer_info', 'WEBGL_lose_context']);

export function open(element) {
  host = element;
  let context = contextOf(false);
  const software = drawnInSoftware(context);
  if (!software) {
    context.getExtension('WEBGL_lose_context')?.loseContext();
    context = contextOf(true);
  }
  renderer = new THREE.WebGLRenderer({ canvas: context.canvas, context });
  // our shaders are tried by the tests; asking for each one's log holds up the first picture
  renderer.debug.checkShaderErrors = false;
  quality = new Quality(software, renderer, paint, (yes) => tell('hurry', yes));
  renderer.domElement.setAttribute('aria-hidden', 'true');
  host.append(renderer.domElement);
  controls = new OrbitControls(camera, renderer.domElement);
  controls.enableDamping = false;
  controls.addEventListener('change', invalidate);
  // Whoever turns the arm out of the picture wants it so, until they ask for a view again.
  controls.addEventListener('end', () => {
    handsOff = !inView();
    nearer = null;
  });
  new ResizeObserver(resize).observe(host);
  host.tabIndex = 0;
  host.setAttribute('role', 'application');
  host.setAttribute(
    'aria-label',
    'The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views.',
  );
  host.addEventListener('keydown', onKey);
}

function resize() {
  const w = host.clientWidth,
    h = host.clientHeight;
  if (!w || !h) return;
  quality.resized(w, h);
  renderer.setSize(w, h);
  camera.aspect = w / h;
  camera.updateProjectionMatrix();
  // at once, so that a resized picture does not flicker
  if (drawn) draw();
  else invalidate();
  if (!returnIfRoom()) keepInView();
}

function onKey(e) {
  const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
  const view = { 1: 'iso', 2: 'front', 3: 'side', 4: 'top' }[e.key];
  if (turn) orbit(turn[0] * 0.1, turn[1] * 0.1);
  else if (e.key === '+' || e.key === '=') dolly(1 / 1.15);
  else if (e.key === '-') dolly(1.15);
  else if (e.key.toLowerCase() === 'f') fit(lastPoints);
  else if (view) look(view);
  else return;
  e.preventDefault();
}
function orbit(dAzimuth, dPolar) {
  const v = camera.position.clone().sub(controls.target),
    r = v.length();
  const az = Math.atan2(v.y, v.x) + dAzimuth;
  const po = Math.min(Math.max(Math.acos(v.z / r) + dPolar, 0.02), Math.PI - 0.02);
  camera.position
    .set(Math.sin(po) * Math.cos(az), Math.sin(po) * Math.sin(az), Math.cos(po))
    .multiplyScalar(r)
    .add(controls.target);
  controls.update();
  invalidate();
}
function dolly(k) {
  camera.position.sub(controls.target).multiplyScalar(k).add(controls.target);
  controls.update();
  invalidate();
}

// ---- fitting
let lastPoints = [
  [0, 0, 0],
  [0, 0, 1],
];
/** The closest camera along a direction from which every point is in the picture, with a margin. */
function framing(points, dir) {
  const box = new THREE.Box3().setFromPoints(points.map((p) => new THREE.Vector3(...p)));
  const target = box.getCenter(new THREE.Vector3());
  const back = new THREE.Vector3(...dir).normalize();
  const right = new THREE.Vector3().crossVectors(camera.up, back).normalize();
  const up = new THREE.Vector3().crossVectors(back, right);
  const ty = Math.tan(THREE.MathUtils.degToRad(FOV / 2)) * 0.8,
    tx = ty * camera.aspect;
  let distance = box.getSize(new THREE.Vector3()).length() * 0.4 + 1e-3;
  // Two passes centre the picture, not only the box: the second one starts from the first one's balance.
  for (let pass = 0; pass < 3; pass++) {
    let need = 0,
      lo = Infinity,
      hi = -Infinity,
      left = Infinity,
      far = -Infinity;
    for (const p of points) {
      const v = new THREE.Vector3(...p).sub(target);
      const x = v.dot(right),
        y = v.dot(up),
        z = v.dot(back);
      need = Math.max(need, z + Math.abs(x) / tx, z + Math.abs(y) / ty);
      lo = Math.min(lo, y);
      hi = Math.max(hi, y);
      left = Math.min(left, x);
      far = Math.max(far, x);
    }
    distance = Math.max(need, distance * 0.2);
    if (pass < 2) target.addScaledVector(up, (lo + hi) / 2).addScaledVector(right, (left + far) / 2);
  }
  return { target, position: target.clone().addScaledVector(back, distance) };
}

let moving = 0;
function fly({ target, position }, seconds = 0.35) {
  const from = { t: controls.target.clone(), p: camera.position.clone() },
    began = performance.now(),
    mine = ++moving;
  const still = matchMedia('(prefers-reduced-motion: reduce)').matches || seconds === 0;
  (function go(now) {
    if (mine !== moving) return;
    const s = still ? 1 : Math.min((now - began) / (1000 * seconds), 1),
      k = s * s * (3 - 2 * s);
    controls.target.lerpVectors(from.t, target, k);
    camera.position.lerpVectors(from.p, position, k);
    const d = camera.position.distanceTo(controls.target);
    camera.near = d / 100;
    camera.far = d * 30;
    scene.fog.near = d * 1.3;
    scene.fog.far = d * 3.4;
    camera.updateProjectionMatrix();
    controls.update();
    invalidate();
    if (s < 1) requestAnimationFrame(go);
  })(began);
}
/** Bring points into the picture from the present direction. */
export function fit(points, { instant = false, view = null, byItself = false } = {}) {
  lastPoints = points;
  if (!byItself) nearer = null;
  handsOff = false;
  const dir = view ? directions[view] : camera.position.clone().sub(controls.target).toArray();
  fly(framing(points, dir), instant ? 0 : 0.35);
}
/** One of the standard views: iso, front (from +x), side (from -y), top. */
export function look(name) {
  handsOff = false;
  nearer = null;
  fly(framing(lastPoints, directions[name]));
}
let handsOff = false;
function inView() {
  camera.updateMatrixWorld();
  const v = new THREE.Vector3();
  return lastPoints.every((p) => {
    v.set(...p).project(camera);
    return Math.abs(v.x) < 1 && Math.abs(v.y) < 1 && v.z < 1;
  });
}
/** Move back a little when the arm has grown out of the picture, unless the person has chosen it so. */
export function keepInView() {
  // never under a hand that drags the target, which lets go of the controls meanwhile
  if (handsOff || !controls.enabled || !lastPoints.length || inView()) return;
  nearer ??= { position: camera.position.clone(), target: controls.target.clone() };
  fit(lastPoints, { byItself: true });
}
/** Where the camera was before it moved back by itself; null after a hand or a view that somebody chose. */
let nearer = null;
export function returnFromWide() {
  if (!nearer || handsOff || !controls.enabled) return;
  const there = nearer;
  nearer = null;
  fly(there);
  setTimeout(keepInView, 500);
}
/** Go back to where the camera was if everything is in the picture from there now; returns whether it is. */
function returnIfRoom() {
  if (!nearer || handsOff || !controls.enabled) return false;
  const here = { position: camera.position.clone(), target: controls.target.clone() },
    there = nearer;
  const put = ({ position, target }) => {
    camera.position.copy(position);
    controls.target.copy(target);
    camera.lookAt(target);
  };
  put(there);
  const fits = inView();
  put(here);
  if (!fits) return false;
  nearer = null;
  fly(there, 0);
  return true;
}
export const remember = (points) => {
  lastPoints = points;
};
export const cameraState = () =>
  [...camera.position.toArray(), ...controls.target.toArray()].map((v) => Number(v.toPrecision(5)));
export function setCamera(six) {
  moving += 1;
  fly({ position: new THREE.Vector3(...six.slice(0, 3)), target: new THREE.Vector3(...six.slice(3)) }, 0);
}

// ---- ground
let grid = null;
export const ground = { cell: 0.1 };
/** A grid on z = 0 whose cell is 1, 2 or 5 times a power of ten, about a tenth of the arm. */
export function layGround(reach) {
  const raw = reach / 6,
    ten = 10 ** Math.floor(Math.log10(raw));
  const cell = [1, 2, 5, 10].map((k) => k * ten).findLast((c) => c <= raw * 1.0001) ?? ten;
  ground.cell = cell;
  const half = Math.ceil((reach * 2.2) / cell),
    at = [],
    shade = [];
  const fine = new THREE.Color(colours.gridFine),
    coarse = new THREE.Color(colours.gridCoarse);
  for (let i = -half; i <= half; i++) {
    const c = i % 5 === 0 ? coarse : fine,
      e = half * cell;
    at.push(i * cell, -e, 0, i * cell, e, 0, -e, i * cell, 0, e, i * cell, 0);
    for (let k = 0; k < 4; k++) shade.push(c.r, c.g, c.b);
  }
  grid?.geometry.dispose();
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(at, 3));
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(shade, 3));
  if (!grid) {
    grid = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ vertexColors: true }));
    grid.renderOrder = -2;
    grid.material.depthWrite = false;
    scene.add(grid);
  } else grid.geometry = geometry;
  grid.userData.reach = reach;
  invalidate();
}
export function applyTheme() {
  scene.background = new THREE.Color(colours.ground);
  scene.fog.color.set(colours.ground);
  if (grid) layGround(grid.userData.reach);
  invalidate();
}

/** Where a point of space is on the screen, CSS pixels in the page; for tests that drag like a hand. */
export function toScreen(p) {
  camera.updateMatrixWorld();
  const v = new THREE.Vector3(...p).project(camera),
    r = host.getBoundingClientRect();
  return [r.x + ((v.x + 1) / 2) * r.width, r.y + ((1 - v.y) / 2) * r.height];
}
