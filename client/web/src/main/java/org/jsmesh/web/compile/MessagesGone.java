package org.jsmesh.web.compile;

import java.lang.invoke.StringConcatFactory;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.InvokeDynamicInstruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.Variable;
import org.teavm.model.instructions.RaiseInstruction;
import org.teavm.model.instructions.StringConstantInstruction;

/**
 * Takes the words out of exceptions. Nobody reads those of the first decoder: whatever stops it, the whole one is fed
 * the same bytes and tells the reason.
 */
public final class MessagesGone implements ClassHolderTransformer {
    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        boolean isThrowable = context.getHierarchy().isSuperType(Throwable.class.getName(), type.getName(), false);
        for (MethodHolder method : type.getMethods()) {
            if (method.getProgram() == null) continue;
            for (BasicBlock block : method.getProgram().getBasicBlocks())
                if (isThrowable || block.getLastInstruction() instanceof RaiseInstruction) silence(block);
        }
    }

    private static void silence(BasicBlock block) {
        for (Instruction i : block) {
            if (i instanceof StringConstantInstruction words) words.setConstant("");
            else if (i instanceof InvokeDynamicInstruction call && isConcatenation(call))
                call.replace(nothing(call.getReceiver()));
        }
    }

    private static boolean isConcatenation(InvokeDynamicInstruction call) {
        return call.getBootstrapMethod().getClassName().equals(StringConcatFactory.class.getName());
    }

    private static Instruction nothing(Variable receiver) {
        StringConstantInstruction nothing = new StringConstantInstruction();
        nothing.setReceiver(receiver);
        nothing.setConstant("");
        return nothing;
    }
}
