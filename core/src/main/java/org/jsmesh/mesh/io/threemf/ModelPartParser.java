package org.jsmesh.mesh.io.threemf;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Reads a model part: 3MF core specification, of the materials extension the base of it (colours and textures), and of
 * the production extension the paths of parts. Extensions that a file requires and nobody here knows are refused.
 */
final class ModelPartParser {
    static final String CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
    private static final String MATERIALS = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
    private static final String PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
    private static final Set<String> KNOWN = Set.of(CORE, MATERIALS, PRODUCTION);
    private static final int NONE = -1;

    private final XmlPart xml;
    private final ModelPart part;
    private final PackageNotes notes;

    private ModelPartParser(String path, byte[] content, PackageNotes notes) throws ThreeMfException {
        xml = new XmlPart(path, content);
        part = new ModelPart(path);
        this.notes = notes;
    }

    static ModelPart parse(String path, byte[] content, PackageNotes notes) throws ThreeMfException {
        ModelPartParser parser = new ModelPartParser(path, content, notes);
        parser.model();
        return parser.part;
    }

    private void model() throws ThreeMfException {
        if (!xml.next() || !xml.name().equals("model") || !xml.namespace().equals(CORE))
            throw xml.error("there is no element model of 3MF", "Export the model as 3MF anew");
        String required = xml.attribute("requiredextensions");
        for (String prefix : required == null || required.isBlank()
                ? new String[0]
                : required.strip().split("\\s+")) {
            String uri = xml.namespaceOf(prefix);
            if (uri == null || !KNOWN.contains(uri)) {
                throw xml.error(
                        "it requires the extension " + XmlPart.quote(uri == null ? prefix : uri)
                                + ", which jSM does not know",
                        "Export it without that extension, or as glTF, OBJ or PLY");
            }
        }
        if (notes.unit == null) notes.unit = xml.attribute("unit");
        while (xml.next()) {
            switch (known()) {
                case "resources" -> resources();
                case "build" -> references("item", part.build);
                case "metadata" -> {
                    String name = xml.attribute("name");
                    PackageNotes.keep(notes.metadata, name == null ? "metadata" : name);
                    xml.skip();
                }
                default -> other();
            }
        }
    }

    /** The name of an element of an extension known here, or an empty text. */
    private String known() {
        return KNOWN.contains(xml.namespace()) ? xml.name() : "";
    }

    private void other() throws ThreeMfException {
        PackageNotes.keep(notes.elements, xml.name());
        xml.skip();
    }

    private void resources() throws ThreeMfException {
        while (xml.next()) {
            switch (known()) {
                case "object" -> object();
                case "basematerials" -> baseMaterials();
                case "colorgroup" -> colours();
                case "texture2d" -> {
                    part.textures.put(xml.whole("id"), PackagePaths.absolute(part.path, xml.required("path")));
                    xml.skip();
                }
                case "texture2dgroup" -> textureCoordinates();
                default -> other();
            }
        }
    }

    private void baseMaterials() throws ThreeMfException {
        ModelPart.BaseMaterials group = new ModelPart.BaseMaterials(new ArrayList<>(), new IntRow());
        part.properties.put(xml.whole("id"), group);
        while (xml.next()) {
            if (known().equals("base")) {
                String name = xml.attribute("name");
                group.names().add(name == null ? "" : name);
                group.argb().add(colour("displaycolor"));
                xml.skip();
            } else {
                other();
            }
        }
    }

    private void colours() throws ThreeMfException {
        ModelPart.Colours group = new ModelPart.Colours(new IntRow());
        part.properties.put(xml.whole("id"), group);
        while (xml.next()) {
            if (known().equals("color")) {
                group.argb().add(colour("color"));
                xml.skip();
            } else {
                other();
            }
        }
    }

    private void textureCoordinates() throws ThreeMfException {
        ModelPart.TextureCoordinates group = new ModelPart.TextureCoordinates(xml.whole("texid"), new DoubleRow());
        part.properties.put(xml.whole("id"), group);
        while (xml.next()) {
            if (known().equals("tex2coord")) {
                group.uv().add(xml.number("u"));
                group.uv().add(xml.number("v"));
                xml.skip();
            } else {
                other();
            }
        }
    }

