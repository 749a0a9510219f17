// @ts-check
// What the first pictures show of a material: colours and factors, no images.

/** @import { GltfSlot, PlainSlot, Slot } from '../session/header.js' */
/** @import { Shading } from '../session/shading.js' */
/**
 * @typedef {object} Look
 * @property {number[]} base linear red, green, blue, and opacity
 * @property {number[]} emission linear red, green, blue
 * @property {number} metal
 * @property {number} rough
 * @property {boolean} blended
 * @property {boolean} oneSided
 * @property {boolean} coloured whether vertices have colours
 */

/** Models without colours: warm in the studio's light, neutral in the matte one. */
export const CLAY = [0.74, 0.71, 0.66];
export const GREY = [0.8, 0.8, 0.8];
/** Of a material that says nothing of it. */
export const ROUGHNESS = 0.62;

/**
 * @param {Slot} slot
 * @param {Shading} shading
 * @returns {Look}
 */
export function plainLook(slot, shading) {
  return 'gltf' in slot ? ofGltf(slot) : ofPlain(slot, shading);
}

/**
 * @param {PlainSlot} slot
 * @param {Shading} shading
 * @returns {Look}
 */
function ofPlain({ colour, metallic, roughness, emission, textures }, shading) {
  const [r, g, b, alpha] = colour ?? [...(shading === 'matte' ? GREY : CLAY), 1];
  return {
    base: [...[r, g, b].map(linear), alpha],
    emission: emission !== null && textures.EMISSION === undefined ? emission.map(linear) : [0, 0, 0],
    metal: textures.METALLIC === undefined ? Math.max(0, metallic) : 0,
    rough: roughness >= 0 ? roughness : ROUGHNESS,
    blended: alpha < 1,
    oneSided: false,
    coloured: false,
  };
}

/**
 * @param {GltfSlot} slot
 * @returns {Look}
 */
function ofGltf({ gltf }) {
  // What an archive says may be anything.
  const { pbrMetallicRoughness, emissiveFactor, emissiveTexture, alphaMode, doubleSided } = parsed(gltf);
  const { baseColorFactor, metallicFactor, roughnessFactor, metallicRoughnessTexture } = pbrMetallicRoughness ?? {};
  const [r, g, b, alpha] = numbers(baseColorFactor, 4) ?? [1, 1, 1, 1];
  return {
    base: [r, g, b, alphaMode === 'BLEND' ? alpha : 1],
    emission: (emissiveTexture === undefined && numbers(emissiveFactor, 3)) || [0, 0, 0],
    metal: metallicRoughnessTexture === undefined ? number(metallicFactor) : 0,
    rough: number(roughnessFactor),
    blended: alphaMode === 'BLEND',
    oneSided: doubleSided !== true,
    coloured: false,
  };
}

/** @param {string} text @returns {Record<string, any>} */
function parsed(text) {
  try {
    return JSON.parse(text) ?? {};
  } catch {
    return {};
  }
}

/** @param {unknown} value @param {number} length @returns {number[] | null} */
function numbers(value, length) {
  return Array.isArray(value) && value.length === length && value.every((n) => Number.isFinite(n)) ? value : null;
}

/** @param {unknown} value */
function number(value) {
  return typeof value === 'number' && Number.isFinite(value) ? Math.min(Math.max(value, 0), 1) : 1;
}

/** @param {number} screen sRGB, 0 to 1 */
function linear(screen) {
  return screen <= 0.04045 ? screen / 12.92 : ((screen + 0.055) / 1.055) ** 2.4;
}
