/**
 * The parts of a 3MF package as they are written: models in XML, objects, properties, and the mesh that the build items
 * and components make of them. {@code mesh.io} makes a mesh with wedges of it.
 */
package org.jsmesh.mesh.io.threemf;
