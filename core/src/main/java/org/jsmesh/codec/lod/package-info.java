/** The mesh while it is refined: fans of vertices, corners, numbering and normals. */
package org.jsmesh.codec.lod;
