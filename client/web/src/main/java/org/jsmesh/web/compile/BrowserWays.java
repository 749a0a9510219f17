package org.jsmesh.web.compile;

import java.util.Map;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.ValueType;
import org.teavm.model.instructions.InvokeInstruction;

/**
 * Calls methods with the same results in place of others that are fast on the Java virtual machine alone. Browsers
 * compile a sorting network to as many calls, each with branches, and a sort by insertion takes less.
 */
public class BrowserWays implements ClassHolderTransformer {
    private static final String OURS = "org.jsmesh.";
    private static final String SORT = "org.jsmesh.codec.position.SmallSort";
    private static final MethodReference NETWORK =
            new MethodReference(SORT, "merge", ValueType.parse(int[].class), ValueType.INTEGER, ValueType.VOID);
    private static final MethodReference INSERTION =
            new MethodReference(SORT, "insert", ValueType.parse(int[].class), ValueType.INTEGER, ValueType.VOID);

    private final Map<MethodReference, MethodReference> ways;

    /** Makes the transformer; TeaVM does. */
    public BrowserWays() {
        this(Map.of(NETWORK, INSERTION));
    }

    /** @param ways what is called in place of each method, with the same parameters */
    BrowserWays(Map<MethodReference, MethodReference> ways) {
        this.ways = ways;
    }

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        if (!type.getName().startsWith(OURS)) return;
        for (MethodHolder method : type.getMethods()) {
            if (method.getProgram() == null) continue;
            for (BasicBlock block : method.getProgram().getBasicBlocks()) for (Instruction i : block) redirect(i);
        }
    }

    private void redirect(Instruction instruction) {
        if (instruction instanceof InvokeInstruction call)
            call.setMethod(ways.getOrDefault(call.getMethod(), call.getMethod()));
    }
}
