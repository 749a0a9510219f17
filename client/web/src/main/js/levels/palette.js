// @ts-check
// Colours for numbers. They go from dark blue over green to yellow, brighter all the way, so that they keep their order for those who see few colours, and in print.

/** The colour map viridis at equal distances, sRGB. */
const STOPS = [0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725];

const OPAQUE = 255;
/** Colours that are reckoned once for many numbers. */
const SHADES = 1024;

/**
 * The colour of a share, as bytes red, green, blue.
 *
 * @param {number} share from 0 to 1
 * @returns {[number, number, number]}
 */
export function colourOf(share) {
  const at = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const stop = Math.min(Math.floor(at), STOPS.length - 2);
  const part = (/** @type {number} */ shift) => {
    const from = (STOPS[stop] >> shift) & 255;
    const to = (STOPS[stop + 1] >> shift) & 255;
    return Math.round(from + (at - stop) * (to - from));
  };
  return [part(16), part(8), part(0)];
}

/**
 * The same for a style sheet.
 *
 * @param {number} share
 */
export function cssOf(share) {
  return `rgb(${colourOf(share).join(' ')})`;
}

/** All of the map, from left to right, for a style sheet. */
export function cssGradient() {
  return `linear-gradient(to right, ${STOPS.map((_, i) => cssOf(i / (STOPS.length - 1))).join(', ')})`;
}

/**
 * The share of a level.
 *
 * @param {number} level
 * @param {number} most the last level that there is
 */
export function shareOfLevel(level, most) {
  return most > 0 ? level / most : 0;
}

/**
 * Colours of distances, sRGB and opacity.
 *
 * @param {Float32Array} distances
 * @param {number} most the distance at the bright end of the scale
 */
export function shaded(distances, most) {
  const shades = Uint32Array.from({ length: SHADES }, (_, i) => {
    const [r, g, b] = colourOf(i / (SHADES - 1));
    return (OPAQUE << 24) | (b << 16) | (g << 8) | r;
  });
  const colours = new Uint8Array(4 * distances.length);
  const words = new DataView(colours.buffer);
  const scale = most > 0 ? (SHADES - 1) / most : 0;
  for (let i = 0; i < distances.length; i++) words.setUint32(4 * i, shades[Math.min(SHADES - 1, Math.round(scale * distances[i]))], true);
  return colours;
}
