// @ts-check
// The shape of what an archive says of itself.

/**
 * How a material uses an image.
 *
 * @typedef {object} TextureUse
 * @property {string} path of the image
 * @property {boolean} clamped the colour of the edge goes on outside the image; else the image repeats
 * @property {[number, number, number, number, number, number]} transform a, b, c, d, e, f: (u, v) lies at (au + bv + c, du + ev + f) on the image, from its upper left corner
 * @property {number} factor scale of bumps
 */
/** @typedef {'COLOUR' | 'METALLIC' | 'ROUGHNESS' | 'NORMAL' | 'BUMP' | 'OCCLUSION' | 'EMISSION' | 'OPACITY'} Use what an image is for */
/**
 * How a display slot looks that is not from glTF: those faces that are drawn with one material. Colours are sRGB.
 *
 * @typedef {object} PlainSlot
 * @property {[number, number, number, number] | null} colour red, green, blue, opacity, or null for the viewer's own
 * @property {number} metallic 0 to 1, or -1 when the material does not say
 * @property {number} roughness 0 to 1, or -1 when the material does not say
 * @property {[number, number, number] | null} emission red, green, blue of light that it sends out
 * @property {Partial<Record<Use, TextureUse>>} textures
 */
/**
 * A display slot from glTF.
 *
 * @typedef {object} GltfSlot
 * @property {string} gltf the material as JSON: in place of its number each texture stands itself, with its sampler
 * @property {string[]} images paths of the images that sources of textures number
 */
/** @typedef {PlainSlot | GltfSlot} Slot */
/**
 * What to say of the original once it is proved: the decoder has the words, as command and window have them.
 *
 * @typedef {object} Words
 * @property {string} claim a clause
 * @property {boolean} warning is it not the whole original?
 * @property {string} notKept what else of the file is not in the archive, a clause; empty when nothing is lost
 */
/**
 * What an archive says of itself: totals, identity, and the columns of its index, one element per batch.
 *
 * @typedef {object} Header
 * @property {boolean} whole false while only its first part has arrived, which knows the first batches alone; totals are then null, and bounds too large
 * @property {number | null} faces
 * @property {number | null} vertices
 * @property {number | null} wedges
 * @property {string | null} meshSha256
 * @property {string | null} modelSha256
 * @property {number | null} levels
 * @property {Words | null} words
 * @property {number[]} bounds smallest x, y, z, then largest
 * @property {number[]} origin what bounds and positions count from; zeros but in double precision
 * @property {string} up the axis that points up: `y`, `z` or `unknown`
 * @property {boolean} isClosed whether the original bounds a solid, so that nobody outside sees a face from behind
 * @property {{ semantic: string, name: string }[]} channels
 * @property {Slot[]} slots
 * @property {number} archiveBytes
 * @property {number[]} ends the byte behind each batch
 * @property {number[]} batchFaces
 * @property {number[]} batchLevels
 * @property {number[]} precisionBits
 * @property {number[]} errorMeans in percent of the diagonal
 * @property {number[]} errorQuantiles distances that 99.9% of the surface does not exceed, in percent of the diagonal
 */

export {};
