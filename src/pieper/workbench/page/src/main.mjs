// The page's door: puts the pieces in their places and connects to the session.
import { $ } from './dom.mjs';
import { state, on, tell, setTable, presentable, forgetHistory } from './store.mjs';
import { readTheme } from './theme.mjs';
import * as link from './link.mjs';
import * as library from './library.mjs';
import * as view from './scene/view.mjs';
import * as arm from './scene/arm.mjs';
import { bar, rail, overlay, keys } from './chrome.mjs';
import { joints } from './panels/joints.mjs';
import { pose } from './panels/pose.mjs';
import { matrices } from './panels/matrices.mjs';
import { dhTable } from './panels/dh_table.mjs';

readTheme();
view.open($('#view'));
on('theme', view.applyTheme);
view.applyTheme();
arm.begin();
library.begin();
bar($('#bar'));
overlay($('#overlay'));
keys();
rail($('#rail'), $('#panels'), $('#pinned'), [
  { id: 'move', title: 'Move', sections: [joints, pose] },
  matrices, dhTable,
]);

on('online', async (yes) => {
  if (!yes) return;
  const hello = await link.ask('hello', { wants_arm: !state.table.joints.length });
  state.catalog = hello.catalog;
  tell('catalog');
  if (hello.table && !state.table.joints.length) {
    setTable(hello.table, { q: presentable(hello.table), step: false, what: 'new' });
    forgetHistory();
  }
  document.documentElement.dataset.ready = 'yes';
});
link.start();
