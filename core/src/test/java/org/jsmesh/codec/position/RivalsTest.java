package org.jsmesh.codec.position;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RivalsTest {
    private final Rivals rivals = new Rivals();

    @Test
    void shouldTakeTheFirstOfEqualOnes() {
        assertThat(rivals.best(0, 0, 0)).isZero();
    }

    @Test
    void shouldTakeTheOneThatWasBest() {
        rivals.turn(6);
        for (int i = 0; i < 9; i++) learn(3, 2, 1);
        assertThat(rivals.best(0, 0, 0)).isEqualTo(2);
        assertThat(rivals.best(0, 0, 1e9)).isEqualTo(1);
        assertThat(rivals.isThirdClose()).isTrue();
    }

    @Test
    void shouldAddWhatIsKnownOfTheVertex() {
        rivals.turn(6);
        for (int i = 0; i < 9; i++) learn(3, 2, 1);
        assertThat(rivals.best(0, 0, 9)).isEqualTo(1);
    }

    @Test
    void shouldJudgeByVerticesOfAsManyNeighboursToo() {
        for (int i = 0; i < 200; i++) {
            rivals.turn(6);
            learn(1, 2, 1.5);
            rivals.turn(8);
            learn(2, 1, 1.5);
        }
        rivals.turn(6);
        assertThat(rivals.best(0, 0, 0)).isZero();
        rivals.turn(12);
        assertThat(rivals.best(0, 0, 0)).isEqualTo(1);
        assertThat(rivals.isThirdClose()).isFalse();
    }

    private void learn(double first, double second, double third) {
        rivals.learn(0, first);
        rivals.learn(1, second);
        rivals.learn(2, third);
    }
}
