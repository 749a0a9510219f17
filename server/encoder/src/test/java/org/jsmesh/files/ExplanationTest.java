package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.stream.Stream;
import org.jsmesh.files.Explanation.Audience;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** One failure has one wording; the remedy is for who reads it. */
class ExplanationTest {
    static Stream<Arguments> failures() {
        return Stream.of(
                Arguments.of(
                        new ModelFormatException("a.obj", "line 3", "y is \"nan\"", "Repair this vertex"),
                        "a.obj, line 3: y is \"nan\". Repair this vertex.",
                        "the model cannot be read: y is \"nan\" (line 3) | Repair this vertex"),
                Arguments.of(
                        new MalformedStreamException(7, "cut"),
                        "x.obj: not a whole archive: cut (byte 7). Encode the model or fetch the archive again.",
                        "the model is not a whole archive: cut (byte 7) | encode the model again with 'jsm encode'"),
                Arguments.of(
                        new IllegalArgumentException("the mesh has no faces. Give one with faces"),
                        "x.obj: the mesh has no faces. Give one with faces.",
                        "the model cannot be encoded: the mesh has no faces | Give one with faces"),
                Arguments.of(
                        new IllegalArgumentException("odd"),
                        "x.obj: odd.",
                        "the model cannot be encoded: odd | repair the model file"),
                Arguments.of(
                        new StackOverflowError(),
                        "x.obj: is nested too deeply. Export the model anew.",
                        "the model is nested too deeply | Export the model anew"),
                Arguments.of(
                        new NoSuchFileException("/srv/y.obj"),
                        "/srv/y.obj: no such file. Check the path.",
                        "the model could not be prepared | see the server's log"),
                Arguments.of(
                        new AccessDeniedException("/srv/y.obj"),
                        "/srv/y.obj: access denied. Check the permissions.",
                        "the model could not be prepared | see the server's log"),
                Arguments.of(
                        new FileAlreadyExistsException("/srv/y"),
                        "/srv/y: is a file, not a folder. Choose another place.",
                        "the model could not be prepared | see the server's log"),
                Arguments.of(
                        new FileSystemException("/srv/y", null, "is a folder. Name a file in it"),
                        "/srv/y: is a folder. Name a file in it.",
                        "the model could not be prepared | see the server's log"),
                Arguments.of(
                        new IOException("no space\n left"),
                        "x.obj: no space left.",
                        "the model could not be prepared | see the server's log"),
                Arguments.of(
                        new IllegalStateException("a fault"),
                        "x.obj: java.lang.IllegalStateException: a fault. This is a fault in jSM: please report it with the file.",
                        "the model could not be prepared | see the server's log"));
    }

    @ParameterizedTest
    @MethodSource("failures")
    void shouldSayReasonAndRemedy(Throwable failure, String command, String server) {
        assertThat(Explanation.of("x.obj", failure)).hasToString(command);
        Explanation words = Explanation.of("the model", failure, Audience.SERVER);
        assertThat(words.sentence() + " | " + words.remedy()).isEqualTo(server);
    }

    @ParameterizedTest
    @MethodSource("failures")
    void shouldTellSendersNothingOfTheServersPaths(Throwable failure, String command, String server) {
        Explanation words = Explanation.of("the model", failure, Audience.SENDER);
        assertThat(words.sentence() + words.remedy()).startsWith("the model ").doesNotContain("/srv", "log");
        assertThat(words.remedy()).isNotEmpty();
        boolean isOfTheServer = server.contains("log");
        assertThat(words.remedy().equals("tell the server's owner")).isEqualTo(isOfTheServer);
    }

    @Test
    void shouldGiveEachReaderARemedyForWantOfMemory() {
        OutOfMemoryError failure = new OutOfMemoryError();
        assertThat(Explanation.of("x.obj", failure).toString())
                .matches("x\\.obj: needs more memory than the \\d+ MiB allowed\\. Give Java more, .*-Xmx\\d+g\\.");
        assertThat(Explanation.of("the model", failure, Audience.SERVER).remedy())
                .contains("jsm encode");
        assertThat(Explanation.of("the model", failure, Audience.SENDER).remedy())
                .isEqualTo("send a smaller model");
    }

    @Test
    void shouldNeedNoPlace() {
        assertThat(Explanation.of(null, new IOException("gone"))).hasToString("gone.");
        assertThat(Explanation.of(null, new IOException())).hasToString("no reason given.");
    }
}
