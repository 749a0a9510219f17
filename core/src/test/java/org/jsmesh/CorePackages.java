package org.jsmesh;

import static java.util.Map.entry;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** The packages of core and the arrows between them: what each may use, directly or through what it uses. */
final class CorePackages {
    static final String BASE = "org.jsmesh.";

    /** Package to the packages it may use. */
    static final Map<String, Set<String>> ARROWS = Map.ofEntries(
            entry("lock", Set.of()),
            entry("mesh", Set.of()),
            entry("mesh.io.zip", Set.of()),
            entry("mesh.io.threemf", Set.of("mesh", "mesh.io.zip")),
            entry("mesh.io", Set.of("display", "mesh.io.zip", "mesh.io.threemf")),
            entry("patch", Set.of("mesh")),
            entry("collapse", Set.of("patch")),
            entry("codec.entropy", Set.of("mesh")),
            entry("codec.lattice", Set.of("codec.entropy")),
            entry("codec.lod", Set.of("codec.lattice", "patch")),
            entry("codec.connectivity", Set.of("codec.lod")),
            entry("codec.position", Set.of("codec.connectivity")),
            entry("codec.attribute", Set.of("codec.position")),
            entry("codec.exact", Set.of("codec.entropy")),
            entry("codec", Set.of("codec.attribute", "codec.exact")),
            entry("archive", Set.of("mesh")),
            entry("archive.coding", Set.of("archive", "codec")),
            entry("decode", Set.of("archive.coding")),
            entry("encode.measure", Set.of("codec")),
            entry("encode.write", Set.of("encode.measure", "archive.coding")),
            entry("encode", Set.of("collapse", "encode.write", "decode", "display")),
            entry("plan", Set.of("archive")),
            entry("display", Set.of("mesh")),
            entry("studio", Set.of("display")),
            entry("simulation", Set.of("encode", "plan")));

    /** What runs in the browser as well. */
    static final Set<String> DECODER = Set.of(
            "mesh",
            "patch",
            "codec",
            "codec.entropy",
            "codec.lattice",
            "codec.lod",
            "codec.connectivity",
            "codec.position",
            "codec.exact",
            "codec.attribute",
            "archive",
            "archive.coding",
            "decode",
            "plan",
            "display");

    static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(new ImportOption.DoNotIncludeJars())
            .importPackages("org.jsmesh");

    private CorePackages() {}

    /** The package and all it may use, so named that a rule can take it. */
    static String[] reach(String name) {
        Set<String> reached = new TreeSet<>();
        collect(name, reached);
        return reached.stream().map(BASE::concat).toArray(String[]::new);
    }

    static boolean isOfDecoder(JavaClass type) {
        return DECODER.stream().map(BASE::concat).anyMatch(type.getPackageName()::equals);
    }

    /** Must compute the same numbers everywhere. What is drawn may differ in its last bits: no one decodes from it. */
    static boolean isExact(JavaClass type) {
        return isOfDecoder(type) && !type.getPackageName().equals(BASE + "display");
    }

    private static void collect(String name, Set<String> reached) {
        if (reached.add(name)) ARROWS.get(name).forEach(used -> collect(used, reached));
    }
}
