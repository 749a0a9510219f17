package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.encode.write.TexturePlan;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/**
 * Computes what images, and small previews of them, do for the picture of a model. At points all over its surface it
 * computes the error of the colour that viewers show without the image, with each stage of the preview, and with the
 * whole image. Pixels of a preview are the means of the points in them, so parts of an image that no face shows cost
 * nothing and spoil no border.
 */
final class TextureStages {
    private static final int FIRST_SIDE = 8; // pixels of the longer side of a preview's first stage
    private static final int MOST_STAGES = 5;
    /** Previews of a texture take at most this share of its bytes, in addition to them. */
    private static final double MOST_BYTES = .03;
    /** A stage is worth its bytes when they gain this many times as much as the same bytes of the image. */
    private static final double LEAST_WORTH = 2;
    /** Gain of an image that the encoder cannot read, if it covers all of the surface, in %. */
    private static final double UNREAD_GAIN = 20;

    private final Mesh mesh;
    private final PaintedPoints points;
    private final Map<String, Picture> pictures = new HashMap<>();

    /** @param pictures of those textures of the mesh that can be read */
    TextureStages(Mesh mesh, List<Picture> pictures) {
        this.mesh = mesh;
        for (Picture p : pictures) this.pictures.put(p.path(), p);
        points = new PaintedPoints(mesh, this.pictures);
    }

    /** A texture and what it is worth. */
    record Worth(Texture texture, TexturePlan plan) {
        private double gainPerByte() {
            return plan.gain() / texture.bytes().length;
        }
    }

    /** The mesh's textures, the one with the most gain per byte first. */
    List<Worth> inOrder() {
        List<Worth> list = new ArrayList<>();
        for (Texture t : mesh.textures()) list.add(new Worth(t, plan(t)));
        list.sort((a, b) -> Double.compare(b.gainPerByte(), a.gainPerByte()));
        return list;
    }

    private TexturePlan plan(Texture texture) {
        PaintedPoints.OfTexture at = points.of(texture.path());
        if (at == null) return TexturePlan.imageAlone(0);
        Picture picture = pictures.get(texture.path());
        if (picture == null) return TexturePlan.imageAlone(UNREAD_GAIN * at.share());
        try {
            return plan(texture, at);
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // the encoder's own pictures are small
        }
    }

    private static TexturePlan plan(Texture texture, PaintedPoints.OfTexture at) throws MalformedStreamException {
        List<TexturePlan.Stage> stages = new ArrayList<>();
        PreviewCoder coder = new PreviewCoder();
        double most = MOST_BYTES * texture.bytes().length;
        double bytes = 0;
        double off = at.differenceFromPlain();
        int longer = Math.max(at.width(), at.height());
        int width = Math.max(1, Math.round((float) FIRST_SIDE * at.width() / longer));
        int height = Math.max(1, Math.round((float) FIRST_SIDE * at.height() / longer));
        for (int i = 0; i < MOST_STAGES && 2 * (width << i) <= at.width(); i++) {
            int[] rgb = at.means(width << i, height << i);
            RangeEncoder stream = new RangeEncoder();
            coder.codeStage(stream, width, height, rgb);
            double size = stream.finish().length;
            bytes += size;
            double next = at.differenceFrom(coder.rgb(), coder.width(), coder.height());
            if (bytes > most || (off - next) / size < LEAST_WORTH * off / texture.bytes().length) break;
            stages.add(new TexturePlan.Stage(width, height, rgb, off - next));
            off = next;
        }
        return new TexturePlan(stages, off);
    }
}
