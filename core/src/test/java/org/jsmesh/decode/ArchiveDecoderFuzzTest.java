package org.jsmesh.decode;

import com.code_intelligence.jazzer.junit.FuzzTest;
import org.jsmesh.archive.Checksums;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.junit.jupiter.api.Tag;

/**
 * Feeds bytes whose checksums are right: only {@link MalformedStreamException} may come out. The seeds beside it are
 * whole archives of a few faces, so that a run takes little time and a changed byte changes much.
 */
@Tag("slow")
class ArchiveDecoderFuzzTest {
    @FuzzTest(maxDuration = "60s")
    void shouldOnlyEverReportMalformedBytes(byte[] archive) {
        byte[] bytes = archive.clone();
        ArchiveDecoder decoder = new ArchiveDecoder();
        try {
            Checksums.feedMended(decoder, bytes);
        } catch (MalformedStreamException expected) {
            // the one answer that damaged bytes may have
        }
        if (decoder.batches() == 0) return;
        Mesh mesh = decoder.mesh();
        if (mesh.faces() != decoder.faces()) throw new AssertionError("snapshot of " + mesh.faces() + " faces");
        if (decoder.isComplete()) readOrder(decoder);
    }

    private static void readOrder(ArchiveDecoder decoder) {
        try {
            Mesh mesh = decoder.meshInOrder();
            if (mesh.faces() != decoder.faces()) throw new AssertionError("original of " + mesh.faces() + " faces");
        } catch (MalformedStreamException expected) {
            // as above
        }
    }
}
