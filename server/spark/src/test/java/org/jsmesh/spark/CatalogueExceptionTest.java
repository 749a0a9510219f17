package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.AccessDeniedException;
import org.apache.spark.SparkException;
import org.junit.jupiter.api.Test;

class CatalogueExceptionTest {
    @Test
    void shouldSayWhatFailedInAnExecutor() {
        SparkException failure = new SparkException(
                "Job aborted due to stage failure: Task 3 failed 16 times", new AccessDeniedException("s3://b/x"));
        assertThat(CatalogueException.brokenOff("s3://b/site", failure))
                .hasMessageContaining("s3://b/x: access denied. Check the permissions.")
                .hasMessageContaining("run again");
    }

    @Test
    void shouldSayTheFirstLineOfWhatOnlySparkKnows() {
        SparkException failure = new SparkException("Job was cancelled.\nDriver stacktrace:");
        assertThat(CatalogueException.brokenOff("s3://b/site", failure))
                .hasMessageStartingWith("the run was broken off: s3://b/site: Job was cancelled. When");
    }
}
