/** Things of the graphics card: shaders, buffers, samplers, framebuffers. Used on the thread that holds the context. */
package org.jsmesh.desktop.gpu;
