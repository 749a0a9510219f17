/** Draws resolutions of models with OpenGL: camera, materials, images, light. */
package org.jsmesh.desktop.draw;
