// Numbers as engineers write them: three digits at most, units with prefixes for times, 1.2e-10 for what is tiny.

export const k_missing = '–';

/** @param {any} value @returns {value is number} */
export const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

/** @param {string} text: digits with an exponent of JavaScript, 1.20e-10 @returns {string} 1.2e-10 */
function tidied(text) {
  const [digits, exponent] = text.split('e');
  const short = digits.includes('.') ? digits.replace(/\.?0+$/, '') : digits;
  return exponent === undefined ? short : `${short}e${exponent.replace('+', '')}`;
}

/** Errors, drifts, tolerances: 0.0012 is 1.2e-3, since powers of ten are compared. */
export function small(/** @type {any} */ value, digits = 2) {
  if (!isNumber(value)) return k_missing;
  return value === 0 ? '0' : tidied(value.toExponential(digits - 1));
}

/** The same for columns: always two digits, so that those of a column stand below each other. */
export function column(/** @type {any} */ value) {
  if (!isNumber(value)) return k_missing;
  return value === 0 ? '0' : value.toExponential(1).replace('e+', 'e');
}

/**
 * Factors of a column, with two digits at least: 0.012, 1.30, 12.4, or all with a power of ten where one of them is tiny or huge.
 * @param {any[]} values @returns {(value: any) => string}
 */
export function factors(values) {
  const arePlain = values.filter(isNumber).every((value) => value === 0 || (value >= 0.01 && value < 1e5));
  return arePlain ? factor : column;
}

function factor(/** @type {any} */ value) {
  if (!isNumber(value)) return k_missing;
  if (value === 0) return '0';
  return value < 0.995 ? value.toPrecision(2) : value < 10 ? value.toFixed(2) : value < 100 ? value.toFixed(1) : plain(value);
}

/** What is counted, with all its digits: those of a column stand below each other. */
export const count = (/** @type {any} */ value) => isNumber(value) ? grouped(Math.round(value)) : k_missing;

/** Any number: 1.23, 812, 0.031, 4.1e6, with `digits` digits where it is no integer below a million. */
export function plain(/** @type {any} */ value, digits = 3) {
  if (!isNumber(value)) return k_missing;
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e6) return grouped(value);
  if (size >= 1e-3 && size < 1e6) {
    const rounded = Number(value.toPrecision(digits));
    return Math.abs(rounded) >= 1e4 ? grouped(rounded) : tidied(value.toPrecision(digits).includes('e') ? String(rounded) : value.toPrecision(digits));
  }
  return tidied(value.toExponential(digits - 1));
}

/** 12345 is 12 345: a thin space, and only from five digits on. */
function grouped(/** @type {number} */ value) {
  const text = String(value);
  return Math.abs(value) < 1e4 ? text : text.replace(/\B(?=(\d{3})+$)/g, '\u202f');
}

const k_times = /** @type {[number, string][]} */ ([[1, 's'], [1e-3, 'ms'], [1e-6, 'µs'], [1e-9, 'ns']]);

/** Seconds with a prefix: 3.4 ms. Three digits, so that times of a column can be compared. */
export function seconds(/** @type {any} */ value) {
  if (!isNumber(value)) return k_missing;
  if (value === 0) return '0 s';
  const rounded = Number(value.toPrecision(3));
  const [unit, name] = k_times.find(([size]) => Math.abs(rounded) >= size * (1 - 1e-12)) ?? k_times[3];
  const digits = rounded / unit;
  return `${Math.abs(digits) >= 1000 ? grouped(Math.round(digits)) : digits.toPrecision(3)} ${name}`;
}

/** A ratio: 1.7 times, 41 times. */
export function times(/** @type {any} */ value) {
  return isNumber(value) ? `${plain(value, value < 10 ? 2 : 3)} times` : k_missing;
}

/**
 * How numbers that are read together are written: all with a point, or all with a power of ten. Labels of an axis, which are round.
 * @param {number[]} values @returns {(value: number) => string}
 */
export const alike = (values) => values.every((value) => value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) <= 1e5)) ? (value) => plain(value) : (value) => small(value, 2);

/** @param {number} count @param {string} one @param {string} [many] */
export const counted = (count, one, many = `${one}s`) => `${plain(count)} ${count === 1 ? one : many}`;
