// Waiting for an answer: what stands there meanwhile is of an earlier question, which is said once the answer takes long.

/** Milliseconds after which the eye is told that an answer is waited for; sooner it would only flicker. */
const SEEN = 250;

/** Say whether one waits: `tell` hears true when that takes longer than the eye minds, and false once it is over. */
export function awaiting(tell) {
  let timer = null,
    late = false;
  const wait = (yes) => {
    if (yes) {
      timer ??= setTimeout(() => {
        late = true;
        tell(true);
      }, SEEN);
      return;
    }
    clearTimeout(timer);
    timer = null;
    if (!late) return;
    late = false;
    tell(false);
  };
  wait.late = () => late;
  return wait;
}

/** Mark what stands in these as of an earlier question, or as of the present one. */
export function busy(yes, ...els) {
  for (const el of els) {
    if (yes) el.setAttribute('aria-busy', 'true');
    else el.removeAttribute('aria-busy');
  }
}