    /** {@code #RRGGBB} or {@code #RRGGBBAA} as 0xAARRGGBB. */
    private int colour(String attribute) throws ThreeMfException {
        String text = xml.required(attribute).strip();
        if (!text.matches("#([0-9A-Fa-f]{6}|[0-9A-Fa-f]{8})"))
            throw xml.error(
                    attribute + " is " + XmlPart.quote(text) + ", not #RRGGBB or #RRGGBBAA", "Correct this line");
        long value = Long.parseLong(text.substring(1), 16);
        return text.length() == 7 ? 0xFF000000 | (int) value : (int) (value >>> 8 | (value & 0xFF) << 24);
    }

    private void object() throws ThreeMfException {
        int id = xml.whole("id");
        String name = xml.attribute("name");
        ModelPart.Item item =
                new ModelPart.Item(name == null ? "" : name, xml.whole("pid", NONE), xml.whole("pindex", NONE));
        if (part.objects.putIfAbsent(id, item) != null)
            throw xml.error("object " + id + " appears twice", "Rename or remove one");
        while (xml.next()) {
            switch (known()) {
                case "mesh" -> mesh(item);
                case "components" -> references("component", item.components);
                default -> other();
            }
        }
    }

    private void references(String name, List<ModelPart.Reference> to) throws ThreeMfException {
        while (xml.next()) {
            if (known().equals(name)) to.add(reference());
            else other();
        }
    }

    private ModelPart.Reference reference() throws ThreeMfException {
        String path = xml.attribute(PRODUCTION, "path");
        ModelPart.Reference reference = new ModelPart.Reference(
                path == null ? null : PackagePaths.absolute(part.path, path), xml.whole("objectid"), transform());
        xml.skip();
        return reference;
    }

    /** Twelve numbers, row by row, of a matrix that rows of coordinates are multiplied by; null for none. */
    private double[] transform() throws ThreeMfException {
        String text = xml.attribute("transform");
        if (text == null) return null;
        String[] words = text.strip().split("\\s+");
        if (words.length != 12)
            throw xml.error("transform has " + words.length + " numbers, not 12", "Correct this line");
        double[] transform = new double[12];
        for (int i = 0; i < 12; i++) transform[i] = xml.number("transform", words[i]);
        return transform;
    }

    private void mesh(ModelPart.Item item) throws ThreeMfException {
        while (xml.next()) {
            switch (known()) {
                case "vertices" -> vertices(item);
                case "triangles" -> triangles(item);
                default -> other();
            }
        }
    }

    private void vertices(ModelPart.Item item) throws ThreeMfException {
        while (xml.next()) {
            if (known().equals("vertex")) vertex(item);
            else other();
        }
    }

    private void triangles(ModelPart.Item item) throws ThreeMfException {
        while (xml.next()) {
            if (known().equals("triangle")) triangle(item);
            else other();
        }
    }

    private void vertex(ModelPart.Item item) throws ThreeMfException {
        for (String axis : new String[] {"x", "y", "z"}) {
            double value = xml.number(axis);
            item.positions.add(value);
            if (notes.isFloat) notes.isFloat = Double.parseDouble(Float.toString((float) value)) == value;
        }
        xml.skip();
    }

    private void triangle(ModelPart.Item item) throws ThreeMfException {
        for (String corner : new String[] {"v1", "v2", "v3"}) {
            int vertex = xml.whole(corner);
            if (3L * vertex >= item.positions.size)
                throw xml.error(
                        corner + " of a triangle names vertex " + vertex + " of " + item.positions.size / 3,
                        "Repair or remove this triangle");
            item.triangles.add(vertex);
        }
        int properties = xml.whole("pid", NONE);
        int first = xml.whole("p1", properties < 0 ? NONE : item.property);
        item.triangles.add(properties < 0 ? item.properties : properties);
        if (properties < 0 && first < 0) first = item.property;
        item.triangles.add(first);
        item.triangles.add(xml.whole("p2", first));
        item.triangles.add(xml.whole("p3", first));
        xml.skip();
    }
}
