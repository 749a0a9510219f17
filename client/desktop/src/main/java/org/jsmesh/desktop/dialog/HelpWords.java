package org.jsmesh.desktop.dialog;

/** What the help menu says. */
public final class HelpWords {
    /** Keys and mouse. */
    public static final String KEYS = """
            Drag turns the model; with Shift, or the right button, it moves it.
            The wheel zooms; a double click, Home or F shows all of the model.
            Arrows turn, with Shift they move; + and -, Page Up and Page Down zoom.

            Space refines for another round, O loads the original, Esc stops.
            [ and ] show coarser and finer resolutions of what has arrived.
            1 to 5 choose what the colours show, W shows the triangles.
            T tries a lost connection again at once, F5 loads once more.
            F9 hides the side panel, Ctrl+D changes to dark and back, F1 tells this.

            Ctrl+O opens a file, Ctrl+L an address, Ctrl+V what was copied, Ctrl+N a window.
            Ctrl+S saves what is shown, Ctrl+Shift+S the original, Ctrl+E the archive,
            Ctrl+P the picture. Ctrl+W closes the window, Ctrl+Q all of them.""";

    private HelpWords() {}

    /** {@return what this program is} */
    public static String about() {
        String what = """

                A model is streamed as a coarse mesh and its refinements.
                When all has come, it is the original, bit for bit.

                """;
        return "jSM, java Streaming Mesh: " + version() + "\n" + what + "Java " + Runtime.version();
    }

    /** {@return the version that the build wrote into the jar} */
    public static String version() {
        String version = HelpWords.class.getPackage().getImplementationVersion();
        return "jsm-viewer " + (version == null ? "(not packaged)" : version);
    }
}
