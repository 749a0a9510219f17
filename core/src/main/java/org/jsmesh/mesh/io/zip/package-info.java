/**
 * Packed bytes: gzip and ZIP archives in memory, unpacked within limits.
 *
 * <p>For the modules of this project alone; nothing here is exported to others.
 */
package org.jsmesh.mesh.io.zip;
