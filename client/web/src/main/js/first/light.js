// @ts-check
// What the small renderer and three.js share of their light.

/** The key light comes over the viewer's left shoulder, in the eye's directions. @type {[number, number, number]} */
export const KEY_DIRECTION = [-0.6, 0.9, 0.7];

/**
 * A face that is seen from behind shows the other side of its normal n. At a silhouette, where a face may be seen from
 * either side by a rounding error, n is bent towards the eye instead: both sides get the same light there.
 */
export const FACING = 'float away=-dot(n,toEye);if(!gl_FrontFacing&&away>0.)n=normalize(mix(n+2.*away*toEye,-n,smoothstep(0.,.2,away)));';
