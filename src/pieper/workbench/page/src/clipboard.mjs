// Numbers on a clipboard, as rows of entries: a block of a spreadsheet, CSV, or brackets as Python, NumPy, MATLAB and LaTeX write them.

/** Signs that a clipboard may have: more is no table that has room here. */
const LONGEST = 20_000;

/** Rows of entries as they were written; an empty cell of a spreadsheet is an entry too, '', so that the others keep their places. */
export function block(text) {
  if (text.length > LONGEST) throw new Error(`longer than ${LONGEST} characters`);
  const plain = undressed(text);
  if (/[[\]{}]/.test(plain) || listAt(plain, plain.search(/\S/))) return bracketed(plain);
  if (plain.includes('\t')) return sheet(plain, '\t');
  return plain.includes(';') ? semicolons(plain) : lines(plain);
}
/** The same where there is more than one entry, null otherwise: that is left to the field. */
export function pasted(text) {
  if (text.length > LONGEST) return null;
  const rows = block(text);
  return rows.length > 1 || (rows[0]?.length ?? 0) > 1 ? rows : null;
}

// ---- what stands around the numbers
function undressed(text) {
  let t = text.replace(/\r\n?/g, '\n').replace(/[\u00a0\u202f\u2007]/g, ' ');
  if (/\\begin\b|&/.test(t))
    t = t
      .replace(/\\(?:begin|end)\s*\{[^}]*\}(?:\{[clr|]*\})?|\\(?:left|right)\s*[[\]().|]|\\hline|\$/g, '')
      .replace(/[ \t]+/g, ' ')
      .replace(/\\\\(?:\[[^\]]*\])?\s*/g, '\n')
      .replaceAll('\\', '')
      .replace(/ ?& ?/g, '\t');
  return t
    .replace(/^\s*[A-Za-z_][\w.]*\s*=\s*/, '') // T = …
    .replace(/\b(?:np|numpy)\.(?:float|double|single|int)\w*\(([^()]*)\)/g, '$1')
    .replace(/^\s*[A-Za-z_][\w.]*\s*\(\s*(?=[[{])/, '') // array([…
    .replace(/(?:,\s*[A-Za-z_]\w*\s*=\s*[\w.'"]+\s*)*\)?\s*[;,]?\s*$/, (end) => (/[=;,]/.test(end) ? '' : end))
    .replace(/^(?:[ ]*\n)+|\n\s*$/g, '');
}

// ---- one row: which sign parts its entries
const BETWEEN = /\s*,\s+|\s+,\s*|\s+/;
/** Blanks that belong to an expression: "pi / 2", "a - b", "90 deg". */
const glued = (line) =>
  line
    .trim()
    .replace(/\s*([*/^·])\s*/g, '$1')
    .replace(/(?<=[\w.)°π])\s+([-+−])\s+(?=\S)/g, '$1')
    .replace(/(?<=[\d.)πi])\s+(?=(?:deg|rad|mm|cm|m|°)(?![\wπ]))/g, '')
    .replace(/\(\s+/g, '(')
    .replace(/\s+\)/g, ')');
/** One number with the signs of its thousands, in either country: its field says why it cannot be read. */
const THOUSANDS = /^[-+−]?\d{1,3}(?:(?:,\d{3})+(?:\.\d*)?|(?:\.\d{3})+,\d*)$/;
/** A comma is the decimal sign where something else parts the entries and no point is one. */
const commasAreDecimal = (text) =>
  /\d,\d/.test(text) && !/,(?!\d)|(?<!\d),|\./.test(text) && /[\d)][ \t]+[-+−]?\d/.test(text);

/** Every line of these is parted by the same sign; returns how, or null where each is one entry. */
function parter(list) {
  const full = list.filter(Boolean);
  if (full.some((l) => /,\s|\s,/.test(l.replace(/,$/, '')))) return (l) => l.split(/\s*,\s*|\s+/);
  if (full.some((l) => /\s/.test(l))) return (l) => l.split(BETWEEN);
  if (full.every((l) => THOUSANDS.test(l))) return null;
  const compact = (l) => !THOUSANDS.test(l) && (/,.*,/.test(l) || (l.includes(',') && /[.A-Za-zπ(]|,[-+−]/.test(l)));
  return full.some(compact) ? (l) => l.split(',') : null;
}
const withoutEnds = (row) => {
  const out = row.map((v) => v.trim());
  if (out.at(-1) === '') out.pop(); // "1, 2," ends with its sign
  return out;
};

// ---- whole texts
function lines(text) {
  const list = text.split('\n').map(glued);
  const split = parter(list);
  // a column may have empty cells; between rows of more, an empty line is room
  return split ? list.filter(Boolean).map((l) => withoutEnds(split(l))) : list.map((l) => [l.replace(/,$/, '')]);
}
function sheet(text, sign) {
  const rows = text
    .split('\n')
    .filter((line) => line.includes(sign) || line.trim())
    .map((line) => line.split(sign).map((v) => v.trim().replace(/^"(.*)"$/, '$1')));
  while (rows.length && rows.at(-1).every((v) => !v)) rows.pop();
  return rows;
}
/** Between entries as spreadsheets of many countries write them, or between rows as MATLAB does. */
function semicolons(text) {
  const list = text.split('\n').filter((l) => l.trim());
  const parts = text.split(/[;\n]/).map(glued).filter(Boolean);
  const ends = list.length > 1 && list.slice(0, -1).every((l) => /^[^;]*;\s*$/.test(l));
  if (ends || parter(parts)) return lines(parts.join('\n'));
  return sheet(text, ';');
}
/** Whether a bracket at this place begins a list: it has a comma of its own, and nothing before it that it would belong to. */
function listAt(text, at) {
  if (text[at] !== '(' || /[\w)π°.*/^+−-]\s*$/.test(text.slice(0, at))) return false;
  let depth = 0;
  for (let i = at; i < text.length; i++) {
    if ('(['.includes(text[i])) depth += 1;
    else if (')]'.includes(text[i]) && (depth -= 1) === 0) return false;
    else if (text[i] === ',' && depth === 1) return true;
  }
  return false;
}
function bracketed(text) {
  const nested = /[[({]\s*[[({]|[\])}]\s*,?\s*[[({]/.test(text),
    decimal = commasAreDecimal(text.replace(/[\])}]\s*,\s*(?=[[({])/g, ';')),
    rows = [];
  const open = []; // whether each bracket that is open is a list's
  let line = '';
  const close = () => {
    const inner = nested ? line.replaceAll('\n', ' ') : line.replace(/(,|\.\.\.)\s*\n/g, '$1 ');
    for (const part of inner.replaceAll('...', ' ').split(/[;\n]/)) {
      const row = glued(part)
        .split(decimal ? /\s+/ : /\s*,\s*|\s+/)
        .filter(Boolean);
      if (row.some((v) => /[\wπ]/.test(v))) rows.push(row);
    }
    line = '';
  };
  for (let i = 0; i < text.length; i++) {
    const c = text[i];
    if ('[{'.includes(c) || (c === '(' && listAt(text, i))) {
      open.push(true);
      close();
    } else if (c === '(') {
      open.push(false);
      line += c;
    } else if ('])}'.includes(c)) {
      if (open.pop() ?? c !== ')') close();
      else line += c;
    } else line += c;
  }
  close();
  return rows;
}
