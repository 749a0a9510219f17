package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.jsmesh.mesh.io.ThreeMfSamples.TRIANGLE;
import static org.jsmesh.mesh.io.ThreeMfSamples.file;
import static org.jsmesh.mesh.io.ThreeMfSamples.mesh;
import static org.jsmesh.mesh.io.ThreeMfSamples.model;
import static org.jsmesh.mesh.io.ThreeMfSamples.object;

import java.io.IOException;
import java.util.Arrays;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.Slot;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ThreeMfReaderTest {
    private static final String ITEM = "<item objectid='1'/>";
    private static final String FACE = "0,0,0 1,0,0 0,1,0";

    private static ModelFile read(byte[] content) throws IOException {
        return ModelReader.read("a.3mf", content, ResourceResolver.NONE);
    }

    private static Mesh built(String resources, String build) throws IOException {
        return read(file(model("", resources, build))).mesh();
    }

    private static String component(int object, String rest) {
        return "<component objectid='" + object + "' " + rest + "/>";
    }

    @Test
    void shouldReadAMeshThatIsBuilt() throws IOException {
        ModelFile file = ModelReader.read("x", file(model("", object(1, TRIANGLE), ITEM)), ResourceResolver.NONE);
        assertThat(file.format()).isEqualTo(ModelFormat.THREE_MF);
        assertThat(Reading.faces(file.mesh())).containsExactly(FACE);
        assertThat(file.mesh().exactPositions()).isNull();
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldPutEveryInstanceWhereItBelongs() throws IOException {
        Mesh mesh = built(
                object(1, TRIANGLE)
                        + object(
                                2,
                                "<components>" + component(1, "transform='1 0 0 0 1 0 0 0 1 10 0 0'")
                                        + component(1, "transform='0 1 0 -1 0 0 0 0 1 0 0 5'") + "</components>"),
                ITEM + "<item objectid='2' transform='2 0 0 0 2 0 0 0 2 0 0 100'/>");
        assertThat(Reading.faces(mesh)).containsExactly(FACE, "20,0,100 22,0,100 20,2,100", "0,0,110 0,2,110 -2,0,110");
    }

    @Test
    void shouldTurnTrianglesOfMirroredInstances() throws IOException {
        assertThat(Reading.faces(
                        built(object(1, TRIANGLE), "<item objectid='1' transform='-1 0 0 0 1 0 0 0 1 0 0 0'/>")))
                .containsExactly("0,0,0 0,1,0 -1,0,0");
    }

    @Test
    void shouldMakeMaterialsOfBaseMaterials() throws IOException {
        String triangles = "<triangle v1='0' v2='1' v3='2'/><triangle v1='0' v2='1' v3='2' pid='5' p1='1'/>"
                + "<triangle v1='0' v2='1' v3='2' p1='1'/>";
        ModelFile file = read(file(model(
                "",
                "<basematerials id='5'><base name='red' displaycolor='#FF0000'/>"
                        + "<base name='glass' displaycolor='#0000FF33'/></basematerials>"
                        + "<object id='1' pid='5' pindex='0'>" + mesh(triangles) + "</object>",
                ITEM)));
        Mesh mesh = file.mesh();
        assertThat(mesh.faceMaterials()).containsExactly(0, 1, 1);
        assertThat(mesh.materials().get(0).name()).isEqualTo("red");
        assertThat(DisplayMaterial.of(mesh.materials().get(0), false).plain()).containsExactly(1, 0, 0, 1);
        assertThat(DisplayMaterial.of(mesh.materials().get(1), false).plain()).containsExactly(0, 0, 1, .2f);
        assertThat(file.notes()).isEmpty();
    }

    @Test
    void shouldGiveCornersTheirColours() throws IOException {
        Mesh mesh = built(
                "<m:colorgroup id='5'><m:color color='#FF0000FF'/><m:color color='#00FF00'/></m:colorgroup>"
                        + object(
                                1,
                                mesh("<triangle v1='0' v2='1' v3='2' pid='5' p1='0' p2='1' p3='0'/>"
                                        + "<triangle v1='2' v2='1' v3='0'/>")),
                ITEM);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 0)).containsExactly(1, 0, 0);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 0, 1)).containsExactly(0, 1, 0);
        assertThat(Reading.at(mesh, Channel.Semantic.COLOUR, 1, 0)).isNull();
        assertThat(mesh.channel(Channel.Semantic.COLOUR).type()).isEqualTo(Channel.Type.UINT8);
    }

    @Test
    void shouldReadTexturesOfThePackage() throws IOException {
        String resources = "<m:texture2d id='4' path='/3D/Textures/wood.png' contenttype='image/png'/>"
                + "<m:texture2dgroup id='5' texid='4'><m:tex2coord u='0' v='0'/><m:tex2coord u='.5' v='1'/>"
                + "</m:texture2dgroup>"
                + object(1, mesh("<triangle v1='0' v2='1' v3='2' pid='5' p1='0' p2='1' p3='0'/>"));
        ModelFile file = read(file(model("", resources, ITEM), "3d/textures/Wood.png", "PNG"));
        assertThat(DisplayMaterial.of(file.mesh().materials().get(0), false).image(Slot.COLOUR))
                .isEqualTo("3D/Textures/wood.png");
        assertThat(file.mesh().textures().get(0).bytes()).containsExactly('P', 'N', 'G');
        assertThat(Reading.at(file.mesh(), Channel.Semantic.TEXCOORD, 0, 1)).containsExactly(.5f, 1);
        assertThat(file.notes()).isEmpty();
        assertThat(read(file(model("", resources, ITEM))).notes())
                .containsExactly(Note.dropped("Textures not found: 3D/Textures/wood.png.", 1, "3D/Textures/wood.png")
                        .asWarning());
    }

    @Test
    void shouldFindObjectsInOtherPartsOfThePackage() throws IOException {
        String other = model("", object(7, TRIANGLE), "");
        byte[] content = file(
                model(
                        "requiredextensions='p'",
                        object(1, "<components>" + component(7, "p:path='/3D/Objects/x.model'") + "</components>"),
                        ITEM),
                "3D/Objects/x.model",
                other);
        assertThat(Reading.faces(read(content).mesh())).containsExactly(FACE);
    }

    @Test
    void shouldKeepNamesOfObjectsByFace() throws IOException {
        Mesh mesh = built(
                object(1, TRIANGLE).replace("type=", "name='lid' type=")
                        + object(2, TRIANGLE)
                        + object(3, TRIANGLE).replace("type=", "name='box' type="),
                "<item objectid='3'/><item objectid='1'/><item objectid='2'/><item objectid='3'/>");
        FaceChannel names = mesh.faceChannels().get(0);
        assertThat(names.name()).isEqualTo(FaceChannel.OBJECT);
        assertThat(java.util.stream.IntStream.range(0, 4).mapToObj(names::label))
                .containsExactly("box", "lid", "", "box");
    }

    @Test
    void shouldTellWhatItDoesNotKeep() throws IOException {
        String resources = object(1, mesh("<triangle v1='0' v2='1' v3='2' pid='9' p1='0'/>"))
                + object(2, TRIANGLE)
                + "<m:multiproperties id='9' pids='5 6'><m:multi pindices='0 0'/></m:multiproperties>";
        byte[] content = file(
                model("unit='inch'", resources, ITEM)
                        .replace("<resources>", "<metadata name='Title'>x</metadata><resources>"),
                "Metadata/thumbnail.png",
                "x");
        assertThat(read(content).notes())
                .extracting(Note::text)
                .containsExactly(
                        "The unit (inch) is not kept; the numbers are as they were.",
                        "Properties of triangles not kept: pid 9.",
                        "Metadata not kept: Title.",
                        "Elements skipped: multiproperties.",
                        "Parts of the package skipped: Metadata/thumbnail.png.",
                        "1 object that no build item uses left out.");
    }

    @Test
    void shouldKeepDecimalsThatFloat32DoesNotHold() throws IOException {
        Mesh mesh = built(object(1, TRIANGLE.replace("x='1'", "x='450000.123'")), ITEM);
        assertThat(mesh.exactPositions()[3]).isEqualTo(450000.123);
        assertThat(built(object(1, TRIANGLE.replace("x='1'", "x='.1'")), ITEM).exactPositions())
                .isNull();
    }

    @Test
    void shouldKeepTheShapeOfWhatATransformMovesFar() throws IOException {
        Mesh far = built(object(1, TRIANGLE), "<item objectid='1' transform='1 0 0 0 1 0 0 0 1 5411000.456 0 0'/>");
        assertThat(far.exactPositions()[3] - far.exactPositions()[0])
                .isCloseTo(1, org.assertj.core.data.Offset.offset(1e-8));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "v2='1'|v2='3'|v2 of a triangle names vertex 3 of 3",
                "v2='1'|v2='-1'|not a whole number in range",
                "x='1'|x='NaN'|x is \"NaN\", not a finite number",
                "x='1'|x='1f'|not a finite number",
                "x='1'|x='1e999'|not a finite number",
                "x='1' y='0'|x='1'|vertex has no y",
                "objectid='1'|objectid='2'|there is no object 2",
                "objectid='1'|objectid='1' transform='1 2 3'|transform has 3 numbers, not 12",
                "<build>|<buildd>|the XML is damaged or cut off",
                "<model |<modell |there is no element model of 3MF",
                "core/2015/02|core/1999/02|there is no element model of 3MF",
                "type='model'|id='3'|the XML is damaged or cut off"
            })
    void shouldRefuseBadModels(String part, String replacement, String reason) throws IOException {
        String model = model("", object(1, TRIANGLE), ITEM);
        assertThat(model).contains(part);
        ModelFormatException refusal = Reading.refusal("a.3mf", file(model.replace(part, replacement)));
        assertThat(refusal.reason()).contains(reason);
        assertThat(refusal.place()).startsWith("3D/3dmodel.model");
    }

    @Test
    void shouldRefuseExtensionsThatItDoesNotKnowByName() throws IOException {
        String model = model(
                "xmlns:b='http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02' requiredextensions='m b'",
                object(1, TRIANGLE),
                ITEM);
        assertThat(Reading.refusal("a.3mf", file(model)).reason())
                .isEqualTo(
                        "it requires the extension"
                                + " \"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\", which jSM does not know");
        assertThat(Reading.refusal("a.3mf", file(model("requiredextensions='q'", "", "")))
                        .reason())
                .contains("requires the extension \"q\"");
    }

    @Test
    void shouldRefusePackagesWithoutAModel() throws IOException {
        assertThat(Reading.refusal("a.3mf", file(null, "x.model", "<x/>")).reason())
                .isEqualTo("the package has no such model part");
    }

    @Test
    void shouldRefuseEntitiesAndNestingWithoutEnd() throws IOException {
        String bomb = "<!DOCTYPE model [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>]>";
        String model = model("", object(1, TRIANGLE), ITEM);
        String bombed = model.replace("<model ", bomb + "<model ").replace("<build>", "&b;<build>");
        assertThat(Reading.refusal("a.3mf", file(bombed)).reason()).contains("document type or an entity");
        String outside = "<!DOCTYPE model SYSTEM 'file:///etc/passwd'>";
        assertThat(Reading.refusal("a.3mf", file(model.replace("<model ", outside + "<model ")))
                        .reason())
                .contains("document type or an entity");
        String deep = "<x>".repeat(100_000) + "</x>".repeat(100_000);
        assertThat(Reading.refusal("a.3mf", file(model.replace("<build>", deep + "<build>")))
                        .reason())
                .contains("nested more than 64 deep");
    }

    @Test
    void shouldRefuseComponentsWithoutEnd() throws IOException {
        assertThat(Reading.refusal(
                                "a.3mf",
                                file(model(
                                        "",
                                        object(1, "<components>" + component(2, "") + "</components>")
                                                + object(2, "<components>" + component(1, "") + "</components>"),
                                        ITEM)))
                        .reason())
                .isEqualTo("object 1 is a component of itself");
        StringBuilder doubling = new StringBuilder(object(30, TRIANGLE));
        for (int id = 29; id > 0; id--)
            doubling.append(
                    object(id, "<components>" + component(id + 1, "") + component(id + 1, "") + "</components>"));
        assertThat(Reading.refusal("a.3mf", file(model("", doubling.toString(), ITEM)))
                        .reason())
                .isEqualTo("the components make more than 1000000 instances");
        StringBuilder chain = new StringBuilder(object(50, TRIANGLE));
        for (int id = 49; id > 0; id--)
            chain.append(object(id, "<components>" + component(id + 1, "") + "</components>"));
        assertThat(Reading.refusal("a.3mf", file(model("", chain.toString(), ITEM)))
                        .reason())
                .isEqualTo("components are nested more than 32 deep");
    }

    @Test
    void shouldRefuseMoreTrianglesThanAllowed() throws IOException {
        String many = mesh("<triangle v1='0' v2='1' v3='2'/>".repeat(1000));
        StringBuilder resources = new StringBuilder(object(17, many));
        for (int id = 16; id > 0; id--)
            resources.append(
                    object(id, "<components>" + component(id + 1, "") + component(id + 1, "") + "</components>"));
        assertThat(Reading.refusal("a.3mf", file(model("", resources.toString(), ITEM)))
                        .reason())
                .isEqualTo("the build makes more than 20000000 triangles or vertices");
    }

    @Test
    void shouldRefuseEveryTruncation() throws IOException {
        byte[] content = file(model("", object(1, TRIANGLE), ITEM));
        for (int length = 0; length < content.length; length += 7)
            assertThat(Reading.refusal("a.3mf", Arrays.copyOf(content, length)))
                    .as("%d bytes", length)
                    .isNotNull();
    }
}
