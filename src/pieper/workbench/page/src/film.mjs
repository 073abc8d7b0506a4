// A motion as a film: the pictures of the canvas, recorded by the browser as WebM; or drawn by the library as GIF or MP4.
import { askArm } from './library.mjs';
import { cameraState, invalidate } from './scene/view.mjs';

/** Samples that are sent, at most. */
const MOST = 1500;
/** Bytes of a film without pictures, at most. */
const HEADER = 400;
const TYPES = { gif: 'image/gif', webp: 'image/webp', mp4: 'video/mp4' };
/** Have the library draw a motion; {name, blob}, or null where it was stopped. */
export async function drawn(motion, kind, speed, progress) {
  const every = Math.max(1, Math.ceil(motion.q.length / MOST)),
    rows = motion.q.map((_, i) => i).filter((i) => i % every === 0 || i === motion.q.length - 1);
  const [x, y, z, tx, ty, tz] = cameraState(),
    [dx, dy, dz] = [x - tx, y - ty, z - tz];
  const view = [Math.atan2(dz, Math.hypot(dx, dy)), Math.atan2(dy, dx)].map((v) => (v * 180) / Math.PI);
  const short = (v) => Number(v.toPrecision(8));
  const body = {
    kind,
    speed,
    view,
    q: rows.map((i) => motion.q[i].map(short)),
    t: rows.map((i) => short(motion.seconds[i])),
  };
  const got = await askArm('film', body, ({ done, of }) => progress(done, of));
  if (got.stopped) return null;
  const bytes = Uint8Array.from(atob(got.data), (c) => c.charCodeAt(0));
  return { name: got.name, blob: new Blob([bytes], { type: TYPES[kind] }) };
}

/** Record a canvas while `run` goes on (a promise), and return the film; throws where the browser records nothing. */
export async function film(canvas, run) {
  if (!window.MediaRecorder || !canvas.captureStream) throw new Error('This browser records no video.');
  const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: 'video/webm', videoBitsPerSecond: 8e6 });
  const pieces = [];
  recorder.ondataavailable = ({ data }) => data.size && pieces.push(data);
  const ended = new Promise((resolve) => {
    recorder.onstop = resolve;
  });
  const rest = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  const size = () => pieces.reduce((sum, piece) => sum + piece.size, 0);
  // a busy machine takes a while until it records: what was played before would not be there
  const recorded = async (least) => {
    for (let k = 0; k < 100 && size() <= least; k++) {
      invalidate();
      await rest(100);
    }
  };
  recorder.start(100);
  await recorded(HEADER);
  const still = size();
  await run();
  // the last picture at rest belongs to it
  await rest(400);
  await recorded(still);
  recorder.stop();
  await ended;
  if (size() <= HEADER) throw new Error('The browser recorded no pictures. GIF and MP4 are drawn without it.');
  return new Blob(pieces, { type: 'video/webm' });
}
