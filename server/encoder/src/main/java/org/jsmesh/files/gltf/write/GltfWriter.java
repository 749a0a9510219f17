package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.files.gltf.read.NoteText;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ResourceSink;

/**
 * Writes a mesh as GLB: a node with a mesh for each object, and a primitive for its faces that have the same material
 * and the same attributes. In glTF an attribute that is absent at some corner is absent in the whole primitive. Each
 * primitive has vertices of its own, those that its faces use.
 *
 * <p>The mesh of a file that was glTF is written as that file had it. What comes from other formats is said in glTF for
 * other programs, and objects {@code jsm} in the extras ({@link org.jsmesh.files.gltf.json.GltfExtras}) lead back:
 *
 * <ul>
 *   <li>An accessor of an attribute with {@code name} holds the channel of that name. It has the meaning
 *       {@code semantic}, and stands at {@code order} among the channels of the mesh. The raw numbers of the accessor
 *       are the numbers of the channel in its {@code type}; without a type the channel has that of the accessor. With
 *       {@code screen} the accessor has linear light in 16 bits, and opacity times 257, and the channel the closest
 *       levels of a screen in 8 bits.
 *   <li>An accessor with {@code copyOf} is for other programs. A reader skips it where the primitive has the attribute
 *       that it names.
 *   <li>A material with {@code parameters} and {@code textures} has this definition, in place of that of glTF. One with
 *       {@code sameAs} is the material of that number.
 *   <li>An image with {@code path} has this path. Its name gives that of others.
 * </ul>
 */
public final class GltfWriter {
    private static final String GENERATOR = "jSM";

    private final Mesh mesh;
    private final UpAxis up;
    private final List<String> notes = new ArrayList<>();
    private final List<String> remarks;
    private final BinaryChunk buffer = new BinaryChunk();
    private final AccessorList accessors = new AccessorList(buffer);
    private final ExtensionNames extensions = new ExtensionNames();
    private final ArrayNode meshes = JsonNodeFactory.instance.arrayNode();
    private final NodeTree nodes = new NodeTree();

    private GltfWriter(Mesh mesh, UpAxis up, List<String> remarks) {
        this.mesh = mesh;
        this.up = up;
        this.remarks = remarks;
    }

    /**
     * @param up the axis of the mesh that points up
     * @param fileName of the file, ending in {@code .glb}
     * @param sink takes the one file
     * @param remarks gets what other programs may miss though it is in the file, one sentence each
     * @return what glTF cannot hold or holds in another way, one sentence each
     * @throws IOException from the sink
     */
    public static List<String> write(Mesh mesh, UpAxis up, String fileName, ResourceSink sink, List<String> remarks)
            throws IOException {
        GltfWriter writer = new GltfWriter(mesh, up, remarks);
        ObjectNode gltf = writer.gltf();
        try (OutputStream out = sink.create(fileName)) {
            GlbChunks.write(gltf, writer.buffer, out);
        }
        return List.copyOf(writer.notes);
    }

    private ObjectNode gltf() throws IOException {
        if (mesh.faces() > 0) place();
        AttributeList attributes = new AttributeList(mesh);
        if (attributes.isQuantized()) extensions.require("KHR_mesh_quantization");
        MaterialList materials = new MaterialList(mesh, buffer, extensions);
        addObjects(attributes.attributes(), materials);
        attributes.report(notes);
        reportLosses(attributes.attributes());
        materials.report(notes, remarks);
        ObjectNode gltf = JsonNodeFactory.instance.objectNode();
        gltf.putObject("asset").put("version", "2.0").put("generator", GENERATOR);
        extensions.describe(gltf);
        nodes.describe(gltf);
        if (!meshes.isEmpty()) gltf.set("meshes", meshes);
        materials.describe(gltf);
        if (!accessors.json().isEmpty()) gltf.set("accessors", accessors.json());
        buffer.describe(gltf);
        return gltf;
    }

    private void place() {
        if (up == UpAxis.Z) {
            nodes.turnUp();
            remarks.add("The z axis of the model points up, and in glTF y does: a node turns the model.");
        }
        if (!mesh.isDouble()) return;
        nodes.moveTo(mesh.origin());
        notes.add("glTF holds float32 alone: positions are rounded to it, as offsets from the place of their node.");
    }

    private void addObjects(List<VertexAttribute> attributes, MaterialList materials) {
        Part.of(mesh, attributes).forEach((name, parts) -> {
            ObjectNode object = meshes.addObject();
            if (!name.isEmpty()) object.put("name", name);
            ArrayNode primitives = object.putArray("primitives");
            for (Part part : parts) addPrimitive(primitives.addObject(), part, attributes, materials);
            nodes.add(name, meshes.size() - 1);
        });
    }

    private void addPrimitive(ObjectNode json, Part part, List<VertexAttribute> all, MaterialList materials) {
        int[] corners = part.corners(mesh);
        int[] wedges = distinct(corners);
        for (int i = 0; i < corners.length; i++) corners[i] = Arrays.binarySearch(wedges, corners[i]);
        ObjectNode attributes = json.putObject("attributes");
        attributes.put("POSITION", accessors.positions(mesh, wedges));
        for (VertexAttribute attribute : PartAttributes.of(part, all))
            attributes.put(attribute.name(), accessors.values(attribute, wedges));
        json.put("indices", accessors.indices(corners, wedges.length));
        if (part.material() >= 0) json.put("material", materials.number(part.material(), attributes.has("TEXCOORD_0")));
    }

    /** In ascending order, which keeps what is close together in the mesh together in the file. */
    private static int[] distinct(int[] wedges) {
        int[] sorted = wedges.clone();
        Arrays.sort(sorted);
        int count = 0;
        for (int i = 0; i < sorted.length; i++) if (i == 0 || sorted[i] != sorted[i - 1]) sorted[count++] = sorted[i];
        return Arrays.copyOf(sorted, count);
    }

    private void reportLosses(List<VertexAttribute> attributes) {
        List<String> left = mesh.faceChannels().stream()
                .filter(channel -> !channel.name().equals(FaceChannel.OBJECT)
                        || channel.labels().isEmpty())
                .map(FaceChannel::name)
                .toList();
        if (!left.isEmpty()) notes.add("glTF does not hold these attributes of faces: " + NoteText.shown(left) + ".");
        int partly = Part.partlyAbsent(mesh, attributes);
        if (partly > 0)
            notes.add("glTF has no mark for absent attributes: on " + partly
                    + " faces that have one at some corners only it is left out.");
    }
}
