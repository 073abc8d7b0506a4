// The page's door: puts the pieces in their places and connects to the session.
import { $, say } from './dom.mjs';
import { state, on, tell, setTable, presentable } from './store.mjs';
import * as history from './history.mjs';
import { readTheme } from './theme.mjs';
import * as layout from './layout.mjs';
import * as link from './link.mjs';
import * as library from './library.mjs';
import * as view from './scene/view.mjs';
import * as arm from './scene/arm.mjs';
import * as labels from './scene/labels.mjs';
import * as gizmo from './scene/gizmo.mjs';
import * as solving from './solving.mjs';
import * as sharing from './sharing.mjs';
import * as dock from './dock.mjs';
import { splitter } from './room.mjs';
import { bar, rail, overlay, keys } from './chrome.mjs';
import { joints } from './panels/joints.mjs';
import { pose } from './panels/pose.mjs';
import { matrices } from './panels/matrices.mjs';
import { inverse } from './panels/inverse.mjs';
import { dhTable } from './panels/dh_table.mjs';
import { equations } from './panels/equations.mjs';
import { path } from './panels/path.mjs';
import { route } from './panels/route.mjs';
import { program } from './panels/program.mjs';
import { world as worldPanel } from './panels/world.mjs';
import { sequence } from './panels/sequence.mjs';
import { analysis } from './panels/analysis.mjs';
import { share } from './panels/share.mjs';
import * as beside from './beside.mjs';
import * as gripper from './scene/gripper.mjs';
import * as playing from './playing.mjs';
import * as clearance from './scene/clearance.mjs';
import * as ellipsoid from './scene/ellipsoid.mjs';
import * as world from './scene/world.mjs';
import * as looks from './scene/looks.mjs';
import { expose } from './hook.mjs';

readTheme();
layout.begin();
view.open($('#view'));
on('theme', view.applyTheme);
view.applyTheme();
history.begin();
labels.begin($('#overlay'));
arm.begin();
gizmo.begin();
world.begin();
looks.begin();
clearance.begin();
ellipsoid.begin();
gripper.begin();
playing.begin();
beside.begin();
library.begin();
solving.begin();
bar($('#bar'));
overlay($('#overlay'));
dock.build($('#dock'));
keys();
let showPanel;
const group = (name, first, ...rest) => [{ ...first, group: name }, ...rest];
showPanel = rail($('#rail'), $('#panels'), $('#pinned'), [
  ...group('Drive', { id: 'move', title: 'Move', sections: [joints, pose] }, inverse),
  ...group('Describe', dhTable, worldPanel),
  ...group(
    'Plan',
    path,
    route(() => showPanel),
    program,
    sequence,
  ),
  ...group('Study', matrices, equations, analysis),
  ...group(
    'Hand on',
    share(() => showPanel),
  ),
]);
splitter($('#room'), $('#rail'));
sharing.begin(showPanel);

/** An arm of the address goes before the one that the server would open with. */
const fromAddress = sharing
  .fromAddress()
  .then((s) => s && sharing.restore(s, showPanel))
  .catch((error) => say(`The link could not be read: ${error.message}`, 'wrong'));

on('online', async (yes) => {
  if (!yes) return;
  await fromAddress;
  const hello = await link.greeting();
  state.catalog = hello.catalog;
  tell('catalog');
  if (hello.table && (!state.table.joints.length || hello.bench)) {
    setTable(hello.table, { q: presentable(hello.table), step: false, what: 'new' });
    history.forgetHistory();
  }
  if (hello.looks) looks.take(hello.looks, hello.table);
  beside.open(hello.bench);
  document.documentElement.dataset.ready = 'yes';
});
if (state.online) tell('online', true);
// Labels in the picture are as wide as the page's own letters once these are here.
document.fonts?.ready.then(() => tell('theme'));
expose();
