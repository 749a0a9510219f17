package org.jsmesh.web.compile;

import java.util.HashSet;
import java.util.Set;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.ValueType;
import org.teavm.model.Variable;
import org.teavm.model.instructions.ConstructInstruction;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.model.instructions.NullConstantInstruction;
import org.teavm.model.instructions.RaiseInstruction;
import org.teavm.model.instructions.StringConstantInstruction;

/**
 * Takes the words out of exceptions. Nobody reads those of the first decoder: whatever stops it, the whole one is fed
 * the same bytes and tells the reason.
 */
public final class MessagesGone implements ClassHolderTransformer {
    /** TeaVM reads a concatenation as calls of one. */
    private static final String BUILDER = StringBuilder.class.getName();

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        boolean isThrowable = isThrowable(type.getName(), context);
        for (MethodHolder method : type.getMethods()) {
            if (method.getProgram() == null) continue;
            boolean isForThrowing = isThrowable
                    || method.getResultType() instanceof ValueType.Object result
                            && isThrowable(result.getClassName(), context);
            for (BasicBlock block : method.getProgram().getBasicBlocks())
                if (isForThrowing || block.getLastInstruction() instanceof RaiseInstruction) silence(block);
        }
    }

    private static boolean isThrowable(String type, ClassHolderTransformerContext context) {
        return context.getHierarchy().isSuperType(Throwable.class.getName(), type, false);
    }

    private static void silence(BasicBlock block) {
        Set<Variable> builders = new HashSet<>(); // made and used up here
        for (Instruction i : block) {
            if (i instanceof StringConstantInstruction words) {
                words.setConstant("");
            } else if (i instanceof ConstructInstruction made && made.getType().equals(BUILDER)) {
                builders.add(made.getReceiver());
                i.replace(nothing(made.getReceiver()));
            } else if (i instanceof InvokeInstruction call && builders.contains(call.getInstance())) {
                silence(call, builders);
            }
        }
    }

    private static void silence(InvokeInstruction call, Set<Variable> builders) {
        Variable receiver = call.getReceiver();
        if (receiver == null) {
            call.delete();
        } else if (call.getMethod().getName().equals("toString")) {
            StringConstantInstruction words = new StringConstantInstruction();
            words.setReceiver(receiver);
            words.setConstant("");
            call.replace(words);
        } else {
            builders.add(receiver);
            call.replace(nothing(receiver));
        }
    }

    private static Instruction nothing(Variable receiver) {
        NullConstantInstruction nothing = new NullConstantInstruction();
        nothing.setReceiver(receiver);
        return nothing;
    }
}
