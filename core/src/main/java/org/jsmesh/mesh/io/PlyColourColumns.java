package org.jsmesh.mesh.io;

import java.util.Arrays;
import org.jsmesh.mesh.Channel;

/**
 * The properties of a PLY element that are its colour, under one of the names that programs give them.
 *
 * @param columns of red, green, blue and perhaps opacity; empty when there is no colour
 * @param type of all of them; null when there are none
 */
record PlyColourColumns(int[] columns, PlyType type) {
    private static final String[][] NAMES = {
        {"red", "green", "blue", "alpha"},
        {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
        {"r", "g", "b", "a"}
    };

    static PlyColourColumns of(PlyHeader.Element element) {
        for (String[] names : NAMES) {
            int[] columns = new int[names.length];
            PlyType type = null;
            int found = 0;
            while (found < columns.length) {
                int column = element.indexOf(names[found]);
                if (column < 0) break;
                PlyHeader.Property property = element.properties().get(column);
                if (type == null) type = property.type();
                if (property.isList() || property.type() != type) break;
                columns[found++] = column;
            }
            if (found >= 3) return new PlyColourColumns(Arrays.copyOf(columns, found), type);
        }
        return new PlyColourColumns(new int[0], null);
    }

    /** Decimals as float32; whole numbers keep their type, those of 64 bits as if they had 32. */
    Channel.Type channelType() {
        return switch (type) {
            case FLOAT, DOUBLE -> Channel.Type.FLOAT32;
            case LONG -> Channel.Type.INT32;
            case ULONG -> Channel.Type.UINT32;
            default -> type.channelType();
        };
    }

    FaceColours.Range range() {
        if (type == null || !type.isInteger()) return FaceColours.Range.DECIMAL;
        return switch (type) {
            case UCHAR -> FaceColours.Range.BYTE;
            case USHORT -> FaceColours.Range.SHORT;
            default -> FaceColours.Range.WHOLE;
        };
    }
}
