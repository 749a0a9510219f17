package org.jsmesh.sandbox;

import com.sun.management.OperatingSystemMXBean;
import java.io.File;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.lang.management.ManagementFactory;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.memory.HeapShortageException;
import org.jsmesh.memory.MemoryAdmission;
import org.jsmesh.memory.MemoryAdmission.Admission;
import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.mesh.ProgressListener;

/**
 * Encodes each model in a process of its own with limited heap and time, so that a hostile file harms nothing else. The
 * process gets nothing of the server's environment, works in the folder of the archive, yields to the server where the
 * system knows niceness, and ends with the server. As many run at a time as the machine has memory for, by their
 * estimates. Thread-safe.
 */
public final class SandboxEncoder implements ModelEncoder {
    private static final Logger LOG = System.getLogger(SandboxEncoder.class.getName());

    /** Exit values of a JVM that SIGHUP, SIGINT or SIGTERM ended. They say nothing about the model. */
    private static final Set<Integer> TOLD_TO_END = Set.of(129, 130, 143);

    private static final int MOST_TRIES = 3;
    private static final long PAUSE_MILLIS = 1000;
    private static final long LOOK_MILLIS = 50;
    private static final String NICE = "nice";

    private static final double FOR_ENCODERS = .6; // of the machine's memory

    /** All processes that encode, whoever started them. */
    private static final MemoryAdmission MACHINE = new MemoryAdmission((long) (FOR_ENCODERS * memory()));

    private final SandboxLimits limits;
    private final Path program;
    private final String classPath;

    private SandboxEncoder(SandboxLimits limits, Path program, String classPath) {
        this.limits = limits;
        this.program = program;
        this.classPath = classPath;
    }

    /**
     * Makes an encoder with the default settings of encoding.
     *
     * @param limits for each model
     * @return the encoder
     * @throws IOException when no process can be started, for instance from a packed application
     */
    public static SandboxEncoder of(SandboxLimits limits) throws IOException {
        Path bin = Path.of(System.getProperty("java.home"), "bin");
        Path program = Files.isExecutable(bin.resolve("java.exe")) ? bin.resolve("java.exe") : bin.resolve("java");
        if (!Files.isExecutable(program)) {
            throw new FileSystemException(program.toString(), null, "is no program; models need one to be encoded by");
        }
        return new SandboxEncoder(limits, program, classPath());
    }

