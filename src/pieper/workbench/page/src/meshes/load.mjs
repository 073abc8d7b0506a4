// A mesh file becomes parts to draw: fetched from the user's folder or taken from a file that a person opened.
import { readDae } from './dae.mjs';

/** Two read at once: one waits for the disk while the other welds. */
const workers = [];
const waiting = new Map();
let count = 0;
function worker() {
  if (workers.length < 2) {
    const w = new Worker('meshes.js', { type: 'module' });
    w.onmessage = ({ data: { id, mesh, error } }) => {
      const { resolve, reject } = waiting.get(id);
      waiting.delete(id);
      if (error) reject(new Error(error));
      else resolve(mesh);
    };
    w.onerror = () => {
      for (const { reject } of waiting.values()) reject(new Error('meshes cannot be read in this browser'));
      waiting.clear();
    };
    workers.push(w);
    return w;
  }
  return workers[count % workers.length];
}
function welded(message, transfer) {
  return new Promise((resolve, reject) => {
    count += 1;
    waiting.set(count, { resolve, reject });
    worker().postMessage({ id: count, ...message }, transfer);
  });
}

/**
 * @param source {url} or {file: File}
 * @returns [{mesh, colour}]: `mesh` as `weld` makes it
 */
export async function load(source, name) {
  const kind = name.split('.').at(-1).toLowerCase();
  let bytes;
  if (source.file) bytes = await source.file.arrayBuffer();
  else {
    const answer = await fetch(source.url);
    if (!answer.ok) throw new Error(`${name} cannot be fetched`);
    bytes = await answer.arrayBuffer();
  }
  if (kind === 'dae') {
    const parts = readDae(new TextDecoder().decode(bytes));
    return Promise.all(parts.map(async ({ at, colour }) => ({ mesh: await welded({ at }, [at.buffer]), colour })));
  }
  return [{ mesh: await welded({ bytes, kind }, [bytes]), colour: null }];
}
