// The page without a server: an arm's script is fetched as a script, so that it works from a file; solver.js solves it with the
// library's own kernels.
"use strict";
// [name, script, whether it is a robot file's], one arm each; filled in where the folder is built.
const NAMES = [];
const $ = (id) => document.getElementById(id);
const state = { arm: null, q: [], view: { yaw: -0.9, tilt: 0.35 } };
const known = {};

window.PIEPER.arrived = (arm) => {
  known[arm.name] = arm;
  window.PIEPER.ready.then(() => show(arm));
};

// The colours of the one identity, as the page's style has them for the reader's screen.
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const words = (value, slides) => (slides ? `${(value * 1e3).toFixed(1)} mm` : `${((value * 180) / Math.PI).toFixed(2)}°`);

// Where each joint is, its axis, and the tool: frames down the chain.
// Values are the axes'.
function frames(arm, values) {
  const times = (T, L) => {
    const out = new Array(12);
    for (let i = 0; i < 12; i += 4)
      for (let j = 0; j < 4; ++j)
        out[i + j] = T[i] * L[j] + T[i + 1] * L[4 + j] + T[i + 2] * L[8 + j] + (j === 3 ? T[i + 3] : 0);
    return out;
  };
  let T = arm.links[0];
  const out = [];
  values.forEach((value, i) => {
    const c = Math.cos(value), s = Math.sin(value);
    T = times(T, arm.slides[i] ? [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, value] : [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0]);
    out.push(T);
    T = times(T, arm.links[i + 1]);
  });
  out.push(T);
  return out;
}

window.PIEPER.frames = frames;

// Where the axes are at joint vector q.
const axes = (arm, q) => (arm.gears ? arm.gears.map((row) => row.reduce((sum, x, j) => sum + x * q[j], 0)) : q);

function table(element, rows) {
  const most = Math.max(...rows.flat().map(Math.abs));
  const text = (x) => (Math.abs(x) < 1e-12 * Math.max(most, 1) ? "0" : x.toFixed(4).replace("-0.0000", "0.0000"));
  element.innerHTML = rows.map((row) => `<tr>${row.map((x) => `<td>${text(x)}</td>`).join("")}</tr>`).join("");
}

function jacobian(all, arm) {
  const tool = all[all.length - 1], J = [[], [], [], [], [], []];
  arm.slides.forEach((slides, i) => {
    const T = all[i], z = [T[2], T[6], T[10]], d = [tool[3] - T[3], tool[7] - T[7], tool[11] - T[11]];
    for (let k = 0; k < 3; ++k) {
      const a = (k + 1) % 3, b = (k + 2) % 3;
      J[k].push(slides ? z[k] : z[a] * d[b] - z[b] * d[a]);
      J[3 + k].push(slides ? 0 : z[k]);
    }
  });
  if (!arm.gears) return J;
  return J.map((row) => arm.joints.map((_, j) => row.reduce((sum, x, i) => sum + x * arm.gears[i][j], 0)));
}

const same = (a, b) => window.PIEPER.same(state.arm, axes(state.arm, a), axes(state.arm, b), 1e-6);

