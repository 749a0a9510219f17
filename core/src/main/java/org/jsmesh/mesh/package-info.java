/** Vertices, faces, wedges and materials of a triangle mesh, its half-edge adjacency and its identity. */
package org.jsmesh.mesh;
