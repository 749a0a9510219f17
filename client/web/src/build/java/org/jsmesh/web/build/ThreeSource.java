package org.jsmesh.web.build;

import java.io.IOException;
import java.net.URI;
import java.net.URL;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The sources of three.js, as its WebJar has them. Whoever imports a thing of three imports the very source that has
 * it: by the one that exports all, everything that some part of the page needs would come with every part.
 */
final class ThreeSource {
    private static final String WEBJAR = "META-INF/resources/webjars/three/";
    private static final Pattern NEEDED = Pattern.compile(
            "LICENSE|package\\.json|src/(?!nodes/|renderers/(common|webgpu)/|Three\\.(TSL|WebGPU)).*\\.js|"
                    + "examples/jsm/(controls/OrbitControls|environments/RoomEnvironment|loaders/GLTFLoader|utils/BufferGeometryUtils)\\.js");
    private static final Pattern NAMED = Pattern.compile("import \\{([^}]*)\\} from 'three';");
    private static final Pattern WHOLE = Pattern.compile("import \\* as THREE from 'three';");
    private static final Pattern MEMBER = Pattern.compile("\\bTHREE\\.(\\w+)");

    private final Path folder;
    private final ThreeExports exports;

    private ThreeSource(Path folder) throws IOException {
        this.folder = folder;
        exports = new ThreeExports(folder.resolve("src/Three.js"));
    }

    /** @param folder for three, which is not there yet */
    static ThreeSource unpack(Path folder) throws IOException {
        String version = System.getProperty("three.version");
        URL place = ThreeSource.class.getClassLoader().getResource(WEBJAR + version + "/package.json");
        if (place == null) throw new IOException("the WebJar of three.js is not on the class path of the build");
        URI jar = URI.create(place.toString().replaceFirst("^jar:", "").replaceFirst("!/.*$", ""));
        try (FileSystem zip = FileSystems.newFileSystem(Path.of(jar), Map.of())) {
            Folders.copy(
                    zip.getPath(WEBJAR + version),
                    folder,
                    name -> NEEDED.matcher(name).matches());
        }
        for (Path source : Folders.files(folder.resolve("src"))) {
            String text = Files.readString(source);
            String shortened = Glsl.shortened(text);
            if (!shortened.equals(text)) Files.writeString(source, shortened);
        }
        return new ThreeSource(folder);
    }

    /** Changes the imports of the add-ons of three, and of the scripts in a folder. */
    void importDirectly(Iterable<Path> scripts) throws IOException {
        for (Path script : scripts) change(script);
        for (Path addon : Folders.files(folder.resolve("examples/jsm"))) change(addon);
    }

    private void change(Path script) throws IOException {
        String text = Files.readString(script);
        String changed =
                NAMED.matcher(text).replaceAll(m -> Matcher.quoteReplacement(statements("import", script, m.group(1))));
        if (WHOLE.matcher(text).find()) {
            String beside = script.getFileName().toString().replaceFirst("\\.js$", ".three.js");
            Set<String> members = new TreeSet<>();
            for (Matcher member = MEMBER.matcher(text); member.find(); ) members.add(member.group(1));
            Files.writeString(script.resolveSibling(beside), statements("export", script, String.join(",", members)));
            changed = WHOLE.matcher(changed).replaceAll("import * as THREE from './" + beside + "';");
        }
        if (!changed.equals(text)) Files.writeString(script, changed);
    }

    private String statements(String verb, Path script, String names) {
        StringBuilder statements = new StringBuilder();
        for (String item : names.split(",")) {
            String[] parts = item.strip().split("\\s+as\\s+");
            ThreeExports.Export found = exports.find(parts[0]);
            if (found == null) continue;
            statements.append("%s { %s as %s } from './%s';%n"
                    .formatted(
                            verb,
                            found.name(),
                            parts[parts.length - 1],
                            Folders.relative(script.getParent(), found.source())));
        }
        return statements.toString().replace("\r", "");
    }
}
