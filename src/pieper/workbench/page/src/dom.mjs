// Making elements without inline markup or styles, as the content security policy asks.
import { unlessPressed } from './press.mjs';

/** h('button', {class, text, on: {click}, aria-label ...}, ...children) */
export function h(tag, props = {}, ...children) {
  const el = document.createElement(tag);
  for (const [key, value] of Object.entries(props)) {
    if (value === undefined || value === null || value === false) continue;
    if (key === 'text') el.textContent = value;
    else if (key === 'on') for (const [type, f] of Object.entries(value)) el.addEventListener(type, f);
    else if (key === 'value') el.value = value;
    else if (key === 'checked' || key === 'disabled' || key === 'hidden') el[key] = value;
    else el.setAttribute(key, value === true ? '' : value);
  }
  el.append(...children.flat().filter((c) => c !== null && c !== undefined && c !== false));
  return el;
}

/** A button with what it says and does. */
export const button = (text, props, press) => h('button', { type: 'button', text, ...props, on: { click: press } });

export const $ = (selector, root = document) => root.querySelector(selector);
export const replace = (el, ...children) =>
  unlessPressed(el, () => el.replaceChildren(...children.flat().filter(Boolean)));

/** Set text only when it differs: a write that changes nothing still costs layout. */
export function setText(el, text) {
  if (el.textContent !== text) el.textContent = text;
}

/** A row of buttons of which one is pressed. */
export function choice(label, options, current, pick, testid) {
  const group = h('div', { class: 'choice', role: 'group', 'aria-label': label, 'data-testid': testid });
  const mark = (name) => {
    for (const b of group.children) b.setAttribute('aria-pressed', String(b.dataset.value === name));
  };
  for (const [value, text] of options) {
    group.append(
      h('button', {
        type: 'button',
        text,
        'data-value': value,
        on: {
          click: () => {
            mark(value);
            pick(value);
          },
        },
      }),
    );
  }
  mark(current);
  group.mark = mark;
  return group;
}

/** A labelled select. */
export function select(label, options, current, pick, props = {}) {
  const el = h(
    'select',
    { 'aria-label': label, ...props, on: { change: () => pick(el.value) } },
    options.map(([value, text]) => h('option', { value, text })),
  );
  el.value = current;
  return el;
}

export const field = (label, ...controls) =>
  h('label', { class: 'field' }, h('span', { class: 'field-name', text: label }), ...controls);

/** Call f at most once a frame. */
export function perFrame(f) {
  let asked = false;
  const soon = () => {
    if (!asked) {
      asked = true;
      requestAnimationFrame(() => {
        asked = false;
        f();
      });
    }
  };
  soon.now = f; // where nothing stands there yet
  return soon;
}

/** Call f at once, and again at most every `ms` while it is asked for, the last time with what was asked last. */
export function atMostEvery(ms, f) {
  let timer = null,
    last = -Infinity;
  const run = () => {
    clearTimeout(timer);
    timer = null;
    last = performance.now();
    f();
  };
  run.soon = () => {
    const wait = last + ms - performance.now();
    if (wait <= 0) run();
    else timer ??= setTimeout(run, wait);
  };
  return run;
}

export function debounce(f, ms) {
  let timer;
  const run = (...args) => {
    clearTimeout(timer);
    timer = setTimeout(() => f(...args), ms);
  };
  run.cancel = () => clearTimeout(timer);
  return run;
}

/** Hand text or a blob to the person as a file. */
export function download(name, content, type = 'text/plain') {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  const a = h('a', { href: url, download: name });
  document.body.append(a);
  a.click();
  a.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = h('textarea', { class: 'offscreen' });
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }
  say('Copied');
}

/** A short remark at the foot of the view, spoken by screen readers. */
let timer;
export function say(text, tone = 'plain') {
  const el = document.getElementById('remark');
  el.textContent = text;
  el.dataset.tone = tone;
  el.classList.add('shown');
  clearTimeout(timer);
  timer = setTimeout(() => el.classList.remove('shown'), tone === 'wrong' ? 8000 : 2500);
}

/**
 * The first field in these sections that cannot be read, as a sentence, or null: nothing is done with the number before it. Of
 * a section that is not shown the name of its panel is said too.
 */
export function unreadable(...roots) {
  for (const root of roots) {
    const shown = (f) => {
      const hidden = f.closest('[hidden]');
      return !hidden || hidden.contains(root);
    };
    const el = [...root.querySelectorAll('.number.wrong')].find(shown);
    if (!el) continue;
    const panel = root.closest('.panel');
    if (el.closest('details')) el.closest('details').open = true;
    el.focus();
    const where = panel.hidden ? `${document.getElementById(panel.getAttribute('aria-labelledby')).textContent}: ` : '';
    return `${where}${el.getAttribute('aria-label')} cannot be read (${el.title}).`;
  }
  return null;
}
