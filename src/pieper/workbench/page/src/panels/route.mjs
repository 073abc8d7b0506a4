// Route: the line with the tool's turn left free; every branch and every turn on one map, the cheapest curve, or what shuts it.
import { button, h, replace, say, setText } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { showUnit } from '../units.mjs';
import { position } from '../matrix.mjs';
import { armNumber, askArm } from '../library.mjs';
import { newestOnly } from '../link.mjs';
import { motionOf } from '../curves.mjs';
import * as dock from '../dock.mjs';
import { showPath, showPreview } from '../scene/arm.mjs';
import { between } from '../rotation.mjs';
import { colours } from '../theme.mjs';
import { setProgram } from '../program.mjs';
import { routing, setRouting, routeMessage, freedom, isRound } from '../routing.mjs';
import { routeMap } from '../routemap.mjs';
import { answerTo, armSection, longQuestion, verdictLine, worldSection } from './long_question.mjs';
import { lineEnds } from './line_ends.mjs';
import { routeSettings } from './route_settings.mjs';

/** @param open opens another panel by its name */
export const route = (open) => ({
  id: 'route',
  title: 'Route',
  wide: true,
  build(root) {
    const P = state.path;
    let found = null,
      only = null,
      mine = null; // the motion in the dock that is this route's
    const ends = lineEnds('route', () => preview());
    const settings = routeSettings();
    const named = (text, testid, click, props = {}) => button(text, { 'data-testid': testid, ...props }, click);
    const letFree = named('Let both ends free', 'free-ends', () => {
      setRouting({ start: null, end: null }, 'let the ends of the route free');
      plan.ask();
    });
    const send = named('Send to the program', 'route-to-program', toProgram, { hidden: true });
    const more = named('', 'route-others', others, { hidden: true });
    const verdict = verdictLine('route-verdict');
    /** What a route is asked with, and what it is of. */
    const asking = {
      roots: () => [root, armSection(), worldSection()],
      about: () => [armNumber(), P.from, P.to, P.n, state.routing, state.world],
    };
    const plan = longQuestion({
      text: 'Find the route',
      working: 'Looking …',
      testid: 'find-route',
      verdict,
      ...asking,
      async ask() {
        const [low, high] = routing().turn ?? [0, 0];
        if (low > high)
          throw new Error(
            `The turn must have its lower end first; it goes from ${showUnit(low, 'angle')} to ${showUnit(high, 'angle')}.`,
          );
        try {
          return await askArm('route', routeMessage());
        } catch (error) {
          map.cancel();
          throw error;
        }
      },
      show: report,
      forget: () => forget(),
    });
    const chips = h('div', { class: 'chips', role: 'group', 'aria-label': 'Branches on the map' });
    const list = h('div', { class: 'branches', 'data-testid': 'route-list' });
    const map = routeMap({
      drag: (which, turn) => (turn === null ? showPreview(null) : look(which, turn)),
      drop: (which, turn) => take(which, turn),
      scrub: (s) => mine && state.motion === mine && dock.go(nearest(s)),
    });
    const line = h('details', { class: 'fold', open: true }, h('summary', { text: 'The line' }), ends.el);
    map.el.hidden = true;
    letFree.hidden = true;
    root.append(
      h('p', {
        class: 'hint',
        text: 'The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve.',
      }),
      line,
      settings.el,
      h('div', { class: 'line' }, plan, letFree, send),
      map.el,
      chips,
      verdict,
      h('div', { class: 'line' }, more),
      list,
    );

    const preview = () => {
      if (P.from && P.to && !found)
        showPath(Array.from({ length: 33 }, (_, i) => position(between(P.from, P.to, i / 32))));
    };
    function report(got) {
      const r = routing();
      found = state.route = { ...got, turn: asHeld(got, r), asked: [P.from, P.to] };
      // all branches at once lie over each other: the one that is gone comes first
      only = got.found ? got.branches[got.labels[0]] : null;
      if (got.found) line.open = false;
      verdict.say(got.text, got.found ? 'good' : got.verdict === 'IMPOSSIBLE' ? 'wrong' : 'note');
      map.show(found, only, { start: Boolean(r.start), end: Boolean(r.end) });
      showPreview(null);
      letFree.hidden = !(r.start || r.end);
      send.hidden = !got.found;
      more.hidden = false;
      setText(more, got.found ? 'Routes that begin with other postures' : 'What would let it through?');
      replace(list);
      branchChips();
      showPath(got.points);
      if (!got.found) {
        mine = null;
        dock.show(null);
        return;
      }
      const n = got.q.length;
      mine = motionOf({
        table: state.table,
        q: got.q,
        xs: got.q.map((_, i) => i + 1),
        xName: 'point',
        xEnd: n,
        seconds: got.s.map((s) => P.seconds * s),
        title: `${state.table.name}: route, ${n} points`,
      });
      dock.show(mine);
    }
    /** The curve's turn is told up to whole turns: it is shown where a hand has put an end of it. */
    function asHeld(got, r) {
      if (!got.found || !got.map || !isRound(got.map)) return got.turn;
      const off = r.start ? r.start.turn - got.turn[0] : r.end ? r.end.turn - got.turn.at(-1) : 0;
      return got.turn.map((v) => v + 2 * Math.PI * Math.round(off / (2 * Math.PI)));
    }
    const nearest = (s) => found.s.reduce((b, v, i) => (Math.abs(v - s) < Math.abs(found.s[b] - s) ? i : b), 0);
    function branchChips() {
      replace(
        chips,
        found.branches.map((name, k) => {
          const dot = h('span', { class: 'swatch' });
          dot.style.setProperty('background', colours.curves[k % colours.curves.length]);
          const chip = h(
            'button',
            {
              type: 'button',
              class: 'chip',
              'aria-pressed': String(only === name),
              title: only === name ? 'Show all branches' : 'Show this branch alone',
              'data-testid': `route-branch-${k + 1}`,
              on: {
                click: () => {
                  only = only === name ? null : name;
                  map.only(only);
                  branchChips();
                },
              },
            },
            dot,
            name,
          );
          return chip;
        }),
      );
    }

    // ---- an end under the hand
    const endMessage = (which, turn) => {
      const first = which === 'start',
        i = first ? 0 : found.q.length - 1;
      return {
        T: first ? P.from : P.to,
        turn,
        free: freedom(),
        near: found.q[i],
        branch: found.branches[found.labels[i]],
      };
    };
    const look = newestOnly(async (which, turn) => {
      const got = await askArm('route_posture', endMessage(which, turn)).catch(() => null);
      showPreview(got?.q ?? null);
    });
    async function take(which, turn) {
      try {
        const got = await askArm('route_posture', endMessage(which, turn));
        if (!got.q) throw new Error(`The route cannot ${which} there. ${got.why}`);
        setRouting(
          { [which]: { turn, q: got.q, branch: got.label } },
          `turn the ${which} of the route to ${showUnit(turn, 'angle', 1)}`,
        );
        await plan.ask();
      } catch (error) {
        showPreview(null);
        map.cancel();
        say(error.message, 'wrong');
      }
    }

    async function others() {
      more.disabled = true;
      setText(more, 'Looking …');
      try {
        const got = await answerTo(asking, () => askArm('route_others', routeMessage()));
        if (got.stopped) return;
        const cost = (v) => `cost ${Number(v.toPrecision(3))}`;
        replace(
          list,
          got.relaxations.map((text) => h('p', { class: 'verdict', 'data-tone': 'note', text })),
          got.alternatives.map((a, k) =>
            h(
              'button',
              {
                type: 'button',
                class: 'branch',
                'data-testid': `route-other-${k + 1}`,
                on: {
                  click: async () => {
                    setRouting(
                      { start: { turn: a.turn, q: a.q, branch: a.branch }, end: null },
                      `begin the route ${a.branch}`,
                    );
                    await plan.ask();
                  },
                },
              },
              h('span', { class: 'branch-name', text: a.branch }),
              h('span', { class: 'hint', text: `begins turned ${showUnit(a.turn, 'angle', 1)}` }),
              h('span', { class: 'branch-end', text: cost(a.cost) }),
            ),
          ),
          got.relaxations.length + got.alternatives.length
            ? null
            : h('p', {
                class: 'hint',
                text: found?.found ? 'There is no other.' : 'No single change that was tried lets a route through.',
              }),
        );
        more.hidden = true;
      } catch (error) {
        verdict.say(error.message);
      } finally {
        more.disabled = false;
        if (found) setText(more, found.found ? 'Routes that begin with other postures' : 'What would let it through?');
      }
    }

    async function toProgram() {
      send.disabled = true;
      try {
        const got = await answerTo(asking, () => askArm('route_program', routeMessage()));
        if (got.stopped) return;
        const first = !state.program.length,
          steps = first ? got.steps.slice(1) : got.steps;
        if (first) state.start = got.steps[0].q;
        setProgram([...state.program, ...steps], 'send the route to the program');
        const off = `${showUnit(got.metres, 'length', 3)} and ${showUnit(got.radians, 'angle', 3)}`;
        say(`Sent as a spline through ${got.poses} poses; it strays by at most ${off}.`);
        open()?.('program');
      } catch (error) {
        verdict.say(error.message);
      } finally {
        send.disabled = false;
      }
    }

    const letEndsFree = () => {
      if (state.routing) state.routing = { ...state.routing, start: null, end: null };
    };
    /** What was found is for another line, another arm or another freedom: it goes. */
    function forget() {
      found = state.route = null;
      dock.drop(mine);
      verdict.say('');
      map.show(null);
      line.open = true;
      send.hidden = more.hidden = letFree.hidden = true;
      replace(chips);
      replace(list);
      showPreview(null);
    }
    on('panel', (id) => {
      if (id !== 'route') return;
      const tool = () => state.frames.at(-1).slice();
      P.from ??= tool();
      P.to ??= tool();
      ends.show();
      preview();
      if (found) map.paint();
    });
    on('played', () => {
      if (!mine || state.motion !== mine) map.at(null);
      else map.at(found.s[dock.at()] ?? null);
    });
    on('motion', () => state.motion !== mine && map.at(null));
    on('theme', () => {
      map.paint();
      if (found) branchChips();
    });
    on('units', () => map.paint());
    on('routing', (what) => {
      // what was asked for before is looked for again
      if (what === 'undo' && found) plan.ask();
    });
    on(['path', 'path-loaded'], () => {
      if (!found || (found.asked[0] === P.from && found.asked[1] === P.to)) return;
      letEndsFree();
      forget();
    });
    on('table', (what) => {
      if (['postures', 'name', 'gripper'].includes(what)) return;
      // an undone step brings its own ends back
      if (what !== 'undo') letEndsFree();
      forget();
    });
    // for tests that drag like a hand
    map.el.addEventListener('where', (e) => Object.assign(e.detail, { at: map.place(e.detail.which, e.detail.turn) }));
  },
});
