/**
 * Lattices that coordinates lie on: decimals, translated and scaled ones. The encoder finds them and the decoder undoes
 * them.
 */
package org.jsmesh.codec.lattice;
