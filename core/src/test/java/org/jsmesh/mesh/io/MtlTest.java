package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;

class MtlTest {
    private final List<Note> unread = new ArrayList<>();
    private final List<String> notes = new ArrayList<>();

    private Map<String, Material> read(String text) {
        Map<String, Material> materials = new LinkedHashMap<>();
        new MtlReader("l.mtl", text.getBytes(StandardCharsets.UTF_8), materials, unread).read();
        return materials;
    }

    private String write(Material... materials) throws IOException {
        MemoryFiles files = new MemoryFiles();
        try (TextOutput out = new TextOutput(files.create("l.mtl"))) {
            new MtlWriter(List.of(materials), notes).write(out, new TextureFiles(List.of(), notes));
        }
        return files.text("l.mtl");
    }

    private void shouldComeBack(Material... materials) throws IOException {
        assertThat(read(write(materials)).values()).containsExactly(materials);
        assertThat(notes).isEmpty();
        assertThat(unread).isEmpty();
    }

    @Test
    void shouldReadOptionsOfTexturesAsParameters() {
        Material m =
                read("newmtl m\nmap_Kd -s 2 2 1 -clamp on -bm 0.5 my wood.png").get("m");
        assertThat(m.textures()).containsExactly(new Material.TextureReference("map_Kd", "my wood.png"));
        assertThat(m.parameters())
                .containsExactly(
                        new Material.Parameter("map_Kd -s", 2, 2, 1),
                        new Material.Parameter("map_Kd -clamp on"),
                        new Material.Parameter("map_Kd -bm", .5f));
    }

    @Test
    void shouldKeepStatementsThatAreNotNumbers() {
        Material m = read("newmtl m\nKa spectral f.rfl 1\nillum 2 # comment\nd -halo 0.5\nNs nan")
                .get("m");
        assertThat(m.parameters())
                .containsExactly(
                        new Material.Parameter("Ka spectral f.rfl 1"),
                        new Material.Parameter("illum", 2),
                        new Material.Parameter("d -halo 0.5"),
                        new Material.Parameter("Ns nan"));
    }

    @Test
    void shouldBringBackEveryKindOfDefinition() throws IOException {
        shouldComeBack(
                Material.named("bare"),
                new Material(
                        "with blanks",
                        List.of(
                                new Material.Parameter("Kd", .1f, -0f, 1e-30f),
                                new Material.Parameter("Ka spectral f.rfl")),
                        List.of()),
                new Material(
                        "textured",
                        List.of(
                                new Material.Parameter("map_Kd -s", 2, 2, 1),
                                new Material.Parameter("map_Kd -clamp on"),
                                new Material.Parameter("Ns", 5)),
                        List.of(
                                new Material.TextureReference("map_Kd", "a b.png"),
                                new Material.TextureReference("bump", "b.png"))));
    }

    @Test
    void shouldDeriveColoursAndTexturesForOthersButNotReadThemBack() throws IOException {
        Material gltf = new Material(
                "g",
                List.of(),
                List.of(new Material.TextureReference("baseColorTexture", "duck.png")),
                "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,1,0.25],\"baseColorTexture\":{\"index\":{"
                        + "\"source\":0}}},\"alphaMode\":\"BLEND\",\"extras\":{\"a\":\"# b \\\\ \\\"c\\\"\"}}");
        assertThat(write(gltf)).contains("\nKd 1 0 1\n", "\nd 0.25\n", "\nmap_Kd -s 1 -1 1 -o 0 1 0 duck.png\n");
        Material own = new Material(
                "own", List.of(), List.of(new Material.TextureReference("FOO_bar.texture", "b.png")), "{}");
        shouldComeBack(
                gltf, own, new Material("rgb=(1 0 0)", List.of(new Material.Parameter("rgb", 1, 0, 0)), List.of()));
    }

    @Test
    void shouldTakeADefinitionOfGltfForTheWholeMaterial() {
        String definition = "{\"normalTexture\":{\"index\":{\"source\":0}}}";
        Material m = read("newmtl m\nKd 1 0 0\nmap_Kd -s 2 2 a.png\ngltf " + definition + "\nnormalTexture n.png")
                .get("m");
        assertThat(m)
                .isEqualTo(new Material(
                        "m", List.of(), List.of(new Material.TextureReference("normalTexture", "n.png")), definition));
        assertThat(unread)
                .containsExactly(Note.dropped(
                        "l.mtl: statements beside a definition of glTF left out: m: Kd, m: map_Kd -s, m: map_Kd.",
                        3,
                        "m: Kd"));
    }

    @Test
    void shouldWriteMaterialsOfOneNameUnderTwo() throws IOException {
        Material red = new Material("m", List.of(new Material.Parameter("Kd", 1, 0, 0)), List.of());
        Material blue = new Material("m", List.of(new Material.Parameter("Kd", 0, 0, 1)), List.of());
        assertThat(read(write(red, blue, red)).keySet()).containsExactly("m", "m-2");
        assertThat(notes).containsExactly("Materials written under other names: m as m-2.");
    }

    @Test
    void shouldNotLetNamesBreakOutOfTheirLine() throws IOException {
        Material evil = new Material(
                " a\nnewmtl b ",
                List.of(new Material.Parameter("x\nnewmtl c", 1), new Material.Parameter("newmtl d")),
                List.of(new Material.TextureReference("map_Kd", "a\nnewmtl e")));
        assertThat(read(write(evil)).keySet()).containsExactly("a_newmtl b");
        assertThat(notes).hasSize(2);
    }
}
