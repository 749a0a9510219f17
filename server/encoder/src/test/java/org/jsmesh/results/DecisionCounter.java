package org.jsmesh.results;

import java.lang.reflect.Field;
import java.util.Map;
import org.jsmesh.decode.ArchiveDecoder;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Counts the adaptive decisions that a decoder makes. It decodes with classes of its own, whose range decoder has a
 * counter woven in: what is shipped has none.
 */
final class DecisionCounter {
    private static final String WOVEN = "org.jsmesh.codec.entropy.RangeDecoder";
    private static final String DECISION = "codeBit";
    private static final String COUNTER = "decisions";

    private final Class<?> decoders;
    private final Field counter;

    DecisionCounter() throws ReflectiveOperationException {
        ClassLoader loader = new WeavingLoader(Map.of(WOVEN, DecisionCounter::counting));
        decoders = loader.loadClass(ArchiveDecoder.class.getName());
        counter = loader.loadClass(WOVEN).getField(COUNTER);
    }

    /** Counts what a whole archive takes. */
    synchronized long count(byte[] archive) {
        try {
            counter.setLong(null, 0);
            decode(archive);
            long count = counter.getLong(null);
            if (count > 0) return count;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
        throw new IllegalStateException(WOVEN + "." + DECISION + " was never called: let " + DecisionCounter.class
                + " count the method that decodes a bit of a context");
    }

    private void decode(byte[] archive) throws ReflectiveOperationException {
        Object decoder = decoders.getConstructor().newInstance();
        decoders.getMethod("feed", byte[].class, int.class, int.class).invoke(decoder, archive, 0, archive.length);
        if (!(boolean) decoders.getMethod("isComplete").invoke(decoder))
            throw new IllegalStateException("the decoder did not come to the end of " + archive.length + " bytes");
    }

    /** Gives a class the counter, and has a method count. */
    private static ClassVisitor counting(ClassVisitor next) {
        String owner = WOVEN.replace('.', '/');
        return new ClassVisitor(Opcodes.ASM9, next) {
            @Override
            public MethodVisitor visitMethod(
                    int access, String name, String descriptor, String signature, String[] exceptions) {
                MethodVisitor method = super.visitMethod(access, name, descriptor, signature, exceptions);
                return name.equals(DECISION) ? new Counting(method, owner) : method;
            }

            @Override
            public void visitEnd() {
                visitField(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, COUNTER, "J", null, null);
                super.visitEnd();
            }
        };
    }

    /** A method that begins by counting. */
    private static final class Counting extends MethodVisitor {
        private final String owner;

        Counting(MethodVisitor method, String owner) {
            super(Opcodes.ASM9, method);
            this.owner = owner;
        }

        @Override
        public void visitCode() {
            super.visitCode();
            visitFieldInsn(Opcodes.GETSTATIC, owner, COUNTER, "J");
            visitInsn(Opcodes.LCONST_1);
            visitInsn(Opcodes.LADD);
            visitFieldInsn(Opcodes.PUTSTATIC, owner, COUNTER, "J");
        }
    }
}
