package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.Provenance;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.AlteredPicture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecoderMainTest {
    /** Of numbers and flags, what a careless caller may pass. */
    private static final List<Double> NUMBERS = List.of(0., -1., 1e300, Double.NaN);

    /** A model with a picture. */
    private static final byte[] SKY = DecodingSessionTest.archive("sky.png");

    @BeforeEach
    void open() {
        DecoderMain.open();
    }

    @Test
    void shouldGiveBackPathsWithLineBreaksAndQuotes() {
        feed(DecodingSessionTest.archive("a\nb\t\"8\"\\\u0001.png"));
        String path = "\"a\\u000ab\\u0009\\\"8\\\"\\\\\\u0001.png\"";
        assertThat(DecoderMain.images()).isEqualTo("{\"value\":[{\"paths\":[" + path + "],\"width\":null}]}");
        assertThat(DecoderMain.header()).contains("\"COLOUR\":{\"path\":" + path);
    }

    @Test
    void shouldCopyAnImageThroughTheBuffer() {
        feed(SKY);
        assertThat(DecoderMain.copyImage(0, 29_990)).isEqualTo("{\"value\":10}");
        byte[] copied = new byte[10];
        DecoderCalls.STAGING.position(0).get(copied);
        assertThat(copied).isEqualTo(Arrays.copyOfRange(DecodingSessionTest.IMAGE, 29_990, 30_000));
        assertThat(DecoderMain.copyImage(0, 30_000)).isEqualTo("{\"value\":0}");
        assertThat(DecoderMain.copyImage(0, 30_001)).isEqualTo(error("call", "image 0 has no byte 30001"));
        assertThat(DecoderMain.copyImage(1, 0)).isEqualTo(error("call", "there is no image 1 of 1"));
    }

    @Test
    void shouldSayWhatAStepChanges() {
        assertThat(DecoderMain.isComplete()).isEqualTo("{\"value\":false}");
        assertThat(DecoderMain.header()).isEqualTo("{\"value\":null}");
        feed(SKY);
        assertThat(DecoderMain.isComplete()).isEqualTo("{\"value\":true}");
        assertThat(DecoderMain.copy(0)).isEqualTo(error("call", "there is nothing to copy before refine()"));
        String all = DecoderMain.refine();
        assertThat(all)
                .matches(
                        "\\{\"value\":\\{\"step\":1,\"jump\":false,\"batches\":\\d+,\"faces\":\\d+,\"vertices\":\\d+,\"places\":\\d+,"
                                + "\"groups\":\\[1,0,\\d+],\"tangents\":\\[],\"ranges\":\\[0,0,\\d+,1,0,\\d+,6,0,\\d+,3,0,\\d+]}}");
        assertThat(DecoderMain.copy(0)).matches("\\{\"value\":\\d\\d+}");
        assertThat(DecoderMain.copy(1 << 30)).isEqualTo("{\"value\":0}");
        assertThat(DecoderMain.copy(-1)).isEqualTo(error("call", "there is no element -1"));
        assertThat(DecoderMain.refine()).contains("\"step\":2,", "\"ranges\":[]");
    }

    @Test
    void shouldPlanTheFirstRequest() {
        DecoderMain.beginRound(0, 2000);
        assertThat(DecoderMain.nextRequest(0, 0))
                .isEqualTo("{\"value\":{\"from\":0,\"end\":16384,\"fromBatch\":0,\"endBatch\":-1,"
                        + "\"bytesPerSecond\":0,\"waitMillis\":0}}");
    }

    @Test
    void shouldAnswerCallsInTheWrongOrderWithAnError() {
        String early = error("call", "the base has not arrived yet");
        assertThat(DecoderMain.refine()).isEqualTo(early);
        assertThat(DecoderMain.sha256()).isEqualTo(early);
        assertThat(DecoderMain.copyImage(0, 0)).isEqualTo(early);
        assertThat(DecoderMain.images()).isEqualTo("{\"value\":[]}");
        assertThat(DecoderMain.feed(-1)).isEqualTo(error("call", "cannot feed -1 bytes, only 0 to 1048576"));
        assertThat(DecoderMain.beginRound(0, Double.NaN)).isEqualTo(error("call", "a round cannot take 0 ms"));
    }

    @Test
    void shouldAnswerDamagedBytesWithAnError() {
        DecoderCalls.STAGING.clear().put(new byte[1000]);
        assertThat(DecoderMain.feed(1000)).startsWith("{\"error\":{\"kind\":\"damaged\",\"message\":\"");
    }

    @Test
    void shouldAnswerWhateverStopsTheDecoderWithAnError() {
        assertThat(Answer.of(json -> {
                    throw new OutOfMemoryError("Java heap space");
                }))
                .isEqualTo(error("memory", "there is not enough memory for this model"));
        assertThat(Answer.of(json -> {
                    throw new MalformedStreamException(7, "two\nlines");
                }))
                .isEqualTo(error("damaged", "two\\u000alines (byte 7)"));
        assertThat(Answer.done(() -> {
                    throw new StackOverflowError();
                }))
                .isEqualTo(error("damaged", "the decoder stopped"));
    }

    @Test
    void shouldProveMeshAndPictures() throws Exception {
        byte[] archive = SKY;
        feed(archive);
        ArchiveHeader header = header(archive);
        assertThat(DecoderMain.proof())
                .isEqualTo("{\"value\":{\"meshSha256\":\"" + header.meshSha256() + "\",\"modelSha256\":\""
                        + header.modelSha256() + "\",\"difference\":\"\"}}");
    }

    @Test
    void shouldNameAPictureThatWasAltered() throws Exception {
        byte[] archive = SKY;
        feed(AlteredPicture.in(archive));
        assertThat(DecoderMain.isComplete()).isEqualTo("{\"value\":true}");
        assertThat(DecoderMain.proof())
                .contains("\"difference\":\"the picture sky.png is not the one that was encoded\"");
    }

    @Test
    void shouldProveNothingBeforeTheLastBatch() {
        byte[] archive = SKY;
        feed(Arrays.copyOf(archive, archive.length - 1));
        assertThat(DecoderMain.proof()).isEqualTo(error("call", "the last batch has not arrived yet"));
    }

    @Test
    void shouldHaveTheWordsOfCommandAndWindow() throws Exception {
        Provenance from = new Provenance(
                "OBJ",
                List.of(
                        Note.dropped("3 group names not kept.", 3, ""),
                        Note.dropped("Gone.", 1, "").asWarning()));
        byte[] archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(TestShapes.ROUND.mesh(), from, List.of(), ProgressListener.NONE)
                .bytes();
        feed(archive);
        ArchiveHeader header = header(archive);
        assertThat(DecoderMain.header())
                .contains("\"modelSha256\":\"" + header.modelSha256() + "\"")
                .contains("\"words\":{\"claim\":\"" + OriginalWords.claim(from) + "\",\"warning\":true,\"notKept\":\""
                        + OriginalWords.notKept(from) + "\"}");
    }

    /** What was written of a value before the error is not part of the answer. */
    @Test
    void shouldForgetHalfAValue() {
        assertThat(Answer.of(json -> {
                    json.open('[').number(1);
                    throw new MalformedStreamException(-1, "no more");
                }))
                .isEqualTo(error("damaged", "no more"));
    }

    @ParameterizedTest
    @MethodSource("exported")
    void shouldLetNoExceptionOut(Method method) throws Exception {
        for (byte[] before : new byte[][] {{}, SKY}) {
            for (Object[] arguments : arguments(method)) {
                DecoderMain.open();
                feed(before);
                assertThat((String) method.invoke(null, arguments))
                        .as("%s %s", method, List.of(arguments))
                        .matches("(?s)\\{\"value\":.*}|\\{\"error\":\\{\"kind\":\"call\",.*}}");
            }
        }
    }

    /** What a call leaves behind must not make the fault of a later one another's. */
    @ParameterizedTest
    @MethodSource("exported")
    void shouldLetNoExceptionOutAfterAnyOther(Method first) throws Exception {
        feed(SKY);
        for (Method second : exported().toList())
            for (Object[] before : arguments(first))
                for (Object[] arguments : arguments(second)) {
                    first.invoke(null, before);
                    assertThat((String) second.invoke(null, arguments))
                            .as("%s %s after %s %s", second, List.of(arguments), first, List.of(before))
                            .matches("(?s)\\{\"value\":.*}|\\{\"error\":\\{\"kind\":\"call\",.*}}");
                }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldWorkAfterAnError(boolean fed) {
        if (fed) feed(new byte[] {1, 2, 3});
        DecoderMain.refine();
        DecoderMain.open();
        feed(SKY);
        assertThat(DecoderMain.sha256()).matches("\\{\"value\":\"[0-9a-f]{64}\"}");
    }

    static Stream<Method> exported() {
        return Stream.of(DecoderMain.class.getDeclaredMethods())
                .filter(m -> Modifier.isPublic(m.getModifiers()))
                .filter(m -> !m.getName().equals("main") && !m.getName().equals("staging"));
    }

    /** Every combination of numbers as the method's types have them. */
    private static List<Object[]> arguments(Method method) {
        List<Object[]> all = List.<Object[]>of(new Object[0]);
        for (Class<?> type : method.getParameterTypes()) {
            List<Object[]> longer = new ArrayList<>();
            for (Object[] before : all)
                for (double number : NUMBERS) {
                    Object[] after = Arrays.copyOf(before, before.length + 1);
                    after[before.length] = cast(number, type);
                    longer.add(after);
                }
            all = longer;
        }
        return all;
    }

    private static Object cast(double number, Class<?> type) {
        if (type == int.class) return (int) number;
        return type == boolean.class ? (Object) (number > 0) : (Object) number;
    }

    private static ArchiveHeader header(byte[] archive) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        return decoder.header();
    }

    private static void feed(byte[] bytes) {
        DecoderCalls.STAGING.clear().put(bytes);
        DecoderMain.feed(bytes.length);
    }

    private static String error(String kind, String message) {
        return "{\"error\":{\"kind\":\"" + kind + "\",\"message\":\"" + message + "\"}}";
    }
}
