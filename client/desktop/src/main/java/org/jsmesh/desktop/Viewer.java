package org.jsmesh.desktop;

/** The viewer's command. */
public final class Viewer {
    private Viewer() {}

    public static void main(String[] arguments) {
        System.exit(2);
    }
}
