package org.jsmesh.app;

import picocli.CommandLine.Option;

/** The choice of JSON for a report. A mixin. */
final class JsonReport {
    @Option(names = "--json", description = "Print the report as one JSON value on stdout.")
    private boolean wanted;

    boolean isWanted() {
        return wanted;
    }
}