function update() {
  const { arm, q } = state, all = frames(arm, axes(arm, q)), tool = all[all.length - 1];
  const T = [tool.slice(0, 4), tool.slice(4, 8), tool.slice(8, 12), [0, 0, 0, 1]];
  table($("pose"), T);
  table($("jacobian"), jacobian(all, arm));
  let rows = [], note = arm.refused || "";
  if (arm.solver) {
    const { held } = arm.solver, found = window.PIEPER.ikAll(arm, T.flat(), held === null ? 0 : q[held]);
    rows = found.rows.map((row) => {
      const inside = window.PIEPER.inside(arm, row);
      return { q: inside || row, inside: inside !== null };
    });
    const out = rows.filter((row) => !row.inside).length;
    note = `${rows.length - out} inside the limits${out ? `, ${out} outside` : ""}`;
    note += held === null ? "." : `, with ${arm.joints[held]}, the joint to spare, where it is.`;
    if (found.unclear) note += " At or next to a singular pose: a row may stand for many, and some may be missing.";
  }
  const head = arm.joints.map((name) => `<th>${name}</th>`).join("");
  const body = rows.map((row, i) => {
    const kind = row.inside ? (same(row.q, q) ? "row here" : "row") : "outside";
    const cells = row.q.map((x, j) => `<td>${words(x, arm.kinds[j])}</td>`).join("");
    return `<tr class="${kind}" data-row="${i}"${row.inside ? ' tabindex="0"' : ""}>${cells}</tr>`;
  });
  $("solutions").innerHTML = `<p class="note"></p>${rows.length ? `<table><tr>${head}</tr>${body.join("")}</table>` : ""}`;
  $("solutions").querySelector("p").textContent = note;
  for (const line of $("solutions").querySelectorAll("tr.row")) {
    const go = () => move(rows[Number(line.dataset.row)].q);
    line.addEventListener("click", go);
    line.addEventListener("keydown", (event) => event.key === "Enter" && go());
  }
  state.others = rows.filter((row) => row.inside && !same(row.q, q)).map((row) => row.q);
  draw();
}

function move(q) {
  state.q = q.slice();
  state.q.forEach((value, i) => {
    $(`joint-${i}`).value = value;
    $(`value-${i}`).textContent = words(value, state.arm.kinds[i]);
  });
  update();
}

function draw() {
  const canvas = $("view"), size = canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
  canvas.width = size.width * ratio;
  canvas.height = size.height * ratio;
  const pen = canvas.getContext("2d"), { arm, q, view } = state;
  pen.scale(ratio, ratio);
  const c = Math.cos(view.yaw), s = Math.sin(view.yaw), a = Math.cos(view.tilt), b = Math.sin(view.tilt);
  const reach = arm.links.reduce((sum, L) => sum + Math.hypot(L[3], L[7], L[11]), 0) || 1;
  const scale = (0.46 * Math.min(size.width, size.height)) / (0.62 * reach);
  const to = (x, y, z) => {
    const u = -s * x + c * y, v = c * x + s * y;
    return [size.width / 2 + scale * u, 0.66 * size.height - scale * (a * z - b * v)];
  };
  const at = (T) => to(T[3], T[7], T[11]);
  const line = (points, stroke, width) => {
    pen.beginPath();
    points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.strokeStyle = stroke;
    pen.lineWidth = width;
    pen.lineJoin = pen.lineCap = "round";
    pen.stroke();
  };
  for (let k = -4; k <= 4; ++k) {
    const r = 0.5 * reach, x = (k / 4) * r;
    line([to(x, -r, 0), to(x, r, 0)], colour("grid-coarse"), 1);
    line([to(-r, x, 0), to(r, x, 0)], colour("grid-coarse"), 1);
  }
  const bones = (posture) => [to(0, 0, 0), ...frames(arm, axes(arm, posture)).map(at)];
  for (const other of state.others || []) {
    pen.globalAlpha = 0.3;
    line(bones(other), colour("ghost"), 4);
  }
  pen.globalAlpha = 1;
  line(bones(q), colour("link"), 7);
  for (const T of frames(arm, axes(arm, q)).slice(0, -1)) {
    const h = 0.03 * reach;
    line([to(T[3] - h * T[2], T[7] - h * T[6], T[11] - h * T[10]), to(T[3] + h * T[2], T[7] + h * T[6], T[11] + h * T[10])], colour("joint"), 9);
  }
  const tool = frames(arm, axes(arm, q)).pop();
  state.lens = { at: at(tool), scale, right: [-s, c, 0], up: [-b * c, -b * s, a], pose: tool };
  window.PIEPER.axes.forEach((stroke, k) => {
    const h = 0.09 * reach;
    line([at(tool), to(tool[3] + h * tool[k], tool[7] + h * tool[4 + k], tool[11] + h * tool[8 + k])], stroke, 3);
  });
}

