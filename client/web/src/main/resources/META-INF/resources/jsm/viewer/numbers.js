// @ts-check
// Numbers as people read them, in the browser's language.

const whole = new Intl.NumberFormat();
const UNITS = ['bytes', 'kB', 'MB', 'GB'];

/** @param {number} value */
export function count(value) {
  return whole.format(value);
}

/** @param {number} value */
export function faces(value) {
  return `${count(value)} ${value === 1 ? 'face' : 'faces'}`;
}

/** @param {number} value */
export function bytes(value) {
  let unit = 0;
  let scaled = value;
  while (scaled >= 1000 && unit < UNITS.length - 1) {
    scaled /= 1000;
    unit++;
  }
  const digits = unit === 0 || scaled >= 100 ? 0 : scaled >= 10 ? 1 : 2;
  return `${scaled.toLocaleString(undefined, { minimumFractionDigits: digits, maximumFractionDigits: digits })} ${UNITS[unit]}`;
}

/** @param {number} bytesPerSecond */
export function rate(bytesPerSecond) {
  return bytesPerSecond > 0 ? `${bytes(bytesPerSecond)}/s` : '–';
}

/**
 * A share of 1 in percent; 100% only when it is all.
 *
 * @param {number} share
 */
export function percent(share) {
  return `${share >= 1 ? 100 : Math.min(99, Math.floor(share * 100))} %`;
}

/**
 * An error in percent of the diagonal.
 *
 * @param {number} percentOfDiagonal
 */
export function distance(percentOfDiagonal) {
  if (percentOfDiagonal === 0) return '0';
  return `${percentOfDiagonal.toLocaleString(undefined, { maximumSignificantDigits: 2 })} %`;
}
