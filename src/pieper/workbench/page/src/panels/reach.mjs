// Where the tool can be: a cloud of random postures, or a map of voxels solved completely, coloured by a value.
import { button, choice, h, replace, select, setText } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { units, showUnit, engineering } from '../units.mjs';
import { ask, Offline } from '../link.mjs';
import { BACK } from './long_question.mjs';
import { armNumber, askArm } from '../library.mjs';
import { reach } from '../kinematics.mjs';
import { showBeside, fitArm } from '../scene/arm.mjs';
import * as cloud from '../scene/cloud.mjs';
import * as voxels from '../scene/voxels.mjs';

const counted = (v) => v.toLocaleString('en');
/** How many voxels there are along an arm that reaches as far as its links are long. */
const FINENESS = { coarse: 12, middling: 20, fine: 32 };
/** Sides of voxels are 1, 2, 2.5 or 5 times a power of ten. */
function voxelSide(fineness) {
  const raw = (2 * reach(state.table)) / FINENESS[fineness],
    ten = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 2.5, 5, 10].map((k) => k * ten).findLast((s) => s <= raw * 1.0001);
}

/** The two ways to see it: what is asked, how its pieces are drawn, and what is said at the end. */
const kinds = {
  cloud: {
    scene: cloud,
    colours: [
      ['manipulability', 'manipulability'],
      ['height', 'height of the tool', (v) => showUnit(v, 'length')],
      ['condition', 'inverse condition number'],
      ['limits', 'distance to the limits'],
    ],
    sizes: [
      ['20000', '20,000 points'],
      ['5000', '5,000 points'],
      ['100000', '100,000 points'],
    ],
    begin: (size) => cloud.begin(Number(size)),
    asked: (size, colour) => ({ count: Number(size), colour, seed: 1 }),
    piece: (m) => cloud.take(m.points),
    progress: (m) => `${counted(m.done)} of ${counted(m.of)} points`,
    stopped: () => `Cancelled after ${counted(cloud.size())} points.`,
    ended: (end, colour) => `${counted(end.done)} random postures inside the limits, coloured by ${colour}.`,
  },
  voxels: {
    scene: voxels,
    colours: [
      ['fraction', 'share of orientations'],
      ['count', 'number of solutions in all orientations', (v) => counted(Math.round(v))],
      ['manipulability', 'best manipulability'],
      ['margin', 'distance to the limits'],
    ],
    sizes: [
      ['middling', 'middling voxels'],
      ['coarse', 'coarse voxels'],
      ['fine', 'fine voxels'],
    ],
    begin: () => voxels.clear(),
    asked: (size, colour) => ({ step: voxelSide(size), colour }),
    piece: (m) => (m.low ? voxels.begin(m) : voxels.take(m.points)),
    progress: (m) => `${Math.round((100 * m.done) / m.of)} % solved`,
    stopped: () => `Cancelled after ${counted(voxels.size())} voxels.`,
    ended: (end, colour, size) =>
      `${counted(end.reached)} voxels of ${showUnit(voxelSide(size), 'length', units.length === 'mm' ? 0 : 3)} are reached inside the limits in some of ${end.orientations} orientations, ${end.volume.toPrecision(3)} m³ together; coloured by ${colour}. Each is solved at its centre.`,
  },
};

