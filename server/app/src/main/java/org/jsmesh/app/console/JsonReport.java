package org.jsmesh.app.console;

import picocli.CommandLine.Option;

/** The choice of JSON for a report. A mixin. */
public final class JsonReport {
    @Option(names = "--json", description = "Print the report as one JSON value on stdout.")
    private boolean wanted;

    public boolean isWanted() {
        return wanted;
    }
}