    /**
     * The same, or else an encoder in this process where none can be started. The log tells of that.
     *
     * @param limits for each model, where there are processes
     * @return the encoder
     */
    public static ModelEncoder orInProcess(SandboxLimits limits) {
        try {
            return of(limits);
        } catch (IOException e) {
            LOG.log(Level.WARNING, "Models are encoded in the server''s own process: {0}", e.getMessage());
            return new ModelFilesEncoder(EncoderSettings.defaults().withThreads(limits.threads()));
        }
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
                if (!part.isEmpty()) parts.add(Path.of(part).toAbsolutePath().toString());
        }
        if (parts.isEmpty()) {
            throw new IOException("models are encoded by a process, which needs the application's files: "
                    + "let the container unpack the application");
        }
        return String.join(File.pathSeparator, parts);
    }

    @Override
    public String settings() {
        return ModelFilesEncoder.settings(EncoderSettings.defaults());
    }

    /**
     * A service manager that stops the server, or Ctrl+C, also tells this process to end, while the server still lets
     * transfers end. The model is not to blame then: it is begun again, and if the server stops meanwhile, it waits for
     * the next start.
     */
    @Override
    @SuppressWarnings("try") // the room is held, not used
    public ModelInputs encode(Path model, Path archive, ProgressListener progress)
            throws IOException, InterruptedException {
        try (Admission room = admit(model, progress)) {
            for (int tries = 1; ; tries++) {
                ModelInputs inputs = attempt(model, archive, progress, tries == MOST_TRIES);
                if (inputs != null) return inputs;
                Thread.sleep(PAUSE_MILLIS);
            }
        }
    }

    /** Waits until the machine has the memory, unless the model would never fit. */
    private Admission admit(Path model, ProgressListener progress) throws IOException, InterruptedException {
        long heap = (long) limits.heapMegabytes() << 20;
        MemoryEstimate need = MemoryEstimate.of(model, EncoderSettings.defaults());
        if (need.leastBytes() > heap) {
            Explanation words = Explanation.of(
                    "the model", new HeapShortageException(need.bytes(), heap), Explanation.Audience.SENDER);
            throw EncodingFailure.ofModel(words.sentence(), words.remedy());
        }
        Admission room = MACHINE.admit(Math.min(need.bytes(), heap), progress::isCancelled);
        if (room == null) throw new CancellationException("the encoding was cancelled");
        return room;
    }

    private static long memory() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getTotalMemorySize();
    }

    /** Returns null when the process was told to end, unless this is the last try. */
    private ModelInputs attempt(Path model, Path archive, ProgressListener progress, boolean last)
            throws IOException, InterruptedException {
        Path report = archive.resolveSibling(archive.getFileName() + ".inputs");
        Process process = start(model, archive, report);
        try {
            SandboxHearing hearing = new SandboxHearing(process, progress);
            hearing.start();
            await(process, progress);
            if (!last && TOLD_TO_END.contains(process.exitValue())) return null;
            hearing.join(10_000);
            if (hearing.failure() != null) throw hearing.failure();
            if (process.exitValue() != 0 || !Files.isRegularFile(archive) || !Files.isRegularFile(report)) {
                throw EncodingFailure.ofModel(
                        "the encoder broke down over this file", "check the file, or send it to us");
            }
            return ModelInputs.fromJson(Files.readString(report));
        } finally {
            process.destroyForcibly();
            process.waitFor(10, TimeUnit.SECONDS);
            Files.deleteIfExists(report);
        }
    }

    private void await(Process process, ProgressListener progress) throws IOException, InterruptedException {
        long begun = System.nanoTime();
        while (!process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
            if (progress.isCancelled()) throw new CancellationException("the encoding was cancelled");
            if ((System.nanoTime() - begun) / 1_000_000 >= limits.encodeMillis()) {
                throw EncodingFailure.ofModel(
                        "encoding took longer than the " + limits.encodeMillis() / 1000 + " s allowed",
                        "give a smaller model");
            }
        }
    }

    private static boolean hasNice() {
        String path = System.getenv("PATH");
        if (path == null || File.separatorChar != '/') return false;
        for (String folder : path.split(Pattern.quote(File.pathSeparator)))
            if (Files.isExecutable(Path.of(folder, NICE))) return true;
        return false;
    }

    private Process start(Path model, Path archive, Path report) throws IOException {
        List<String> command = new ArrayList<>();
        if (hasNice()) command.addAll(List.of(NICE, "-n", "5"));
        command.add(program.toString());
        command.add("-Xmx" + limits.heapMegabytes() + "m");
        command.addAll(List.of("-XX:+UseSerialGC", "-XX:-UsePerfData", "-Djava.awt.headless=true", "-cp", classPath));
        command.add(SandboxMain.class.getName());
        command.add(model.toAbsolutePath().toString());
        command.add(archive.toAbsolutePath().toString());
        command.add(report.toAbsolutePath().toString());
        command.add(Integer.toString(limits.mostFaces()));
        command.add(Long.toString(limits.mostBytes()));
        command.add(Integer.toString(limits.threads()));
        ProcessBuilder builder = new ProcessBuilder(command);
        String windows = builder.environment().get("SystemRoot");
        String locale = builder.environment().get("LC_ALL");
        String language = builder.environment().get("LANG");
        builder.environment().clear();
        if (windows != null) builder.environment().put("SystemRoot", windows);
        // Java tells by these how the names of files are written.
        if (locale != null) builder.environment().put("LC_ALL", locale);
        if (language != null) builder.environment().put("LANG", language);
        Path folder = archive.toAbsolutePath().getParent();
        if (folder != null) builder.directory(folder.toFile());
        builder.redirectError(ProcessBuilder.Redirect.DISCARD);
        return builder.start();
    }
}
