// The arm as it looks: the shapes and meshes of its own file over, or instead of, what is drawn from its table.
import * as THREE from 'three';
import { state, on, tell } from '../store.mjs';
import { colours } from '../theme.mjs';
import { say } from '../dom.mjs';
import { load } from '../meshes/load.mjs';
import { scene, invalidate, bySoftware } from './view.mjs';
import { solid } from './matte.mjs';
import { showSketch, wear, shadowMaterial, shadowMatrix } from './arm.mjs';

/** Grey of a shape whose file says no colour. */
const PLAIN = { light: '#c9ced6', dark: '#8b96a6' };
const group = new THREE.Group();
let shapes = [], // {on, T, fine, some, few, mesh, shadow, colour, corners}
  loading = 0,
  moving = false;

/** What of the table says which arm a file's looks are of: not its limits, base, tool or name. */
export const looksKey = (t) =>
  JSON.stringify([
    t.convention,
    t.coupling ?? null,
    t.joints.map((j) => [j.type, j.a, j.alpha, j.d, j.theta, j.sign, j.offset]),
  ]);

/** @param looks {shapes, notes} from the library, or null; `files` finds meshes that a person opened, by their name */
export function take(looks, table, files = null) {
  state.looks = looks?.shapes.length ? { ...looks, key: looksKey(table), files } : null;
  if (looks?.notes.length) say(`Of its looks: ${looks.notes.join(' ')}`, looks.shapes.length ? 'plain' : 'wrong');
  build();
}
/** Whether what is known of looks is of the arm on the page. */
export const known = () => Boolean(state.looks && state.looks.key === looksKey(state.table));
export const mode = () => (known() ? state.look.mode : 'sketch');

let builtFor = null;
function build() {
  if (builtFor === state.looks) return;
  builtFor = state.looks;
  for (const s of shapes) for (const g of new Set([s.fine, s.some, s.few])) g.dispose();
  shapes = [];
  group.clear();
  const mine = builtFor;
  for (const s of mine?.shapes ?? []) {
    if (s.kind !== 'mesh') {
      add(s, [primitives[s.kind](s.size)], s.colour);
      continue;
    }
    const source = s.url ? { url: s.url } : { file: mine.files?.(s.file) };
    if (!source.url && !source.file) continue;
    loading += 1;
    load(source, s.url ?? s.file)
      .then((parts) => {
        if (builtFor !== mine) return;
        for (const { mesh, colour } of parts) {
          const fine = geometryOf(mesh),
            some = mesh.some === mesh ? fine : geometryOf(mesh.some);
          add(
            s,
            [fine, some, mesh.few === mesh.some ? some : geometryOf(mesh.few)],
            s.colour ?? colour,
            s.size,
            mesh.closed,
          );
        }
      })
      .catch((error) => say(`${s.name}: ${error.message}`, 'wrong'))
      .finally(() => {
        loading -= 1;
        place();
        if (loading) return;
        wear(corners);
        tell('looks', 'loaded');
      });
  }
  tell('looks');
  place();
  wear(corners);
}
/** Corners of the boxes about the shapes, where the frames F put them; none while they are not shown. */
function corners(F) {
  if (mode() === 'sketch') return [];
  return shapes
    .filter((s) => F[s.on])
    .flatMap((s) => {
      at.set(...F[s.on]);
      return s.corners.map((p) => corner.copy(p).applyMatrix4(at).toArray());
    });
}
const corner = new THREE.Vector3();
const upright = (g) => g.rotateX(Math.PI / 2);
const primitives = {
  box: (v) => new THREE.BoxGeometry(...v),
  cylinder: ([r, h]) => upright(new THREE.CylinderGeometry(r, r, h, 36)),
  capsule: ([r, h]) => upright(new THREE.CapsuleGeometry(r, h, 8, 24)),
  sphere: ([r]) => new THREE.SphereGeometry(r, 28, 16),
};
function geometryOf(m) {
  const g = new THREE.BufferGeometry();
  g.setAttribute('position', new THREE.BufferAttribute(m.at, 3));
  g.setAttribute('normal', m.normal.length === m.at.length ? new THREE.BufferAttribute(m.normal, 3) : packed(m.normal));
  g.setIndex(new THREE.BufferAttribute(m.index, 1));
  return g;
}
/** Normals of three bytes and one that fills up to four, as graphics want them. */
function packed(normal) {
  return new THREE.InterleavedBufferAttribute(new THREE.InterleavedBuffer(normal, 4), 3, 0, true);
}
function add(s, [fine, some = fine, few = some], colour, scale = null, closed = true) {
  const material = solid(closed);
  const mesh = new THREE.Mesh(fine, material),
    shadow = new THREE.Mesh(few, shadowMaterial);
  const T = new THREE.Matrix4().set(...s.T);
  if (scale) T.scale(new THREE.Vector3(...scale));
  for (const m of [mesh, shadow]) {
    m.matrixAutoUpdate = false;
    m.frustumCulled = false;
  }
  shadow.renderOrder = -1;
  group.add(mesh, shadow);
  few.computeBoundingBox();
  const { min, max } = few.boundingBox,
    corners = [min.x, max.x].flatMap((x) =>
      [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new THREE.Vector3(x, y, z).applyMatrix4(T))),
    );
  shapes.push({ on: s.on, T, fine, some, few, mesh, shadow, colour, corners });
  paint();
}

