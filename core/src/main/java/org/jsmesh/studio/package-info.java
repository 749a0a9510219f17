/** The light that a viewer's studio sends from all sides, computed ahead for surfaces of every roughness. */
package org.jsmesh.studio;
