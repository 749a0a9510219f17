package org.jsmesh;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.analysis.AnalyzerException;

/**
 * TeaVM's JavaScript forgets the brackets of {@code a + (b − c)} and {@code a · (b / c)}, as if floating point were
 * associative, also where locals or short methods stand for the brackets. The last bit then differs, and decoding with
 * it. So the decoder adds and multiplies from left to right.
 *
 * <p>Floats are doubles there that nothing rounds but {@link Float#floatToIntBits} and arrays of floats, neither a cast
 * nor an operation, and constants are what their decimals say. So the decoder takes a float that it has made through
 * its bits, or through an array, before anything else reads it.
 */
class DecoderArithmeticTest {
    private static final Set<Integer> SUMS = Set.of(Opcodes.DADD, Opcodes.DSUB, Opcodes.FADD, Opcodes.FSUB);
    private static final Set<Integer> PRODUCTS =
            Set.of(Opcodes.DMUL, Opcodes.DDIV, Opcodes.DREM, Opcodes.FMUL, Opcodes.FDIV, Opcodes.FREM);

    /** Method to the operations whose results it returns. */
    private final Map<String, Set<Integer>> returned = new HashMap<>();

    @Test
    void shouldAddAndMultiplyFromLeftToRight() throws Exception {
        assertThat(bracketed(decoder())).isEmpty();
    }

    @Test
    void shouldSeeEveryKindOfBracket() throws Exception {
        assertThat(bracketed(List.of(read(Bracketed.class)))).hasSize(4).allMatch(place -> place.contains("wrong"));
    }

    @Test
    void shouldRoundFloatsThroughTheirBitsOrArrays() throws Exception {
        assertThat(unrounded(decoder())).isEmpty();
    }

    @Test
    void shouldSeeEveryUseOfFloatsThatAreNotRounded() throws Exception {
        assertThat(unrounded(List.of(read(Rounded.class)))).hasSize(9).allMatch(place -> place.contains("wrong"));
    }

    private static List<ClassNode> decoder() throws IOException {
        List<ClassNode> decoder = new ArrayList<>();
        for (JavaClass type : CorePackages.CLASSES) if (CorePackages.isExact(type)) decoder.add(read(type.reflect()));
        assertThat(decoder).hasSizeGreaterThan(50);
        return decoder;
    }

    private static List<String> unrounded(List<ClassNode> classes) throws AnalyzerException {
        List<String> places = new ArrayList<>();
        for (ClassNode type : classes)
            for (MethodNode method : type.methods) places.addAll(UnroundedFloats.in(type, method));
        return places;
    }

    private List<String> bracketed(List<ClassNode> classes) throws AnalyzerException {
        for (ClassNode type : classes) for (MethodNode method : type.methods) noteReturned(type, method);
        List<String> places = new ArrayList<>();
        for (ClassNode type : classes) for (MethodNode method : type.methods) findIn(type, method, places);
        return places;
    }

    private static ClassNode read(Class<?> type) throws IOException {
        ClassNode node = new ClassNode();
        try (InputStream bytes = type.getResourceAsStream("/" + type.getName().replace('.', '/') + ".class")) {
            new ClassReader(bytes).accept(node, 0);
        }
        return node;
    }

    private void noteReturned(ClassNode type, MethodNode method) throws AnalyzerException {
        ValueSources sources = new ValueSources(type, method);
        Set<Integer> operations = new HashSet<>();
        for (AbstractInsnNode instruction : method.instructions) {
            int opcode = instruction.getOpcode();
            if (opcode != Opcodes.DRETURN && opcode != Opcodes.FRETURN) continue;
            for (AbstractInsnNode source : sources.ofTop(instruction)) operations.add(source.getOpcode());
        }
        returned.put(type.name + "." + method.name + method.desc, operations);
    }

    private void findIn(ClassNode type, MethodNode method, List<String> places) throws AnalyzerException {
        ValueSources sources = new ValueSources(type, method);
        for (AbstractInsnNode instruction : method.instructions) {
            int opcode = instruction.getOpcode();
            boolean sum = opcode == Opcodes.DADD || opcode == Opcodes.FADD;
            boolean product = opcode == Opcodes.DMUL || opcode == Opcodes.FMUL;
            if (!sum && !product) continue;
            for (AbstractInsnNode source : sources.ofTop(instruction)) {
                if (operations(source).stream().anyMatch((sum ? SUMS : PRODUCTS)::contains))
                    places.add(type.name + "." + method.name);
            }
        }
    }

    private Set<Integer> operations(AbstractInsnNode source) {
        return source instanceof MethodInsnNode call
                ? returned.getOrDefault(call.owner + "." + call.name + call.desc, Set.of())
                : Set.of(source.getOpcode());
    }

    /** What the rule must and must not find. */
    private static final class Bracketed {
        static double wrongSum(double a, double b, double c) {
            return a + (b - c);
        }

        static double wrongProduct(double a, double b, double c) {
            return a * (b / c);
        }

        static double wrongByLocal(double a, double b, double c) {
            double product = b * c;
            return a * product;
        }

        static double rightByLocal(double a, double b, double c) {
            double product = b * c;
            return a * product + product;
        }

        static double wrongByMethod(double a, double b, double c) {
            return a + rightSum(a, b, c);
        }

        static double rightSum(double a, double b, double c) {
            double sum = a * b - c;
            sum += b * c;
            return sum - (a + b);
        }
    }

    /** What the rule on floats must and must not find. */
    private static final class Rounded {
        private float field;

        static double wrongCast(double x) {
            return (float) x;
        }

        static double wrongByLocal(int x, boolean half) {
            float number = 0;
            if (half) number = x;
            return number * 2d;
        }

        static double wrongSum(float x) {
            return x + 1f + 1d;
        }

        static boolean wrongComparison(double x, float y) {
            return (float) x < y;
        }

        static float wrongResult(float x) {
            return x / 255f;
        }

        static int wrongParameter(double x) {
            return rightBits((float) x, 0);
        }

        static boolean wrongConstant(float x) {
            return x < .1f;
        }

        void wrongField(double x) {
            field = (float) x;
        }

        static long wrongInteger(double x) {
            return (long) (float) x;
        }

        static int rightBits(float x, double y) {
            float sum = (float) (x + y);
            return Float.floatToIntBits(sum);
        }

        static double rightByBits(double x) {
            return Float.intBitsToFloat(Float.floatToRawIntBits((float) x)) + .5;
        }

        static double rightByArray(double x, float[] numbers) {
            numbers[0] = (float) x;
            return numbers[0];
        }

        float rightField() {
            return field;
        }
    }
}
