package org.jsmesh.encode;

import java.util.List;
import org.jsmesh.archive.ArchiveHeader;

/**
 * An encoded mesh.
 *
 * @param bytes the whole archive file
 * @param header what it says of itself
 * @param notes what was repaired or dropped, one sentence each
 */
public record EncodedArchive(byte[] bytes, ArchiveHeader header, List<String> notes) {}
