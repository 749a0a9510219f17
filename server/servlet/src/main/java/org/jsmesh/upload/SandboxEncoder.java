package org.jsmesh.upload;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.jsmesh.mesh.ProgressListener;

/**
 * Encodes in a process of its own with limited heap and time, so that a hostile file harms nothing else. The process
 * gets nothing of the server's environment, works in the folder of the upload, and ends with the server.
 */
final class SandboxEncoder implements UploadEncoder {
    private static final int LONGEST_LINE = 2000;

    /** Exit values of a JVM that SIGHUP, SIGINT or SIGTERM ended. They say nothing about the model. */
    private static final Set<Integer> TOLD_TO_END = Set.of(129, 130, 143);

    private static final int MOST_TRIES = 3;
    private static final long PAUSE_MILLIS = 1000;

    private final UploadSettings settings;
    private final Path program;
    private final String classPath;

    /** @throws IOException when there is no program to start */
    SandboxEncoder(UploadSettings settings) throws IOException {
        this.settings = settings;
        Path bin = Path.of(System.getProperty("java.home"), "bin");
        program = Files.isExecutable(bin.resolve("java.exe")) ? bin.resolve("java.exe") : bin.resolve("java");
        if (!Files.isExecutable(program)) {
            throw new FileSystemException(
                    program.toString(), null, "is no program; models that are sent need one to be encoded by");
        }
        classPath = classPath();
    }

    /** Web applications have class loaders of files; everything else has a class path. */
    private static String classPath() throws IOException {
        List<String> parts = new ArrayList<>();
        if (SandboxEncoder.class.getClassLoader() instanceof URLClassLoader loader) {
            for (URL url : loader.getURLs()) {
                try {
                    if (url.getProtocol().equals("file"))
                        parts.add(Path.of(url.toURI()).toString());
                } catch (URISyntaxException e) {
                    throw new IOException(e);
                }
            }
        } else {
            for (String part : System.getProperty("java.class.path").split(Pattern.quote(File.pathSeparator)))
                parts.add(Path.of(part).toAbsolutePath().toString());
        }
        if (parts.isEmpty()) {
            throw new IOException("models that are sent are encoded by a process, which needs the application's files: "
                    + "let the container unpack the WAR");
        }
        return String.join(File.pathSeparator, parts);
    }

    /**
     * A service manager that stops the server, or Ctrl+C, also tells this process to end, while the server still lets
     * transfers end. The model is not to blame then: it is begun again, and if the server stops meanwhile, it waits for
     * the next start.
     */
    @Override
    public void encode(Path model, Path archive, ProgressListener progress)
            throws UploadFailure, IOException, InterruptedException {
        for (int tries = 1; !isEncoded(model, archive, progress, tries == MOST_TRIES); tries++)
            Thread.sleep(PAUSE_MILLIS);
    }

    /** Returns false when the process was told to end, unless this is the last try. */
    private boolean isEncoded(Path model, Path archive, ProgressListener progress, boolean last)
            throws UploadFailure, IOException, InterruptedException {
        Process process = start(model, archive);
        try {
            Hearing hearing = new Hearing(process, progress);
            hearing.start();
            boolean ended = process.waitFor(settings.encodeMillis(), TimeUnit.MILLISECONDS);
            if (!ended) {
                throw new UploadFailure(
                        "encoding took longer than the " + settings.encodeMillis() / 1000 + " s allowed",
                        "send a smaller model");
            }
            if (!last && TOLD_TO_END.contains(process.exitValue())) return false;
            hearing.join(10_000);
            if (hearing.failure != null) throw hearing.failure;
            if (process.exitValue() != 0 || !Files.isRegularFile(archive)) {
                throw new UploadFailure("the encoder broke down over this file", "check the file, or send it to us");
            }
            return true;
        } finally {
            process.destroyForcibly();
            process.waitFor(10, TimeUnit.SECONDS);
        }
    }

    private Process start(Path model, Path archive) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(program.toString());
        command.add("-Xmx" + settings.heapMegabytes() + "m");
        command.addAll(List.of("-XX:+UseSerialGC", "-XX:-UsePerfData", "-Djava.awt.headless=true", "-cp", classPath));
        command.add(SandboxMain.class.getName());
        command.add(model.toAbsolutePath().toString());
        command.add(archive.toAbsolutePath().toString());
        command.add(Integer.toString(settings.mostFaces()));
        command.add(Long.toString(settings.mostBytes()));
        ProcessBuilder builder = new ProcessBuilder(command);
        String windows = builder.environment().get("SystemRoot");
        builder.environment().clear();
        if (windows != null) builder.environment().put("SystemRoot", windows);
        Path folder = archive.toAbsolutePath().getParent();
        if (folder != null) builder.directory(folder.toFile());
        builder.redirectError(ProcessBuilder.Redirect.DISCARD);
        return builder.start();
    }

    /** Reads what the process says, line by line. */
    private static final class Hearing extends Thread {
        private final Process process;
        private final ProgressListener progress;
        private volatile UploadFailure failure;

        Hearing(Process process, ProgressListener progress) {
            super("jsm-upload-hearing");
            this.process = process;
            this.progress = progress;
            setDaemon(true);
        }

        @Override
        public void run() {
            try (BufferedReader lines =
                    new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
                for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                    String[] words = line.length() > LONGEST_LINE ? new String[0] : line.split("\t");
                    if (words.length == 3 && words[0].equals(SandboxMain.PROGRESS))
                        progress.progress(words[1], Double.parseDouble(words[2]));
                    if (words.length == 3 && words[0].equals(SandboxMain.FAILURE))
                        failure = new UploadFailure(words[1], words[2]);
                }
            } catch (IOException | NumberFormatException e) {
                // The process has ended, or says nothing useful.
            }
        }
    }
}
