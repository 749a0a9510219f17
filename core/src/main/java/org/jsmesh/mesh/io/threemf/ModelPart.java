package org.jsmesh.mesh.io.threemf;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What one model part of a package defines, by the ids of its resources. */
final class ModelPart {
    /** Properties that triangles refer to. */
    interface Properties {
        int size();
    }

    /** @param argb of each material, 0xAARRGGBB */
    record BaseMaterials(List<String> names, IntRow argb) implements Properties {
        @Override
        public int size() {
            return argb.size;
        }
    }

    /** @param argb of each colour, 0xAARRGGBB */
    record Colours(IntRow argb) implements Properties {
        @Override
        public int size() {
            return argb.size;
        }
    }

    /** @param uv two numbers of each coordinate */
    record TextureCoordinates(int texture, DoubleRow uv) implements Properties {
        @Override
        public int size() {
            return uv.size / 2;
        }
    }

    /** @param part of the object, or null for the same part */
    record Reference(String part, int object, double[] transform) {}

    /** A mesh, or components. */
    static final class Item {
        static final int WIDTH = 7;

        final String name;
        final int properties;
        final int property;
        final DoubleRow positions = new DoubleRow();

        /** Seven per triangle: three vertices, the id of its properties or −1, three of these or −1. */
        final IntRow triangles = new IntRow();

        final List<Reference> components = new ArrayList<>();

        Item(String name, int properties, int property) {
            this.name = name;
            this.properties = properties;
            this.property = property;
        }
    }

    final String path;
    final Map<Integer, Item> objects = new HashMap<>();
    final Map<Integer, Properties> properties = new HashMap<>();
    final Map<Integer, String> textures = new HashMap<>();
    final List<Reference> build = new ArrayList<>();

    ModelPart(String path) {
        this.path = path;
    }
}
