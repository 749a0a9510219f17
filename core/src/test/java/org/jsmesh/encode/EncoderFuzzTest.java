package org.jsmesh.encode;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.VertexMerger;
import org.junit.jupiter.api.Tag;

/** Any mesh of finite numbers comes back as it was, whatever its faces and numbers are. */
@Tag("slow")
class EncoderFuzzTest {
    @FuzzTest(maxDuration = "60s")
    void shouldComeBackAsItWas(byte[] content) throws Exception {
        FuzzedBytes data = new FuzzedBytes(content);
        EncoderSettings settings = settings(data);
        Mesh mesh = FuzzedMesh.of(data);
        byte[] bytes =
                new MeshEncoder(settings).encode(mesh, ProgressListener.NONE).bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        if (!decoder.isComplete()) throw new AssertionError("the archive ends early");
        Mesh clean = MeshCleaner.clean(mesh, new ArrayList<>());
        String wanted = MeshIdentity.sha256(VertexMerger.merge(clean, new ArrayList<>()));
        if (!settings.keepOrder() && !MeshIdentity.sha256(decoder.mesh()).equals(wanted))
            throw new AssertionError("another mesh came back");
        if (settings.keepOrder()) checkOrder(mesh, decoder.meshInOrder());
    }

    private static void checkOrder(Mesh mesh, Mesh back) {
        boolean same = Arrays.equals(bits(mesh), bits(back))
                && Arrays.equals(mesh.faceWedges(), back.faceWedges())
                && Arrays.equals(mesh.wedgeVertices(), back.wedgeVertices())
                && Arrays.equals(mesh.faceMaterials(), back.faceMaterials());
        for (int i = 0; same && i < mesh.channels().size(); i++) {
            Channel a = mesh.channels().get(i);
            Channel b = back.channels().get(i);
            for (int w = 0; w < mesh.wedges(); w++) {
                same &= a.isAbsent(w) == b.isAbsent(w);
                int n = a.words();
                same &= a.isAbsent(w) || Arrays.equals(a.values(), n * w, n * w + n, b.values(), n * w, n * w + n);
            }
        }
        if (!same) throw new AssertionError("another mesh or another order came back");
    }

    private static int[] bits(Mesh mesh) {
        int[] bits = new int[mesh.positions().length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(mesh.positions()[i]);
        return bits;
    }

    private static EncoderSettings settings(FuzzedBytes data) {
        EncoderSettings settings = EncoderSettings.defaults()
                .withThreads(1)
                .withQuality(data.of(Quality.values()))
                .withKeepOrder(data.isTrue());
        if (data.isTrue()) settings = settings.withBaseFaces(data.from(1, 40));
        if (data.isTrue()) settings = settings.withSimplifier(Simplifier.PAPER).withLevels(List.of(.1, .5, 10.0));
        return settings;
    }
}
