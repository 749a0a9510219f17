package org.jsmesh.web.compile;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.MethodHolder;
import org.teavm.model.ValueType;
import org.teavm.model.emit.ProgramEmitter;

/**
 * Empties methods before TeaVM follows what they call. Each is named {@code Class.method}, or {@code Class.*} for all
 * of a class, within the project's packages.
 */
abstract class LeftOut implements ClassHolderTransformer {
    private static final String OURS = "org.jsmesh.";

    private final Set<String> failing;
    private final Set<String> idle;

    /**
     * @param failing methods that throw when they are called
     * @param idle methods that do nothing and give 0 or null back
     */
    LeftOut(List<String> failing, List<String> idle) {
        this.failing = new HashSet<>(failing);
        this.idle = new HashSet<>(idle);
    }

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        if (!type.getName().startsWith(OURS)) return;
        String simple = type.getName().substring(type.getName().lastIndexOf('.') + 1);
        for (MethodHolder method : type.getMethods()) {
            if (method.getProgram() == null) continue;
            String name = simple + "." + method.getName();
            if (failing.contains(name) || failing.contains(simple + ".*")) fail(method, context);
            else if (idle.contains(name)) giveBackNothing(method, context);
        }
    }

    private static void fail(MethodHolder method, ClassHolderTransformerContext context) {
        ProgramEmitter.create(method, context.getHierarchy())
                .construct(IllegalStateException.class)
                .raise();
    }

    private static void giveBackNothing(MethodHolder method, ClassHolderTransformerContext context) {
        ProgramEmitter program = ProgramEmitter.create(method, context.getHierarchy());
        ValueType type = method.getResultType();
        if (type == ValueType.VOID) program.exit();
        else if (type instanceof ValueType.Primitive) program.constant(0).returnValue();
        else program.constantNull(type).returnValue();
    }
}
