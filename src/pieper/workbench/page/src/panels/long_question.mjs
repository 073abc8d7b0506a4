// A button that asks the library something long, and the sentence below it that says what came of it.
import { h, setText, unreadable } from '../dom.mjs';

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

/**
 * The button: pressed, it asks unless a field in the panel cannot be read, and says meanwhile that it works.
 * @param ask does it; what it throws is said by the verdict
 * @param open whether the button can be pressed at all
 */
export function longQuestion({ text, working, testid, verdict, root, open = () => true, ask }) {
  const el = h('button', { type: 'button', class: 'primary', text, 'data-testid': testid });
  el.ask = async (...said) => {
    const bad = unreadable(root);
    if (bad) {
      verdict.say(bad);
      return;
    }
    el.disabled = true;
    setText(el, working);
    try {
      await ask(...said);
    } catch (error) {
      verdict.say(error.message);
    } finally {
      setText(el, text);
      el.show();
    }
  };
  el.show = () => {
    el.disabled = !open();
  };
  el.addEventListener('click', () => el.ask());
  return el;
}
