package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.test.material.MaterialModel;
import org.jsmesh.test.material.MaterialModels;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class ModelFilesTest {
    private static final String OBJ =
            "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n";

    @TempDir
    private Path temp;

    private Path folder;

    @BeforeEach
    void makeFolder() throws IOException {
        folder = Files.createDirectory(temp.resolve("models"));
        Files.writeString(temp.resolve("secret.png"), "SECRET");
        Files.writeString(folder.resolve("x.obj"), OBJ);
    }

    private ModelFile readWithTexture(String path) throws IOException {
        Files.writeString(folder.resolve("m.mtl"), "newmtl a\nKd 1 0 0\nmap_Kd " + path + "\n");
        return ModelFiles.read(folder.resolve("x.obj"));
    }

    @Test
    void shouldFindLibrariesAndTexturesBesideTheFile() throws IOException {
        Files.createDirectory(folder.resolve("tex"));
        Files.writeString(folder.resolve("tex/wood grain.png"), "WOOD");
        ModelFile file = readWithTexture("tex/wood grain.png");
        assertThat(file.notes()).isEmpty();
        assertThat(file.mesh().textures().get(0).bytes()).asString().isEqualTo("WOOD");
    }

    @ParameterizedTest
    @ValueSource(strings = {"C:\\Users\\me\\wood.png", "/home/me/wood.png", "..\\wood.png", "gone/wood.png"})
    void shouldFindTexturesByTheLastPartOfAPathOfAnotherMachine(String path) throws IOException {
        Files.writeString(folder.resolve("wood.png"), "WOOD");
        ModelFile file = readWithTexture(path);
        assertThat(file.mesh().textures().get(0).bytes()).asString().isEqualTo("WOOD");
        assertThat(file.mesh().textures().get(0).path()).isEqualTo(path);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../secret.png",
                "..\\secret.png",
                "tex/../../secret.png",
                "link.png",
                "linked/secret.png",
                "a\u0000b.png",
                ".",
                "/"
            })
    void shouldNeverReadOutsideTheFolder(String path) throws IOException {
        Files.createSymbolicLink(folder.resolve("link.png"), temp.resolve("secret.png"));
        Files.createSymbolicLink(folder.resolve("linked"), temp);
        ModelFile file = readWithTexture(path);
        assertThat(file.mesh().textures()).isEmpty();
        assertThat(file.notes()).hasSize(1);
        assertThat(file.notes().get(0).text()).startsWith("Textures not found: ");
    }

    @Test
    void shouldNotReadAnAbsolutePath() throws IOException {
        assertThat(readWithTexture(temp.resolve("secret.png").toString()).mesh().textures())
                .isEmpty();
    }

    @ParameterizedTest
    @EnumSource(names = {"OBJ", "GLB"})
    void shouldBringBackMaterialsAndTextures(ModelFormat format) throws IOException {
        Files.writeString(folder.resolve("wood.png"), "WOOD");
        Mesh mesh = readWithTexture("wood.png").mesh();
        Path out = temp.resolve("out/y." + format.extension());
        Files.createDirectory(out.getParent());
        ModelFiles.write(mesh, out, format);
        ModelFile again = ModelFiles.read(out);
        assertThat(again.format()).isEqualTo(format);
        assertThat(MeshComparison.firstDifference(mesh, again.mesh())).isEmpty();
        assertThat(again.mesh().textures().get(0).path()).isEqualTo("wood.png");
        assertThat(again.mesh().textures().get(0).bytes()).asString().isEqualTo("WOOD");
    }

    @Test
    void shouldGetMaterialsOfGltfBackFromAnObjFile() throws IOException {
        MaterialModel model = MaterialModels.all().stream()
                .filter(m -> m.name().equals("base-colour-both"))
                .findFirst()
                .orElseThrow();
        model.write(folder);
        Mesh mesh = archived(folder.resolve(model.name() + ".glb"));
        Path out = Files.createDirectory(temp.resolve("out")).resolve("y.obj");
        assertThat(ModelFiles.write(mesh, out, ModelFormat.OBJ).losses()).isEmpty();
        assertThat(mesh.materials()).isNotEmpty().allMatch(Material::isGltf);
        assertThat(MeshIdentity.sha256(archived(out))).isEqualTo(MeshIdentity.sha256(mesh));
    }

    private static Mesh archived(Path model) throws IOException {
        byte[] bytes = new ModelEncoding(EncoderSettings.defaults())
                .encode(model, ProgressListener.NONE)
                .bytes();
        return ArchiveFile.of(bytes).original(ProgressListener.NONE);
    }

    @ParameterizedTest
    @EnumSource(names = {"PLY", "OBJ", "OFF", "GLB"})
    void shouldTellALossWhereTheFileIsAnotherMeshAndNowhereElse(ModelFormat format) throws IOException {
        Path out = Files.createDirectory(temp.resolve("out"));
        int identical = 0;
        for (MaterialModel model : MaterialModels.all()) {
            model.write(folder);
            Mesh mesh = ModelFiles.read(folder.resolve(model.name() + ".glb")).mesh();
            Path file = Files.createDirectory(out.resolve(model.name())).resolve("y." + format.extension());
            boolean told = !ModelFiles.write(mesh, file, format).losses().isEmpty();
            Mesh again = ModelFiles.read(file).mesh();
            boolean same = MeshIdentity.sha256(again).equals(MeshIdentity.sha256(mesh));
            assertThat(same).as(model.name()).isEqualTo(!told);
            if (same) identical++;
        }
        if (format == ModelFormat.OBJ || format == ModelFormat.GLB)
            assertThat(identical).isGreaterThan(20);
    }

    @Test
    void shouldNotReplaceAForeignFileByATexture() throws IOException {
        Files.writeString(folder.resolve("wood.png"), "WOOD");
        Mesh mesh = readWithTexture("wood.png").mesh();
        Path out = Files.createDirectory(temp.resolve("out"));
        Files.writeString(out.resolve("wood.png"), "OTHER");
        assertThatThrownBy(() -> ModelFiles.write(mesh, out.resolve("y.obj"), ModelFormat.OBJ))
                .isInstanceOf(FileAlreadyExistsException.class);
        assertThat(out.resolve("wood.png")).hasContent("OTHER");
        Files.writeString(out.resolve("wood.png"), "WOOD");
        assertThat(ModelFiles.write(mesh, out.resolve("y.obj"), ModelFormat.OBJ).losses())
                .isEmpty();
    }

    @Test
    void shouldNotWriteThroughALinkThatLeadsOut() throws IOException {
        Path tex = Files.createDirectory(folder.resolve("tex"));
        Files.writeString(tex.resolve("wood.png"), "WOOD");
        Mesh mesh = readWithTexture("tex/wood.png").mesh();
        Path out = Files.createDirectory(temp.resolve("out"));
        Path elsewhere = Files.createDirectory(temp.resolve("elsewhere"));
        Files.createSymbolicLink(out.resolve("tex"), elsewhere);
        assertThatThrownBy(() -> ModelFiles.write(mesh, out.resolve("y.obj"), ModelFormat.OBJ))
                .hasMessageContaining("a link leads out of it");
        assertThat(elsewhere).isEmptyDirectory();
    }

    @Test
    void shouldTellTheFormatFromTheContent() throws IOException {
        Files.writeString(folder.resolve("wrong.stl"), OBJ);
        assertThat(ModelFiles.read(folder.resolve("wrong.stl")).format()).isEqualTo(ModelFormat.OBJ);
    }

    @Test
    void shouldReadAFileOfTheWorkingFolderByItsBareName() throws IOException {
        Path relative = Path.of("").toAbsolutePath().relativize(folder.resolve("x.obj"));
        assertThat(ModelFiles.read(relative).mesh().faces()).isEqualTo(1);
    }

    @Test
    void shouldNameTheFileThatCannotBeRead() throws IOException {
        Path bad = Files.write(folder.resolve("bad.ply"), List.of("ply", "format ascii 1.0"));
        assertThatThrownBy(() -> ModelFiles.read(bad))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageStartingWith("bad.ply, line");
    }
}
