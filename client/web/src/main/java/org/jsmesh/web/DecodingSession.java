package org.jsmesh.web;

import org.jsmesh.archive.ArchiveDecoder;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.DrawnArrays;
import org.jsmesh.display.DrawnMesh;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/** One archive being decoded, and what is drawn of it. Not thread-safe. */
final class DecodingSession {
    private final ArchiveDecoder decoder = new ArchiveDecoder();
    private Mesh mesh;
    private int meshBatches;

    int feed(byte[] bytes) throws MalformedStreamException {
        decoder.feed(bytes, 0, bytes.length);
        return decoder.batches();
    }

    ArchiveHeader header() {
        return decoder.header();
    }

    /** The index as far as it is known, or null until the first part of the header has arrived. */
    BatchIndex index() {
        ArchiveHeader header = decoder.header();
        return header == null ? null : header.batches();
    }

    int batches() {
        return decoder.batches();
    }

    boolean isComplete() {
        return decoder.isComplete();
    }

    DrawnArrays draw() {
        Mesh shown = mesh();
        ArchiveHeader header = decoder.header();
        int all = header.isWhole() ? header.faces() : Integer.MAX_VALUE; // not known yet
        int base = header.batches().faces(0);
        return new DrawnMesh(shown, DisplaySlots.of(shown.materials()), CreaseAngle.cosine(shown.faces(), base, all))
                .arrays();
    }

    /**
     * Paths of the textures that can be shown, one per line: of those that have arrived whole, then of previews, each
     * followed by a tab and its width.
     */
    String texturePaths() {
        if (decoder.batches() == 0) return "";
        StringBuilder paths = new StringBuilder();
        for (Texture texture : mesh().textures()) {
            if (paths.length() > 0) paths.append('\n');
            paths.append(texture.path());
        }
        for (Picture preview : mesh().previews()) {
            if (paths.length() > 0) paths.append('\n');
            paths.append(preview.path()).append('\t').append(preview.width());
        }
        return paths.toString();
    }

    /** The image file behind one of these lines. */
    byte[] texture(int index) {
        int whole = mesh().textures().size();
        int all = whole + mesh().previews().size();
        if (index < 0 || index >= all) throw new IllegalArgumentException("texture " + index + " of " + all);
        if (index < whole) return mesh().textures().get(index).bytes();
        return mesh().previews().get(index - whole).bmp();
    }

    String sha256() {
        return MeshIdentity.sha256(mesh());
    }

    private Mesh mesh() {
        if (mesh == null || meshBatches != decoder.batches()) {
            mesh = decoder.mesh();
            meshBatches = decoder.batches();
        }
        return mesh;
    }
}
