package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Sha256;
import org.jsmesh.mesh.Texture;

/**
 * The comparison of what was decoded with the hashes in the header: of the mesh, and of the bytes of each image.
 *
 * @param meshSha256 of the decoded mesh
 * @param modelSha256 of the decoded mesh and images
 * @param expectedMeshSha256 what the header names
 * @param altered paths of the images that are not those that were encoded, or have not come
 */
public record Proof(String meshSha256, String modelSha256, String expectedMeshSha256, List<String> altered) {
    /**
     * Copies the list.
     *
     * @param meshSha256 see {@link #meshSha256()}
     * @param modelSha256 see {@link #modelSha256()}
     * @param expectedMeshSha256 see {@link #expectedMeshSha256()}
     * @param altered see {@link #altered()}
     */
    public Proof {
        altered = List.copyOf(altered);
    }

    /**
     * Hashes what was decoded.
     *
     * @param header of the archive
     * @param mesh decoded from the whole archive, with its images in the header's order, each under all its paths
     * @return the comparison
     */
    public static Proof of(ArchiveHeader header, Mesh mesh) {
        List<ImageInfo> found = new ArrayList<>();
        Texture last = null;
        for (Texture t : mesh.textures()) {
            // An image with several paths is hashed once.
            boolean isShared = last != null && last.bytes() == t.bytes();
            String hash = isShared ? found.get(found.size() - 1).sha256() : Sha256.hex(t.bytes());
            found.add(new ImageInfo(List.of(t.path()), t.bytes().length, hash));
            last = t;
        }
        List<String> altered = new ArrayList<>();
        int i = 0;
        for (ImageInfo expected : header.images())
            for (String path : expected.paths()) {
                boolean same = i < found.size()
                        && expected.sha256().equals(found.get(i).sha256());
                if (!same) altered.add(path);
                i++;
            }
        String sha256 = MeshIdentity.sha256(mesh);
        return new Proof(sha256, ModelIdentity.sha256(sha256, found), header.meshSha256(), altered);
    }

    /** {@return true when mesh and images are those that were encoded} */
    public boolean isOriginal() {
        return difference().isEmpty();
    }

    /** {@return what is not as it was encoded, as a clause; empty when all is} */
    public String difference() {
        if (!meshSha256.equals(expectedMeshSha256))
            return "the decoded mesh has the SHA-256 " + meshSha256 + ", the header names " + expectedMeshSha256;
        if (altered.isEmpty()) return "";
        List<String> names = new ArrayList<>();
        for (String path : altered) names.add(PlainText.of(path));
        return names.size() == 1
                ? "the picture " + names.get(0) + " is not the one that was encoded"
                : "the pictures " + String.join(", ", names) + " are not those that were encoded";
    }
}
