/** How a browser or a file manager comes to start the viewer: links, and what the system is told of them. */
package org.jsmesh.desktop.launch;
