// A text field for one number: expressions, units, arrow-key steps, a mark and a reason when it cannot be read.
import { h, say } from './dom.mjs';
import { unlessPressed } from './press.mjs';
import { tell } from './store.mjs';
import { read } from './expression.mjs';
import { plain, units } from './units.mjs';

/**
 * @param options.key names the thing that the field is of, where rows are made anew; its testid otherwise
 * @param options.kind 'angle' | 'length' | 'plain' (or a function that says it)
 * @param options.input called with (value SI, {symbolic, text}) whenever the text reads as a number
 * @param options.commit called the same way when the person is done
 * @param options.empty value that an empty field means (null for "no limit"); undefined when empty is wrong
 */
export function numberField({ label, kind = 'plain', input, commit, empty, testid, title, check, key = testid }) {
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
  el.key = key;
  el.mayBeEmpty = empty !== undefined;
  // what holds, as the page last said it or as it was last read here; and how that was written
  let last = null,
    lastText = null,
    shown = '';
  // whether a hand is typing here, and whether something else has come to hold since it did
  let typing = false,
    behind = false;
  const parse = () => {
    if (el.value.trim() === '' && empty !== undefined) return { value: empty, symbolic: false };
    const got = read(el.value, kindOf());
    const reason = check?.(got.value);
    if (reason) throw new Error(reason);
    return got;
  };
  const mark = (reason, aloud = true) => {
    el.classList.toggle('wrong', Boolean(reason));
    if (reason) {
      el.setAttribute('aria-invalid', 'true');
      el.title = reason;
    } else {
      el.removeAttribute('aria-invalid');
      el.title = title ?? '';
    }
    if (aloud) sayWhy(el, reason);
    el.dispatchEvent(new CustomEvent('verdict', { bubbles: true, detail: reason ? { label, reason } : null }));
  };
  const hear = (f) => {
    behind = false;
    try {
      const got = parse();
      mark(null);
      if (f) {
        last = got.value;
        lastText = got.symbolic ? el.value.trim() : null;
      }
      f?.(got.value, { symbolic: got.symbolic, text: el.value.trim() });
      return true;
    } catch (error) {
      mark(error.message);
      return false;
    }
  };
  el.addEventListener('input', () => {
    typing = true;
    hear(input);
  });
  el.addEventListener('change', () => {
    typing = false;
    if (commit || !input) hear(commit);
    else if (behind) write(); // every key was heard already: what came from elsewhere since goes before it
    tell('let-go');
  });
  let came = ''; // what stood here, and could be read, when the person came
  const keep = () => {
    try {
      parse();
      came = el.value;
    } catch {
      /* Escape puts back what could be read */
    }
  };
  el.addEventListener('focus', () => {
    keep();
    if (el.classList.contains('wrong')) sayWhy(el, el.title);
    el.select();
  });
  el.addEventListener('blur', () => {
    typing = false;
    if (behind) write();
    sayWhy(el, null);
  });
  el.addEventListener('keydown', (e) => {
    const inTable = el.closest('table.dh');
    if (e.key === 'Escape' && el.value !== came) {
      e.preventDefault();
      el.value = came;
      typing = false;
      hear(commit ?? input);
      el.select();
      return;
    }
    if (inTable && walk(el, e)) return;
    const way = { ArrowUp: 1, ArrowDown: -1 }[e.key];
    if (e.key === 'Enter') {
      typing = false;
      keep();
      el.select();
    }
    if (!way || (inTable && !e.altKey)) return;
    e.preventDefault();
    try {
      const got = parse();
      el.value = plain((got.value ?? 0) + way * units.step(kindOf()) * (e.shiftKey ? 0.1 : 1), kindOf());
      hear(commit ?? input);
    } catch {
      /* the mark says it already */
    }
  });
  const unread = () => el.classList.contains('wrong');
  const write = () => {
    behind = false;
    shown = lastText ?? (last === null || last === undefined ? '' : plain(last, kindOf()));
    el.value = shown;
    wholeNumber(el);
    if (unread()) mark(null);
  };
  /** Show a value unless a hand is typing here, or has left what cannot be read and nothing else holds since; `anew`: it does. */
  el.put = (value, text = null, anew = false) => {
    const held = value === last && !anew,
      same = held && text === lastText;
    last = value;
    lastText = text;
    const here = document.activeElement === el && !el.readOnly;
    if (here && (typing || unread())) {
      behind ||= !held;
      return;
    }
    if (same && (here || unread() || el.value === shown)) return;
    const whole = here && el.selectionStart === 0 && el.selectionEnd === el.value.length;
    write();
    came = el.value;
    if (whole) el.select();
  };
  /** Give up what stands here and cannot be read. */
  el.giveUp = write;
  /** What stood in the field that this one is in place of, and could not be read. */
  el.leave = (text) => {
    el.value = text;
    try {
      parse();
    } catch (error) {
      mark(error.message, false);
    }
  };
  el.addEventListener('input', () => wholeNumber(el));
  widths.observe(el);
  el.refresh = () => {
    if (!unread() && document.activeElement !== el) write();
  };
  return el;
}

