"""What the workbench benchmark runs inside the page, to see with the page's own clock."""

#: Runs before the page's own modules: when the page became usable, and a fixed piece of work to judge the machine by.
WATCH = """
window.watch = { ready: null };
new MutationObserver(() => {
  if (window.watch.ready === null && document.documentElement.dataset.ready === 'yes') {
    const seen = () => window.workbench?.pictures > 0 && window.workbench.table.joints.length > 0
      ? (window.watch.ready = performance.now()) : requestAnimationFrame(seen);
    requestAnimationFrame(seen);
  }
}).observe(document, { subtree: true, attributes: true, attributeFilter: ['data-ready'] });
window.fixedWork = () => {
  const began = performance.now();
  let x = 0;
  for (let i = 0; i < 2e7; i++) x = (x * 1664525 + 1013904223 + i) | 0;
  return [performance.now() - began, x];
};
"""

#: From the event's own time stamp to the matrix cell that changed, and to the second frame after it: the first one
#: hands the picture over, the second one begins when the browser has taken it.
JOINT = """
() => {
  window.heard = { number: [], picture: [], began: null };
  const cell = document.querySelector('[data-testid=pose]');
  addEventListener('keydown', (e) => {
    heard.began = e.timeStamp;
    const drawn = workbench.pictures;
    const look = () => workbench.pictures > drawn
      ? requestAnimationFrame(() => heard.picture.push(performance.now() - e.timeStamp)) : requestAnimationFrame(look);
    requestAnimationFrame(look);
  }, true);
  new MutationObserver(() => {
    if (heard.began === null) return;
    heard.number.push(performance.now() - heard.began);
    heard.began = null;
  }).observe(cell, { subtree: true, characterData: true, childList: true });
}
"""

#: Counts pictures that show a newer answer than the picture before, for as long as the hand drags.
GIZMO = """
() => {
  const seen = { updates: 0, gaps: [], began: performance.now(), on: true,
                 answers: workbench.answers, pictures: workbench.pictures };
  window.seen = seen;
  const first = { answers: seen.answers, pictures: seen.pictures };
  let last = seen.began;
  const look = (now) => {
    if (!seen.on) return;
    if (workbench.answers > seen.answers && workbench.pictures > seen.pictures) {
      seen.updates += 1;
      seen.gaps.push(now - last);
      last = now;
      seen.answers = workbench.answers;
      seen.pictures = workbench.pictures;
    }
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  seen.stop = () => {
    seen.on = false;
    const s = (performance.now() - seen.began) / 1000;
    return { updates: seen.updates / s, answers: (workbench.answers - first.answers) / s,
             pictures: (workbench.pictures - first.pictures) / s, gaps: seen.gaps, ghosts: workbench.ghosts };
  };
}
"""
