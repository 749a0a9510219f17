package org.jsmesh.load;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * What Linux says of a process.
 *
 * @param residentBytes memory that it holds, RSS
 * @param threads of it
 * @param openFiles of it, sockets included
 * @param cpuSeconds that it has used so far
 */
record ProcessFigures(long residentBytes, int threads, int openFiles, double cpuSeconds) {
    /** Ticks of the kernel's accounting in a second; 100 on every Linux. */
    private static final double TICKS = 100;

    static boolean isPossible() {
        return Files.isReadable(Path.of("/proc/self/status"));
    }

    static ProcessFigures of(long pid) throws IOException {
        Path folder = Path.of("/proc", "" + pid);
        long resident = 0;
        int threads = 0;
        for (String line : Files.readAllLines(folder.resolve("status"))) {
            String[] words = line.split("\\s+");
            if (words[0].equals("VmRSS:")) resident = Long.parseLong(words[1]) * 1024;
            if (words[0].equals("Threads:")) threads = Integer.parseInt(words[1]);
        }
        String stat = Files.readString(folder.resolve("stat"));
        // The name before may hold blanks; it ends with the last parenthesis.
        String[] words = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
        double cpu = (Long.parseLong(words[11]) + Long.parseLong(words[12])) / TICKS;
        try (Stream<Path> files = Files.list(folder.resolve("fd"))) {
            return new ProcessFigures(resident, threads, (int) files.count(), cpu);
        }
    }
}
