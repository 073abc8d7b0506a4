// A motion filmed as it plays: the pictures of the canvas, recorded by the browser as WebM.

/** Record a canvas while `run` goes on (a promise), and return the film; throws where the browser records nothing. */
export async function film(canvas, run) {
  if (!window.MediaRecorder || !canvas.captureStream) throw new Error('This browser records no video.');
  const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: 'video/webm', videoBitsPerSecond: 8e6 });
  const pieces = [];
  recorder.ondataavailable = ({ data }) => data.size && pieces.push(data);
  const ended = new Promise((resolve) => {
    recorder.onstop = resolve;
  });
  recorder.start();
  await run();
  // the last picture at rest belongs to it
  await new Promise((resolve) => setTimeout(resolve, 400));
  recorder.stop();
  await ended;
  return new Blob(pieces, { type: 'video/webm' });
}
