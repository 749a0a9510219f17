package org.jsmesh.app.heap;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RelaunchTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "-agentlib:jdwp=transport=dt_socket,server=y,address=5005",
                "-javaagent:a.jar",
                "-Dcom.sun.management.jmxremote.port=9999",
                "-XX:StartFlightRecording=filename=a.jfr",
                "-XX:FlightRecorderOptions=repository=a",
                "-Xloggc:gc.log",
                "-Xlog:gc*:file=gc.log:time",
                "-Xlog:gc:gc.log"
            })
    void shouldNotStartASecondProcessWithWhatIsThereOnce(String option) {
        assertThat(Relaunch.obstacle(List.of("-Dx=y", option), null)).contains("two processes cannot have " + option);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"-Xlog:gc", "-Xlog:gc:stdout:time", "-Xlog:gc::time", "-Xlog:disable", "-Xss4m", "-XX:MaxRAM=1g"
            })
    void shouldStartASecondProcessWithOtherOptions(String option) {
        assertThat(Relaunch.obstacle(List.of(option), null)).isNull();
        assertThat(Relaunch.obstacle(List.of(), "-Dx=y " + option)).isNull();
    }

    @Test
    void shouldNotGiveAHeapThatIsOverruled() {
        assertThat(Relaunch.obstacle(List.of("-Xmx1g"), null)).isNull();
        assertThat(Relaunch.obstacle(List.of(), " -Dx=y  -Xmx1g ")).contains("_JAVA_OPTIONS");
    }

    @ParameterizedTest
    @ValueSource(strings = {"-Xms400m", "-ms400m", "-XX:InitialHeapSize=400m", "-XX:MinHeapSize=400m"})
    void shouldNotBeginWithMoreThanTheHeap(String option) {
        assertThat(Relaunch.obstacle(List.of(), "-Dx=y " + option)).contains("_JAVA_OPTIONS");
        assertThat(Relaunch.obstacle(List.of(option), null)).isNull();
        Relaunch relaunch = Relaunch.of(RelaunchTest.class, "encode");
        HeapSize heap = HeapSize.parse("300m");
        assertThat(relaunch.command(heap, List.of(option, "-Dx=y"), Map.of()))
                .contains("-Dx=y", "-Xmx300m")
                .doesNotContain(option, "-Xms8m");
        for (String variable : List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"))
            assertThat(relaunch.command(heap, List.of(option), Map.of(variable, "-Dz " + option)))
                    .containsSubsequence("-Xmx300m", "-Xms8m", "-cp", "encode")
                    .doesNotContain(option);
    }

    /** Java tells of sizes that do not fit each other, and begins nothing. */
    @Test
    void shouldStartInSpiteOfAVariable() throws Exception {
        Relaunch relaunch = Relaunch.of(RelaunchTest.class);
        String variable = "-Xms400m";
        for (String name : List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS")) {
            List<String> command = new ArrayList<>(
                    relaunch.command(HeapSize.parse("300m"), List.of(variable), Map.of(name, variable)));
            command.subList(command.indexOf("-cp"), command.size()).clear();
            command.add("-version");
            ProcessBuilder java = new ProcessBuilder(command).redirectErrorStream(true);
            java.environment().put(name, variable);
            Process process = java.start();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(process.waitFor()).as(said).isZero();
        }
    }
}
