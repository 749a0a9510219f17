/** Wedges and the values of their channels: normals, texture coordinates, colours. */
package org.jsmesh.codec.attribute;
