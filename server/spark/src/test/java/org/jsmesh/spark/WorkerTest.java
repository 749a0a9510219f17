package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import org.apache.spark.SparkConf;
import org.junit.jupiter.api.Test;

class WorkerTest {
    @Test
    void shouldLeaveRoomForTheCollector() {
        long heap = 16L << 30;
        assertThat(Worker.room(heap, false)).isEqualTo(heap - (300L << 20));
        assertThat(Worker.room(heap, true)).isEqualTo((long) (.8 * (heap - (300L << 20))));
        assertThat(Worker.room(400L << 20, false)).isEqualTo(200L << 20);
    }

    @Test
    void shouldKnowTheCoresOfAnExecutor() {
        SparkConf conf = new SparkConf(false).set("spark.master", "spark://host:7077");
        assertThat(Worker.coresToTake(conf)).isZero();
        assertThat(Worker.coresToTake(conf.set("spark.executor.cores", "4"))).isEqualTo(4);
        assertThat(Worker.coresToTake(new SparkConf(false).set("spark.master", "yarn")))
                .isEqualTo(1);
    }
}