function show(arm) {
  state.arm = arm;
  $("says").textContent = arm.solver ? "solved on this page" : "moves on this page; its solver needs the library";
  $("how").textContent = `Drag ${arm.solver ? "the tool to move it, anything else" : "the picture"} to turn the view.`;
  $("plan").textContent = arm.plan;
  $("forward").innerHTML = arm.forward;
  $("inverse").innerHTML = arm.inverse;
  $("joints").innerHTML = arm.joints
    .map((name, i) => {
      const most = arm.kinds[i] ? 1 : Math.PI, [low, high] = arm.limits[i].map((x, k) => x ?? (k ? most : -most));
      return `<label class="joint"><span>${name}</span><input id="joint-${i}" type="range" min="${low}" max="${high}" step="any"><output id="value-${i}"></output></label>`;
    })
    .join("");
  arm.joints.forEach((_, i) =>
    $(`joint-${i}`).addEventListener("input", (event) => {
      state.q[i] = Number(event.target.value);
      $(`value-${i}`).textContent = words(state.q[i], arm.kinds[i]);
      update();
    }),
  );
  move(arm.home);
}

function choose(name) {
  if (known[name]) return show(known[name]);
  const script = document.createElement("script");
  script.src = `arms/${NAMES.find(([own]) => own === name)[1]}.js`;
  script.onerror = () => ($("says").textContent = `${script.src} is missing`);
  document.head.append(script);
}

for (const [label, own] of [["Own arms", true], ["Catalogue", false]]) {
  const names = NAMES.filter((arm) => arm[2] === own).map(([name]) => new Option(name, name));
  if (!names.length) continue;
  const group = document.createElement("optgroup");
  group.label = label;
  group.append(...names);
  $("arm").append(group);
}
$("arm").addEventListener("change", (event) => choose(event.target.value));
// The tool goes where the pointer drags it, turned as it is: of the solutions inside the limits the nearest to where the arm is.
function reachFor([x, y]) {
  const { arm, q, lens } = state, s = arm.solver;
  const T = lens.pose.concat([0, 0, 0, 1]), across = (x - lens.at[0]) / lens.scale, up = (lens.at[1] - y) / lens.scale;
  lens.right.forEach((r, k) => (T[4 * k + 3] += across * r + up * lens.up[k]));
  const found = window.PIEPER.ikAll(arm, T, s.held === null ? 0 : q[s.held]);
  const rows = (found ? found.rows : []).map((row) => window.PIEPER.inside(arm, row)).filter((row) => row);
  const away = (row) => axes(arm, row).reduce((sum, v, j) => sum + (v - axes(arm, q)[j]) ** 2, 0);
  if (rows.length) move(rows.reduce((best, row) => (away(row) < away(best) ? row : best)));
  $("dragged").textContent = rows.length ? "" : "Not reached there inside the limits.";
}

// What is dragged: the view's last place, or the tool by so much beside its point.
let held = null, offset = null;
const where = (event) => [event.offsetX, event.offsetY];
const onTool = (event) => {
  if (!state.arm || !state.arm.solver) return null;
  const d = where(event).map((v, k) => state.lens.at[k] - v);
  return Math.hypot(...d) < 22 ? d : null;
};
$("view").addEventListener("pointerdown", (event) => {
  offset = onTool(event);
  held = [event.clientX, event.clientY];
  $("view").setPointerCapture(event.pointerId);
});
$("view").addEventListener("pointermove", (event) => {
  if (!held) return void ($("view").style.cursor = onTool(event) ? "move" : "grab");
  if (offset) return reachFor(where(event).map((v, k) => v + offset[k]));
  state.view.yaw -= (event.clientX - held[0]) / 150;
  state.view.tilt = Math.min(1.5, Math.max(-0.3, state.view.tilt + (event.clientY - held[1]) / 200));
  held = [event.clientX, event.clientY];
  draw();
});
for (const end of ["pointerup", "pointercancel"])
  $("view").addEventListener(end, () => {
    held = offset = null;
    $("dragged").textContent = "";
  });
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => state.arm && draw());
window.addEventListener("resize", () => state.arm && draw());
const start = NAMES.find((arm) => arm[2]) || NAMES.find(([name]) => name === "denso-vp6242") || NAMES[0];
$("arm").value = start[0];
choose(start[0]);
