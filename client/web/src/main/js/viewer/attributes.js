// @ts-check
// What attributes of the element mean. Those that model-viewer has too are written as there.

const DEGREES = Math.PI / 180;

/**
 * An angle such as `30deg` or `.5rad`, in radians.
 *
 * @param {string} text
 * @returns {number | null} null when it is none
 */
export function angle(text) {
  const [, number, unit] = /^(-?[\d.]+(?:e-?\d+)?)(deg|rad)$/.exec(text.trim()) ?? [];
  const value = Number(number);
  return Number.isFinite(value) ? value * (unit === 'deg' ? DEGREES : 1) : null;
}

/**
 * A camera's place such as `45deg 75deg 105%`: angle about the upward axis, angle down from it, distance in metres or in
 * percent of that from which all of the model is seen. `auto` leaves a part as it is.
 *
 * @param {string} text
 * @returns {{ theta?: number, phi?: number, radius?: number, share?: number }}
 */
export function cameraOrbit(text) {
  const [first = 'auto', second = 'auto', third = 'auto'] = text.trim().split(/\s+/);
  const [theta, phi] = [angle(first), angle(second)];
  const [, number, unit] = /^([\d.]+)(m|%)$/.exec(third) ?? [];
  const length = Number(number);
  return {
    ...(theta === null ? {} : { theta }),
    ...(phi === null ? {} : { phi }),
    ...(length > 0 ? (unit === 'm' ? { radius: length } : { share: length / 100 }) : {}),
  };
}

/**
 * A place of the model such as `0m 1.5m 0m`.
 *
 * @param {string} text
 * @returns {[number, number, number] | null} null when it is none
 */
export function cameraTarget(text) {
  const numbers = text
    .trim()
    .split(/\s+/)
    .map((part) => (/^-?[\d.]+m?$/.test(part) ? parseFloat(part) : NaN));
  return numbers.length === 3 && numbers.every(Number.isFinite) ? [numbers[0], numbers[1], numbers[2]] : null;
}

/**
 * A number of faces, or `none` for no limit.
 *
 * @param {string | null} text
 * @returns {number | undefined} undefined when it is neither
 */
export function limit(text) {
  return text === 'none' ? Infinity : positive(text, 0) || undefined;
}

/**
 * A number above 0.
 *
 * @param {string | null} text
 * @param {number} otherwise
 */
export function positive(text, otherwise) {
  const value = Number(text);
  return text !== null && Number.isFinite(value) && value > 0 ? value : otherwise;
}
