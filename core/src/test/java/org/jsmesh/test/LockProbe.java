package org.jsmesh.test;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Another process that asks for the lock of a file: within one, locks tell nothing of what others see. */
public final class LockProbe {
    private static final int HELD = 3;

    private LockProbe() {}

    /** Whether a new process gets the lock of a file that is there. */
    public static boolean isFree(Path file) throws IOException, InterruptedException {
        try {
            Path classes = Path.of(LockProbe.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
            int code = new ProcessBuilder(
                            Path.of(System.getProperty("java.home"), "bin", "java")
                                    .toString(),
                            "-Xmx16m",
                            "-cp",
                            classes.toString(),
                            LockProbe.class.getName(),
                            file.toString())
                    .inheritIO()
                    .start()
                    .waitFor();
            if (code != 0 && code != HELD) throw new IOException("the process ended with " + code);
            return code == 0;
        } catch (URISyntaxException e) {
            throw new IOException(e);
        }
    }

    public static void main(String[] arguments) throws IOException {
        try (FileChannel channel = FileChannel.open(Path.of(arguments[0]), StandardOpenOption.WRITE)) {
            if (channel.tryLock() == null) System.exit(HELD);
        }
    }
}
