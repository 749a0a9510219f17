package org.jsmesh.app.heap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
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
}
