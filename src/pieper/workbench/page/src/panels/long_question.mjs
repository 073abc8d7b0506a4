// A button that asks the library something long, and the sentence below it that says what came of it.
import { h, setText, unreadable } from '../dom.mjs';
import { on } from '../store.mjs';
import { Offline } from '../link.mjs';
import { awaiting, busy } from '../late.mjs';

/** What tells that something was changed which a question may be about. */
const ASKED_WITH = [
  'did',
  'table',
  'path',
  'path-loaded',
  'program',
  'routing',
  'sequence',
  'sequence-loaded',
  'world',
];

/** Said where an answer did not come because the server was away, once it is there again. */
export const BACK = 'The server was away and is back; this was not answered. Ask again.';

/** A sentence with a tone (good, note, wrong), read aloud when it changes; empty text hides it. */
export function verdictLine(testid) {
  const el = h('p', { class: 'verdict', role: 'status', 'data-testid': testid, hidden: true });
  el.say = (text, tone = 'wrong') => {
    el.hidden = !text;
    el.dataset.tone = tone;
    setText(el, text);
  };
  return el;
}

/** Where the numbers of the arm stand, and those of what is around it. */
export const armSection = () => document.querySelector('#panel-table section');
export const worldSection = () => document.querySelector('#panel-world section');
const same = (a, b) => a.length === b.length && a.every((v, i) => Object.is(v, b[i]));

/**
 * An answer to what stands in the fields: not asked for where one of them cannot be read, not taken where what it is about was
 * changed before it came.
 */
export async function answerTo({ roots, about }, ask) {
  const bad = unreadable(...roots());
  if (bad) throw new Error(`${bad} Nothing was computed.`);
  const asked = about(),
    got = await ask();
  if (!same(asked, about()))
    throw new Error('What was asked was changed meanwhile, so the answer is not shown. Ask again.');
  return got;
}

/**
 * The button: pressed, it asks unless a field in these sections cannot be read, and says meanwhile that it works. An answer
 * is shown while what it is about stands as it was asked; once that is changed, what was said of it goes.
 * @param roots the sections whose numbers are asked with
 * @param about what the answer is of, as a list that differs when it is something else
 * @param ask gets the answer; what it throws is said by the verdict
 * @param show shows it
 * @param forget takes back what was shown, beside the verdict
 * @param open whether the button can be pressed at all
 */
export function longQuestion({ text, working, testid, verdict, roots, about, ask, show, forget, open = () => true }) {
  const el = h('button', { type: 'button', class: 'primary', text, 'data-testid': testid });
  const wait = awaiting((late) => verdict.classList.toggle('stale', late));
  let answered = null, // what the shown answer is about, or the one that is looked for
    underway = 0, // questions under way: a newer one takes the place of an older
    away = false; // whether it was the server being away that was said
  el.ask = async (...said) => {
    const asked = about(),
      again = answered && same(answered, asked);
    // what is shown stays until the answer, unless what was asked is changed before
    answered = asked;
    away = false;
    el.disabled = true;
    underway += 1;
    setText(el, working);
    busy(true, verdict);
    wait(true);
    try {
      const got = await answerTo({ roots, about }, () => ask(...said));
      if (got.stopped) return;
      answered = about();
      show(got);
    } catch (error) {
      away = error instanceof Offline;
      if (answered === asked && !again) {
        answered = null;
        forget?.();
      }
      verdict.say(error.message);
    } finally {
      underway -= 1;
      if (!underway) rest();
    }
  };
  function rest() {
    busy(false, verdict);
    wait(false);
    setText(el, text);
    el.show();
  }
  el.show = () => {
    el.disabled = !open();
  };
  el.addEventListener('click', () => el.ask());
  const check = () => {
    if (!answered || same(answered, about())) return;
    answered = null;
    verdict.say('');
    forget?.();
  };
  on('online', (yes) => {
    if (yes && away) verdict.say(BACK, 'note');
    away = false;
  });
  // an action is told before it is done
  on(ASKED_WITH, () => queueMicrotask(check));
  return el;
}
