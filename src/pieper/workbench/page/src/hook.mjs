// What the page says of itself to a test: what is drawn, how often, and where things are on the screen. It changes nothing.
import { state } from './store.mjs';
import { frames } from './kinematics.mjs';
import { underway } from './link.mjs';
import { convert } from './convert.mjs';
import { read } from './expression.mjs';
import { block } from './clipboard.mjs';
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
import { addressed, snapshot } from './sharing.mjs';
import { counts, settled } from './solving.mjs';
import * as cloud from './scene/cloud.mjs';
import * as voxels from './scene/voxels.mjs';

export function expose() {
  const seen = {
    said: () => structuredClone(snapshot()),
    q: () => state.q.slice(),
    frames: () => structuredClone(state.frames),
    target: () => state.target.slice(),
    table: () => structuredClone(state.table),
    solutions: () => structuredClone(state.solutions),
    camera: () => cameraState(),
    pictures: () => picturesDrawn(),
    ghosts: () => ghostCount(),
    ghostsOutside: () => ghostsOutside(),
    labels: () => labelsDrawn(),
    history: () => [toUndo(), toRedo()],
    beyond: () => beyondDrawn(),
    things: () => thingsDrawn(),
    looks: () => looksDrawn(),
    program: () => structuredClone(state.program),
    route: () => structuredClone(state.route),
    motion: () => structuredClone(state.motion),
    gripper: () => gripperShown(),
    stepFrame: () => (state.dhStep === null ? null : framesOfStep().at(-1).T),
    clearance: () => structuredClone(state.clearance),
    bodies: () => bodiesShown(),
    ellipsoid: () => structuredClone(ellipsoidShown()),
    world: () => structuredClone(state.world),
    framesDrawn: () => framesDrawn(),
    answers: () => counts.answers,
    settled: () => settled(),
    resting: () => underway() === 0 && addressed(),
    trace: () => traceLength(),
    voxels: () => voxels.size(),
    cloud: () => cloud.size(),
  };
  const page = {
    routePlace(which, turn) {
      const detail = { which, turn };
      document.querySelector('.route-map').dispatchEvent(new CustomEvent('where', { detail }));
      return detail.at;
    },
    placeOf: (name) => carriedAt(name) ?? state.world.find((t) => t.name === name)?.T ?? null,
    go,
    toScreen,
    withPicture: (f) => withPicture(f),
    handles: () => handles(),
    forward: (table, q) => frames(table, q),
    convert: (table, to) => convert(table, to),
    read: (text, kind) => read(text, kind),
    block: (text) => block(text),
    present: (equation, table, q) => withPresentNumbers(equation, table, q),
  };
  for (const [name, get] of Object.entries(seen)) Object.defineProperty(page, name, { get, enumerable: true });
  window.workbench = Object.freeze(page);
}
