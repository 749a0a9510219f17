// @ts-check
// The ways in which a model can be shaded.

/** @typedef {'smooth' | 'flat' | 'matte' | 'normals'} Shading `matte` is plain diffuse light; `normals` shows each face in the colour of its direction */

/** @type {Shading[]} */
export const SHADINGS = ['smooth', 'flat', 'matte', 'normals'];
