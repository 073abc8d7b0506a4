// Triangles out of mesh files: STL (binary and text) and OBJ, as nine numbers each.

const decoder = new TextDecoder();

/** @param bytes ArrayBuffer of the file */
export function readStl(bytes) {
  const view = new DataView(bytes),
    n = bytes.byteLength >= 84 ? view.getUint32(80, true) : 0;
  if (n && 84 + 50 * n <= bytes.byteLength && !looksLikeText(bytes)) return binary(view, n);
  const numbers = decoder.decode(bytes).matchAll(/vertex\s+(\S+)\s+(\S+)\s+(\S+)/g);
  const out = [];
  for (const [, x, y, z] of numbers) out.push(Number(x), Number(y), Number(z));
  if (out.length >= 9) return Float32Array.from(out.slice(0, out.length - (out.length % 9)));
  if (n && 84 + 50 * n <= bytes.byteLength) return binary(view, n);
  throw new Error('this is no STL');
}
/** Some writers begin binary files with the word "solid": text has a "facet" near its beginning too. */
function looksLikeText(bytes) {
  const head = decoder.decode(new Uint8Array(bytes, 0, Math.min(bytes.byteLength, 600)));
  return /^\s*solid/.test(head) && /\bfacet\b/.test(head);
}
function binary(view, n) {
  const out = new Float32Array(9 * n);
  for (let i = 0; i < n; i++)
    for (let k = 0; k < 9; k++) out[9 * i + k] = view.getFloat32(84 + 50 * i + 12 + 4 * k, true);
  return out;
}

export function readObj(bytes) {
  const points = [],
    out = [];
  for (const line of decoder.decode(bytes).split('\n')) {
    if (line.startsWith('v ')) {
      const [, x, y, z] = line.trim().split(/\s+/);
      points.push([Number(x), Number(y), Number(z)]);
    } else if (line.startsWith('f ')) {
      const corners = line
        .trim()
        .split(/\s+/)
        .slice(1)
        .map((w) => {
          const i = parseInt(w, 10);
          return points[i < 0 ? points.length + i : i - 1];
        });
      if (corners.includes(undefined)) throw new Error('a face of this OBJ names a corner that is not there');
      for (let k = 2; k < corners.length; k++) out.push(...corners[0], ...corners[k - 1], ...corners[k]);
    }
  }
  if (!out.length) throw new Error('there is no face in this OBJ');
  return Float32Array.from(out);
}
