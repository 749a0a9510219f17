/**
 * What is drawn of a mesh, the same for page, window and measurement: render vertices of wedges, normals with crease
 * angles, display materials.
 *
 * <pre>{@code
 * double crease = CreaseAngle.cosine(mesh.faces(), baseFaces, allFaces);
 * RenderMesh drawn = RenderMesh.of(mesh, crease);
 * for (int g = 0; g < drawn.groups().length; g += 3)
 *     draw(drawn.slots().materials().get(drawn.groups()[g]), drawn.groups()[g + 1], drawn.groups()[g + 2]);
 * }</pre>
 */
package org.jsmesh.display;
