package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TextureFilesTest {
    private static Mesh textured(String... paths) {
        List<Material> materials = new ArrayList<>();
        List<Texture> textures = new ArrayList<>();
        int[] faceMaterials = new int[paths.length];
        for (int i = 0; i < paths.length; i++) {
            materials.add(new Material("m" + i, List.of(), List.of(new Material.TextureReference("map_Kd", paths[i]))));
            textures.add(new Texture(paths[i], new byte[] {(byte) i}));
            faceMaterials[i] = i;
        }
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[3 * paths.length])
                .faceMaterials(faceMaterials)
                .materials(materials)
                .textures(textures)
                .build();
    }

    @Test
    void shouldKeepPathsWithinTheFolder() throws IOException {
        MemoryFiles files = new MemoryFiles();
        assertThat(ModelWriter.write(textured("a b.png", "tex/c.png"), ModelFormat.OBJ, "x.obj", files))
                .isEmpty();
        assertThat(files.files()).containsOnlyKeys("x.obj", "x.mtl", "a b.png", "tex/c.png");
        assertThat(files.read("x.obj").mesh().textures())
                .extracting(Texture::path)
                .containsExactly("a b.png", "tex/c.png");
    }

    @ParameterizedTest
    @CsvSource({
        "../../etc/wood.png,wood.png",
        "/etc/wood.png,wood.png",
        "C:\\tex\\wood.png,wood.png",
        "..,texture",
        "a/../b.png,b.png",
        ".bashrc,bashrc",
        "-o,o",
        "x.OBJ,x-2.OBJ",
        "x.mtl,x-2.mtl",
        "a//b,b",
        "con?.png,con_.png"
    })
    void shouldWriteNothingOutsideOrOverTheModel(String path, String name) throws IOException {
        MemoryFiles files = new MemoryFiles();
        List<String> notes = ModelWriter.write(textured(path), ModelFormat.OBJ, "x.obj", files);
        assertThat(files.files()).containsOnlyKeys("x.obj", "x.mtl", name);
        assertThat(notes)
                .containsExactly(
                        "Textures written under other names, which every system takes: " + path + " as " + name + ".");
        assertThat(files.read("x.obj").mesh().textures().get(0).path()).isEqualTo(name);
    }

    @Test
    void shouldTellFilesApartThatWouldGetOneName() throws IOException {
        MemoryFiles files = new MemoryFiles();
        ModelWriter.write(textured("../a.png", "A.png", "/a.png"), ModelFormat.OBJ, "x.obj", files);
        assertThat(files.files()).containsOnlyKeys("x.obj", "x.mtl", "a.png", "A-2.png", "a-3.png");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", " a", "a ", "a\nb", "a\\b", "a:b", "/a", "a/", "a/./b", "..", "../a", "-a", ".hidden", "a#b"
            })
    void shouldCallTheseUnsafe(String path) {
        assertThat(FileNames.isSafe(path)).isFalse();
    }
}
