/** Reads the versioned container of a streaming mesh: header, index, base mesh, batches and checksums. */
package org.jsmesh.archive;
