package org.jsmesh.decode;

import com.code_intelligence.jazzer.api.FuzzedDataProvider;
import com.code_intelligence.jazzer.junit.FuzzTest;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.Checksums;
import org.jsmesh.archive.TestArchives;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Tag;

/** Edits real archives, mends their checksums and feeds them: only {@link MalformedStreamException} may come out. */
@Tag("slow")
class ArchiveDecoderFuzzTest {
    private static final byte[][] SEEDS = new byte[2 * RandomMeshes.values().length][];

    static {
        for (RandomMeshes kind : RandomMeshes.values()) {
            SEEDS[2 * kind.ordinal()] = TestArchives.encodeFar(kind.mesh(11)).bytes();
            SEEDS[2 * kind.ordinal() + 1] =
                    TestArchives.encodeInOrder(kind.mesh(12)).bytes();
        }
    }

    @FuzzTest(maxDuration = "60s")
    void shouldOnlyEverReportMalformedBytes(FuzzedDataProvider data) throws Exception {
        byte[] bytes;
        if (data.consumeBoolean()) {
            bytes = SEEDS[data.consumeInt(0, SEEDS.length - 1)].clone();
            BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
            for (int edits = data.consumeInt(1, 8); edits > 0; edits--)
                bytes[data.consumeInt(0, bytes.length - 1)] = data.consumeByte();
            if (data.consumeBoolean()) Checksums.mend(bytes, index);
        } else {
            bytes = data.consumeRemainingAsBytes();
        }
        ArchiveDecoder decoder = new ArchiveDecoder();
        try {
            decoder.feed(bytes, 0, bytes.length);
        } catch (MalformedStreamException expected) {
            // the one answer that damaged bytes may have
        }
        if (decoder.batches() > 0) {
            Mesh mesh = decoder.mesh();
            if (mesh.faces() != decoder.faces()) throw new AssertionError("snapshot of " + mesh.faces() + " faces");
            if (decoder.isComplete()) readOrder(decoder);
        }
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
