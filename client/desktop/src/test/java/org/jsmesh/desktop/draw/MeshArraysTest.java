package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.display.LiveStep;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.Test;

class MeshArraysTest {
    private static final int ARRAY = LiveStep.POSITIONS;

    @Test
    void shouldHaveAsMuchRoomAsHasComeWhateverIsExpected() {
        MeshArrays arrays = new MeshArrays();
        arrays.expect(ARRAY, Integer.MAX_VALUE);
        for (int end = 3; end < 100_000; end += 3) {
            arrays.write(ARRAY, end - 3, new int[] {end, end, end}, 0, 3);
            assertThat(arrays.bits(ARRAY)).hasSizeBetween(end, 4 * end);
        }
        assertThat(arrays.bits(ARRAY)).startsWith(3, 3, 3, 6, 6, 6);
    }

    @Test
    void shouldHaveTheRoomThatIsExpectedInTheEnd() {
        MeshArrays arrays = new MeshArrays();
        arrays.expect(ARRAY, 10_000);
        for (int i = 0; i < 10_000; i++) arrays.write(ARRAY, i, new int[] {i}, 0, 1);
        assertThat(arrays.bits(ARRAY)).hasSize(10_000);
        arrays.write(ARRAY, 10_000, new int[] {1}, 0, 1);
        assertThat(arrays.bits(ARRAY)).hasSize(15_001);
    }

    @Test
    void shouldMakeRoomForFewRowsOfAHeaderThatClaimsMany() throws Exception {
        EncodedArchive archive =
                new MeshEncoder(EncoderSettings.defaults()).encode(Shapes.torus(12, 8), ProgressListener.NONE);
        ShownScene first = new TestSteps(archive, claiming(archive.header(), Integer.MAX_VALUE / 8), 5)
                .steps
                .get(0)
                .first();
        assertThat(first.arrays.bits(LiveStep.INDICES)).hasSizeLessThan(10_000_000);
        assertThat(first.arrays.bits(LiveStep.POSITIONS)).hasSizeLessThan(10_000_000);
        assertThat(first.levels()).hasSizeLessThan(10_000_000);
        assertThat(new TestSteps(archive, 5).steps.get(0).first().arrays.bits(LiveStep.INDICES))
                .hasSize(3 * archive.header().faces());
    }

    private static ArchiveHeader claiming(ArchiveHeader h, int rows) {
        return new ArchiveHeader(
                rows,
                h.vertices(),
                rows,
                h.channels(),
                h.materials(),
                h.images(),
                h.faceChannels(),
                h.origin(),
                h.bounds(),
                h.up(),
                h.isClosed(),
                h.levels(),
                h.meshSha256(),
                h.provenance(),
                h.batches());
    }
}
