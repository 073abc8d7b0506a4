// What the page says of itself to a test: what is drawn, how often, and where things are on the screen. It changes nothing.
import { state } from './store.mjs';
import { frames } from './kinematics.mjs';
import { convert } from './convert.mjs';
import { read } from './expression.mjs';
import { withPresentNumbers } from './presentnumbers.mjs';
import { cameraState, picturesDrawn, toScreen, withPicture } from './scene/view.mjs';
import { ghostCount, traceLength, framesDrawn, beyondDrawn, ghostsOutside } from './scene/arm.mjs';
import { toUndo, toRedo } from './history.mjs';
import { handles } from './scene/gizmo.mjs';
import { thingsDrawn, carriedAt } from './scene/world.mjs';
import { labelsDrawn } from './scene/labels.mjs';
import { gripperShown } from './scene/gripper.mjs';
import { framesOfStep } from './panels/dh_steps.mjs';
import { bodiesShown } from './scene/clearance.mjs';
import { looksDrawn } from './scene/looks.mjs';
import { ellipsoidShown } from './scene/ellipsoid.mjs';
import { go } from './dock.mjs';
import { counts } from './solving.mjs';
import * as cloud from './scene/cloud.mjs';
import * as voxels from './scene/voxels.mjs';

export function expose() {
  window.workbench = Object.freeze({
    get q() {
      return state.q.slice();
    },
    get frames() {
      return structuredClone(state.frames);
    },
    get target() {
      return state.target.slice();
    },
    get table() {
      return structuredClone(state.table);
    },
    get solutions() {
      return structuredClone(state.solutions);
    },
    get camera() {
      return cameraState();
    },
    get pictures() {
      return picturesDrawn();
    },
    get ghosts() {
      return ghostCount();
    },
    get ghostsOutside() {
      return ghostsOutside();
    },
    get labels() {
      return labelsDrawn();
    },
    get history() {
      return [toUndo(), toRedo()];
    },
    get beyond() {
      return beyondDrawn();
    },
    get things() {
      return thingsDrawn();
    },
    get looks() {
      return looksDrawn();
    },
    get program() {
      return structuredClone(state.program);
    },
    get route() {
      return structuredClone(state.route);
    },
    routePlace(which, turn) {
      const detail = { which, turn };
      document.querySelector('.route-map').dispatchEvent(new CustomEvent('where', { detail }));
      return detail.at;
    },
    get motion() {
      return structuredClone(state.motion);
    },
    get gripper() {
      return gripperShown();
    },
    placeOf: (name) => carriedAt(name) ?? state.world.find((t) => t.name === name)?.T ?? null,
    go,
    get stepFrame() {
      return state.dhStep === null ? null : framesOfStep().at(-1).T;
    },
    get clearance() {
      return structuredClone(state.clearance);
    },
    get bodies() {
      return bodiesShown();
    },
    get ellipsoid() {
      return structuredClone(ellipsoidShown());
    },
    get world() {
      return structuredClone(state.world);
    },
    get framesDrawn() {
      return framesDrawn();
    },
    get answers() {
      return counts.answers;
    },
    get trace() {
      return traceLength();
    },
    get voxels() {
      return voxels.size();
    },
    get cloud() {
      return cloud.size();
    },
    toScreen,
    withPicture: (f) => withPicture(f),
    handles: () => handles(),
    forward: (table, q) => frames(table, q),
    convert: (table, to) => convert(table, to),
    read: (text, kind) => read(text, kind),
    present: (equation, table, q) => withPresentNumbers(equation, table, q),
  });
}
