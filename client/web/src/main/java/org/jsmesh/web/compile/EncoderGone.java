package org.jsmesh.web.compile;

import java.util.HashSet;
import java.util.Set;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.Program;
import org.teavm.model.ValueType;
import org.teavm.model.Variable;
import org.teavm.model.instructions.GetFieldInstruction;
import org.teavm.model.instructions.IntegerConstantInstruction;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.model.instructions.NullConstantInstruction;
import org.teavm.model.optimization.ConstantConditionElimination;
import org.teavm.model.optimization.UnreachableBasicBlockEliminator;
import org.teavm.model.util.InstructionVariableMapper;

/**
 * Takes the encoder's half out of code that serves both directions: no coder encodes, and what only an encoder knows is
 * null. TeaVM does not follow what stands behind such a condition.
 */
public final class EncoderGone implements ClassHolderTransformer {
    private static final String OURS = "org.jsmesh.";

    /** Types whose values a decoder has none of. */
    private static final Set<String> ABSENT = Set.of(
            "org.jsmesh.codec.connectivity.EncoderTruth",
            "org.jsmesh.codec.connectivity.PatchPlan",
            "org.jsmesh.codec.connectivity.PairRunner",
            "org.jsmesh.codec.ComponentSteps",
            "org.jsmesh.codec.SplitSteps");

    private static final String QUESTION = "isEncoder";

    /** Coders of the header keep the answer in a field. */
    private static final String ANSWER = "write";

    private static final String CODERS = "org.jsmesh.archive.coding.";

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        if (!type.getName().startsWith(OURS)) return;
        for (MethodHolder method : type.getMethods()) if (method.getProgram() != null) decode(method);
    }

    private static void decode(MethodHolder method) {
        Program program = method.getProgram();
        boolean isChanged = forgetParameters(method);
        for (BasicBlock block : program.getBasicBlocks()) for (Instruction i : block) isChanged |= replace(i);
        if (!isChanged) return;
        while (new ConstantConditionElimination().optimize(method.getDescriptor(), program)) {
            // a condition may decide the next one
        }
        new UnreachableBasicBlockEliminator().optimize(program);
    }

    private static boolean forgetParameters(MethodHolder method) {
        Set<Variable> absent = new HashSet<>();
        Program program = method.getProgram();
        for (int i = 0; i < method.parameterCount(); i++)
            if (isAbsent(method.parameterType(i))) absent.add(program.variableAt(i + 1)); // behind `this`
        if (absent.isEmpty()) return false;
        Variable nothing = program.createVariable();
        InstructionVariableMapper mapper =
                new InstructionVariableMapper(used -> absent.contains(used) ? nothing : used);
        for (BasicBlock block : program.getBasicBlocks()) mapper.apply(block);
        NullConstantInstruction constant = new NullConstantInstruction();
        constant.setReceiver(nothing);
        program.basicBlockAt(0).addFirst(constant);
        return true;
    }

    private static boolean replace(Instruction instruction) {
        if (instruction instanceof GetFieldInstruction read && isAbsent(read.getFieldType())) {
            NullConstantInstruction constant = new NullConstantInstruction();
            constant.setReceiver(read.getReceiver());
            constant.setLocation(read.getLocation());
            return read.replace(constant);
        }
        if (instruction instanceof GetFieldInstruction read
                && read.getField().getFieldName().equals(ANSWER)
                && read.getField().getClassName().startsWith(CODERS)) return answerNo(read, read.getReceiver());
        if (instruction instanceof InvokeInstruction call
                && call.getMethod().getName().equals(QUESTION)
                && call.getMethod().getClassName().startsWith(OURS)
                && call.getReceiver() != null) return answerNo(call, call.getReceiver());
        return false;
    }

    private static boolean answerNo(Instruction question, Variable receiver) {
        IntegerConstantInstruction no = new IntegerConstantInstruction();
        no.setConstant(0);
        no.setReceiver(receiver);
        no.setLocation(question.getLocation());
        return question.replace(no);
    }

    private static boolean isAbsent(ValueType type) {
        return type instanceof ValueType.Object object && ABSENT.contains(object.getClassName());
    }
}
