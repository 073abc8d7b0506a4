// How finely to draw. A graphics card smooths edges by itself; a software renderer draws coarsely while things move, as
// coarsely as it must to keep up with the hand, and once finely when they have come to rest.
const LEVELS = [1, 0.75, 0.55, 0.42];
/** Milliseconds between pictures above which the next coarser level is taken, and below which the next finer one. */
const SLOW = 30,
  FAST = 17;
const REST = 400;
/** Pixels of a picture at rest, at most. */
const MOST = 6e6;

/** Whether WebGL is drawn by the processor here. */
export function drawnInSoftware(gl) {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return /swiftshader|llvmpipe|software|basic render/i.test(
    String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)),
  );
}

export class Quality {
  /** @param hurry called with true when things begin to move and with false when they rest, where the processor draws */
  constructor(software, renderer, draw, hurry) {
    this.software = software;
    this.renderer = renderer;
    this.draw = draw;
    this.hurry = hurry;
    this.resting = true;
    this.level = 0;
    this.gaps = [];
    this.last = 0;
    this.area = 1;
  }

  resized(width, height) {
    this.area = width * height;
  }

  /** The person's pixels, as many as a picture can afford. */
  get base() {
    return Math.min(devicePixelRatio, 2, Math.sqrt(MOST / this.area));
  }

  #use(ratio) {
    if (Math.abs(this.renderer.getPixelRatio() - ratio) > 1e-3) this.renderer.setPixelRatio(ratio);
  }

  /** Before every picture. */
  moving(now) {
    if (!this.software) {
      this.#use(this.base);
      return;
    }
    const gap = now - this.last;
    this.last = now;
    if (gap < 120) this.gaps.push(gap);
    if (this.gaps.length >= 8) {
      const middle = this.gaps.sort((a, b) => a - b)[4];
      this.gaps = [];
      if (middle > SLOW && this.level < LEVELS.length - 1) this.level += 1;
      else if (middle < FAST && this.level > 0) this.level -= 1;
    }
    if (this.resting) this.hurry(true);
    this.resting = false;
    this.#use(this.base * LEVELS[this.level]);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.gaps = [];
      this.resting = true;
      this.hurry(false);
      this.#use(Math.min(2 * this.base, Math.max(Math.sqrt(MOST / this.area), 0.5)));
      this.draw();
    }, REST);
  }
}
