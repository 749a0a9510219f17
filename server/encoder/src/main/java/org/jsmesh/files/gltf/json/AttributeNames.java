package org.jsmesh.files.gltf.json;

import java.util.regex.Pattern;

/** The names of attributes of vertices that are read, and written as they are. */
public final class AttributeNames {
    private static final Pattern KNOWN =
            Pattern.compile("NORMAL|TANGENT|(TEXCOORD|COLOR|JOINTS|WEIGHTS)_[0-9]{1,3}|_(?s:.){1,99}");

    private AttributeNames() {}

    /** Whether an attribute beside the position is one of glTF or of an application. */
    public static boolean isKnown(String name) {
        return KNOWN.matcher(name).matches();
    }

    /** Whether a name is that of a set, such as {@code TEXCOORD} with its number. */
    public static boolean isSet(String name, String kind) {
        return name.startsWith(kind + '_') && isKnown(name);
    }
}
