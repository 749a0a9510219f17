package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How the material libraries and images of an OBJ file are found. */
class ObjCompanionsTest {
    private static final String FACE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    private final MemoryFiles files = new MemoryFiles();

    private ModelFile read(String library) throws IOException {
        return files.with("chair.obj", "mtllib " + library + "\n" + FACE).read("chair.obj");
    }

    private static List<String> images(ModelFile file) {
        return file.mesh().textures().stream()
                .map(t -> t.path() + "=" + new String(t.bytes(), java.nio.charset.StandardCharsets.UTF_8))
                .toList();
    }

    private static Note renamed(String text) {
        return Note.repaired("Files found under another name: " + text + ".", 1, text);
    }

    @Test
    void shouldFindALibraryWhateverTheCaseAndSaySo() throws IOException {
        files.with("paint.mtl", "newmtl m\nKd 1 0 0");
        ModelFile file = read("Paint.MTL");
        assertThat(file.mesh().materials().get(0).parameter("Kd")).containsExactly(1, 0, 0);
        assertThat(file.notes()).containsExactly(renamed("Paint.MTL as paint.mtl"));
    }

    @Test
    void shouldTakeTheLibraryOfTheExactNameFirst() throws IOException {
        files.with("paint.mtl", "newmtl m\nKd 1 0 0").with("Paint.mtl", "newmtl m\nKd 0 1 0");
        ModelFile file = read("Paint.mtl");
        assertThat(file.mesh().materials().get(0).parameter("Kd")).containsExactly(0, 1, 0);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldFindAnImageOfAnotherMachineByItsNameBesideTheModel() throws IOException {
        files.with("abs.mtl", "newmtl m\nmap_Kd D:\\Work\\Tex.PNG").with("tex.png", "T");
        ModelFile file = read("abs.mtl");
        assertThat(images(file)).containsExactly("D:\\Work\\Tex.PNG=T");
        assertThat(file.notes()).containsExactly(renamed("D:\\Work\\Tex.PNG as tex.png"));
    }

    @ParameterizedTest
    @CsvSource({
        "tex.png,mats/tex.png=BESIDE",
        "Tex.PNG,mats/Tex.PNG=BESIDE",
        "sub/a.png,mats/sub/a.png=DEEP",
        "mats/tex.png,mats/tex.png=BESIDE",
        "../wood.png,wood.png=WOOD",
        "wood.png,wood.png=WOOD"
    })
    void shouldLookInTheFolderOfTheLibraryBehindThatOfTheModel(String path, String found) throws IOException {
        files.with("mats/a.mtl", "newmtl m\nmap_Kd " + path)
                .with("mats/tex.png", "BESIDE")
                .with("mats/wood.png", "OTHER")
                .with("mats/sub/a.png", "DEEP")
                .with("wood.png", "WOOD");
        assertThat(images(read("mats\\a.mtl"))).containsExactly(found);
    }

    @Test
    void shouldTellImagesOfOneNameInTwoFoldersApart() throws IOException {
        files.with("a/a.mtl", "newmtl m\nmap_Kd tex.png").with("a/tex.png", "A");
        files.with("b/b.mtl", "newmtl n\nmap_Kd tex.png").with("b/tex.png", "B");
        files.with("chair.obj", "mtllib a/a.mtl\nmtllib b/b.mtl\n" + FACE + "usemtl n\nf 1 2 3\n");
        ModelFile file = files.read("chair.obj");
        assertThat(images(file)).containsExactly("a/tex.png=A", "b/tex.png=B");
        MemoryFiles copy = new MemoryFiles();
        assertThat(ModelWriter.write(file.mesh(), ModelFormat.OBJ, "copy.obj", copy))
                .isEmpty();
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), copy.read("copy.obj").mesh()))
                .isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"my tex.png\"",
                "'my tex.png'",
                "my tex.png   # the wood",
                "-clamp on -bm 1 -o 0 0 0 -s 1 1 1 \"my tex.png\"",
                "-imfchan l -mm 0 1 my tex.png"
            })
    void shouldStripQuotesCommentsAndOptions(String statement) throws IOException {
        files.with("a.mtl", "newmtl m\nmap_Kd " + statement).with("my tex.png", "T");
        ModelFile file = read("\"a.mtl\"");
        assertThat(images(file)).containsExactly("my tex.png=T");
        assertThat(file.notes()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"-colorspace", "-foo 1 2.5", "-foo on", "-s 1 1 1 -foo off -clamp on"})
    void shouldSkipOptionsThatItDoesNotKnowAndTellThem(String options) throws IOException {
        files.with("a.mtl", "newmtl m\nmap_Kd " + options + " tex.png").with("tex.png", "T");
        ModelFile file = read("a.mtl");
        assertThat(images(file)).containsExactly("tex.png=T");
        assertThat(file.notes()).hasSize(1);
        assertThat(file.notes().get(0).kind()).isEqualTo(Note.Kind.UNREAD);
        assertThat(file.notes().get(0).text())
                .startsWith("a.mtl: options of textures that are not known, kept and not drawn: -");
        MemoryFiles copy = new MemoryFiles();
        assertThat(ModelWriter.write(file.mesh(), ModelFormat.OBJ, "copy.obj", copy))
                .isEmpty();
        assertThat(MeshComparison.firstDifference(
                        file.mesh(), copy.read("copy.obj").mesh()))
                .isEmpty();
    }

    @Test
    void shouldTakeANameThatLooksLikeAnOption() throws IOException {
        files.with("a.mtl", "newmtl m\nmap_Kd -wood.png\nmap_Ka -x")
                .with("-wood.png", "T")
                .with("-x", "X");
        assertThat(images(read("a.mtl"))).containsExactly("-wood.png=T", "-x=X");
    }

    @Test
    void shouldTakeTheLibraryWithTheNameOfTheModelWhereNoneIsThere() throws IOException {
        files.with("chair.mtl", "newmtl m\nKd 1 0 0");
        ModelFile file = read("untitled.mtl");
        assertThat(file.mesh().materials().get(0).parameter("Kd")).containsExactly(1, 0, 0);
        assertThat(file.notes())
                .containsExactly(new Note(
                                Note.Kind.CHANGED,
                                "Material libraries not found: untitled.mtl. chair.mtl is read in their place.",
                                1,
                                "untitled.mtl")
                        .asWarning());
    }

    @Test
    void shouldFindTheMaterialOfANameWithAComment() throws IOException {
        files.with("a.mtl", "newmtl m\nKd 1 0 0");
        files.with("chair.obj", "mtllib a.mtl # paint\n" + FACE.replace("usemtl m", "usemtl m  # red"));
        ModelFile file = files.read("chair.obj");
        assertThat(file.mesh().materials().get(0).parameter("Kd")).containsExactly(1, 0, 0);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldKeepTheReferenceToAnImageThatIsNotThereAndSayWhatToDo() throws IOException {
        files.with("a.mtl", "newmtl m\nmap_Kd nowhere.png\nbump gone.png");
        ModelFile file = read("a.mtl");
        assertThat(file.mesh().textures()).isEmpty();
        assertThat(file.mesh().materials().get(0).textures())
                .extracting(Material.TextureReference::path)
                .containsExactly("nowhere.png", "gone.png");
        assertThat(file.notes())
                .containsExactly(Note.dropped(
                                "Textures not found: nowhere.png, gone.png."
                                        + " Put the images beside the model under these names, and encode it again.",
                                2,
                                "nowhere.png")
                        .asWarning());
    }

    @Test
    void shouldReadOneFileOnceWhoeverNamesIt() throws IOException {
        files.with("a.mtl", "newmtl m\nmap_Kd tex.png\nmap_d tex.png").with("tex.png", "T");
        assertThat(read("a.mtl").mesh().textures()).extracting(Texture::path).containsExactly("tex.png");
    }
}
