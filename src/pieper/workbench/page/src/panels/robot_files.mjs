// Robot files: the arm written as one, and one read as the arm.
import { button, download, h, say, unreadable } from '../dom.mjs';
import { state, setTable, presentable } from '../store.mjs';
import { ask } from '../link.mjs';
import { askArm } from '../library.mjs';
import { take } from '../scene/looks.mjs';
import { armSection } from './long_question.mjs';

export async function saveRobot() {
  const bad = unreadable(armSection());
  if (bad) {
    say(`${bad} Nothing was written.`, 'wrong');
    return;
  }
  try {
    download(`${state.table.name || 'arm'}.toml`, (await askArm('save', {})).text, 'application/toml');
  } catch (error) {
    say(error.message, 'wrong');
  }
}
/** Two buttons: a robot file alone, or a folder with one and its meshes. */
export function robotOpeners() {
  const one = (text, title, props) => {
    const input = h('input', {
      type: 'file',
      class: 'offscreen',
      tabindex: '-1',
      ...props,
      on: { change: () => openRobot(input) },
    });
    return [button(text, { title }, () => input.click()), input];
  };
  return [
    ...one('Open…', 'A robot file (.toml) or a URDF', {
      accept: '.toml,.urdf,.xml',
      'aria-label': 'Robot file',
      'data-testid': 'robot-file',
    }),
    ...one('Folder…', 'A folder with a URDF and the meshes that it names; they stay in this browser', {
      webkitdirectory: true,
      multiple: true,
      'aria-label': 'Folder with a robot file and its meshes',
      'data-testid': 'robot-folder',
    }),
  ];
}

/** Robot files by their endings; a folder has as a rule one of them, and the meshes that it names. */
const ROBOT = /\.(toml|urdf|xml)$/i;
const MOST = 200_000;
/** Open a robot file, or a folder with one and the meshes that it names, which stay in this browser. */
async function openRobot(input) {
  const files = [...input.files];
  input.value = '';
  if (!files.length) return;
  const robots = files.filter((f) => ROBOT.test(f.name)),
    file = files.length === 1 ? files[0] : (robots.find((f) => /\.urdf$/i.test(f.name)) ?? robots[0]);
  if (!file) {
    say('There is no robot file (.urdf or .toml) in this folder.', 'wrong');
    return;
  }
  if (file.size > MOST) {
    say(`${file.name} has ${file.size} bytes; a robot file has at most ${MOST.toLocaleString('en')}.`, 'wrong');
    return;
  }
  try {
    const { table, looks } = await ask('open', { name: file.name.slice(-80), text: await file.text() });
    setTable(table, { q: presentable(table), what: 'new', label: `open ${file.name.slice(-40)}` });
    take(looks, table, (name) => meshNamed(files, name));
    const missing = looks?.shapes.filter((s) => s.file && !meshNamed(files, s.file)).length;
    if (missing) say(`${missing} of its meshes were not opened with it: open the folder that holds them.`);
  } catch (error) {
    say(error.message, 'wrong');
  }
}
/** The file that a robot file names so: the one whose path ends like it, most of it. */
function meshNamed(files, name) {
  const parts = name.replace(/^\w+:\/\//, '').split('/');
  const alike = (f) => {
    const own = (f.webkitRelativePath || f.name).split('/');
    let k = 0;
    while (k < parts.length && k < own.length && parts.at(-1 - k) === own.at(-1 - k)) k += 1;
    return k;
  };
  return files.reduce((best, f) => (alike(f) > (best ? alike(best) : 0) ? f : best), null);
}
