// Units that the person picks, and numbers as text: SI inside, degrees or radians and millimetres or metres outside.
const DEG = 180 / Math.PI;
const choice = { angle: 'deg', length: 'mm' };
const symbol = { deg: '°', rad: 'rad', mm: 'mm', m: 'm' };
const perSI = { deg: DEG, rad: 1, mm: 1000, m: 1 };
const digits = { deg: 2, rad: 4, mm: 2, m: 5 };
const step = { deg: 1, rad: 0.02, mm: 5, m: 0.005 };

export const units = {
  get angle() {
    return choice.angle;
  },
  get length() {
    return choice.length;
  },
  set(kind, name) {
    if (name in perSI && kind in choice) choice[kind] = name;
  },
  /** Shown value = SI value times this. */
  factor: (kind) => (kind in choice ? perSI[choice[kind]] : 1),
  symbol: (kind) => (kind in choice ? symbol[choice[kind]] : ''),
  digits: (kind) => (kind in choice ? digits[choice[kind]] : 4),
  /** One keyboard step, SI. */
  step: (kind) => (kind in choice ? step[choice[kind]] / perSI[choice[kind]] : 0.01),
  suffix: (kind) =>
    kind === 'angle' ? { deg: DEG, '°': DEG, rad: 1 } : kind === 'length' ? { mm: 1000, m: 1, cm: 100 } : {},
};

/** A number with fixed digits and a true minus sign; -0 reads 0. */
export function fixed(value, n) {
  if (!Number.isFinite(value)) return value === Infinity ? '∞' : value === -Infinity ? '−∞' : '–';
  const s = value.toFixed(n);
  return Number(s) === 0 ? s.replace('-', '') : s.replace('-', '−');
}
/** SI value to shown text without its unit. */
export const show = (value, kind, n = units.digits(kind)) => fixed(value * units.factor(kind), n);
/** SI value to shown text with its unit. */
export const showUnit = (value, kind, n) =>
  `${show(value, kind, n)}${kind === 'angle' && choice.angle === 'deg' ? '' : ' '}${units.symbol(kind)}`;
/** For an input field: shortest text that keeps nine digits, with an ASCII minus. */
export const plain = (value, kind = 'plain') => String(Number((value * units.factor(kind)).toPrecision(9)) + 0);
/** Short scientific text such as 3e-16 for residuals. */
export const tiny = (v) => (v === 0 ? '0' : v.toExponential(0).replace('-', '−'));

/**
 * Half of the last digit that somebody typed, SI: of the finest of these texts, and never less than of what the page shows,
 * since a whole number is as a rule meant as it stands.
 */
export function halfDigit(texts, kind) {
  const typed = texts.map((t) => /^[-+−]?\d*[.,](\d+)$/.exec(t.trim())?.[1].length ?? 0);
  const decimals = Math.max(0, ...typed) || units.digits(kind);
  return (0.5 * 10 ** -decimals) / units.factor(kind);
}

/** A figure without a unit: four places, or three digits and a power of ten where it is very small or large. */
export const engineering = (v) =>
  v === 0 ? '0' : Math.abs(v) >= 1e-3 && Math.abs(v) < 1e4 ? fixed(v, 4) : v.toExponential(2).replace('-', '−');
