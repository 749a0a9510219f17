package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.codec.connectivity.PairRunner;
import org.jsmesh.codec.entropy.BatchStreams;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.Effort;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ForkedPairRunnerTest {
    private static final ExecutorService HELPERS = Executors.newFixedThreadPool(1);

    @AfterAll
    static void stop() {
        HELPERS.shutdown();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldNotChangeTheBytes(boolean hasAttributes) throws MalformedStreamException {
        CollapseMesh collapsing = new CollapseMesh(terrain(100, hasAttributes));
        QuadricSimplifier.simplify(
                collapsing, SimplificationTarget.ofVertices(300), Effort.SOME, ProgressListener.NONE);
        CodedMesh source = new SimplifiedMesh(collapsing);
        AtomicInteger helped = new AtomicInteger();
        ForkedPairRunner shared = new ForkedPairRunner(work -> {
            helped.incrementAndGet();
            HELPERS.execute(work);
        });
        assertThat(coded(source, shared)).isDeepEqualTo(coded(source, null));
        assertThat(helped.get()).isGreaterThan(10);
    }

    @Test
    void shouldNotChangeTheBytesWhereSheetsMeet() throws MalformedStreamException {
        CollapseMesh collapsing = new CollapseMesh(RandomMeshes.book(60, 3));
        QuadricSimplifier.simplify(
                collapsing, SimplificationTarget.ofVertices(300), Effort.SOME, ProgressListener.NONE);
        CodedMesh source = new SimplifiedMesh(collapsing);
        AtomicInteger helped = new AtomicInteger();
        ForkedPairRunner shared = new ForkedPairRunner(work -> {
            helped.incrementAndGet();
            HELPERS.execute(work);
        });
        assertThat(coded(source, shared)).isDeepEqualTo(coded(source, null));
        assertThat(helped.get()).isGreaterThan(10);
    }

    /** Whole passes at once: large enough portions to be worth sharing. */
    private static byte[][] coded(CodedMesh source, PairRunner helper) throws MalformedStreamException {
        MeshCoder coder = MeshCoder.encoder(MeshFormat.of(source), source);
        if (helper != null) coder.useHelper(helper);
        RangeEncoder connectivity = new RangeEncoder();
        RangeEncoder geometry = new RangeEncoder();
        RangeEncoder attributes = new RangeEncoder();
        BatchStreams streams = new BatchStreams(connectivity, geometry, attributes);
        coder.codeBase(streams, 0, 0);
        PatchLog log = source.log();
        for (int pass = log.passes() - 1; pass >= 0; pass--) {
            coder.beginPass(pass);
            coder.codeSplits(streams, log.steps(pass));
        }
        assertThat(coder.faces()).isEqualTo(source.original().faces());
        return new byte[][] {connectivity.finish(), geometry.finish(), attributes.finish()};
    }

    @Test
    void shouldDoTheSecondHalfItselfWhenNobodyHelps() {
        int[] runs = new int[2];
        new ForkedPairRunner(work -> {}).runBoth(() -> runs[0]++, () -> runs[1]++);
        assertThat(runs).containsExactly(1, 1);
    }

    @Test
    void shouldThrowWhatTheHelperThrows() {
        ForkedPairRunner work = new ForkedPairRunner(HELPERS);
        Runnable failing = () -> {
            throw new IllegalStateException("no more room");
        };
        assertThatThrownBy(() -> work.runBoth(() -> {}, failing)).hasMessage("no more room");
    }

    private static Mesh terrain(int side, boolean hasAttributes) {
        Random random = new Random(4);
        float[] xyz = new float[3 * side * side];
        int[] colours = new int[3 * side * side];
        for (int v = 0; v < side * side; v++) {
            xyz[3 * v] = v % side;
            xyz[3 * v + 1] = v / side;
            xyz[3 * v + 2] = (float) Math.sin(v % side * .1) * 5 + random.nextFloat();
            for (int k = 0; k < 3; k++) colours[3 * v + k] = v % side + random.nextInt(20) & 255;
        }
        int[] faces = new int[6 * (side - 1) * (side - 1)];
        int at = 0;
        for (int v = 0; v + side < side * side; v++) {
            if (v % side == side - 1) continue;
            for (int corner : new int[] {v, v + 1, v + side, v + 1, v + side + 1, v + side}) faces[at++] = corner;
        }
        MeshBuilder builder = new MeshBuilder().positions(xyz).faceWedges(faces);
        Channel colour = new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, colours, null);
        if (hasAttributes) builder.channels(List.of(colour));
        return builder.build();
    }
}
