package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.jsmesh.mesh.MalformedStreamException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecoderMainTest {
    /** Of numbers and flags, what a careless caller may pass. */
    private static final List<Double> NUMBERS = List.of(0., -1., 1e300, Double.NaN);

    /** Number of the array of groups. */
    private static final int GROUPS = 5;

    @BeforeEach
    void open() {
        DecoderMain.open();
    }

    @Test
    void shouldGiveBackPathsWithLineBreaksAndQuotes() {
        feed(DecodingSessionTest.archive("a\nb\t\"8\"\\\u0001.png"));
        String path = "\"path\":\"a\\u000ab\\u0009\\\"8\\\"\\\\\\u0001.png\"";
        assertThat(DecoderMain.images()).isEqualTo("{\"value\":[{" + path + ",\"width\":null}]}");
        assertThat(DecoderMain.header()).contains("\"texture\":" + path.substring("\"path\":".length()));
    }

    @Test
    void shouldCopyAnImageThroughTheBuffer() {
        feed(DecodingSessionTest.archive("sky.png"));
        assertThat(DecoderMain.copyImage(0, 29_990)).isEqualTo("{\"value\":10}");
        byte[] copied = new byte[10];
        DecoderMain.STAGING.position(0).get(copied);
        assertThat(copied).isEqualTo(Arrays.copyOfRange(DecodingSessionTest.IMAGE, 29_990, 30_000));
        assertThat(DecoderMain.copyImage(0, 30_000)).isEqualTo("{\"value\":0}");
        assertThat(DecoderMain.copyImage(0, 30_001)).isEqualTo(error("call", "image 0 has no byte 30001"));
        assertThat(DecoderMain.copyImage(1, 0)).isEqualTo(error("call", "there is no image 1 of 1"));
    }

    @Test
    void shouldSayHowManyElementsEachArrayHas() {
        assertThat(DecoderMain.isComplete()).isEqualTo("{\"value\":false}");
        assertThat(DecoderMain.header()).isEqualTo("{\"value\":null}");
        feed(DecodingSessionTest.archive("sky.png"));
        assertThat(DecoderMain.isComplete()).isEqualTo("{\"value\":true}");
        assertThat(DecoderMain.draw()).matches("\\{\"value\":\\[\\d+,\\d+,\\d+,0,\\d+,\\d+]}");
        assertThat(DecoderMain.copy(GROUPS, 0)).isEqualTo("{\"value\":6}"); // no material, and one
        assertThat(DecoderMain.copy(GROUPS, 7)).isEqualTo(error("call", "array 5 has no element 7"));
        assertThat(DecoderMain.copy(6, 0)).isEqualTo(error("call", "there is no array 6"));
        DecoderMain.release();
        assertThat(DecoderMain.copy(GROUPS, 0)).isEqualTo(error("call", "there is nothing to copy before draw()"));
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
        assertThat(DecoderMain.draw()).isEqualTo(early);
        assertThat(DecoderMain.sha256()).isEqualTo(early);
        assertThat(DecoderMain.copyImage(0, 0)).isEqualTo(early);
        assertThat(DecoderMain.images()).isEqualTo("{\"value\":[]}");
        assertThat(DecoderMain.feed(-1)).isEqualTo(error("call", "cannot feed -1 bytes, only 0 to 1048576"));
        assertThat(DecoderMain.beginRound(0, Double.NaN)).isEqualTo(error("call", "a round cannot take NaN ms"));
    }

    @Test
    void shouldAnswerDamagedBytesWithAnError() {
        DecoderMain.STAGING.clear().put(new byte[1000]);
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
        for (byte[] before : new byte[][] {{}, DecodingSessionTest.archive("sky.png")}) {
            for (Object[] arguments : arguments(method)) {
                DecoderMain.open();
                feed(before);
                assertThat((String) method.invoke(null, arguments))
                        .as("%s %s", method, List.of(arguments))
                        .matches("(?s)\\{\"value\":.*}|\\{\"error\":\\{\"kind\":\"call\",.*}}");
            }
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldWorkAfterAnError(boolean fed) {
        if (fed) feed(new byte[] {1, 2, 3});
        DecoderMain.draw();
        DecoderMain.open();
        feed(DecodingSessionTest.archive("sky.png"));
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

    private static void feed(byte[] bytes) {
        DecoderMain.STAGING.clear().put(bytes);
        DecoderMain.feed(bytes.length);
    }

    private static String error(String kind, String message) {
        return "{\"error\":{\"kind\":\"" + kind + "\",\"message\":\"" + message + "\"}}";
    }
}
