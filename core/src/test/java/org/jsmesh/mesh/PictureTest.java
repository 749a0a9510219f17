package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class PictureTest {
    @Test
    void shouldRefuseAnotherNumberOfColours() {
        assertThatThrownBy(() -> new Picture("a.png", 2, 2, new int[3])).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Picture("a.png", 1 << 16, 1 << 16, new int[0]))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
