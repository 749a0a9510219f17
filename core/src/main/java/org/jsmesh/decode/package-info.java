/** Archive in, mesh out, while bytes arrive. */
package org.jsmesh.decode;
