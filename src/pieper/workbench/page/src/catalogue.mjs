// The catalogue as a list one can search: by name, maker, joints, payload or reach, each arm with a small picture.
import { button, h, replace } from './dom.mjs';
import { ask } from './link.mjs';

const SVG = 'http://www.w3.org/2000/svg';
/** A stick figure of an arm from the points of its frames, seen from the corner. */
function figure(points) {
  const flat = points.map(([x, y, z]) => [0.77 * x + 0.62 * y, 0.3 * x - 0.38 * y - 0.88 * z]);
  flat.unshift([flat[0][0], flat[0][1]]);
  const [xs, ys] = [0, 1].map((k) => flat.map((p) => p[k]));
  const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)) || 1;
  const at = ([x, y]) => [
    22 + (36 * (x - (Math.max(...xs) + Math.min(...xs)) / 2)) / size,
    22 + (36 * (y - (Math.max(...ys) + Math.min(...ys)) / 2)) / size,
  ];
  const el = (name, props) => {
    const e = document.createElementNS(SVG, name);
    for (const [k, v] of Object.entries(props)) e.setAttribute(k, v);
    return e;
  };
  const svg = el('svg', { viewBox: '0 0 44 44', class: 'thumb', 'aria-hidden': 'true' });
  svg.append(
    el('polyline', {
      points: flat
        .map((p) =>
          at(p)
            .map((v) => v.toFixed(1))
            .join(','),
        )
        .join(' '),
    }),
  );
  for (const p of flat.slice(1)) svg.append(el('circle', { cx: at(p)[0].toFixed(1), cy: at(p)[1].toFixed(1), r: 1.7 }));
  return svg;
}

const kind = (joints) => (/^(.)\1*$/.test(joints) ? `${joints.length}${joints[0]}` : joints);
/** How much an arm must carry (kg), and how far it must reach (m), where a word says so: 5kg, 900mm, 1.2m. */
function figureOf(word) {
  const found = /^>?(\d+(?:[.,]\d+)?)(kg|mm|m)$/.exec(word);
  if (!found) return null;
  const value = Number(found[1].replace(',', '.'));
  return found[2] === 'kg' ? { payload: value } : { reach: found[2] === 'm' ? value : value / 1000 };
}
/** Whether an arm answers to every word; one whose figures are not known answers to none that asks for a figure. */
function answers(arm, words) {
  const all = `${arm.name} ${arm.maker} ${arm.joints} ${kind(arm.joints)}`.toLowerCase();
  return words.every((w) => {
    const many = /^(\d+)joints$/.exec(w);
    if (many) return arm.joints.length === Number(many[1]);
    const least = figureOf(w);
    if (!least) return all.includes(w);
    return Object.entries(least).every(([key, value]) => arm[key] !== null && arm[key] >= value - 1e-9);
  });
}
const about = ({ maker, joints, payload, reach }) =>
  [
    maker,
    kind(joints),
    payload === null ? '' : `${payload} kg`,
    reach === null ? '' : `${Math.round(reach * 1000)} mm`,
  ].filter(Boolean);

/** A dialog over the page; `pick` is called with the name of the chosen arm. */
export function catalogueDialog(pick) {
  let arms = null;
  const list = h('div', { class: 'arms', role: 'listbox', 'aria-label': 'Arms found', 'data-testid': 'arms-found' });
  const count = h('span', { class: 'hint', role: 'status' });
  const search = h('input', {
    type: 'text',
    placeholder: 'Name, maker, joints (7R, 5 axes), payload (5 kg), reach (900 mm)',
    'aria-label': 'Search the catalogue',
    'data-testid': 'search-arms',
    autocomplete: 'off',
    on: {
      input: () => show(),
      keydown: (e) => {
        if (e.key === 'ArrowDown') list.firstElementChild?.focus();
        else if (e.key === 'Enter') list.firstElementChild?.click();
        else return;
        e.preventDefault();
      },
    },
  });
  const dialog = h(
    'dialog',
    { class: 'catalogue', 'aria-label': 'Catalogue' },
    h(
      'div',
      { class: 'line' },
      search,
      count,
      button('×', { class: 'icon', 'aria-label': 'Close the catalogue' }, () => dialog.close()),
    ),
    list,
  );
  document.body.append(dialog);
  function show() {
    // a number and its unit are one word, whether or not there is a space between them
    const said = search.value
      .toLowerCase()
      .replace(/(\d)\s+(kg|mm|m)\b/g, '$1$2')
      .replace(/(\d)[\s-]*(joints?|ax[ei]s|axe|dof)\b/g, '$1joints');
    const words = said.split(/\s+/).filter(Boolean);
    const found = (arms ?? []).filter((a) => answers(a, words));
    count.textContent = arms ? `${found.length} of ${arms.length} arms` : 'Fetching the list …';
    replace(
      list,
      found.map((a) =>
        h(
          'button',
          {
            type: 'button',
            role: 'option',
            class: 'arm-card',
            'data-name': a.name,
            on: {
              click: () => {
                dialog.close();
                pick(a.name);
              },
              keydown: (e) => {
                const way = { ArrowDown: 'nextElementSibling', ArrowUp: 'previousElementSibling' }[e.key];
                if (!way) return;
                e.preventDefault();
                (e.currentTarget[way] ?? search).focus();
              },
            },
          },
          figure(a.points),
          h('span', {}, h('b', { text: a.name }), h('span', { class: 'hint', text: about(a).join(', ') })),
        ),
      ),
    );
  }
  return async () => {
    dialog.showModal();
    search.select();
    if (arms) return;
    show();
    try {
      arms = (await ask('catalog')).arms;
      show();
    } catch (error) {
      count.textContent = error.message;
    }
  };
}
