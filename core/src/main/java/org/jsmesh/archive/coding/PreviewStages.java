package org.jsmesh.archive.coding;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.archive.TextureInfo;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Picture;

/** The previews of textures that have arrived. */
public final class PreviewStages {
    /** Limit of all previews together, because a few bytes can stand for many pixels. */
    private static final int MOST_PIXELS = 1 << 20;

    private static final int TEXTURE_BITS = 12;
    private final Map<Integer, PreviewCoder> byTexture = new HashMap<>();
    private int pixels;

    /**
     * Codes which texture a stage is of.
     *
     * @param stream in either direction
     * @param texture its number: known to the encoder alone
     * @return its number
     */
    public static int codeTexture(BinaryCoder stream, int texture) {
        return stream.raw(texture, TEXTURE_BITS);
    }

    public void decode(byte[] buffer, int offset, int length, int textures) throws MalformedStreamException {
        RangeDecoder stream = new RangeDecoder(buffer, offset, length);
        int texture = codeTexture(stream, 0);
        if (texture >= textures) throw new MalformedStreamException(-1, "a preview of texture " + texture);
        PreviewCoder coder = byTexture.get(texture);
        if (coder == null) {
            coder = new PreviewCoder();
            byTexture.put(texture, coder);
        }
        pixels += Math.max(PreviewCoder.LARGEST, 4 * coder.width() * coder.height());
        if (pixels > MOST_PIXELS)
            throw new MalformedStreamException(-1, "previews of more than " + MOST_PIXELS + " pixels");
        coder.codeStage(stream, 0, 0, null);
        if (stream.isExhausted()) throw new MalformedStreamException(-1, "a preview ends early");
    }

    /** The previews of the textures that have not arrived whole; the first {@code arrived} have. */
    public List<Picture> pictures(List<TextureInfo> textures, int arrived) {
        List<Picture> list = new ArrayList<>();
        for (int i = arrived; i < textures.size(); i++) {
            PreviewCoder coder = byTexture.get(i);
            if (coder != null)
                list.add(new Picture(textures.get(i).path(), coder.width(), coder.height(), coder.rgb()));
        }
        return list;
    }
}
