/** The versioned container of a streaming mesh: header, index, base mesh, batches, checksums and hashes. */
package org.jsmesh.archive;
