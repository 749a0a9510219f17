// @ts-check
// Materials of formats other than glTF: colours, a few numbers, and images.

import * as THREE from 'three';
import { CLAY, GREY, ROUGHNESS } from '../first/looks.js';
import { adaptShaders } from './shaders.js';

/** @import { PlainSlot, TextureUse } from '../session/header.js' */
/** @import { Look } from './materials.js' */
/** @import { Opacity } from './opacity.js' */
/** @typedef {{ opacity: Opacity, mask: { texture: THREE.Texture, opacity: Opacity } | null }} Meaning what the opacity of an image means */
/** @typedef {'colour' | 'data' | 'mask'} Reading */
/** @typedef {{ textureOf: (use: TextureUse, reading: Reading) => THREE.Texture | null, meaningOf: (path: string) => Meaning | undefined }} Images those that have arrived */

/** Opacity from which on a surface with holes is there. */
const CUTOFF = 0.5;

/**
 * @param {PlainSlot} slot
 * @param {Images} images
 * @param {Look} look
 */
export function plainMaterial(slot, images, { shading, wireframe, colours }) {
  const { COLOUR, METALLIC, ROUGHNESS: ROUGH, NORMAL, BUMP, EMISSION, OPACITY } = slot.textures;
  const shown = (/** @type {TextureUse | undefined} */ use, /** @type {Reading} */ reading) => (use === undefined ? null : images.textureOf(use, reading));
  const map = shown(COLOUR, 'colour');
  const emissiveMap = shown(EMISSION, 'colour');
  const alphaMap = shown(OPACITY, 'mask');
  const common = {
    map,
    alphaMap,
    emissiveMap,
    normalMap: shown(NORMAL, 'data'),
    bumpMap: shown(BUMP, 'data'),
    bumpScale: BUMP?.factor ?? 1,
    side: THREE.DoubleSide,
    wireframe,
    flatShading: shading === 'flat',
  };
  const material = shading === 'matte' ? new THREE.MeshLambertMaterial({ ...common, toneMapped: false }) : new THREE.MeshStandardMaterial(common);
  if (material instanceof THREE.MeshStandardMaterial) {
    material.metalnessMap = shown(METALLIC, 'data');
    material.roughnessMap = shown(ROUGH, 'data');
    material.roughness = slot.roughness >= 0 ? slot.roughness : ROUGHNESS;
    material.metalness = METALLIC !== undefined && material.metalnessMap === null ? 0 : Math.max(0, slot.metallic);
  }
  const [r, g, b, alpha] = slot.colour ?? [...(shading === 'matte' ? GREY : CLAY), 1];
  material.color.setRGB(r, g, b, THREE.SRGBColorSpace);
  // Many MTL files give a textured material a black or grey Kd that no viewer applies.
  if (map !== null) material.color.setRGB(1, 1, 1);
  if (slot.emission !== null && (EMISSION === undefined || emissiveMap !== null)) material.emissive.setRGB(...slot.emission, THREE.SRGBColorSpace);
  // The images count from their upper left corner, so v grows downwards.
  material.normalScale.set(NORMAL?.factor ?? 1, -(NORMAL?.factor ?? 1));
  const opacities = [COLOUR && images.meaningOf(COLOUR.path)?.opacity, OPACITY && images.meaningOf(OPACITY.path)?.mask?.opacity];
  if (alpha < 1 || opacities.includes('glass')) {
    material.transparent = true;
    material.opacity = alpha;
    material.depthWrite = false;
  }
  if (opacities.includes('holes')) material.alphaTest = CUTOFF * alpha;
  adaptShaders(material, { colours, tangents: false });
  return material;
}
