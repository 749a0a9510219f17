package org.jsmesh.sandbox;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.ProgressListener;

/** Reads what a process that encodes says, line by line. */
final class SandboxHearing extends Thread {
    private static final int LONGEST_LINE = 2000;

    private final Process process;
    private final ProgressListener progress;
    private volatile EncodingFailure failure;

    SandboxHearing(Process process, ProgressListener progress) {
        super("jsm-sandbox-hearing");
        this.process = process;
        this.progress = progress;
        setDaemon(true);
    }

    /** What the process said last of its failure, or null. */
    EncodingFailure failure() {
        return failure;
    }

    @Override
    public void run() {
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine())
                if (line.length() <= LONGEST_LINE) hear(line.split("\t"));
        } catch (IOException | NumberFormatException e) {
            // The process has ended, or says nothing useful.
        }
    }

    private void hear(String[] words) {
        if (words.length != 3) return;
        switch (words[0]) {
            case SandboxMain.PROGRESS -> progress.progress(words[1], Double.parseDouble(words[2]));
            case SandboxMain.FAILURE -> failure = EncodingFailure.ofModel(words[1], words[2]);
            case SandboxMain.NO_ROOM -> failure = EncodingFailure.noRoom(new IOException(words[1]));
            default -> {
                // Something else prints, too.
            }
        }
    }
}
