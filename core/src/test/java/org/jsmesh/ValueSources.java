package org.jsmesh;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.VarInsnNode;
import org.objectweb.asm.tree.analysis.Analyzer;
import org.objectweb.asm.tree.analysis.AnalyzerException;
import org.objectweb.asm.tree.analysis.Frame;
import org.objectweb.asm.tree.analysis.SourceInterpreter;
import org.objectweb.asm.tree.analysis.SourceValue;

/**
 * Which instructions of a method compute the values on its stack, seen through locals that are read once: a compiler
 * puts their values in their place.
 */
final class ValueSources {
    private final MethodNode method;
    private final Frame<SourceValue>[] frames;

    /** Store to the number of loads that may read it. */
    private final Map<AbstractInsnNode, Integer> loads = new HashMap<>();

    ValueSources(ClassNode type, MethodNode method) throws AnalyzerException {
        this.method = method;
        frames = new Analyzer<>(new StoresAsSources()).analyze(type.name, method);
        for (AbstractInsnNode instruction : method.instructions) {
            Frame<SourceValue> frame = frame(instruction);
            int opcode = instruction.getOpcode();
            if (frame == null || opcode != Opcodes.DLOAD && opcode != Opcodes.FLOAD) continue;
            for (AbstractInsnNode store : frame.getLocal(((VarInsnNode) instruction).var).insns)
                loads.merge(store, 1, Integer::sum);
        }
    }

    /** What computes the topmost operand of an instruction. */
    Set<AbstractInsnNode> ofTop(AbstractInsnNode instruction) {
        Set<AbstractInsnNode> found = new HashSet<>();
        collect(instruction, found);
        return found;
    }

    private void collect(AbstractInsnNode instruction, Set<AbstractInsnNode> found) {
        Frame<SourceValue> frame = frame(instruction);
        if (frame == null) return;
        for (AbstractInsnNode source : frame.getStack(frame.getStackSize() - 1).insns) {
            int opcode = source.getOpcode();
            boolean store = opcode == Opcodes.DSTORE || opcode == Opcodes.FSTORE;
            if (found.add(source) && store && loads.getOrDefault(source, 0) == 1) collect(source, found);
        }
    }

    /** Null where the method never comes. */
    private Frame<SourceValue> frame(AbstractInsnNode instruction) {
        return frames[method.instructions.indexOf(instruction)];
    }

    /** A loaded value comes from where its local was stored. */
    private static final class StoresAsSources extends SourceInterpreter {
        StoresAsSources() {
            super(Opcodes.ASM9);
        }

        @Override
        public SourceValue copyOperation(AbstractInsnNode instruction, SourceValue value) {
            int opcode = instruction.getOpcode();
            boolean load = opcode == Opcodes.DLOAD || opcode == Opcodes.FLOAD;
            return load && !value.insns.isEmpty() ? value : super.copyOperation(instruction, value);
        }
    }
}
