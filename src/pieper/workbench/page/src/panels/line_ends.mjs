// The two ends of the line that Path follows and Route turns along: typed, or taken from where the arm stands.
import { button, h } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { poseEditor } from './pose_editor.mjs';

const tool = () => state.frames.at(-1).slice();

/** @param id begins the names that tests find the fields by; `changed` is called after an end was set here */
export function lineEnds(id, changed) {
  const P = state.path,
    own = id === 'path' ? '' : `${id}-`;
  const set = (key, T, label, one) => {
    tell('did', { label, key: one });
    P[key] = T;
    changed();
    tell('path', id);
  };
  const ends = ['from', 'to'].map((key) => {
    const editor = poseEditor(
      key === 'from' ? 'From' : 'To',
      `${id}-${key}`,
      () => P[key],
      (T) => set(key, T, `set “${key}” of the path`, `path-${key}`),
    );
    const capture = button('Take the present pose', { class: 'quiet', 'data-testid': `${own}take-${key}` }, () => {
      set(key, tool(), `take “${key}” of the path`);
      editor.show();
    });
    return { el: h('div', { class: 'end' }, capture, editor.el), show: editor.show };
  });
  const show = () => ends.forEach((e) => e.show());
  on('path', (by) => by !== id && show());
  on('path-loaded', show);
  on('notation', show);
  return { el: h('div', {}, ...ends.map((e) => e.el)), show, showEnd: (k) => ends[k].show() };
}
