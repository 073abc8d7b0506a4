// What is under a pressed finger or button stays until it is let go: otherwise the press would end on nothing and do nothing.
let pressed = null;
const later = new Map(); // element -> what will change in it

const done = () => {
  pressed = null;
  const waiting = [...later.values()];
  later.clear();
  for (const change of waiting) change();
};
addEventListener('pointerdown', (e) => (pressed = e.target), true);
// a click comes after the release, of a finger in a task of its own; what it does goes before what waits
addEventListener('pointerup', () => setTimeout(done, 60), true);
addEventListener('pointercancel', done, true);
addEventListener('click', () => (pressed = null), true);

/** Change what an element holds: at once or, where something in it is being pressed, once that is let go, the newest change only. */
export function unlessPressed(el, change) {
  if (pressed && pressed !== el && el.contains(pressed)) later.set(el, change);
  else {
    later.delete(el);
    change();
  }
}
