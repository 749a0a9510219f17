package org.jsmesh.codec.entropy;

import java.util.Arrays;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Utf8;

/**
 * Codes texts as UTF-8, the better the more alike they are. Where the last four bytes were there before, the byte that
 * followed them is the guess; a bit says whether it is right, under the length of the match. Other bytes are coded bit
 * by bit under the mean of what one and what two bytes before say (as PPM and PAQ predict; Cleary and Witten 1984,
 * Mahoney 2005). A model knows the words of glTF's materials from the start.
 */
public final class TextModel {
    /** Bytes of any text. */
    public static final int MOST_BYTES = 1 << 20;

    /** Bytes of all texts together, each with those that part it from the next. */
    public static final int MOST_HISTORY = 1 << 24;

    /** Bytes that part a text from the next. */
    public static final int MATCH = 4;

    private static final int CONTEXT_BITS = 14;
    private static final int PLACE_BITS = 12;
    private static final int LONGEST_RUN = 31;
    private static final int HASH = 0x9E3779B1; // 2^32 / golden ratio

    private static final String WORDS = "KHR_texture_transform\":{\"rotation\":\"offset\":[0,\"scale\":[1,"
            + "\"KHR_materials_unlit\":{},\"KHR_materials_emissive_strength\":{\"emissiveStrength\":"
            + "\"KHR_materials_ior\":{\"ior\":1.5},\"KHR_materials_specular\":{\"specularColorFactor\":[1.0,"
            + "\"KHR_materials_transmission\":{\"transmissionFactor\":\"KHR_materials_volume\":{\"attenuationColor\":"
            + "\"KHR_materials_clearcoat\":{\"clearcoatFactor\":\"clearcoatRoughnessFactor\":\"KHR_materials_sheen\":{"
            + "\"pbrSpecularGlossiness\":{\"diffuseFactor\":\"extras\":{\"extensions\":{\"alphaCutoff\":0.5,"
            + "\"alphaMode\":\"MASK\",\"alphaMode\":\"BLEND\",\"alphaMode\":\"OPAQUE\",\"emissiveFactor\":[0.0,0.0,0.0],"
            + "\"texCoord\":1},\"name\":\"doubleSided\":true,\"emissiveTexture\":{\"index\":{\"source\":3}},"
            + "\"occlusionTexture\":{\"strength\":1,\"index\":{\"source\":2}},"
            + "\"normalTexture\":{\"scale\":1,\"index\":{\"source\":1}},\"metallicRoughnessTexture\":{\"index\":"
            + "\"sampler\":{\"magFilter\":9729,\"minFilter\":9987,\"wrapS\":33071,\"wrapT\":33071},\"wrapT\":10497}"
            + ".jpeg.jpg.webp.png material Material image texture map_Kd map_Ks map_Bump Ka Ks Ns Ni illum "
            + "{\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,1],\"metallicFactor\":0.0,"
            + "\"baseColorTexture\":{\"index\":{\"source\":0}},\"roughnessFactor\":";

    private final IntegerModel lengths = new IntegerModel(1);
    private final int[] hits = BinaryCoder.newContexts(LONGEST_RUN + 1);
    private final int[] afterOne = BinaryCoder.newContexts(1 << CONTEXT_BITS);
    private final int[] afterTwo = BinaryCoder.newContexts(1 << CONTEXT_BITS);
    private final int[] places = new int[1 << PLACE_BITS];
    private byte[] history = new byte[1 << 11];
    private int size;
    private int match; // where in the history the guess is; 0 for none
    private int run; // bytes that matched

    /** Makes a model that knows nothing but the words of materials. */
    public TextModel() {
        for (byte b : Utf8.bytes(WORDS)) {
            literal(null, b & 255);
            push(b);
        }
    }

    /**
     * Codes a text.
     *
     * @param coder in either direction
     * @param text of no meaning to a decoder; null for the empty one
     * @return the text
     * @throws MalformedStreamException when what is read is too long, or ends early
     */
    public String code(BinaryCoder coder, String text) throws MalformedStreamException {
        byte[] bytes = text == null ? new byte[0] : Utf8.bytes(text);
        int length = lengths.unsigned(coder, bytes.length);
        if (length < 0 || length > MOST_BYTES || size > MOST_HISTORY - length)
            throw new MalformedStreamException(-1, "a text of " + length + " bytes");
        begin();
        int from = size;
        for (int i = 0; i < length; i++) {
            if ((i & 255) == 0 && coder.isExhausted()) throw new MalformedStreamException(-1, "a text ends early");
            push((byte) codeByte(coder, coder.isEncoder() ? bytes[i] & 255 : 0));
        }
        return Utf8.text(history, from, length);
    }

    /** A byte that no text has stands between texts, so that their beginnings are alike. */
    private void begin() {
        for (int i = 0; i < MATCH; i++) push((byte) 0);
    }

    private int codeByte(BinaryCoder coder, int value) {
        if (match == 0) return literal(coder, value);
        int guess = history[match] & 255;
        if (coder.bit(hits, Math.min(run, LONGEST_RUN), value == guess ? 1 : 0) != 0) return guess;
        return literal(coder, value);
    }

    /** @param coder null to learn a byte that needs no coding */
    private int literal(BinaryCoder coder, int value) {
        int one = size > 0 ? history[size - 1] & 255 : 0;
        int two = size > 1 ? history[size - 2] & 255 : 0;
        int node = 1;
        for (int i = 7; i >= 0; i--) {
            int first = (one << 8 | node) * HASH >>> 32 - CONTEXT_BITS;
            int second = (two << 16 | one << 8 | node) * HASH >>> 32 - CONTEXT_BITS;
            int bit = value >>> i & 1;
            if (coder == null) {
                afterOne[first] = BinaryCoder.adapt(afterOne[first], bit);
                afterTwo[second] = BinaryCoder.adapt(afterTwo[second], bit);
            } else {
                bit = coder.bit(afterOne, first, afterTwo, second, bit);
            }
            node = node << 1 | bit;
        }
        return node & 255;
    }

    private void push(byte value) {
        if (size == history.length) history = Arrays.copyOf(history, 2 * size);
        boolean goesOn = match > 0 && history[match] == value;
        history[size++] = value;
        match = goesOn ? match + 1 : 0;
        run = goesOn ? run + 1 : 0;
        if (size < MATCH) return;
        int bits = 0;
        for (int i = size - MATCH; i < size; i++) bits = bits << 8 | history[i] & 255;
        int place = bits * HASH >>> 32 - PLACE_BITS;
        if (match == 0 && places[place] > 0) look(places[place]);
        places[place] = size;
    }

    /** Takes a place for the match when as many bytes in front of it are those in front of the end. */
    private void look(int from) {
        int same = 0;
        while (same < LONGEST_RUN && same < from && history[from - 1 - same] == history[size - 1 - same]) same++;
        if (same < MATCH) return;
        match = from;
        run = same;
    }
}
