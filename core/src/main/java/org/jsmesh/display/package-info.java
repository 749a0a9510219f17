/** What is drawn of a mesh: render vertices of wedges, normals with crease angles, display materials. */
package org.jsmesh.display;