/**
 * Make rows anew: what stands in one of their fields and cannot be read goes to the new field of the same thing. Of fields that
 * are no more it is said that what they held before stays.
 */
export function remake(root, make) {
  unlessPressed(root, () => remade(root, make));
}
/** Another arm, or another state: what could not be read was said of the one before. */
export function giveUpUnread(root) {
  for (const el of root.querySelectorAll('.number.wrong')) el.giveUp();
}
function remade(root, make) {
  const left = [...root.querySelectorAll('.number.wrong')];
  make();
  if (!left.length) return;
  const now = new Map([...root.querySelectorAll('.number')].map((f) => [f.key, f]));
  const gone = left.filter((f) => {
    const next = now.get(f.key);
    if (next && next !== f) next.leave(f.value);
    return !next;
  });
  const names = gone.map((f) => `${f.getAttribute('aria-label')} (“${f.value}”)`).join(', ');
  if (names) say(`Could not be read and is given up: ${names}.`, 'wrong');
}

/** A field that becomes narrower, or is first shown, is measured anew. */
const widths = new ResizeObserver((list) =>
  requestAnimationFrame(() =>
    list.forEach(({ target }) => {
      const em = parseFloat(getComputedStyle(target).fontSize);
      // so many letters have room however wide they are
      target.sure = target.shrunk ? 0 : Math.floor((target.clientWidth - 14) / (0.8 * em));
      wholeNumber(target);
    }),
  ),
);
/** The last digit is never cut: long numbers are written smaller. */
function wholeNumber(el) {
  if (el.value.length <= el.sure && !el.shrunk) return;
  const room = el.clientWidth;
  if (!room) return; // once it is shown
  el.style.removeProperty('font-size');
  el.shrunk = false;
  if (el.scrollWidth <= room) return;
  const size = parseFloat(getComputedStyle(el).fontSize);
  el.style.setProperty(
    'font-size',
    `${Math.max(0.5 * size, (size * (room - 14)) / (el.scrollWidth - 14)).toFixed(2)}px`,
  );
  el.shrunk = true;
}

// ---- the reason, under the field, read aloud
let why = null;
function sayWhy(el, reason) {
  if (!reason) {
    if (why && why.about === el) why.hidden = true;
    el.removeAttribute('aria-describedby');
    return;
  }
  if (!why) {
    why = h('div', { class: 'why', id: 'why', role: 'alert', 'data-testid': 'why' });
    document.body.append(why);
  }
  why.about = el;
  why.hidden = false;
  if (why.textContent !== reason) why.textContent = reason;
  el.setAttribute('aria-describedby', 'why');
  const r = el.getBoundingClientRect();
  why.style.setProperty('top', `${r.bottom + 4}px`);
  why.style.setProperty('left', `${Math.max(8, Math.min(r.left, innerWidth - why.offsetWidth - 8))}px`);
}
addEventListener('scroll', () => why && (why.hidden = true), true);

/** Arrows and Enter go from cell to cell; within a text the arrows go along it first. Returns whether the key was used. */
function walk(el, e) {
  const whole = el.selectionStart === 0 && el.selectionEnd === el.value.length;
  const down = { ArrowUp: -1, ArrowDown: 1, Enter: e.shiftKey ? -1 : 1 }[e.key];
  const side =
    {
      ArrowLeft: whole || el.selectionEnd === 0 ? -1 : 0,
      ArrowRight: whole || el.selectionStart === el.value.length ? 1 : 0,
    }[e.key] ?? 0;
  if (e.altKey || e.ctrlKey || e.metaKey || (!down && !side)) return false;
  const rows = [...el.closest('tbody').rows].map((r) => [...r.querySelectorAll('input.number')]);
  const y = rows.findIndex((r) => r.includes(el)),
    x = rows[y].indexOf(el);
  const next = rows[y + (down ?? 0)]?.[x + side];
  if (e.key === 'Enter') el.dispatchEvent(new Event('change'));
  if (!next) return e.key !== 'Enter';
  e.preventDefault();
  next.focus();
  return true;
}
