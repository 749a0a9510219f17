package org.jsmesh.desktop;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;
import org.jsmesh.desktop.dialog.HelpWords;
import org.jsmesh.desktop.dialog.SwingDialogs;
import org.jsmesh.desktop.draw.DrawStyle;
import org.jsmesh.desktop.draw.Shading;
import org.jsmesh.desktop.files.UserSettings;
import org.jsmesh.desktop.launch.LinkHandler;
import org.jsmesh.desktop.launch.ModelLink;
import org.jsmesh.desktop.launch.OpenRequests;
import org.jsmesh.desktop.panel.PlainLabel;
import org.jsmesh.session.UserCache;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The command {@code java -jar jsm-viewer.jar}: opens a window, or draws a picture for a script. */
@Command(
        name = "jsm-viewer",
        mixinStandardHelpOptions = true,
        versionProvider = Viewer.Version.class,
        description = "Streams a model and shows it as it refines.",
        footer = {
            "",
            "Examples:",
            "  java -jar jsm-viewer.jar 'http://127.0.0.1:8080/?m=bunny'",
            "  java -jar jsm-viewer.jar chair.obj",
            "  java -jar jsm-viewer.jar bunny.jsm --screenshot bunny.png --original",
            "",
            "Drag turns the model, Shift and drag moves it, the wheel zooms; Home shows",
            "all of it, W its triangles, Space refines, O loads the original, F1 tells all",
            "keys. Without a model the window says how to open one."
        },
        exitCodeOnInvalidInput = 2,
        exitCodeOnExecutionException = 1)
public final class Viewer implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "URL_OR_FILE",
            arity = "0..*",
            description =
                    "Address of an archive, of a manifest, or of the page that shows a model; an archive file; or a model file (ply, obj, stl, off, m, 3mf, gltf, glb), which is encoded first. Each has a window of its own.")
    private List<String> locations = List.of();

    @Option(
            names = "--wait",
            paramLabel = "TIME",
            defaultValue = "2s",
            converter = WaitConverter.class,
            description = "The time that a round takes, for example 500ms or 2s (default: ${DEFAULT-VALUE}).")
    private int waitMillis;

    @Option(
            names = "--screenshot",
            paramLabel = "PNG",
            description = "Draw what is there after one round into this file and exit.")
    private File screenshot;

    @Option(
            names = "--style",
            paramLabel = "STYLE",
            defaultValue = "materials",
            description =
                    "What the colours show: materials, flat, normals, levels or error (default: ${DEFAULT-VALUE}).")
    private Shading shading;

    @Option(names = "--wireframe", description = "Show the triangles.")
    private boolean wireframe;

    @Option(names = "--original", description = "Load everything instead of one round.")
    private boolean original;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            defaultValue = "1024x768",
            converter = SizeConverter.class,
            description = "Size of the picture in pixels (default: ${DEFAULT-VALUE}).")
    private PictureSize size;

    @Option(names = "--transparent", description = "Leave out the background of the screenshot.")
    private boolean transparent;

    @Option(
            names = "--cache",
            paramLabel = "DIR",
            description =
                    "Where archives are kept, so that the next visit asks for missing bytes alone; at most 1 GiB (default: the user's cache folder).")
    private Path cache = UserCache.folder();

    @Option(names = "--no-cache", description = "Keep nothing.")
    private boolean noCache;

    @Option(
            names = "--register",
            description = "Open jsm: links and .jsm files with this viewer from now on, and exit.")
    private boolean register;

    @Option(names = "--unregister", description = "Take that back, and exit.")
    private boolean unregister;

    private Viewer() {}

    public static void main(String[] arguments) {
        int code = new CommandLine(new Viewer())
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setExecutionExceptionHandler((error, command, parsed) -> {
                    command.getErr().println("jsm-viewer: " + SessionView.words(error));
                    return 1;
                })
                .execute(arguments);
        // JOGL and Swing keep threads of their own.
        System.exit(code);
    }

    /** @return the exit code, once the picture is written or the window closed */
    @Override
    public Integer call() throws Exception {
        if (register || unregister) {
            LinkHandler handler = LinkHandler.ofSystem();
            spec.commandLine().getOut().println(register ? handler.register() : handler.unregister());
            return 0;
        }
        if (screenshot != null && locations.size() != 1) {
            throw new ParameterException(
                    spec.commandLine(),
                    "--screenshot needs " + (locations.isEmpty() ? "a model" : "one model alone")
                            + ": name an address or a file");
        }
        if (screenshot != null && shading.isPainted()) {
            throw new ParameterException(
                    spec.commandLine(),
                    "--style " + shading.name().toLowerCase(Locale.ROOT)
                            + " is for windows: a screenshot is materials, flat or normals");
        }
        requireDisplay();
        if (screenshot != null) {
            new ScreenshotRun(locations.get(0), size, !transparent, keeping(), new DrawStyle(shading, wireframe))
                    .run(screenshot, original ? 0 : waitMillis);
            return 0;
        }
        CompletableFuture<Integer> end = new CompletableFuture<>();
        SwingUtilities.invokeAndWait(() -> openWindows(end));
        return end.get();
    }

    private static void requireDisplay() {
        String remedy = "; set DISPLAY, or start under xvfb-run";
        if (GraphicsEnvironment.isHeadless()) throw new ViewerException("there is no display" + remedy);
        try {
            GraphicsEnvironment.getLocalGraphicsEnvironment();
        } catch (AWTError e) {
            throw new ViewerException("the display " + System.getenv("DISPLAY") + " cannot be opened" + remedy, e);
        }
    }

    private void openWindows(CompletableFuture<Integer> end) {
        ViewerOptions options =
                new ViewerOptions(waitMillis, size, keeping(), original, new DrawStyle(shading, wireframe));
        Windows windows = new Windows(options, UserSettings.ofUser(), SwingDialogs::new, () -> end.complete(0));
        try {
            if (locations.isEmpty()) windows.open(null);
            ModelLink.requireAlone(locations);
            locations.forEach(windows::open);
            OpenRequests.listen(argument -> openToo(windows, argument));
        } catch (IllegalArgumentException | ViewerException e) {
            tell(e);
            end.complete(1);
        }
    }

    private static void openToo(Windows windows, String argument) {
        try {
            windows.open(argument);
        } catch (ViewerException e) {
            tell(e);
        }
    }

    private static void tell(RuntimeException e) {
        JOptionPane.showMessageDialog(null, PlainLabel.lines(SessionView.words(e)), "jSM", JOptionPane.ERROR_MESSAGE);
    }

    private Path keeping() {
        return noCache ? null : cache;
    }

    /** The version that the build wrote into the jar. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {HelpWords.version()};
        }
    }
}
