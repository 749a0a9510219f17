package org.jsmesh.mesh.io;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;

/** Runs the seeds beside it in every build; fuzzes for a minute with JAZZER_FUZZ=1 and only this test chosen. */
class ObjReaderFuzzTest {
    @FuzzTest(maxDuration = "1m")
    void shouldThrowNothingButModelFormatException(byte[] content) throws IOException {
        ReaderFuzz.read("fuzz.obj", content);
    }
}