const at = new THREE.Matrix4();
function place() {
  arrange();
  invalidate();
}
/** Put every shape where its link is; the picture is somebody else's to ask for. */
function arrange() {
  const now = mode();
  group.visible = now !== 'sketch' && shapes.length > 0;
  // until the meshes are here the sketch stands for them
  showSketch(now !== 'real' || loading > 0, now !== 'sketch' && shapes.length > 0);
  if (!group.visible) return;
  for (const s of shapes) {
    const F = state.frames[s.on];
    if (!F) continue;
    s.mesh.geometry = moving ? s.few : bySoftware() ? s.some : s.fine;
    s.mesh.matrix.copy(at.set(...F)).multiply(s.T);
    s.shadow.matrix.copy(shadowMatrix).multiply(s.mesh.matrix);
    s.mesh.matrixWorldNeedsUpdate = s.shadow.matrixWorldNeedsUpdate = true;
  }
}
function paint() {
  const whole = mode() === 'both' ? state.look.opacity : 1;
  for (const { mesh, colour } of shapes) {
    const [r, g, b, a] = colour ?? [];
    if (colour) mesh.material.colour.setRGB(r, g, b, THREE.SRGBColorSpace);
    else mesh.material.colour.set(colours.dark ? PLAIN.dark : PLAIN.light);
    mesh.material.see((a ?? 1) * whole, colours.dark);
  }
  invalidate();
}

/** Show the arm as sketched, as it looks, or both, the looks so far see-through. */
export function setLook(change) {
  state.look = { ...state.look, ...change };
  paint();
  place();
  wear(corners);
  tell('look');
}

export function begin() {
  scene.add(group);
  on('table', () => {
    place();
    paint();
    tell('looks');
  });
  on('q', place);
  on('theme', paint);
  on('look', (what) => {
    if (what !== 'loaded') return;
    paint();
    place();
  });
  on('hurry', (yes) => {
    moving = yes;
    // asked in the middle of a picture, or for one that is drawn at once
    arrange();
  });
}
/** What is drawn of the looks, for tests: how many shapes, triangles at rest and in motion, how many still load. */
export const looksDrawn = () => ({
  mode: mode(),
  visible: group.visible,
  loading,
  shapes: shapes.length,
  triangles: shapes.reduce((n, s) => n + (s.fine.index?.count ?? 0) / 3, 0),
  few: shapes.reduce((n, s) => n + (s.few.index?.count ?? 0) / 3, 0),
  places: shapes.map((s) => s.mesh.matrix.clone().transpose().toArray()),
});
