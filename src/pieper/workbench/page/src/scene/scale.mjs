// From values to colours: one scale, dark to light, that reads in grey too (after viridis), and the figures at its ends.
import * as THREE from 'three';

const stops = ['#440154', '#414487', '#2a788e', '#22a884', '#7ad151', '#fde725'].map((c) => new THREE.Color(c));
/** The share of the values at each end that the scale does not stretch for. */
const TAIL = 0.02;

/** Where a scale over values begins and ends. */
export function rangeOf(values) {
  const sorted = Float32Array.from(values).sort(),
    n = sorted.length;
  return { lo: sorted[Math.floor(n * TAIL)] ?? 0, hi: sorted[Math.max(Math.ceil(n * (1 - TAIL)) - 1, 0)] ?? 1 };
}
const mixed = new THREE.Color();
/** The colour of a value, to be read before it is asked again. */
export function colourAt(value, { lo, hi }) {
  const v = Math.min(Math.max((value - lo) / (hi - lo || 1), 0), 1) * (stops.length - 1),
    k = Math.min(Math.floor(v), stops.length - 2);
  return mixed.lerpColors(stops[k], stops[k + 1], v - k);
}
/** Blocks as the server sends them: x, y, z, value as float32, in base64. */
export const unpacked = (base64) => new Float32Array(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);
