// Coordinate frames as three arrows, x red, y green, z blue, with the frame's name beside its origin.
import * as THREE from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { colours } from '../theme.mjs';
import identity from '../../../../document/identity.json';

export const axisColours = identity.axes;

function arrow(colour, turn) {
  const shaft = new THREE.CylinderGeometry(0.028, 0.028, 0.82, 8).translate(0, 0.41, 0);
  const head = new THREE.ConeGeometry(0.085, 0.22, 12).translate(0, 0.9, 0);
  const g = mergeGeometries([shaft, head]).applyMatrix4(turn);
  const c = new THREE.Color(colour),
    rgb = new Float32Array(g.attributes.position.count * 3);
  for (let i = 0; i < rgb.length; i += 3) rgb.set([c.r, c.g, c.b], i);
  g.setAttribute('color', new THREE.BufferAttribute(rgb, 3));
  return g;
}
const along = (axis) =>
  new THREE.Matrix4().makeRotationFromQuaternion(
    new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(...axis)),
  );
const glyph = mergeGeometries([
  arrow(axisColours[0], along([1, 0, 0])),
  arrow(axisColours[1], along([0, 1, 0])),
  arrow(axisColours[2], along([0, 0, 1])),
]);

/** Height of a label as a share of the picture's. */
const LETTER = 0.021;
const labels = new Map();
function label(text) {
  const key = `${text}/${colours.dark}`;
  if (labels.has(key)) return labels.get(key);
  const canvas = document.createElement('canvas'),
    k = 4,
    c = canvas.getContext('2d', { willReadFrequently: true });
  const font = `600 ${13 * k}px "Inter Variable", system-ui, sans-serif`;
  c.font = font;
  canvas.width = c.measureText(text).width + 12 * k;
  canvas.height = 20 * k;
  c.font = font;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  c.lineWidth = 4 * k;
  c.lineJoin = 'round';
  c.strokeStyle = colours.ground;
  c.strokeText(text, canvas.width / 2, canvas.height / 2);
  c.fillStyle = colours.ink;
  c.fillText(text, canvas.width / 2, canvas.height / 2);
  const map = new THREE.CanvasTexture(canvas);
  map.colorSpace = THREE.SRGBColorSpace;
  const material = new THREE.SpriteMaterial({ map, depthTest: false, sizeAttenuation: false, fog: false });
  material.userData.aspect = canvas.width / canvas.height;
  labels.set(key, material);
  return material;
}

export class Frames {
  constructor() {
    this.group = new THREE.Group();
    this.mesh = new THREE.InstancedMesh(glyph, new THREE.MeshBasicMaterial({ vertexColors: true, fog: false }), 64);
    this.mesh.frustumCulled = false;
    this.mesh.count = 0;
    this.sprites = [];
    this.group.add(this.mesh);
  }

  show(list, size) {
    this.last = [list, size];
    const m = new THREE.Matrix4();
    this.mesh.count = list.length;
    this.sprites.forEach((s, i) => {
      s.visible = i < list.length;
    });
    list.forEach(({ T, name }, i) => {
      this.mesh.setMatrixAt(i, m.set(...T).scale(new THREE.Vector3(size, size, size)));
      const sprite = this.sprites[i] ?? (this.sprites[i] = new THREE.Sprite());
      if (!sprite.parent) this.group.add(sprite);
      sprite.material = label(name);
      sprite.scale.set(LETTER * sprite.material.userData.aspect, LETTER, 1);
      sprite.renderOrder = 5;
      const d = size * 0.16;
      sprite.position.set(
        T[3] - d * (T[0] + T[1] + T[2]),
        T[7] - d * (T[4] + T[5] + T[6]),
        T[11] - d * (T[8] + T[9] + T[10]),
      );
    });
    this.mesh.instanceMatrix.needsUpdate = true;
    this.mesh.visible = list.length > 0;
  }

  /** After a change of colours or letters. */
  paint() {
    for (const material of labels.values()) {
      material.map.dispose();
      material.dispose();
    }
    labels.clear();
    if (this.last) this.show(...this.last);
  }
}
