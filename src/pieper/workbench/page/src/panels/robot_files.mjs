// Robot files: the arm written as one, and one read as the arm.
import { download, say } from '../dom.mjs';
import { state, setTable, presentable } from '../store.mjs';
import { ask } from '../link.mjs';
import { askArm } from '../library.mjs';

export async function saveRobot() {
  try {
    download(`${state.table.name || 'arm'}.toml`, (await askArm('save', {})).text, 'application/toml');
  } catch (error) {
    say(error.message, 'wrong');
  }
}
export async function openRobot(input) {
  const file = input.files[0];
  input.value = '';
  if (!file) return;
  if (file.size > 200_000) {
    say(`${file.name} has ${file.size} bytes; a robot file has at most 200,000.`, 'wrong');
    return;
  }
  try {
    const { table } = await ask('open', { name: file.name.slice(-80), text: await file.text() });
    setTable(table, { q: presentable(table), what: 'new', label: `open ${file.name.slice(-40)}` });
  } catch (error) {
    say(error.message, 'wrong');
  }
}
