package org.jsmesh.files.gltf.write;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The attributes of one primitive. glTF numbers sets of attributes without gaps, and wants as many sets of joints as of
 * weights. Sets that break this, because the faces lack others, become attributes of the application, unless they come
 * from a file of glTF that broke it.
 */
final class PartAttributes {
    private static final Pattern SET = Pattern.compile("(TEXCOORD|COLOR|JOINTS|WEIGHTS)_([0-9]+)");

    private final List<VertexAttribute> attributes = new ArrayList<>();
    private final Set<String> names = new HashSet<>();

    private PartAttributes(Part part, List<VertexAttribute> all) {
        for (int a = 0; a < all.size(); a++) {
            if (!part.has(a)) continue;
            attributes.add(all.get(a));
            names.add(all.get(a).name());
        }
    }

    static List<VertexAttribute> of(Part part, List<VertexAttribute> all) {
        PartAttributes of = new PartAttributes(part, all);
        List<VertexAttribute> result = new ArrayList<>();
        for (VertexAttribute attribute : of.attributes) {
            VertexAttribute fit = of.fit(attribute);
            if (fit != null) result.add(fit);
        }
        return result;
    }

    private VertexAttribute fit(VertexAttribute attribute) {
        Matcher set = SET.matcher(attribute.name());
        if (!set.matches()) return attribute;
        boolean skin = set.group(1).equals("JOINTS") || set.group(1).equals("WEIGHTS");
        boolean own = attribute.extras() == null;
        if (own && !skin || isWithoutGaps(set.group(1), Integer.parseInt(set.group(2)), skin)) return attribute;
        boolean free = !names.contains('_' + attribute.name());
        return attribute.isCopy() || !free ? null : attribute.renamed();
    }

    private boolean isWithoutGaps(String kind, int number, boolean skin) {
        boolean without = true;
        for (int n = 0; n <= number; n++) {
            without &= names.contains((skin ? "JOINTS_" : kind + '_') + n);
            without &= !skin || names.contains("WEIGHTS_" + n);
        }
        return without;
    }
}
