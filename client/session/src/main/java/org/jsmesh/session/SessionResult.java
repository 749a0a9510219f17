package org.jsmesh.session;

import org.jsmesh.mesh.Mesh;

/**
 * The end of a session: everything has arrived, and was compared with the hashes.
 *
 * @param mesh the decoded mesh, in the order of the original if the archive holds it
 * @param meshSha256 computed from that mesh
 * @param archiveSha256 computed from the bytes received
 * @param difference null when mesh and images are those that were encoded; else the picture that was altered, or the
 *     hash that differs from what header, manifest or address promise
 */
public record SessionResult(Mesh mesh, String meshSha256, String archiveSha256, String difference) {
    /**
     * {@return true when the hashes of mesh and images equal the header's, and those of mesh, model and bytes equal
     * those of manifest or address if these give any}
     */
    public boolean identical() {
        return difference == null;
    }
}
