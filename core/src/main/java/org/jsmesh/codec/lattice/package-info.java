/**
 * Lattices that coordinates lie on: decimals, steps, translated and scaled ones; found by the encoder, undone by the
 * decoder.
 */
package org.jsmesh.codec.lattice;
