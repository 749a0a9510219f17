package org.jsmesh.desktop.launch;

import java.io.IOException;

/** macOS asks the packages of applications what they open, so there is nothing to be told. */
final class MacHandler extends LinkHandler {
    @Override
    String register(StartCommand command) throws IOException {
        throw new IOException(
                "macOS opens links by what a package says of itself: make one with 'mvn -Ppackage', and move it to "
                        + "Applications");
    }

    @Override
    public String unregister() {
        return "macOS forgets the links when the package is moved to the Trash.";
    }
}