export function reachControls() {
  let kind = 'cloud',
    running = false,
    away = false, // whether it was the server being away that was said
    drawn = null; // what the picture is coloured by
  const picked = { size: null, colour: null };
  const start = button('', { class: 'primary', 'data-testid': 'reach-start' }, () =>
    running ? ask('cancel', { kind: running }) : run(),
  );
  const clear = button('Clear', {}, wipe);
  const share = h('input', {
    type: 'range',
    min: '-1',
    max: '1',
    step: 'any',
    value: '0',
    hidden: true,
    'aria-label': 'Where it is cut',
    'data-testid': 'reach-cut-at',
    on: { input: cutNow },
  });
  let half = false;
  const cut = choice(
    'Shown',
    [
      ['whole', 'Whole'],
      ['half', 'Cut open'],
    ],
    'whole',
    (v) => {
      half = v === 'half';
      share.hidden = !half;
      cutNow();
    },
    'reach-cut',
  );
  function cutNow() {
    const at = half ? state.table.base[7] + Number(share.value) * reach(state.table) : null;
    share.style.setProperty('--at', `${50 * (1 + Number(share.value))}%`);
    for (const { scene } of Object.values(kinds)) scene.cutAt(at);
  }
  const progress = h('progress', {
    max: '1',
    'aria-label': 'Progress',
    'data-testid': 'reach-progress',
    hidden: true,
  });
  const note = h('p', { class: 'hint', role: 'status', 'data-testid': 'reach-note' });
  const lo = h('span'),
    hi = h('span');
  const legend = h('div', { class: 'legend-scale', hidden: true }, lo, h('span', { class: 'scale-bar' }), hi);
  const options = h('div', { class: 'line' });
  /** What the ends of the scale stand for: the few values beyond are drawn like them. */
  function scale() {
    if (!drawn) return;
    const { range } = kinds[drawn.kind].scene,
      figure = kinds[drawn.kind].colours.find(([k]) => k === drawn.colour)[2] ?? engineering;
    setText(lo, `≤ ${figure(range.lo)}`);
    setText(hi, `≥ ${figure(range.hi)}`);
  }
  on('units', scale);
  on('online', (yes) => {
    if (yes && away) setText(note, BACK);
    away = false;
  });
  function wipe() {
    drawn = null;
    away = false;
    for (const { scene } of Object.values(kinds)) scene.clear();
    showBeside('reach', []);
    legend.hidden = true;
    setText(note, '');
  }
  async function run() {
    const mine = kinds[kind],
      arm = armNumber(),
      { size, colour } = picked,
      named = mine.colours.find(([k]) => k === colour)[1];
    wipe();
    running = kind;
    drawn = { kind, colour };
    setText(start, 'Cancel');
    progress.hidden = legend.hidden = false;
    progress.value = 0;
    mine.begin(size);
    try {
      const end = await askArm(kind, mine.asked(size, colour), (m) => {
        if (arm !== armNumber()) return; // a piece of another arm's
        mine.piece(m);
        progress.value = m.done / m.of;
        scale();
        setText(note, mine.progress(m));
      });
      setText(note, end.stopped ? mine.stopped() : mine.ended(end, named, size));
    } catch (error) {
      away = error instanceof Offline;
      setText(note, error.message);
    }
    running = false;
    legend.hidden = !mine.scene.size();
    showBeside('reach', mine.scene.corners());
    fitArm();
    words();
    progress.hidden = true;
  }
  const words = () => running || setText(start, kind === 'cloud' ? 'Draw the cloud' : 'Draw the map');
  function show() {
    const { sizes, colours } = kinds[kind];
    picked.size = sizes[0][0];
    picked.colour = colours[0][0];
    const pick = (what) => (v) => {
      picked[what] = v;
    };
    replace(
      options,
      select('How many', sizes, picked.size, pick('size'), { 'data-testid': 'reach-size' }),
      h('span', { class: 'field-name', text: 'coloured by' }),
      select('Coloured by', colours, picked.colour, pick('colour'), { 'data-testid': 'reach-colour' }),
    );
    words();
  }
  on('table', (what) => {
    if (what === 'postures' || what === 'name') return;
    if (running) ask('cancel', { kind: running });
    if (cloud.size() || voxels.size()) wipe();
  });
  show();
  return h(
    'div',
    {},
    choice(
      'Drawn as',
      [
        ['cloud', 'Cloud'],
        ['voxels', 'Map'],
      ],
      kind,
      (v) => {
        kind = v;
        show();
      },
      'reach-kind',
    ),
    h('p', {
      class: 'hint',
      text: 'A cloud is of random postures. A map asks every voxel completely, which takes minutes for arms without a closed form or with joints to spare.',
    }),
    options,
    h('div', { class: 'line' }, start, clear, cut, share),
    progress,
    legend,
    note,
  );
}
