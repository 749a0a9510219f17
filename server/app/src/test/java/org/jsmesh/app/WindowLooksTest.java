package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.desktop.draw.Camera;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.Screenshot;
import org.jsmesh.desktop.draw.TextureImages;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.material.ExtensionModels;
import org.jsmesh.test.material.MaterialModel;
import org.jsmesh.test.material.MaterialModels;
import org.jsmesh.test.material.MtlModels;
import org.jsmesh.test.picture.PictureComparison;
import org.jsmesh.test.picture.View;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.ReferencePage;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each property of a material as the desktop window draws it from an archive, beside three's own loader on the original
 * file: over the pixels that either draws, before black and before white, the mean difference is below
 * {@value #TOLERANCE} of white. A twin of the model that lacks the property differs from it by more than that, so that
 * a window without the property would fail. Of the extensions it draws those of {@link #EXTENSIONS}.
 */
@Tag("long")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
class WindowLooksTest {
    private static final double TOLERANCE = .04;
    private static final Set<String> EXTENSIONS = Set.of("clearcoat", "ior", "specular-glossiness");
    private static final int SIDE = 200;

    @TempDir
    static Path profile;

    private Browser browser;
    private ReferencePage reference;

    @BeforeAll
    void start() throws IOException {
        Requirement.display();
        browser = new Browser(profile);
        reference = new ReferencePage(browser);
    }

    @AfterAll
    void stop() {
        if (reference != null) reference.close();
        if (browser != null) browser.close();
    }

    static Stream<MaterialModel> models() {
        List<MaterialModel> extensions = ExtensionModels.all().stream()
                .filter(model -> EXTENSIONS.contains(model.name()))
                .toList();
        return Stream.of(MaterialModels.all(), extensions, MtlModels.all()).flatMap(List::stream);
    }

    @ParameterizedTest
    @MethodSource("models")
    void shouldDrawEachPropertyAsThreeDoes(MaterialModel model) throws IOException {
        Mesh mesh = streamed(model);
        Framing framing = Framing.of(mesh.bounds(), UpAxis.Y);
        Camera camera = Camera.framing(framing, SIDE, SIDE);
        double crease = CreaseAngle.cosine(mesh.faces(), mesh.faces(), mesh.faces());
        Scene scene = Scene.of(mesh, crease, false, framing, new TextureImages());
        BufferedImage drawn = Screenshot.take(scene, camera, SIDE, SIDE, false);
        View view = view(framing, camera);
        BufferedImage expected = reference.draw(model.reference(), view, SIDE, SIDE);
        BufferedImage without = reference.draw(model.without(), view, SIDE, SIDE);
        PagePictures.keep("window-" + model.name(), PagePictures.beside(drawn, expected, without));
        assertThat(PictureComparison.visibleDifference(drawn, expected))
                .as("difference from three's own loader")
                .isLessThan(TOLERANCE);
        assertThat(PictureComparison.visibleDifference(drawn, without))
                .as("difference from a model without the property")
                .isGreaterThan(TOLERANCE);
    }

    private static Mesh streamed(MaterialModel model) throws IOException {
        Map<String, byte[]> files = model.files();
        String glb = model.name() + ".glb";
        String file = files.containsKey(glb) ? glb : model.name() + ".obj";
        byte[] archive = new ModelEncoding(EncoderSettings.defaults())
                .encode(file, files.get(file), path -> Optional.ofNullable(files.get(path)), ProgressListener.NONE)
                .bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        return decoder.mesh();
    }

    /** The camera in the units of the model. */
    private static View view(Framing framing, Camera camera) {
        double[] centre = {framing.x(), framing.y(), framing.z()};
        double[] eye = camera.eye();
        for (int k = 0; k < 3; k++) eye[k] = centre[k] + framing.radius() * eye[k];
        return new View(eye, centre, new double[] {0, 1, 0}, Math.toDegrees(Camera.FIELD_OF_VIEW));
    }
}
