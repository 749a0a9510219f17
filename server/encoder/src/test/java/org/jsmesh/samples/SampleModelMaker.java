package org.jsmesh.samples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;

/** Makes the sample models. The same bytes come out on every JVM: nothing but StrictMath and integers is used. */
final class SampleModelMaker {
    private SampleModelMaker() {}

    /** File name to content of all files that the samples consist of. */
    static Map<String, byte[]> make() {
        Map<String, byte[]> files = new TreeMap<>();
        files.put("octopus.ply", Octopus.ply());
        files.put("planetary-gear.obj", PlanetaryGear.obj());
        files.put("planetary-gear.mtl", PlanetaryGear.mtl());
        files.put("amphora.obj", Amphora.obj());
        files.put("amphora.mtl", Amphora.mtl());
        files.put("amphora.png", AmphoraPainting.png());
        return files;
    }

    /** Writes all files into the folder {@code arguments[0]}. */
    public static void main(String[] arguments) throws IOException {
        for (Map.Entry<String, byte[]> file : make().entrySet()) {
            Files.write(Path.of(arguments[0], file.getKey()), file.getValue());
        }
    }
}
