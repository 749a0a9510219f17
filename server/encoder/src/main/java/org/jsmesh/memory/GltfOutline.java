package org.jsmesh.memory;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;

/**
 * The counts in the description of a glTF file, and which node has which mesh. It is read in one pass, and nothing else
 * of it is kept. Rows of one kind end where the next ones begin: the children of node 2 are those from
 * {@code childrenEnd} of node 1 to that of node 2.
 */
final class GltfOutline {
    static final int HIDDEN = -2;

    /** Nothing of a file stays in tables that all files share. */
    private static final JsonFactory JSON = JsonFactory.builder()
            .disable(JsonFactory.Feature.INTERN_FIELD_NAMES)
            .disable(JsonFactory.Feature.CANONICALIZE_FIELD_NAMES)
            .build();

    private static final int TRIANGLES = 4;

    final IntList accessorCounts = new IntList();
    final IntList accessorWidths = new IntList();

    /** By mesh. */
    final IntList primitivesEnd = new IntList();

    final IntList positions = new IntList(); // of primitives: accessors, or −1
    final IntList indices = new IntList();
    final IntList modes = new IntList();
    final IntList attributesEnd = new IntList();
    final IntList attributes = new IntList(); // accessors, without those of positions

    /** By node: its mesh, −1, or {@link #HIDDEN}. */
    final IntList nodeMeshes = new IntList();

    final IntList childrenEnd = new IntList();
    final IntList children = new IntList();
    final IntList instancesEnd = new IntList();
    final IntList instances = new IntList(); // accessors

    final IntList rootsEnd = new IntList(); // by scene
    final IntList roots = new IntList();
    int scene;
    int materials;

    private final JsonParser in;

    // Of the value that is read.
    private int mesh;
    private int position;
    private int index;
    private int mode;
    private int count;
    private int width;

    private GltfOutline(JsonParser in) {
        this.in = in;
    }

    /**
     * Reads a description.
     *
     * @throws IOException when it is no JSON, or larger than any that is looked at
     */
    static GltfOutline of(byte[] text) throws IOException {
        try (JsonParser in = JSON.createParser(text)) {
            GltfOutline outline = new GltfOutline(in);
            in.nextToken();
            outline.fields(outline::part);
            return outline;
        }
    }

    private interface Field {
        void take(String name) throws IOException;
    }

    private interface Element {
        void take() throws IOException;
    }

    /** Goes through an object; what is none is passed over. Whoever takes a value leaves the parser at its end. */
    private void fields(Field field) throws IOException {
        if (!in.hasToken(JsonToken.START_OBJECT)) {
            in.skipChildren();
            return;
        }
        while (in.nextToken() == JsonToken.FIELD_NAME) {
            String name = in.currentName();
            in.nextToken();
            field.take(name);
        }
    }

    private void elements(Element element) throws IOException {
        if (!in.hasToken(JsonToken.START_ARRAY)) {
            in.skipChildren();
            return;
        }
        for (JsonToken t = in.nextToken(); t != null && t != JsonToken.END_ARRAY; t = in.nextToken()) element.take();
    }

    private int number() throws IOException {
        if (in.hasToken(JsonToken.VALUE_NUMBER_INT)) return in.getIntValue();
        in.skipChildren();
        return -1;
    }

    private void part(String name) throws IOException {
        switch (name) {
            case "accessors" -> elements(this::accessor);
            case "meshes" -> elements(this::mesh);
            case "nodes" -> elements(this::node);
            case "scenes" -> elements(this::scene);
            case "scene" -> scene = in.hasToken(JsonToken.VALUE_NULL) ? 0 : number();
            case "materials" ->
                elements(() -> {
                    materials++;
                    in.skipChildren();
                });
            default -> in.skipChildren();
        }
    }

    private void accessor() throws IOException {
        count = 0;
        width = 1;
        fields(name -> {
            switch (name) {
                case "count" -> count = Math.max(0, number());
                case "type" -> width = width(in.getValueAsString(""));
                default -> in.skipChildren();
            }
        });
        accessorCounts.add(count);
        accessorWidths.add(width);
    }

    private int width(String type) throws IOException {
        in.skipChildren();
        return switch (type) {
            case "VEC2" -> 2;
            case "VEC3" -> 3;
            case "VEC4" -> 4;
            default -> 1;
        };
    }

    private void mesh() throws IOException {
        fields(name -> {
            if (name.equals("primitives")) elements(this::primitive);
            else in.skipChildren();
        });
        primitivesEnd.add(positions.size());
    }

    private void primitive() throws IOException {
        position = -1;
        index = -1;
        mode = TRIANGLES;
        fields(name -> {
            switch (name) {
                case "attributes" -> fields(this::attribute);
                case "indices" -> index = number();
                case "mode" -> mode = in.hasToken(JsonToken.VALUE_NULL) ? TRIANGLES : number();
                default -> in.skipChildren();
            }
        });
        positions.add(position);
        indices.add(index);
        modes.add(mode);
        attributesEnd.add(attributes.size());
    }

    private void attribute(String name) throws IOException {
        if (name.equals("POSITION")) position = number();
        else attributes.add(number());
    }

    private void node() throws IOException {
        mesh = -1;
        boolean[] isHidden = {false};
        fields(name -> {
            switch (name) {
                case "mesh" -> mesh = Math.max(-1, number());
                case "children" -> elements(() -> children.add(number()));
                case "extensions" -> fields(extension -> extension(extension, isHidden));
                default -> in.skipChildren();
            }
        });
        nodeMeshes.add(isHidden[0] ? HIDDEN : mesh);
        childrenEnd.add(children.size());
        instancesEnd.add(instances.size());
    }

    private void extension(String extension, boolean[] isHidden) throws IOException {
        fields(name -> {
            if (extension.equals("EXT_mesh_gpu_instancing") && name.equals("attributes"))
                fields(attribute -> instances.add(number()));
            else {
                if (extension.equals("KHR_node_visibility") && name.equals("visible"))
                    isHidden[0] = in.hasToken(JsonToken.VALUE_FALSE);
                in.skipChildren();
            }
        });
    }

    private void scene() throws IOException {
        fields(name -> {
            if (name.equals("nodes")) elements(() -> roots.add(number()));
            else in.skipChildren();
        });
        rootsEnd.add(roots.size());
    }
}
