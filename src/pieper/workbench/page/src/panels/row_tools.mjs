// The small buttons at the end of a row: up, down, take out.
import { button } from '../dom.mjs';

const icon = (text, label, click, disabled = false) =>
  button(text, { class: 'icon', 'aria-label': label, disabled }, click);

/**
 * @param k which row this is, of n; @param name what it is called aloud
 * @param move called with the places it goes from and to, null where the order stands; @param remove takes it out
 */
export const rowTools = ({ k, n, name, move = null, remove }) => [
  ...(move
    ? [
        icon('↑', `Move ${name} up`, () => move(k, k - 1), k === 0),
        icon('↓', `Move ${name} down`, () => move(k, k + 1), k === n - 1),
      ]
    : []),
  icon('×', `Remove ${name}`, () => remove(k)),
];
