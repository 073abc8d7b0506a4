// Triangles out of a DAE (COLLADA 1.4, Khronos 2008), part by part with its colour, in metres and with z up.

const numbers = (el) => (el?.textContent.trim() ?? '').split(/\s+/).filter(Boolean).map(Number);
const under = (el, tag) => [...el.children].filter((c) => c.localName === tag);
const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
function mul(a, b) {
  const out = new Array(16).fill(0);
  for (let i = 0; i < 4; i++)
    for (let j = 0; j < 4; j++) for (let k = 0; k < 4; k++) out[4 * i + j] += a[4 * i + k] * b[4 * k + j];
  return out;
}
function turn([x, y, z, degrees]) {
  const n = Math.hypot(x, y, z) || 1,
    a = (degrees * Math.PI) / 180,
    c = Math.cos(a),
    s = Math.sin(a),
    t = 1 - c;
  [x, y, z] = [x / n, y / n, z / n];
  return [
    ...[t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0],
    ...[t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0],
    ...[t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0],
    ...[0, 0, 0, 1],
  ];
}
const placing = {
  matrix: (v) => v,
  translate: ([x, y, z]) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1],
  scale: ([x, y, z]) => [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1],
  rotate: turn,
};
/** What leads from the file's axes to x ahead and z up. */
const UP = {
  X_UP: [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  Y_UP: [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1],
};

/** @returns [{at: nine numbers a triangle, colour: [r, g, b, a] or null}] */
export function readDae(text) {
  const doc = new DOMParser().parseFromString(text, 'application/xml');
  if (doc.querySelector('parsererror') || doc.documentElement.localName !== 'COLLADA')
    throw new Error('this is no DAE');
  const all = (tag) => [...doc.getElementsByTagName('*')].filter((e) => e.localName === tag);
  const byId = new Map(
    [...doc.getElementsByTagName('*')]
      .filter((e) => e.id || e.getAttribute('id'))
      .map((e) => [e.getAttribute('id'), e]),
  );
  const find = (url) => byId.get((url ?? '').replace(/^#/, ''));
  const metre = Number(all('unit')[0]?.getAttribute('meter') ?? 1) || 1;
  const up = UP[all('up_axis')[0]?.textContent.trim()] ?? identity();
  const parts = [];

  function colourOf(material) {
    const effect = find(under(find(material) ?? doc.documentElement, 'instance_effect')[0]?.getAttribute('url'));
    const diffuse = effect && [...effect.getElementsByTagName('*')].find((e) => e.localName === 'diffuse');
    const v = diffuse ? numbers(under(diffuse, 'color')[0]) : [];
    return v.length >= 3 ? [v[0], v[1], v[2], v[3] ?? 1] : null;
  }
  function pointsOf(vertices) {
    const input = under(vertices, 'input').find((i) => i.getAttribute('semantic') === 'POSITION');
    const source = find(input?.getAttribute('source'));
    return source ? numbers(under(source, 'float_array')[0]) : [];
  }
  function take(geometry, T, bound) {
    const mesh = geometry && under(geometry, 'mesh')[0];
    if (!mesh) return;
    for (const group of mesh.children) {
      if (!['triangles', 'polylist', 'polygons'].includes(group.localName)) continue;
      const inputs = under(group, 'input'),
        stride = 1 + Math.max(...inputs.map((i) => Number(i.getAttribute('offset') ?? 0)));
      const vertex = inputs.find((i) => i.getAttribute('semantic') === 'VERTEX');
      if (!vertex) continue;
      const at = Number(vertex.getAttribute('offset') ?? 0),
        points = pointsOf(find(vertex.getAttribute('source')));
      const lists = under(group, 'p').map(numbers);
      const counts =
        group.localName === 'polylist'
          ? numbers(under(group, 'vcount')[0])
          : group.localName === 'polygons'
            ? lists.map((l) => l.length / stride)
            : new Array(lists.reduce((n, l) => n + l.length, 0) / stride / 3).fill(3);
      const index = lists.flat(),
        out = [];
      let from = 0;
      const corner = (k) => {
        const i = 3 * index[(from + k) * stride + at],
          [x, y, z] = [points[i], points[i + 1], points[i + 2]];
        for (let r = 0; r < 3; r++)
          out.push(metre * (T[4 * r] * x + T[4 * r + 1] * y + T[4 * r + 2] * z + T[4 * r + 3]));
      };
      for (const n of counts) {
        for (let k = 2; k < n; k++) for (const c of [0, k - 1, k]) corner(c);
        from += n;
      }
      if (out.length && out.every(Number.isFinite))
        parts.push({ at: Float32Array.from(out), colour: colourOf(bound.get(group.getAttribute('material'))) });
    }
  }
  function walk(node, T, depth) {
    if (depth > 60) return;
    for (const el of node.children) if (placing[el.localName]) T = mul(T, placing[el.localName](numbers(el)));
    for (const el of node.children) {
      if (el.localName === 'instance_geometry') {
        const bound = new Map(
          [...el.getElementsByTagName('*')]
            .filter((e) => e.localName === 'instance_material')
            .map((e) => [e.getAttribute('symbol'), e.getAttribute('target')]),
        );
        take(find(el.getAttribute('url')), T, bound);
      } else if (el.localName === 'node') walk(el, T, depth + 1);
      else if (el.localName === 'instance_node') {
        const other = find(el.getAttribute('url'));
        if (other) walk(other, T, depth + 1);
      }
    }
  }
  const scene = find(all('instance_visual_scene')[0]?.getAttribute('url')) ?? all('visual_scene')[0];
  if (scene) walk(scene, up, 0);
  if (!parts.length) throw new Error('there is no triangle in this DAE');
  return parts;
}
