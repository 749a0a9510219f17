// @ts-check
// Numbers as people read them, in the language of the page.

const LANGUAGE = 'en';
/** Percent of the diagonal that no picture shows. */
const LEAST_DISTANCE = 1e-5;
const whole = new Intl.NumberFormat(LANGUAGE);
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
  return `${scaled.toLocaleString(LANGUAGE, { minimumFractionDigits: digits, maximumFractionDigits: digits })} ${UNITS[unit]}`;
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
  if (percentOfDiagonal < LEAST_DISTANCE) return `< ${LEAST_DISTANCE.toFixed(5)} %`;
  return `${percentOfDiagonal.toLocaleString(LANGUAGE, { maximumSignificantDigits: 2 })} %`;
}

/**
 * A bounding box in the coordinates of the file, to four digits of its longest side.
 *
 * @param {number[]} bounds smallest x, y, z, then largest
 * @param {number[]} origin what they count from
 */
export function box(bounds, origin) {
  const longest = Math.max(...[0, 1, 2].map((axis) => bounds[axis + 3] - bounds[axis]));
  const digits = longest > 0 ? Math.max(0, Math.min(20, 3 - Math.floor(Math.log10(longest)))) : 6;
  const [x, y, z, toX, toY, toZ] = bounds.map((bound, i) =>
    (origin[i % 3] + bound).toLocaleString(LANGUAGE, { maximumFractionDigits: digits }),
  );
  return `Coordinates from ${x} | ${y} | ${z} to ${toX} | ${toY} | ${toZ}`;
}
