package org.jsmesh.results;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.jsmesh.codec.SweepCoder;
import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.lattice.LatticeCoder;
import org.jsmesh.codec.position.PositionCoder;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.results.BitLedger.Kind;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Tells what the bits of an archive are for. It decodes with classes of its own, which note what they read. */
final class BitBudget {
    private static final String LEDGER = BitLedger.class.getName().replace('.', '/');
    private static final String READER = "org.jsmesh.codec.entropy.RangeDecoder";
    private static final String POSITIONS = PositionCoder.class.getName();
    private static final String MIRROR = "org.jsmesh.codec.position.MirrorCoder";
    private static final String COMPONENTS = "org.jsmesh.codec.ComponentCoder";

    /** The methods that decode a kind, and what they call that decodes none of its own. */
    private static final Map<String, Kind> KINDS = Map.ofEntries(
            Map.entry(ConnectivityCoder.class.getName() + ".codeSplit", Kind.FLAGS),
            Map.entry("org.jsmesh.codec.connectivity.RunCoder.code", Kind.CUTS),
            Map.entry("org.jsmesh.codec.connectivity.StitchCoder.code", Kind.STITCHES),
            Map.entry(POSITIONS + ".codeTangent", Kind.TANGENTIAL),
            Map.entry(POSITIONS + ".codeFromRing", Kind.NORMAL),
            Map.entry(POSITIONS + ".codeNear", Kind.BASE),
            Map.entry(COMPONENTS + ".codeBase", Kind.BASE),
            Map.entry(COMPONENTS + ".codeAnother", Kind.BASE),
            Map.entry(POSITIONS + ".move", Kind.MOVED),
            Map.entry(SweepCoder.class.getName() + ".codeMoved", Kind.MOVED),
            Map.entry(POSITIONS + ".refine", Kind.SWEEPS),
            Map.entry(MIRROR + ".codeInPass", Kind.MIRROR),
            Map.entry(MIRROR + ".codeInSweep", Kind.MIRROR),
            Map.entry(LatticeCoder.class.getName() + ".code", Kind.LATTICE),
            Map.entry("org.jsmesh.codec.attribute.WedgeCoder.codeSplit", Kind.ATTRIBUTES),
            Map.entry("org.jsmesh.codec.attribute.AttributeSweep.code", Kind.ATTRIBUTES));

    /** The reader's methods, and those of the ledger that hear of them. */
    private static final Map<String, String> READS = Map.of("codeBit", "bit", "codeRaw", "raw", "codeBelow", "below");

    private final Class<?> decoders;
    private final Method clear;
    private final Method bits;
    private final Set<String> woven = new HashSet<>();

    BitBudget() throws ReflectiveOperationException {
        Map<String, Function<ClassVisitor, ClassVisitor>> weavers = new HashMap<>();
        for (String method : KINDS.keySet()) {
            String type = method.substring(0, method.lastIndexOf('.'));
            weavers.put(type, visitor -> new Entries(visitor, type));
        }
        weavers.put(READER, Reads::new);
        WeavingLoader loader = new WeavingLoader(weavers);
        decoders = loader.loadClass(ArchiveDecoder.class.getName());
        Class<?> ledger = loader.loadClass(BitLedger.class.getName());
        clear = ledger.getMethod("clear");
        bits = ledger.getMethod("bits");
    }

    /** Bits of each kind in an archive, first those up to a byte where a batch ends, then those of the whole. */
    synchronized double[][] count(byte[] archive, int end) throws ReflectiveOperationException {
        clear.invoke(null);
        Object decoder = decoders.getConstructor().newInstance();
        Method feed = decoders.getMethod("feed", byte[].class, int.class, int.class);
        feed.invoke(decoder, archive, 0, end);
        double[] first = (double[]) bits.invoke(null);
        feed.invoke(decoder, archive, end, archive.length - end);
        if (!(boolean) decoders.getMethod("isComplete").invoke(decoder))
            throw new IllegalStateException("the decoder did not come to the end of " + archive.length + " bytes");
        return new double[][] {first, (double[]) bits.invoke(null)};
    }

    /** Methods by which kinds are told apart and which the codec has no more. */
    Set<String> missing() throws ClassNotFoundException {
        Set<String> missing = new TreeSet<>();
        for (String method : KINDS.keySet()) {
            decoders.getClassLoader().loadClass(method.substring(0, method.lastIndexOf('.')));
            if (!woven.contains(method)) missing.add(method);
        }
        return missing;
    }

    /** Names of the kinds, in the order of the counts. */
    static String[] names() {
        return Arrays.stream(Kind.values())
                .map(kind -> kind.name().toLowerCase())
                .toArray(String[]::new);
    }

    /** Weaves the methods of a class that decode a kind. */
    private final class Entries extends ClassVisitor {
        private final String type;

        Entries(ClassVisitor next, String type) {
            super(Opcodes.ASM9, next);
            this.type = type;
        }

        @Override
        public MethodVisitor visitMethod(
                int access, String name, String descriptor, String signature, String[] errors) {
            MethodVisitor method = super.visitMethod(access, name, descriptor, signature, errors);
            Kind kind = KINDS.get(type + "." + name);
            if (kind == null) return method;
            woven.add(type + "." + name);
            return new MethodVisitor(Opcodes.ASM9, method) {
                @Override
                public void visitCode() {
                    super.visitCode();
                    visitIntInsn(Opcodes.BIPUSH, kind.ordinal());
                    visitMethodInsn(Opcodes.INVOKESTATIC, LEDGER, "enter", "(I)V", false);
                }

                @Override
                public void visitInsn(int code) {
                    if (code >= Opcodes.IRETURN && code <= Opcodes.RETURN)
                        visitMethodInsn(Opcodes.INVOKESTATIC, LEDGER, "leave", "()V", false);
                    super.visitInsn(code);
                }
            };
        }
    }

    /** Weaves the methods that read bits. */
    private static final class Reads extends ClassVisitor {
        Reads(ClassVisitor next) {
            super(Opcodes.ASM9, next);
        }

        @Override
        public MethodVisitor visitMethod(
                int access, String name, String descriptor, String signature, String[] errors) {
            MethodVisitor method = super.visitMethod(access, name, descriptor, signature, errors);
            String note = READS.get(name);
            if (note == null) return method;
            boolean isBit = note.equals("bit");
            return new MethodVisitor(Opcodes.ASM9, method) {
                @Override
                public void visitCode() {
                    super.visitCode();
                    if (isBit) return;
                    visitVarInsn(Opcodes.ILOAD, 2);
                    visitMethodInsn(Opcodes.INVOKESTATIC, LEDGER, note, "(I)V", false);
                }

                @Override
                public void visitInsn(int code) {
                    if (isBit && code == Opcodes.IRETURN) {
                        super.visitInsn(Opcodes.DUP);
                        visitVarInsn(Opcodes.ILOAD, 1);
                        visitMethodInsn(Opcodes.INVOKESTATIC, LEDGER, note, "(II)V", false);
                    }
                    super.visitInsn(code);
                }
            };
        }
    }
}
