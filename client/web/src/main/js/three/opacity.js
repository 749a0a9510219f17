// @ts-check
// What the opacity of an image means: nothing, holes in a surface, or glass.

/**
 * `holes` are cut out, so that the order of drawing does not matter; `glass` is blended with what is behind it.
 *
 * @typedef {'opaque' | 'holes' | 'glass'} Opacity
 */

/** Alpha from here on is opaque, and below this one unseen: filters and lossy images are off by a few. */
const OPAQUE = 250;
const UNSEEN = 16;
const JPEG = [0xff, 0xd8];
const BMP = [0x42, 0x4d];

/**
 * Whether the file is of a kind that can have opacity.
 *
 * @param {Uint8Array} file
 */
export function mayHaveOpacity(file) {
  return ![JPEG, BMP].some((mark) => mark.every((byte, i) => file[i] === byte));
}

/**
 * A mask has pixels that are seen and pixels that are not, and few between them at its edges. An image that is unseen
 * everywhere has no opacity at all: some programs leave it 0.
 *
 * @param {ArrayLike<number>} rgba four bytes per pixel
 * @returns {Opacity}
 */
export function opacityOf(rgba) {
  let unseen = 0;
  let between = 0;
  for (let i = 3; i < rgba.length; i += 4) {
    if (rgba[i] < UNSEEN) unseen++;
    else if (rgba[i] < OPAQUE) between++;
  }
  if (unseen + between === 0 || unseen === rgba.length / 4) return 'opaque';
  return between <= unseen ? 'holes' : 'glass';
}

/**
 * The opacity that an image says as a mask: its alpha, or its brightness where it has none.
 *
 * @param {ArrayLike<number>} rgba four bytes per pixel
 * @returns {Uint8Array<ArrayBuffer>} the opacity in all four bytes of each pixel
 */
export function maskOf(rgba) {
  const byAlpha = opacityOf(rgba) !== 'opaque';
  const mask = new Uint8Array(rgba.length);
  for (let i = 0; i < rgba.length; i += 4) {
    const bright = 0.2126 * rgba[i] + 0.7152 * rgba[i + 1] + 0.0722 * rgba[i + 2];
    mask.fill(byAlpha ? rgba[i + 3] : Math.round(bright), i, i + 4);
  }
  return mask;
}

/**
 * The pixels of an image, not premultiplied.
 *
 * @param {ImageBitmap} image
 * @param {number} most pixels a side; of a larger image some are left out
 */
export function pixelsOf(image, most = Infinity) {
  const width = Math.min(image.width, most);
  const height = Math.min(image.height, most);
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) throw new Error('the browser gives no canvas to read an image with');
  context.imageSmoothingEnabled = false;
  context.drawImage(image, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}
