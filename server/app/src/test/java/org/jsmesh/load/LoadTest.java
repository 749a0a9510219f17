package org.jsmesh.load;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.BeforeParameterizedClassInvocation;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The load test in its brief form, in both protocols: 40 viewers at a time with a fault in every fourth round, and a
 * restart of the server. Nothing timed is asked for.
 */
@Tag("long")
@Timeout(400)
@Tag("slow")
@ParameterizedClass(name = "HTTP/2: {0}")
@ValueSource(booleans = {false, true})
class LoadTest {
    private static final Path MODELS = Path.of("../../models");

    @TempDir
    private static Path folder;

    private static LoadReport report;
    private static String text;

    private final boolean http2;

    LoadTest(boolean http2) {
        this.http2 = http2;
    }

    @BeforeParameterizedClassInvocation
    static void run(boolean http2) throws Exception {
        assumeTrue(ProcessFigures.isPossible(), "memory, threads and files of a process are read from Linux");
        List<Path> models = List.of(MODELS.resolve("octopus.ply"), MODELS.resolve("planetary-gear.obj"));
        try (LoadRun run =
                new LoadRun(LoadSettings.brief().withHttp2(http2), models, folder.resolve(http2 ? "2" : "1.1"))) {
            report = run.run();
        }
        StringWriter printed = new StringWriter();
        report.print(new PrintWriter(printed));
        text = printed + report.server().output();
    }

    @Test
    void shouldBringEveryViewerToTheOriginal() {
        Tally tally = report.tally();
        assertThat(tally.started).as(text).isGreaterThanOrEqualTo(40);
        assertThat(tally.wrongEnds).as(text).isZero();
        assertThat(tally.completedViewers()).as(text).isEqualTo(tally.started);
        assertThat(tally.decoded.get()).as(text).isPositive();
        assertThat(tally.decodedWrongly.get()).as(text).isZero();
    }

    @Test
    void shouldSendNoByteTwice() {
        assertThat(report.tally().bodyBytes).as(text).isPositive();
        assertThat(report.tally().bytesTwice).as(text).isZero();
    }

    @Test
    void shouldAnswerEveryRequestAsAsked() {
        assertThat(report.tally().statuses).as(text).containsKeys("200", "206");
        assertThat(report.tally().serverErrors()).as(text).isZero();
        assertThat(report.tally().wrongStatuses()).as(text).isZero();
        assertThat(report.tally().unexplainedBreaks).as(text).isZero();
    }

    @Test
    void shouldMeetEveryKindOfFault() {
        InjectedFaults faults = report.faults();
        assertThat(faults.outageSeconds()).as(text).hasSize(1);
        assertThat(List.of(
                        faults.viewerCuts.get(),
                        faults.viewerStalls.get(),
                        faults.proxyCuts.get(),
                        faults.proxyStalls.get()))
                .as(text)
                .allMatch(count -> count > 0);
        assertThat(faults.viewerResets.get() > 0).as(text).isEqualTo(http2);
    }

    @Test
    void shouldKeepNothingOfViewersWhoLeft() {
        assertThat(report.server().after().openFiles())
                .as(text)
                .isLessThanOrEqualTo(report.server().before().openFiles() + 4);
        int atATime = LoadSettings.brief().viewers();
        assertThat(report.server().after().threads())
                .as(text)
                .isLessThanOrEqualTo(report.server().before().threads() + atATime);
    }
}
