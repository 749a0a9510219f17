package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderSinkTest {
    @TempDir
    Path folder;

    private static void write(FolderSink sink, String name, String text) throws IOException {
        try (OutputStream out = sink.create(name)) {
            out.write(text.getBytes(StandardCharsets.UTF_8));
        }
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void shouldLeaveOlderFilesUntilAllIsWritten() throws Exception {
        Path model = Files.writeString(folder.resolve("chair.obj"), "old");
        try (FolderSink sink = new FolderSink(folder, "chair.obj")) {
            write(sink, "chair.mtl", "new materials");
            write(sink, "chair.obj", "new");
            write(sink, "wood.png", "a picture");
            assertThat(model).hasContent("old");
            assertThat(folder.resolve("wood.png")).doesNotExist();
            sink.commit();
        }
        assertThat(model).hasContent("new");
        assertThat(names()).containsExactly("chair.mtl", "chair.obj", "wood.png");
    }

    @Test
    void shouldLeaveNothingWhenWritingFails() throws Exception {
        Path model = Files.writeString(folder.resolve("chair.obj"), "old");
        assertThatThrownBy(() -> {
                    try (FolderSink sink = new FolderSink(folder, "chair.obj")) {
                        write(sink, "wood.png", "a picture");
                        write(sink, "chair.obj", "half");
                        throw new OutOfMemoryError("a failure for this test");
                    }
                })
                .isInstanceOf(OutOfMemoryError.class);
        assertThat(model).hasContent("old");
        assertThat(names()).containsExactly("chair.obj");
    }

    @Test
    void shouldTakeTheSamePictureTwiceAndNoOtherInItsPlace() throws Exception {
        try (FolderSink sink = new FolderSink(folder, "chair.obj")) {
            write(sink, "wood.png", "a picture");
            write(sink, "wood.png", "a picture");
            assertThatThrownBy(() -> write(sink, "wood.png", "another")).isInstanceOf(FileAlreadyExistsException.class);
            sink.commit();
        }
        assertThat(folder.resolve("wood.png")).hasContent("a picture");
        assertThat(names()).containsExactly("wood.png");
    }
}
