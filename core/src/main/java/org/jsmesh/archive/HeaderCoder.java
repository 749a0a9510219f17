package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader.ChannelInfo;
import org.jsmesh.archive.ArchiveHeader.Level;
import org.jsmesh.archive.ArchiveHeader.TextureInfo;
import org.jsmesh.codec.BinaryCoder;
import org.jsmesh.codec.IntegerModel;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.StringCoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Material;

/** Codes everything in front of the base: totals, format, materials, textures, levels and the batch index; in both directions. */
final class HeaderCoder {
    private static final int MAX_LIST = 1 << 20;
    private static final int MANTISSA = 0x7fffff;
    private final BinaryCoder coder;
    private final boolean write;
    private final IntegerModel counts = new IntegerModel(1);
    private final IntegerModel texts = new IntegerModel(1);
    private MeshFormat format;

    HeaderCoder(BinaryCoder coder) {
        this.coder = coder;
        write = coder.isEncoder();
    }

    MeshFormat format() {
        return format;
    }

    /**
     * @param headBytes bytes in front of the base payload: known to the decoder alone
     * @param baseBytes bytes of the base payload with its checksum
     */
    ArchiveHeader code(ArchiveHeader h, MeshFormat meshFormat, int headBytes, int baseBytes)
            throws MalformedStreamException {
        int faces = count(write ? h.faces() : 0, Integer.MAX_VALUE / 8);
        int vertices = count(write ? h.vertices() : 0, Integer.MAX_VALUE / 8);
        int wedges = count(write ? h.wedges() : 0, Integer.MAX_VALUE / 8);
        StringBuilder sha = new StringBuilder();
        for (int i = 0; i < 64; i++)
            sha.append(Character.forDigit(
                    coder.raw(write ? Character.digit(h.meshSha256().charAt(i), 16) : 0, 4), 16));
        float[] bounds = new float[6];
        for (int i = 0; i < 6; i++) bounds[i] = number(write ? h.bounds()[i] : 0);
        format = MeshFormat.code(coder, meshFormat);
        List<ChannelInfo> channels = new ArrayList<>();
        for (Channel c : format.channels())
            channels.add(new ChannelInfo(c.semantic(), c.name(), c.components(), c.type()));
        List<Material> materials = codeMaterials(write ? h.materials() : null);
        List<TextureInfo> textures = codeTextures(write ? h.textures() : null);
        int levelCount = count(write ? h.levels().size() : 0, 1 << 16);
        float[] thresholds = new float[levelCount];
        float last = 1;
        for (int i = 0; i < levelCount; i++) {
            last = threshold(write ? (float) h.levels().get(i).threshold() : 0, last);
            thresholds[i] = last;
        }
        BatchIndex batches =
                new IndexCoder(coder).code(write ? h.batches() : null, headBytes, baseBytes, format.extentBits(bounds));
        if (!write) checkTotals(batches, faces, vertices, levelCount);
        return new ArchiveHeader(
                faces,
                vertices,
                wedges,
                channels,
                materials,
                textures,
                bounds,
                levels(thresholds, batches),
                sha.toString(),
                batches);
    }

    /** Thresholds mostly differ from level to level by a power of two. */
    private float threshold(float value, float before) throws MalformedStreamException {
        int bits = Float.floatToRawIntBits(value);
        int last = Float.floatToRawIntBits(before);
        boolean power = (bits & MANTISSA) == (last & MANTISSA) && value > 0;
        if (coder.raw(power ? 1 : 0, 1) == 0) return number(value);
        int exponent = (last >>> 23) + counts.signed(coder, 0, (bits >>> 23) - (last >>> 23));
        if (exponent < 0 || exponent >= 255) throw new MalformedStreamException(-1, "a threshold out of range");
        return Float.intBitsToFloat(exponent << 23 | last & MANTISSA);
    }

    private void checkTotals(BatchIndex batches, int faces, int vertices, int levelCount)
            throws MalformedStreamException {
        int last = batches.size() - 1;
        if (batches.faces(last) != faces || batches.vertices(last) != vertices) {
            throw new MalformedStreamException(-1, "the index ends at " + batches.faces(last) + " faces of " + faces);
        }
        if (batches.level(last) > levelCount)
            throw new MalformedStreamException(-1, "the index has more levels than the header");
    }

    private static List<Level> levels(float[] thresholds, BatchIndex batches) {
        List<Level> levels = new ArrayList<>();
        for (int level = 1; level <= thresholds.length; level++) {
            int at = 0;
            for (int b = 0; b < batches.size(); b++) if (batches.level(b) <= level) at = b;
            levels.add(new Level(thresholds[level - 1], batches.faces(at), batches.errorMean(at)));
        }
        return levels;
    }

    private List<Material> codeMaterials(List<Material> list) throws MalformedStreamException {
        int n = count(write ? list.size() : 0, MAX_LIST);
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            checkEnd();
            Material m = write ? list.get(i) : null;
            String name = text(write ? m.name() : null);
            List<Material.Parameter> parameters = new ArrayList<>();
            int parameterCount = count(write ? m.parameters().size() : 0, 1 << 12);
            for (int p = 0; p < parameterCount; p++)
                parameters.add(codeParameter(write ? m.parameters().get(p) : null));
            List<Material.TextureReference> references = new ArrayList<>();
            int referenceCount = count(write ? m.textures().size() : 0, 1 << 12);
            for (int t = 0; t < referenceCount; t++) {
                String key = text(write ? m.textures().get(t).key() : null);
                references.add(new Material.TextureReference(
                        key, text(write ? m.textures().get(t).path() : null)));
            }
            materials.add(new Material(name, parameters, references));
        }
        return materials;
    }

    private Material.Parameter codeParameter(Material.Parameter p) throws MalformedStreamException {
        String key = text(write ? p.key() : null);
        float[] values = new float[count(write ? p.values().length : 0, 256)];
        for (int v = 0; v < values.length; v++) values[v] = number(write ? p.values()[v] : 0);
        return new Material.Parameter(key, values);
    }

    private List<TextureInfo> codeTextures(List<TextureInfo> list) throws MalformedStreamException {
        int n = count(write ? list.size() : 0, 1 << 12);
        List<TextureInfo> textures = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            checkEnd();
            String path = text(write ? list.get(i).path() : null);
            textures.add(new TextureInfo(path, count(write ? list.get(i).bytes() : 0, Integer.MAX_VALUE)));
        }
        return textures;
    }

    private void checkEnd() throws MalformedStreamException {
        if (coder.isExhausted()) throw new MalformedStreamException(-1, "the header ends early");
    }

    private int count(int value, int most) throws MalformedStreamException {
        int n = counts.unsigned(coder, value);
        if (n < 0 || n > most) throw new MalformedStreamException(-1, "a count of the header is " + n);
        return n;
    }

    private String text(String value) throws MalformedStreamException {
        return StringCoder.code(coder, texts, value);
    }

    private float number(float value) throws MalformedStreamException {
        float x = Float.intBitsToFloat(coder.raw(Float.floatToRawIntBits(value), 32));
        if (Float.isNaN(x) || Float.isInfinite(x))
            throw new MalformedStreamException(-1, "a number of the header is not finite");
        return x;
    }
}
