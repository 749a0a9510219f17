package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** {@code jsm encode} with little heap: it starts itself again with more. */
@Timeout(180)
class HeapIT {
    private static final Path JAVA = Path.of(System.getProperty("java.home"), "bin", "java");

    /** Half of it is the heap that Java takes by itself. */
    private static final String SMALL_MACHINE = "-XX:MaxRAM=32m";

    @TempDir
    private static Path folder;

    private static Path model;
    private static Path large;

    @BeforeAll
    static void writeModels() throws IOException {
        model = Bumpy.write(folder.resolve("small.ply"), 330);
        large = Bumpy.write(folder.resolve("large.ply"), 1500);
    }

    /** A run and what it said. */
    private record Said(int code, String text) {}

    private static Process start(String option, Object... words) throws IOException {
        List<String> command = new ArrayList<>(List.of(JAVA.toString()));
        if (!option.isEmpty()) command.add(option);
        command.addAll(List.of("-jar", Path.of("target", "jsm.jar").toString(), "encode"));
        for (Object word : words) command.add(word.toString());
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().remove("JAVA_TOOL_OPTIONS");
        builder.environment().remove("JDK_JAVA_OPTIONS");
        return builder.start();
    }

    private static Said run(String option, Object... words) throws IOException, InterruptedException {
        Process process = start(option, words);
        try {
            String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return new Said(process.waitFor(), text);
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    void shouldTakeTheHeapThatAModelNeeds() throws Exception {
        Path out = folder.resolve("more.jsm");
        Said said = run(SMALL_MACHINE, model, "-o", out, "--threads", 1);
        assertThat(said.code).as(said.text).isZero();
        assertThat(said.text).contains("72600 faces").doesNotContain("warning");
        assertThat(out).isRegularFile();
    }

    @Test
    void shouldStayInItsProcessWhenToldSo() throws Exception {
        for (String option : List.of("--no-relaunch", "-Xmx16m")) {
            boolean ofJava = option.startsWith("-X");
            Said said = ofJava
                    ? run(option, model, "-o", folder.resolve("no.jsm"))
                    : run(SMALL_MACHINE, model, "-o", folder.resolve("no.jsm"), option);
            assertThat(said.code).as(said.text).isEqualTo(1);
            assertThat(said.text).contains("small.ply: ", "needs ", "Give Java more");
            assertThat(folder.resolve("no.jsm")).doesNotExist();
        }
    }

    @Test
    void shouldHandOnWhatTheOtherProcessSays() throws Exception {
        Path bad = Files.writeString(folder.resolve("bad.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n");
        Said said = run("", bad, "-o", folder.resolve("bad.jsm"), "--max-heap", "100m");
        assertThat(said.code).isEqualTo(1);
        assertThat(said.text.lines()).singleElement().asString().contains("bad.off, line 5");
        assertThat(run("", bad, "-o", folder.resolve("bad.jsm"), "--max-heap", "much").code)
                .isEqualTo(2);
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void shouldSayThatTheOtherProcessWasKilled() throws Exception {
        Process first = start("", large, "-o", folder.resolve("killed.jsm"), "--max-heap", "900m");
        try {
            second(first).destroyForcibly();
            String text = new String(first.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(first.waitFor()).isEqualTo(137);
            assertThat(text).contains("heap of 900 MiB was ended from outside", "--max-heap 675m");
        } finally {
            first.destroyForcibly();
        }
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void shouldEndWithItsFirstProcess() throws Exception {
        for (boolean forcibly : new boolean[] {false, true}) {
            Process first = start("", large, "-o", folder.resolve("ended.jsm"), "--max-heap", "900m");
            try {
                ProcessHandle second = second(first);
                while (second.info().totalCpuDuration().map(d -> d.toMillis()).orElse(1000L) < 800) Thread.sleep(20);
                if (forcibly) first.destroyForcibly();
                else first.destroy();
                second.onExit().get(60, TimeUnit.SECONDS);
                assertThat(folder.resolve("ended.jsm")).doesNotExist();
            } finally {
                first.destroyForcibly();
            }
        }
    }

    private static ProcessHandle second(Process first) throws InterruptedException {
        while (first.isAlive()) {
            var child = first.children().findFirst();
            if (child.isPresent()) return child.get();
            Thread.sleep(10);
        }
        throw new AssertionError("it ended without another process");
    }
}
