package org.jsmesh.desktop;

import com.jogamp.opengl.GLException;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.jsmesh.desktop.draw.Camera;
import org.jsmesh.desktop.draw.DrawStyle;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.Screenshot;
import org.jsmesh.desktop.files.ModelAddress;
import org.jsmesh.desktop.files.ModelImport;
import org.jsmesh.desktop.panel.Figures;
import org.jsmesh.files.Explanation;
import org.jsmesh.mesh.ProgressListener;

/** Streams for one round, or to the end, and writes a picture of the result. */
final class ScreenshotRun implements SessionView.Display {
    private final String location;
    private final PictureSize size;
    private final boolean background;
    private final Path cache;
    private final DrawStyle style;
    private volatile Framing framing;
    private volatile Scene scene;
    private volatile ViewState state = ViewState.START;

    /** @param cache folder in which archives are kept, or null */
    ScreenshotRun(String location, PictureSize size, boolean background, Path cache) {
        this(location, size, background, cache, DrawStyle.defaults());
    }

    /** @param style not a painted one, whose colours need what came before */
    ScreenshotRun(String location, PictureSize size, boolean background, Path cache, DrawStyle style) {
        this.cache = cache;
        this.style = style;
        this.location = location;
        this.size = size;
        this.background = background;
    }

    /**
     * @param waitMillis of the round, 0 for the original
     * @throws ViewerException when nothing came, the archive is damaged, or nothing can be drawn; it writes no file
     *     then
     */
    void run(File png, int waitMillis) throws IOException {
        ModelAddress address = ModelAddress.of(location);
        Saving.requireOther(png.toPath(), address);
        stream(address, waitMillis);
        boolean failed = state.phase() == ViewState.Phase.ERROR || state.phase() == ViewState.Phase.DIFFERENT;
        if (failed || scene == null) {
            throw new ViewerException(state.message() == null ? location + ": nothing has arrived" : state.message());
        }
        if (state.message() != null) System.err.println("jsm-viewer: " + state.message());
        write(draw(), png);
        System.out.println(
                png + ": " + Figures.line(state.progress(), state.levels()).replace("  ·  ", ", ") + outcome());
    }

    /** A model file is encoded first, and has all arrived then. */
    private void stream(ModelAddress address, int waitMillis) throws IOException {
        if (address.kind() != ModelAddress.Kind.MODEL) {
            stream(address.location(), address.location(), waitMillis);
            return;
        }
        try (ModelImport model = ModelImport.of(Path.of(address.location()), ProgressListener.NONE)) {
            stream(model.archive().toString(), address.location(), 0);
        } catch (IOException | IllegalArgumentException e) {
            throw new ViewerException(Explanation.of(address.location(), e).toString(), e);
        }
    }

    private void stream(String from, String name, int waitMillis) {
        try (ViewerSession session = new ViewerSession(from, name, List.of(), cache, this)) {
            (waitMillis == 0 ? session.complete() : session.refine(waitMillis)).join();
        }
    }

    private String outcome() {
        return switch (state.phase()) {
            case IDENTICAL -> ", identical to the original";
            case INCOMPLETE -> ", not the whole original";
            default -> "";
        };
    }

    private BufferedImage draw() {
        Camera camera = Camera.framing(framing, size.width(), size.height());
        try {
            return Screenshot.take(scene, camera, size.width(), size.height(), background, style);
        } catch (GLException | UnsatisfiedLinkError e) {
            throw new ViewerException(noOpenGl(e), e);
        }
    }

    static String noOpenGl(Throwable e) {
        return "OpenGL 3.3 is not available on this display: "
                + SessionView.words(e).lines().findFirst().orElse("")
                + "; install a graphics driver (Mesa draws without a graphics card)";
    }

    /** @throws ViewerException when the file cannot be written, or is no regular file */
    static void write(BufferedImage picture, File png) throws IOException {
        File folder = png.getAbsoluteFile().getParentFile();
        if (!folder.isDirectory())
            throw new ViewerException(png + ": there is no folder " + folder + "; make it first");
        if (png.exists() && !png.isFile())
            throw new ViewerException(png + ": is there and is no regular file; choose another place");
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        if (!ImageIO.write(picture, "png", bytes)) throw new ViewerException(png + ": this Java cannot write PNG");
        try {
            Files.write(png.toPath(), bytes.toByteArray());
        } catch (IOException e) {
            String why = e instanceof FileSystemException f && f.getReason() != null ? " (" + f.getReason() + ")" : "";
            throw new ViewerException(
                    png + ": cannot be written" + why
                            + "; check the permissions and the space, or choose another place",
                    e);
        }
    }

    @Override
    public void frame(Framing next) {
        framing = next;
    }

    @Override
    public void show(Scene next) {
        scene = next;
    }

    @Override
    public void show(ViewState next) {
        state = next;
    }
}
