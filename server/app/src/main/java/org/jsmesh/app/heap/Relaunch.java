package org.jsmesh.app.heap;

import com.sun.management.OperatingSystemMXBean;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/**
 * Starts the program again with another heap. A running Java process cannot change its own, and the file of the program
 * cannot say how much it takes. The second process has the streams of the first, its options but those of the heap, and
 * ends with it; its exit code is that of the first.
 */
public final class Relaunch {
    /** System property: {@code no} to keep the program in its first process. */
    private static final String PROPERTY = "jsm.relaunch";

    private static final String SECOND = "second";
    private static final int KILLED = 137; // 128 and the number of the signal
    private static final long END_SECONDS = 5;

    /** In place of a size in a variable, which may be beyond the heap. */
    private static final String SMALL_AT_FIRST = "-Xms8m";

    /** Options that two processes cannot have at a time: ports, such as that of a debugger, and files. */
    private static final List<String> OF_ONE_PROCESS = List.of(
            "-agentlib:",
            "-agentpath:",
            "-javaagent:",
            "-Xrun",
            "-Dcom.sun.management.jmxremote.port",
            "-Dcom.sun.management.jmxremote.rmi.port",
            "-XX:StartFlightRecording",
            "-XX:FlightRecorderOptions",
            "-XX:+FlightRecorder",
            "-Xloggc:");

    /** The variable whose options overrule those of the command line, and so those of the second process. */
    private static final String OVERRULING = "_JAVA_OPTIONS";

    private final String mainClass;
    private final List<String> arguments;
    private final List<String> options;
    private final String obstacle; // or null

    private Relaunch(String obstacle, String mainClass, List<String> arguments, List<String> options) {
        this.obstacle = obstacle;
        this.mainClass = mainClass;
        this.arguments = arguments;
        this.options = options;
    }

    /**
     * Makes this process one that can be started again, unless there is an {@link #obstacle}. In the second process it
     * sees to it that this one ends with the first.
     *
     * @param main whose main method was called
     * @param arguments that it was called with
     * @return how to start it again, or null in the second process
     */
    public static Relaunch of(Class<?> main, String... arguments) {
        String property = System.getProperty(PROPERTY, "");
        if (property.equals(SECOND)) {
            ProcessHandle.current().parent().ifPresent(Relaunch::endWith);
            return null;
        }
        List<String> options = ManagementFactory.getRuntimeMXBean().getInputArguments();
        String obstacle = property.isEmpty()
                ? obstacle(options, System.getenv(OVERRULING))
                : "it is switched off by -D" + PROPERTY + "=" + property;
        return new Relaunch(obstacle, main.getName(), List.of(arguments), options);
    }

    /**
     * {@return a process that cannot be started again}
     *
     * @param obstacle why, as a sentence without its end
     */
    public static Relaunch impossible(String obstacle) {
        return new Relaunch(obstacle, "", List.of(), List.of());
    }

    /** {@return why the program cannot be started again, or null when it can be} */
    public String obstacle() {
        return obstacle;
    }

    static String obstacle(List<String> options, String overruling) {
        for (String option : options)
            if (isOfOneProcess(option)) return "two processes cannot have " + option + " at a time";
        List<String> rules = overruling == null ? List.of() : words(overruling);
        if (HeapPlan.isHeapSet(rules) || HeapPlan.isFirstSizeSet(rules))
            return "the heap in " + OVERRULING + " overrules it and must be changed there";
        if (System.getProperty("java.class.path", "").isEmpty()) return "the program has no class path";
        return Files.isExecutable(java()) ? null : "there is no program " + java();
    }

    private static boolean isOfOneProcess(String option) {
        if (OF_ONE_PROCESS.stream().anyMatch(option::startsWith)) return true;
        if (!option.startsWith("-Xlog:")) return false;
        String[] parts = option.split(":", 4); // -Xlog:what:where:how
        return parts.length > 2 && !List.of("", "stdout", "stderr").contains(parts[2]);
    }

    private static void endWith(ProcessHandle first) {
        first.onExit().thenRun(() -> Runtime.getRuntime().exit(KILLED));
    }

    private static Path java() {
        return Path.of(System.getProperty("java.home"), "bin", File.separatorChar == '\\' ? "java.exe" : "java");
    }

    /** {@return the heap of this process, and of the machine} */
    public HeapPlan plan() {
        OperatingSystemMXBean machine = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        return new HeapPlan(
                Runtime.getRuntime().maxMemory(), machine.getTotalMemorySize(), HeapPlan.isHeapSet(options));
    }

    /**
     * Runs the program again, to its end.
     *
     * @param heap that it may take
     * @return its exit code
     * @throws IOException when it cannot be started
     * @throws InterruptedException when this thread is interrupted, which ends the other process
     */
    public int run(HeapSize heap) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command(heap, options, System.getenv()))
                .inheritIO()
                .start();
        Thread hook = new Thread(() -> end(process));
        Runtime.getRuntime().addShutdownHook(hook);
        try {
            return process.waitFor();
        } catch (InterruptedException e) {
            end(process);
            throw e;
        } finally {
            try {
                Runtime.getRuntime().removeShutdownHook(hook);
            } catch (IllegalStateException e) {
                // This process is ending; the hook is at work.
            }
        }
    }

    /** Whether a process with that exit code was ended by the system, as it is when memory is short. */
    public static boolean isKilled(int code) {
        return code == KILLED;
    }

    private static List<String> words(String variable) {
        return List.of(variable.strip().split("\\s+"));
    }

    List<String> command(HeapSize heap, List<String> given, Map<String, String> variables) {
        List<String> command = new ArrayList<>(List.of(java().toString()));
        List<String> inherited = new ArrayList<>();
        for (String variable : List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", OVERRULING)) {
            String value = variables.get(variable);
            if (value != null) inherited.addAll(words(value));
        }
        Predicate<String> isKept = option -> !inherited.contains(option) // the second process finds them, too
                && !HeapPlan.isHeapSet(List.of(option))
                && !HeapPlan.isFirstSizeSet(List.of(option));
        given.stream().filter(isKept).forEach(command::add);
        command.add(heap.option());
        if (HeapPlan.isFirstSizeSet(inherited)) command.add(SMALL_AT_FIRST);
        // It does with a fifth less than G1, and nobody waits for its pauses.
        if (given.stream().noneMatch(option -> option.matches("-XX:\\+Use\\w+GC"))) command.add("-XX:+UseParallelGC");
        command.add("-D" + PROPERTY + "=" + SECOND);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), mainClass));
        command.addAll(arguments);
        return command;
    }

    /** Ctrl+C reaches both processes, other signals this one alone. */
    private static void end(Process process) {
        process.destroy();
        try {
            if (!process.waitFor(END_SECONDS, TimeUnit.SECONDS)) process.destroyForcibly();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
