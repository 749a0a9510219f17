/**
 * Vertices, faces, wedges and materials of a triangle mesh, its half-edge adjacency and its identity.
 *
 * <pre>{@code
 * Mesh square = new MeshBuilder()
 *         .positions(new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})
 *         .faceWedges(new int[] {0, 1, 2, 0, 2, 3})
 *         .build();
 * for (int face = 0; face < square.faces(); face++) System.out.println("from vertex " + square.vertex(face, 0));
 * System.out.println("identity " + MeshIdentity.sha256(square));
 * }</pre>
 */
package org.jsmesh.mesh;
