package org.jsmesh.library;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.GenericArrayType;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;

/** What the modules export names no type that they keep to themselves: the compiler could not use it. */
class ExportedApiTest {
    private static final List<String> MODULES =
            List.of("core", "client/session", "server/encoder", "server/s3", "server/servlet", "client/desktop");
    private static final Pattern EXPORT = Pattern.compile("(?m)^ *exports ([\\w.]+);");

    private final Set<String> exported = new TreeSet<>();
    private final Set<String> hidden = new TreeSet<>();

    @Test
    void shouldNameExportedTypesAlone() throws Exception {
        List<Class<?>> types = new ArrayList<>();
        for (String module : MODULES) readExports(SampleModels.project().resolve(module));
        for (String module : MODULES) addPublicTypes(SampleModels.project().resolve(module), types);
        for (Class<?> type : types) check(type);

        assertThat(types.size()).isGreaterThan(80);
        assertThat(hidden).as("types of packages that no module exports").isEmpty();
    }

    @Test
    void shouldSeeAHiddenType() {
        exported.add("org.jsmesh.mesh");
        check("here", new ArrayList<org.jsmesh.codec.MeshCoder>() {}.getClass().getGenericSuperclass());
        assertThat(hidden).containsExactly("here: org.jsmesh.codec.MeshCoder");
    }

    private void readExports(Path module) throws IOException {
        Path description = module.resolve("src/main/module/module-info.java");
        if (!Files.exists(description)) return;
        Matcher found = EXPORT.matcher(Files.readString(description));
        while (found.find()) exported.add(found.group(1));
    }

    private void addPublicTypes(Path module, List<Class<?>> types) {
        for (String name : exported) {
            Path folder = module.resolve("target/classes").resolve(name.replace('.', '/'));
            if (!Files.isDirectory(folder)) continue;
            try (Stream<Path> files = Files.list(folder)) {
                files.map(file -> file.getFileName().toString())
                        .filter(file -> file.endsWith(".class") && !file.equals("package-info.class"))
                        .sorted()
                        .map(file -> load(name + "." + file.substring(0, file.length() - ".class".length())))
                        .filter(ExportedApiTest::isVisible)
                        .forEach(types::add);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    private static Class<?> load(String name) {
        try {
            return Class.forName(name, false, ExportedApiTest.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    private static boolean isVisible(Class<?> type) {
        for (Class<?> t = type; t != null; t = t.getEnclosingClass()) if (!isVisible(t.getModifiers())) return false;
        return !type.isAnonymousClass() && !type.isLocalClass();
    }

    private static boolean isVisible(int modifiers) {
        return Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers);
    }

    private void check(Class<?> type) {
        if (type.getGenericSuperclass() != null) check(type.getName(), type.getGenericSuperclass());
        for (Type face : type.getGenericInterfaces()) check(type.getName(), face);
        for (Field field : type.getDeclaredFields())
            if (isVisible(field.getModifiers())) check(type.getName() + "." + field.getName(), field.getGenericType());
        for (Constructor<?> made : type.getDeclaredConstructors()) {
            if (!isVisible(made.getModifiers())) continue;
            for (Type given : made.getGenericParameterTypes()) check(type.getName() + ".new", given);
        }
        for (Method method : type.getDeclaredMethods()) {
            if (!isVisible(method.getModifiers()) || method.isSynthetic()) continue;
            String where = type.getName() + "." + method.getName();
            check(where, method.getGenericReturnType());
            for (Type given : method.getGenericParameterTypes()) check(where, given);
            for (Type thrown : method.getGenericExceptionTypes()) check(where, thrown);
        }
    }

    private void check(String where, Type type) {
        if (type instanceof ParameterizedType generic) {
            check(where, generic.getRawType());
            for (Type argument : generic.getActualTypeArguments()) check(where, argument);
        } else if (type instanceof GenericArrayType array) {
            check(where, array.getGenericComponentType());
        } else if (type instanceof WildcardType wildcard) {
            for (Type bound : wildcard.getUpperBounds()) check(where, bound);
            for (Type bound : wildcard.getLowerBounds()) check(where, bound);
        } else if (type instanceof Class<?> plain) {
            Class<?> element = plain;
            while (element.isArray()) element = element.getComponentType();
            if (element.getName().startsWith("org.jsmesh.") && !exported.contains(element.getPackageName()))
                hidden.add(where + ": " + element.getName());
        }
    }
}
