package org.jsmesh.results;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.function.Function;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;

/** Loads the project's classes anew, and weaves what measures them into some: what is shipped has none of it. */
final class WeavingLoader extends ClassLoader {
    private static final String PROJECT = "org.jsmesh.";

    private final Map<String, Function<ClassVisitor, ClassVisitor>> weavers;

    /** @param weavers by the name of the class; each gets the visitor that writes the woven class */
    WeavingLoader(Map<String, Function<ClassVisitor, ClassVisitor>> weavers) {
        super(WeavingLoader.class.getClassLoader());
        this.weavers = weavers;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (!name.startsWith(PROJECT)) return super.loadClass(name, resolve);
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            return loaded == null ? define(name) : loaded;
        }
    }

    private Class<?> define(String name) throws ClassNotFoundException {
        try (InputStream in = getParent().getResourceAsStream(name.replace('.', '/') + ".class")) {
            if (in == null) throw new ClassNotFoundException(name);
            byte[] bytes = in.readAllBytes();
            if (weavers.containsKey(name)) bytes = woven(bytes, weavers.get(name));
            return defineClass(name, bytes, 0, bytes.length);
        } catch (IOException e) {
            throw new ClassNotFoundException(name, e);
        }
    }

    private static byte[] woven(byte[] type, Function<ClassVisitor, ClassVisitor> weaver) {
        ClassReader reader = new ClassReader(type);
        ClassWriter writer = new ClassWriter(reader, ClassWriter.COMPUTE_MAXS);
        reader.accept(weaver.apply(writer), 0);
        return writer.toByteArray();
    }
}
