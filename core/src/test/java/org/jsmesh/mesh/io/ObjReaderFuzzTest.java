package org.jsmesh.mesh.io;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import org.junit.jupiter.api.Tag;

/**
 * Runs the seeds beside it with the full set of tests; fuzzes for a minute with JAZZER_FUZZ=1 and only this test
 * chosen.
 */
@Tag("slow")
class ObjReaderFuzzTest {
    @FuzzTest(maxDuration = "1m")
    void shouldThrowNothingButModelFormatException(byte[] content) throws IOException {
        ReaderFuzz.read("fuzz.obj", content);
    }
}
