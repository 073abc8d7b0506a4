// The handles on the target: arrows to move it, rings to turn it.
import * as THREE from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import { state, on, setTarget } from '../store.mjs';
import { scene, camera, renderer, controls, invalidate } from './view.mjs';

const handle = new THREE.Object3D();
const tools = [];
let mode = 'both',
  space = 'local',
  shown = false,
  dragging = false;
export const isDragging = () => dragging;

export function begin() {
  scene.add(handle);
  on('target', place);
}

/** The tools are made when they are first shown: a first picture does without them. */
function make() {
  for (const [name, size] of [
    ['translate', 0.75],
    ['rotate', 0.55],
  ]) {
    const tool = new TransformControls(camera, renderer.domElement);
    tool.setMode(name);
    tool.setSize(size);
    tool.setSpace(space);
    tool.attach(handle);
    tool.addEventListener('dragging-changed', ({ value }) => {
      controls.enabled = !value;
      dragging = value;
      // Two tools listen to one pointer: the one that is in the hand silences the other.
      for (const other of tools) if (other !== tool) other.enabled = !value && shown;
      if (!value) setTarget(state.target, 'dropped');
    });
    tool.addEventListener('change', invalidate);
    tool.addEventListener('objectChange', () => {
      handle.updateMatrix();
      const e = handle.matrix.elements;
      setTarget([e[0], e[4], e[8], e[12], e[1], e[5], e[9], e[13], e[2], e[6], e[10], e[14], 0, 0, 0, 1], 'drag');
    });
    lighten(tool.getHelper());
    tools.push(tool);
    scene.add(tool.getHelper());
  }
}

/** Rings of half as many pieces: they look the same, and where the processor draws, triangles are what a picture costs. */
function lighten(helper) {
  helper.traverse(({ geometry }) => {
    if (geometry?.type !== 'TorusGeometry') return;
    const { radialSegments, tubularSegments } = geometry.parameters,
      row = tubularSegments + 1,
      index = [];
    if (tubularSegments < 64) return;
    for (let j = 1; j <= radialSegments; j++)
      for (let i = 0; i + 2 <= tubularSegments; i += 2) {
        const [a, b, c, d] = [row * j + i, row * (j - 1) + i, row * (j - 1) + i + 2, row * j + i + 2];
        index.push(a, b, d, b, c, d);
      }
    geometry.setIndex(index);
  });
}

function place(why) {
  if (why === 'drag' || why === 'dropped') return;
  const T = state.target;
  handle.matrix.set(...T);
  handle.matrix.decompose(handle.position, handle.quaternion, handle.scale);
  handle.scale.set(1, 1, 1);
  handle.updateMatrixWorld(true);
  invalidate();
}
function apply() {
  tools.forEach((tool, i) => {
    const yes = shown && (mode === 'both' || mode === (i === 0 ? 'move' : 'turn'));
    tool.enabled = yes;
    tool.getHelper().visible = yes;
  });
  invalidate();
}
export function show(yes) {
  shown = yes;
  if (yes && !tools.length) make();
  apply();
}
export function setMode(name) {
  mode = name;
  apply();
}
/** Along the target's own axes or along those of the world. */
export function setSpace(name) {
  space = name;
  for (const tool of tools) tool.setSpace(name);
  invalidate();
}
