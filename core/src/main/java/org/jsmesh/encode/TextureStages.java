package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.coding.PreviewStages;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.encode.write.SharedImage;
import org.jsmesh.encode.write.TexturePlan;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;

/**
 * Computes what images, and small previews of them, do for the picture of a model. At points all over its surface it
 * computes the error of the colour that viewers show without the image, with each stage of the preview, and with the
 * whole image. Parts of an image that no face shows cost nothing and spoil no border.
 */
final class TextureStages {
    /** The colours of all images together are close enough when they are off by so much, in % of white. */
    private static final double GOAL = 2.9;
    /** Gain of an image that the encoder cannot read, if it covers all of the surface, in %. */
    private static final double UNREAD_GAIN = 20;

    private final List<SharedImage> images;
    private final PaintedPoints points;
    private final int mostPixels; // of a preview
    private final long colourPoints; // of all images

    /** @param pictures of those textures of the mesh that can be read */
    TextureStages(Mesh mesh, List<Picture> pictures) {
        images = SharedImage.of(mesh.textures());
        points = new PaintedPoints(mesh, images, pictures);
        mostPixels = PreviewStages.MOST_PIXELS / Math.max(1, images.size());
        long sum = 0;
        for (int i = 0; i < images.size(); i++)
            if (points.of(i) != null) sum += points.of(i).colourPoints();
        colourPoints = sum;
    }

    /** An image and what it is worth. */
    record Worth(SharedImage image, TexturePlan plan) {
        private double gainPerByte() {
            return plan.gain() / image.bytes().length;
        }
    }

    /** The mesh's images, the one with the most gain per byte first. */
    List<Worth> inOrder() {
        List<Worth> list = new ArrayList<>();
        for (int i = 0; i < images.size(); i++) list.add(new Worth(images.get(i), plan(i)));
        list.sort((a, b) -> Double.compare(b.gainPerByte(), a.gainPerByte()));
        return list;
    }

    private TexturePlan plan(int image) {
        PaintedImage painted = points.of(image);
        if (painted == null) return TexturePlan.imageAlone(0);
        if (!painted.isRead()) return TexturePlan.imageAlone(UNREAD_GAIN * painted.share());
        try {
            double goal = colourPoints == 0 ? 0 : GOAL * painted.colourPoints() / colourPoints;
            double bytes = images.get(image).bytes().length;
            return plan(painted, new PreviewLadder(painted, mostPixels, bytes, goal).best());
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // the encoder's own pictures are small
        }
    }

    /** Joins stages so that each step gains more per byte than those behind it. */
    private static TexturePlan plan(PaintedImage painted, List<PreviewLadder.Tried> stages) {
        List<TexturePlan.Step> steps = new ArrayList<>();
        double off = painted.differenceFromPlain();
        int next = 0;
        while (next < stages.size()) {
            double best = Double.NEGATIVE_INFINITY;
            int last = next;
            int bytes = 0;
            int bestBytes = 0;
            for (int i = next; i < stages.size(); i++) {
                bytes += stages.get(i).bytes();
                double perByte = (off - stages.get(i).off()) / bytes;
                if (perByte <= best) continue;
                best = perByte;
                bestBytes = bytes;
                last = i;
            }
            double then = stages.get(last).off();
            List<PreviewCoder.Wanted> together = stages.subList(next, last + 1).stream()
                    .map(PreviewLadder.Tried::stage)
                    .toList();
            steps.add(new TexturePlan.Step(together, bestBytes, off - then));
            off = then;
            next = last + 1;
        }
        return new TexturePlan(steps, off, painted.isShape());
    }
}
