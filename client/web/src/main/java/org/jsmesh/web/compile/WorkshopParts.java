package org.jsmesh.web.compile;

import java.util.List;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.ValueType;
import org.teavm.model.instructions.GetFieldInstruction;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.model.instructions.NullConstantInstruction;

/**
 * The workshop has one thread and reads no 3MF. Where it calls for what TeaVM lacks, the browser or the project helps.
 */
public final class WorkshopParts extends LeftOut {
    private static final String OURS = "org.jsmesh.";
    private static final String HELPER = "org.jsmesh.web.BrowserParts";
    private static final String HASH = "org.jsmesh.encode.PlatformHash.sha256";
    private static final String NORMALIZE = "java.text.Normalizer.normalize";
    private static final String FORM = "java.text.Normalizer$Form";
    private static final MethodReference COMPOSED = new MethodReference(
            HELPER, "normalize", ValueType.object("java.lang.CharSequence"), ValueType.object("java.lang.String"));

    /** Makes the transformer; TeaVM does. */
    public WorkshopParts() {
        super(
                List.of(
                        "ForkedTask.fork",
                        "ForkedPairRunner.*",
                        "RangeRunner$Job.take",
                        "RangeRunner$Job.await",
                        "RangeRunner$Job.finish",
                        "ThreeMfReader.read"),
                List.of());
    }

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        super.transformClass(type, context);
        if (!type.getName().startsWith(OURS)) return;
        for (MethodHolder method : type.getMethods()) {
            if (method.getProgram() == null) continue;
            for (BasicBlock block : method.getProgram().getBasicBlocks()) for (Instruction i : block) help(i);
        }
    }

    private static void help(Instruction instruction) {
        if (instruction instanceof GetFieldInstruction read
                && read.getField().getClassName().equals(FORM)) {
            NullConstantInstruction nothing = new NullConstantInstruction();
            nothing.setReceiver(read.getReceiver());
            read.replace(nothing);
        } else if (instruction instanceof InvokeInstruction call) {
            MethodReference wanted = call.getMethod();
            String name = wanted.getClassName() + "." + wanted.getName();
            if (name.equals(HASH)) {
                call.setMethod(new MethodReference(HELPER, wanted.getDescriptor()));
            } else if (name.equals(NORMALIZE)) {
                call.setMethod(COMPOSED);
                call.setArguments(call.getArguments().get(0));
            }
        }
    }
}
