package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A scan in map coordinates, of which float32 would make stairs, through the commands. */
class FarScanTest {
    @TempDir
    private Path folder;

    @Test
    void shouldComeBackBitForBitAndCostWhatItCostsAtTheOrigin() throws Exception {
        Path far = FarScan.write(folder.resolve("far.obj"), 120, 450_000, 5_411_000, 313);
        Path near = FarScan.write(folder.resolve("near.obj"), 120, -10, -10, 3);
        Path farArchive = folder.resolve("far.jsm");
        Path nearArchive = folder.resolve("near.jsm");
        Cli.ok("encode", far, "-o", farArchive);
        Cli.ok("encode", near, "-o", nearArchive);
        assertThat((double) Files.size(farArchive)).isLessThan(1.05 * Files.size(nearArchive));
        Cli.ok("verify", farArchive, far);
        for (String extension : List.of("obj", "ply", "off", "m")) {
            Path decoded = folder.resolve("decoded." + extension);
            Cli.ok("decode", farArchive, "-o", decoded);
            Cli.ok("verify", farArchive, decoded);
        }
        assertThat(Files.readString(folder.resolve("decoded.obj"))).contains("v 450000 5411000 ", " 450020 5411020 ");
        assertThat(Cli.ok("info", farArchive).out())
                .contains("bounds (450000.0 5411000.0 ", "(450020.0 5411020.0 ", "double precision");
        assertThat(Cli.run("verify", farArchive, near).code()).isEqualTo(1);
    }
}
