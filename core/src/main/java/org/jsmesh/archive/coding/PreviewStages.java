package org.jsmesh.archive.coding;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.PreviewModel;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Picture;

/** The previews of images that have arrived. */
public final class PreviewStages {
    /** Limit of all previews together, because a few bytes can stand for many pixels. */
    public static final int MOST_PIXELS = 1 << 22;

    private static final int IMAGE_BITS = 12;
    private final PreviewModel model = new PreviewModel();
    private final Map<Integer, PreviewCoder> byImage = new TreeMap<>();
    private final Map<Integer, Integer> pixelsOf = new TreeMap<>();
    private int pixels;

    /**
     * Codes which image a portion of a stage is of.
     *
     * @param stream in either direction
     * @param image its number: known to the encoder alone
     * @return its number
     */
    public static int codeImage(BinaryCoder stream, int image) {
        return stream.raw(image, IMAGE_BITS);
    }

    public void decode(byte[] buffer, int offset, int length, int images) throws MalformedStreamException {
        RangeDecoder stream = new RangeDecoder(buffer, offset, length);
        int image = codeImage(stream, 0);
        if (image >= images) throw new MalformedStreamException(-1, "a preview of image " + image);
        PreviewCoder coder = byImage.computeIfAbsent(image, i -> new PreviewCoder(model));
        Integer before = pixelsOf.put(image, coder.pixels());
        pixels += coder.pixels() - (before == null ? 0 : before);
        if (pixels > MOST_PIXELS)
            throw new MalformedStreamException(-1, "previews of more than " + MOST_PIXELS + " pixels");
        coder.codePortion(stream, null, () -> false);
        if (stream.isExhausted()) throw new MalformedStreamException(-1, "a preview ends early");
    }

    /**
     * The previews of the images that have not arrived whole, each under all its paths. Those of one image share its
     * colours.
     *
     * @param images of the archive
     * @param arrived how many of them, from the first one on, have arrived whole
     */
    public List<Picture> pictures(List<ImageInfo> images, int arrived) {
        List<Picture> list = new ArrayList<>();
        for (int i = arrived; i < images.size(); i++) {
            PreviewCoder coder = byImage.get(i);
            if (coder == null || coder.width() == 0) continue;
            int[] argb = coder.argb();
            for (String path : images.get(i).paths()) list.add(new Picture(path, coder.width(), coder.height(), argb));
        }
        return list;
    }
}
