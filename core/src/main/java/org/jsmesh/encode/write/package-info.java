/** Plans and writes archives: base, batches of splits and sweeps, textures, header and index. */
package org.jsmesh.encode.write;
