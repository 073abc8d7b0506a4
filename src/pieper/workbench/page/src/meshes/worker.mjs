// Beside the page: triangles read and welded while the picture goes on.
import { readObj, readStl } from './read.mjs';
import { weld } from './weld.mjs';

addEventListener('message', ({ data: { id, bytes, kind, at } }) => {
  try {
    const mesh = weld(at ?? (kind === 'obj' ? readObj(bytes) : readStl(bytes)));
    const buffers = [mesh, mesh.some, mesh.few].flatMap((m) => [m.at.buffer, m.normal.buffer, m.index.buffer]);
    postMessage({ id, mesh }, [...new Set(buffers)]);
  } catch (error) {
    postMessage({ id, error: error.message });
  }
});
