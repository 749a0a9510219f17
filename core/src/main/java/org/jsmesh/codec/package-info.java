/** The whole of a mesh in both directions: its format, and the coder of base, splits, sweeps and order. */
package org.jsmesh.codec;
