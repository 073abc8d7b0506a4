// A text field for one number: expressions, units, arrow-key steps, a mark and a reason when it cannot be read.
import { h } from './dom.mjs';
import { read } from './expression.mjs';
import { plain, units } from './units.mjs';

/**
 * @param options.kind 'angle' | 'length' | 'plain' (or a function that says it)
 * @param options.input called with (value SI, {symbolic, text}) whenever the text reads as a number
 * @param options.commit called the same way when the person is done
 * @param options.empty value that an empty field means (null for "no limit"); undefined when empty is wrong
 */
export function numberField({ label, kind = 'plain', input, commit, empty, testid, title, check }) {
  const kindOf = typeof kind === 'function' ? kind : () => kind;
  const el = h('input', {
    type: 'text',
    class: 'number',
    inputmode: 'decimal',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-label': label,
    'data-testid': testid,
    title,
  });
  let last = null,
    lastText = null;
  const parse = () => {
    if (el.value.trim() === '' && empty !== undefined) return { value: empty, symbolic: false };
    const got = read(el.value, kindOf());
    const reason = check?.(got.value);
    if (reason) throw new Error(reason);
    return got;
  };
  const mark = (reason) => {
    el.classList.toggle('wrong', Boolean(reason));
    if (reason) {
      el.setAttribute('aria-invalid', 'true');
      el.title = reason;
    } else {
      el.removeAttribute('aria-invalid');
      el.title = title ?? '';
    }
    el.dispatchEvent(new CustomEvent('verdict', { bubbles: true, detail: reason ? { label, reason } : null }));
  };
  const hear = (f) => {
    try {
      const got = parse();
      mark(null);
      f?.(got.value, { symbolic: got.symbolic, text: el.value.trim() });
      return true;
    } catch (error) {
      mark(error.message);
      return false;
    }
  };
  el.addEventListener('input', () => hear(input));
  el.addEventListener('change', () => {
    if (hear(commit ?? input)) el.blurred?.();
  });
  el.addEventListener('focus', () => el.select());
  el.addEventListener('keydown', (e) => {
    const way = { ArrowUp: 1, ArrowDown: -1 }[e.key];
    if (e.key === 'Enter') el.select();
    if (!way) return;
    e.preventDefault();
    try {
      const got = parse();
      el.value = plain((got.value ?? 0) + way * units.step(kindOf()) * (e.shiftKey ? 0.1 : 1), kindOf());
      hear(commit ?? input);
    } catch {
      /* the mark says it already */
    }
  });
  /** Show a value unless the person is typing here. */
  el.put = (value, text = null) => {
    if (document.activeElement === el && !el.readOnly) return;
    if (value === last && text === lastText && !el.classList.contains('wrong')) return;
    last = value;
    lastText = text;
    el.value = text ?? (value === null || value === undefined ? '' : plain(value, kindOf()));
    if (el.classList.contains('wrong')) mark(null);
  };
  el.refresh = () => {
    const v = last,
      t = lastText;
    last = NaN;
    el.put(v, t);
  };
  return el;
}
