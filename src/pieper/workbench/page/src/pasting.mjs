// A block of numbers from a clipboard over the fields of a table, or along a list of fields; one step of the history.
import { say } from './dom.mjs';
import { asOne } from './history.mjs';
import { pasted } from './clipboard.mjs';

/** Put rows into fields, from one on; returns how many found a place, were empty, or had no field. */
function fill(rowsOfFields, y, x, rows) {
  const count = { filled: 0, empty: 0, lost: 0 };
  rows.forEach((row, i) =>
    row.forEach((text, k) => {
      const el = rowsOfFields()[y + i]?.[x + k];
      if (!el) count.lost += text ? 1 : 0;
      // an empty cell says something only where a field may be empty
      else if (!text && !el.mayBeEmpty) count.empty += 1;
      else {
        el.value = text;
        el.dispatchEvent(new Event('input', { bubbles: true }));
        el.dispatchEvent(new Event('change', { bubbles: true }));
        count.filled += 1;
      }
    }),
  );
  return count;
}
function sayCount({ filled, empty, lost }) {
  const said = [`Pasted ${filled} number${filled === 1 ? '' : 's'}`];
  if (empty)
    said.push(empty === 1 ? 'an empty cell left what stood there' : `${empty} empty cells left what stood there`);
  if (lost) said.push(`${lost} had no cell`);
  say(`${said.join('; ')}.`, empty || lost ? 'wrong' : 'plain');
}

/** A table whose cells are fields; `room` makes as many rows as are asked for, where it can. */
export function takePastes(body, label, room = () => {}) {
  const fields = () => [...body.rows].map((r) => [...r.querySelectorAll('input.number')]);
  body.addEventListener('paste', (e) => {
    const rows = e.target.matches('input.number') && pasted(e.clipboardData.getData('text'));
    if (!rows) return;
    e.preventDefault();
    const y = fields().findIndex((r) => r.includes(e.target)),
      x = fields()[y].indexOf(e.target);
    asOne(label, () => {
      room(y + rows.length);
      sayCount(fill(fields, y, x, rows));
    });
  });
}
/** A list of fields, which a row or a column is pasted along: a whole one from the first field on. More than there is room for is refused. */
export function takePastesAlong(root, label, fields) {
  root.addEventListener('paste', (e) => {
    const list = fields();
    const at = list.indexOf(e.target),
      entries = at >= 0 && pasted(e.clipboardData.getData('text'))?.flat();
    if (!entries) return;
    e.preventDefault();
    const from = entries.length === list.length ? 0 : at;
    if (entries.length > list.length - from) {
      const room = list.length - from;
      say(`${entries.length} numbers for ${room} field${room === 1 ? '' : 's'}: nothing was pasted.`, 'wrong');
      return;
    }
    asOne(label, () => sayCount(fill(() => [fields()], 0, from, [entries])));
  });
}
