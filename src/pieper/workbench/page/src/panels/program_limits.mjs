// What a program's motion keeps: speeds, accelerations and jerks, as fields.
import { h, replace } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { units } from '../units.mjs';
import { numberField, remake } from '../numberfield.mjs';
import { setLimits, limits } from '../program.mjs';

/** What the motion keeps: the joints that turn, those that slide, the tool. */
export function limitFields() {
  const box = h('div', { class: 'line limits-of' });
  const rebuild = (what) => (what === 'undo' ? fields() : remake(box, fields));
  const fields = () => {
    const types = new Set(state.table.joints.map((j) => j.type));
    const one = (key, text, kind, per, empty) => {
      const f = numberField({
        label: text,
        kind,
        empty,
        testid: `limit-${key}`,
        check: (v) => (v === null || v > 0 ? null : 'more than 0'),
        input: (v) => setLimits({ [key]: v }, `limit the ${text.toLowerCase()}`),
      });
      f.put(limits()[key]);
      if (empty === null) f.placeholder = 'none';
      return h(
        'label',
        { class: 'field' },
        h('span', { class: 'field-name', text: `${text}, ${units.symbol(kind)}${per}` }),
        f,
      );
    };
    const group = (kind, of, name) => [
      one(`${of}_speed`, `${name}speed`, kind, '/s'),
      one(`${of}_acceleration`, `${name}acceleration`, kind, '/s²'),
      one(`${of}_jerk`, `${name}jerk`, kind, '/s³', null),
    ];
    replace(
      box,
      types.has('R') ? group('angle', 'turn', 'Joint ') : null,
      types.has('P') ? group('length', 'slide', 'Slide ') : null,
      one('tool_speed', 'Tool speed', 'length', '/s', null),
    );
  };
  on(['table', 'units'], rebuild);
  on('program', (what) => what !== 'limits' && rebuild(what));
  rebuild();
  return box;
}
