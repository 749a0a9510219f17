package org.jsmesh.session;

import org.jsmesh.mesh.Mesh;

/**
 * The end of a session: everything has arrived, and was compared with the hashes.
 *
 * @param mesh the decoded mesh, in the order of the original if the archive holds it
 * @param meshSha256 computed from that mesh
 * @param archiveSha256 computed from the bytes received
 * @param difference null when the mesh is identical to the original; else the hash that differs from what header,
 *     manifest or address promise
 */
public record SessionResult(Mesh mesh, String meshSha256, String archiveSha256, String difference) {
    /**
     * {@return true when the mesh's hash equals the header's, and the bytes' hash equals that of the manifest or
     * address if these give one}
     */
    public boolean identical() {
        return difference == null;
    }
}
