/** The desktop viewer: a streaming session behind a JOGL window, and the same picture offscreen. */
package org.jsmesh.desktop;
