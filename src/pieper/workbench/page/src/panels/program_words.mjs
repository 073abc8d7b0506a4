// A step of a program in a few words: what it is, and where to.
import { state } from '../store.mjs';
import { units, show } from '../units.mjs';
import { position } from '../matrix.mjs';
import { kindOf } from './joints.mjs';

export const words = {
  joint: 'Joints to',
  line: 'Line to',
  circle: 'Circle to',
  wait: 'Wait',
  gripper: 'Gripper',
  output: 'Output',
  spline: 'Spline to',
  frame: 'Work frame',
  call: 'Again',
};

export function summary(s) {
  if (s.kind === 'wait') return `${s.seconds} s`;
  if (s.kind === 'gripper') return s.value === 0 ? 'open' : s.value === 1 ? 'closed' : `${s.value}`;
  if (s.kind === 'call')
    return `${s.first === s.last ? `step ${s.first}` : `steps ${s.first} to ${s.last}`}${s.times > 1 ? `, ${s.times} times` : ''}`;
  if (s.kind === 'output') return `${s.port} ${s.value ? 'on' : 'off'}`;
  if (s.kind === 'joint' && s.q)
    return s.q.map((v, i) => show(v, kindOf(state.table.joints[i] ?? { type: 'R' }), 1)).join(', ');
  return `${position(s.T)
    .map((v) => show(v, 'length', 1))
    .join(
      ', ',
    )} ${units.length}${s.kind === 'spline' ? `, ${s.through.length} ${s.through.length === 1 ? 'pose' : 'poses'}` : ''}`;
}
