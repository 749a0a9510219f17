package org.jsmesh;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.analysis.Analyzer;
import org.objectweb.asm.tree.analysis.AnalyzerException;
import org.objectweb.asm.tree.analysis.SourceInterpreter;
import org.objectweb.asm.tree.analysis.SourceValue;

/**
 * Finds floats that something reads before their bits or an array have rounded them: results of casts and of
 * arithmetic, and constants of several decimals. They may be made bits, or be put into an array, and nothing else: no
 * field, parameter or result takes them, so within one method everything can be seen.
 */
final class UnroundedFloats extends SourceInterpreter {
    private static final Set<Integer> MAKERS = Set.of(
            Opcodes.D2F,
            Opcodes.I2F,
            Opcodes.L2F,
            Opcodes.FADD,
            Opcodes.FSUB,
            Opcodes.FMUL,
            Opcodes.FDIV,
            Opcodes.FREM);
    private static final Set<String> BITS = Set.of("floatToIntBits", "floatToRawIntBits");

    private final Set<String> found = new TreeSet<>();
    private final String place;

    private UnroundedFloats(String place) {
        super(Opcodes.ASM9);
        this.place = place;
    }

    /** The method's name, if it reads such a float. */
    static Set<String> in(ClassNode type, MethodNode method) throws AnalyzerException {
        UnroundedFloats interpreter = new UnroundedFloats(type.name + "." + method.name);
        new Analyzer<>(interpreter).analyze(type.name, method);
        return interpreter.found;
    }

    /** Locals change nothing. */
    @Override
    public SourceValue copyOperation(AbstractInsnNode instruction, SourceValue value) {
        return value;
    }

    @Override
    public SourceValue unaryOperation(AbstractInsnNode instruction, SourceValue value) {
        check(value);
        return super.unaryOperation(instruction, value);
    }

    @Override
    public SourceValue binaryOperation(AbstractInsnNode instruction, SourceValue left, SourceValue right) {
        check(left);
        check(right);
        return super.binaryOperation(instruction, left, right);
    }

    @Override
    public SourceValue naryOperation(AbstractInsnNode instruction, List<? extends SourceValue> values) {
        boolean bits = instruction instanceof MethodInsnNode call
                && call.owner.equals("java/lang/Float")
                && BITS.contains(call.name);
        if (!bits) values.forEach(this::check);
        return super.naryOperation(instruction, values);
    }

    @Override
    public void returnOperation(AbstractInsnNode instruction, SourceValue value, SourceValue expected) {
        check(value);
    }

    private void check(SourceValue value) {
        if (value.insns.stream().anyMatch(UnroundedFloats::isUnrounded)) found.add(place);
    }

    private static boolean isUnrounded(AbstractInsnNode source) {
        if (source instanceof LdcInsnNode constant && constant.cst instanceof Float x)
            return Double.parseDouble(Float.toString(x)) != (double) x;
        return MAKERS.contains(source.getOpcode());
    }
}
