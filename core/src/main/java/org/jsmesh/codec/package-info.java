/**
 * Entropy coder, context models, predictors and coordinate lattices: base meshes and vertex splits to bytes and back.
 */
package org.jsmesh.codec;
