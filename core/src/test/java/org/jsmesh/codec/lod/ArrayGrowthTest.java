package org.jsmesh.codec.lod;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.TooLargeException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ArrayGrowthTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 100, 1000, 34_834, 1 << 28})
    void shouldNeitherClaimMoreThanFourTimesWhatCameNorEndAboveWhatIsExpected(int expected) {
        int room = 64;
        int came = 65;
        while (came <= expected && came < 1 << 24) {
            room = ArrayGrowth.size(1, room, came, expected);
            assertThat(room).isBetween(came, Math.min(4 * came, Math.max(64, expected)));
            came = room + 1;
        }
        if (came > expected)
            assertThat(ArrayGrowth.size(1, room, expected + 1, expected)).isLessThan(expected / 8 + expected + 66);
    }

    @Test
    void shouldNotAskForMoreThanAnArrayHolds() {
        int most = Sizes.MOST / 4;
        for (int needed : new int[] {most / 2 + 1, most - 1, most}) {
            assertThat(ArrayGrowth.size(4, needed - 1, needed, 0)).isBetween(needed, most);
            assertThat(ArrayGrowth.size(4, needed - 1, needed, Integer.MAX_VALUE))
                    .isBetween(needed, most);
        }
        assertThat(ArrayGrowth.size(1, 2_000_000_000, 2_000_000_001, 0)).isEqualTo(Sizes.MOST);
        assertThatThrownBy(() -> ArrayGrowth.size(4, most, most + 1, 0)).isInstanceOf(TooLargeException.class);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 10, 5000})
    void shouldKeepWhatIsThere(int expected) {
        int[] rows = ArrayGrowth.rows(new int[] {1, 2, 3, 4, 5, 6}, 3, 3, expected);
        assertThat(rows).startsWith(1, 2, 3, 4, 5, 6);
        assertThat(rows.length).isGreaterThanOrEqualTo(9);
    }
}
