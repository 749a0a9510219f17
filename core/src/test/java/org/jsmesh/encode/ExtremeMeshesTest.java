package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Twice as many faces need hardly more than twice the memory, whatever the faces are. */
@Tag("slow")
@Tag("long")
class ExtremeMeshesTest {
    private static final com.sun.management.ThreadMXBean THREADS =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final double GROWTH = 2.3;
    private static final long MOST_ALLOCATED = 40_000; // for each face, in all
    private static final long MOST_HELD = 1500; // at once
    private static final long ANYWAY = 32_000_000;
    private static final MemoryMXBean MEMORY = ManagementFactory.getMemoryMXBean();

    @ParameterizedTest
    @EnumSource
    void shouldAllocateInProportionToFaces(ExtremeMesh kind) {
        long before = allocated(kind.of(1000));
        for (int n = 2000; n <= 4000; n *= 2) {
            long now = allocated(kind.of(n));
            assertThat(now).as("%d faces", n).isLessThan((long) (GROWTH * before));
            assertThat(now - before).as("for %d further faces", n / 2).isLessThan(MOST_ALLOCATED * (n / 2));
            before = now;
        }
    }

    static long allocated(Mesh mesh) {
        long before = THREADS.getCurrentThreadAllocatedBytes();
        new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE);
        return THREADS.getCurrentThreadAllocatedBytes() - before;
    }

    @ParameterizedTest
    @EnumSource
    void shouldHoldSoManyBytesForEachFace(ExtremeMesh kind) {
        int n = 4000;
        long few = peak(kind.of(n));
        assertThat(few).isLessThan(ANYWAY + MOST_HELD * n);
        assertThat(peak(kind.of(2 * n))).isLessThan((long) (ANYWAY + GROWTH * few));
    }

    /** The most bytes that are in use when the encoder tells how far it is, beyond those before. */
    static long peak(Mesh mesh) {
        long before = used();
        Peak peak = new Peak();
        new MeshEncoder(EncoderSettings.defaults().withBaseFaces(4)).encode(mesh, peak);
        return peak.most - before;
    }

    /** Looks when a stage begins, and then less and less often, because a look takes long. */
    private static final class Peak implements ProgressListener {
        private String last = "";
        private int told;
        private int next;
        private long most;

        @Override
        public void progress(String stage, double fraction) {
            if (!stage.equals(last)) told = next = 0;
            last = stage;
            if (told++ < next) return;
            next = told + told / 2;
            most = Math.max(most, used());
        }
    }

    private static long used() {
        System.gc();
        return MEMORY.getHeapMemoryUsage().getUsed();
    }
}
