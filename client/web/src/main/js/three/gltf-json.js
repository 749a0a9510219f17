// @ts-check
// One glTF of materials alone, put together from the materials that an archive keeps one by one.

/**
 * What an image says decides how it is read, and what stands in for it.
 *
 * @typedef {'colour' | 'emission' | 'normal' | 'direction' | 'data'} Kind
 */
/** @typedef {Record<string, any>} Json */
/** @typedef {{ path: string, sampler: Json, kind: Kind, glossiness?: number }} TextureUse `glossiness`: factor of alpha, where an image is to say roughness and its alpha says the contrary */
/** @typedef {{ gltf: Json, images: string[] }} Kept a material with textures in place of their numbers, and paths of their images */

/** @type {Record<string, Kind>} */
const KINDS = {
  baseColorTexture: 'colour',
  diffuseTexture: 'colour',
  sheenColorTexture: 'colour',
  specularColorTexture: 'colour',
  diffuseTransmissionColorTexture: 'colour',
  emissiveTexture: 'emission',
  normalTexture: 'normal',
  clearcoatNormalTexture: 'normal',
  anisotropyTexture: 'direction',
};
/** Graphics cards are given no more sets of texture coordinates. */
const MOST_COORDINATES = 4;
const OLD_SURFACE = 'KHR_materials_pbrSpecularGlossiness';

/**
 * Gives the glTF, with the materials in their order, and its textures in theirs.
 *
 * @param {Kept[]} materials
 */
export function gltfOf(materials) {
  /** @type {Map<string, number>} */
  const numbers = new Map();
  /** @type {TextureUse[]} */
  const uses = [];
  /** @param {TextureUse} use */
  const number = (use) => {
    const key = JSON.stringify(use);
    const known = numbers.get(key) ?? uses.push(use) - 1;
    numbers.set(key, known);
    return known;
  };
  const json = {
    asset: { version: '2.0' },
    extensionsUsed: ['KHR_materials_unlit', 'KHR_texture_transform'],
    materials: materials.map(({ gltf, images }) => lifted(gltf, images, number)),
    textures: uses.map((_, i) => ({ source: i })),
  };
  return { json, uses };
}

/**
 * The value with numbers for its textures; those without an image are left out.
 *
 * @param {any} value
 * @param {string[]} images
 * @param {(use: TextureUse) => number} number
 * @returns {any}
 */
function lifted(value, images, number) {
  if (Array.isArray(value)) return value.map((part) => lifted(part, images, number));
  if (value === null || typeof value !== 'object') return value;
  /** @type {Json} */
  const copy = {};
  for (const [name, part] of Object.entries(value)) {
    if (name === 'extras') continue;
    const texture = part?.index;
    if (typeof texture !== 'object' || texture === null) {
      copy[name] = lifted(part, images, number);
      continue;
    }
    const path = images[sourceOf(texture)];
    if (path === undefined || coordinatesOf(part) >= MOST_COORDINATES) continue;
    /** @type {TextureUse} */
    const use = { path, sampler: texture.sampler ?? {}, kind: KINDS[name] ?? 'data' };
    if (texture.glossiness !== undefined) use.glossiness = texture.glossiness;
    copy[name] = { ...part, index: number(use) };
  }
  return copy;
}

/** @param {Json} info */
function coordinatesOf(info) {
  return info.extensions?.KHR_texture_transform?.texCoord ?? info.texCoord ?? 0;
}

/**
 * The image that every viewer reads, or else one in a later format.
 *
 * @param {Json} texture
 */
function sourceOf({ source, extensions = {} }) {
  const { EXT_texture_webp: webp, EXT_texture_avif: avif, KHR_texture_basisu: basis } = extensions;
  return source ?? webp?.source ?? avif?.source ?? basis?.source;
}

/**
 * Colours of what a surface scatters and mirrors, in words that three.js knows.
 *
 * @param {Json} material
 * @returns {Json}
 */
export function modern(material) {
  const old = material.extensions?.[OLD_SURFACE];
  if (!old || material.pbrMetallicRoughness) return material;
  const { diffuseFactor, diffuseTexture, specularFactor = [1, 1, 1], glossinessFactor = 1, specularGlossinessTexture: both } = old;
  const { [OLD_SURFACE]: _, ...extensions } = material.extensions;
  /** @type {Json} */
  const surface = { metallicFactor: 0, roughnessFactor: 1 - glossinessFactor };
  if (diffuseFactor) surface.baseColorFactor = diffuseFactor;
  if (diffuseTexture) surface.baseColorTexture = diffuseTexture;
  /** @type {Json} */
  const specular = { specularColorFactor: specularFactor };
  if (both) {
    specular.specularColorTexture = both;
    surface.metallicRoughnessTexture = { ...both, index: { ...both.index, glossiness: glossinessFactor } };
    surface.roughnessFactor = 1;
  }
  // A surface whose mirrored colour says it all: nothing is left to the angle at which light falls.
  extensions.KHR_materials_ior = { ior: 1000 };
  extensions.KHR_materials_specular = specular;
  return { ...material, pbrMetallicRoughness: surface, extensions };
}
