package org.jsmesh.web;

import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/** Decodes one archive and prepares it for drawing. Not thread-safe. */
final class DecodingSession {
    private final ArchiveDecoder decoder = new ArchiveDecoder();
    private Mesh mesh;
    private int meshBatches;

    int feed(byte[] bytes) throws MalformedStreamException {
        decoder.feed(bytes, 0, bytes.length);
        return decoder.batches();
    }

    /** What the first bytes say, or null until they have arrived. */
    ArchiveOpening opening() {
        return decoder.opening();
    }

    /** The header, or null until all of it has arrived. */
    ArchiveHeader header() {
        return decoder.header();
    }

    /** The index as far as it is known, or null until the opening has arrived. */
    BatchIndex index() {
        return decoder.index();
    }

    int batches() {
        return decoder.batches();
    }

    boolean isComplete() {
        return decoder.isComplete();
    }

    RenderMesh draw() {
        Mesh shown = mesh();
        ArchiveHeader header = decoder.header();
        int all = header != null ? header.faces() : Integer.MAX_VALUE; // not known yet
        int base = decoder.index().faces(0);
        return RenderMesh.of(shown, CreaseAngle.cosine(shown.faces(), base, all));
    }

    /**
     * Writes a list of the images that can be shown: of the textures that have arrived whole, then of previews of
     * others. Each has the path of its texture and its width in pixels, which is null where the file itself says it.
     */
    void writeImages(Json json) {
        json.open('[');
        if (decoder.batches() > 0) {
            for (Texture texture : mesh().textures()) {
                json.open('{').key("path").text(texture.path());
                json.key("width").text(null).close('}');
            }
            for (Picture preview : mesh().previews()) {
                json.open('{').key("path").text(preview.path());
                json.key("width").number(preview.width()).close('}');
            }
        }
        json.close(']');
    }

    /** The image file at a place in that list. */
    byte[] image(int index) {
        int whole = mesh().textures().size();
        int all = whole + mesh().previews().size();
        if (index < 0 || index >= all) throw new WrongCallException("there is no image " + index + " of " + all);
        if (index < whole) return mesh().textures().get(index).bytes();
        return mesh().previews().get(index - whole).bmp();
    }

    String sha256() {
        return MeshIdentity.sha256(mesh());
    }

    private Mesh mesh() {
        if (decoder.batches() == 0) throw new WrongCallException("the base has not arrived yet");
        if (mesh == null || meshBatches != decoder.batches()) {
            mesh = decoder.mesh();
            meshBatches = decoder.batches();
        }
        return mesh;
    }
}
