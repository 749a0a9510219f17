package org.jsmesh.encode.write;

import java.util.List;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.IndexCoder;
import org.jsmesh.archive.coding.PreviewStages;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Texture;

/**
 * Puts images and their previews where they do more for the picture per byte than anything else. Half an image shows
 * nothing, so the batches of one image follow each other.
 */
final class TextureBatches {
    private final List<Texture> textures;
    private final List<TexturePlan> plans;
    private final BatchList batches;
    private final Waiting[] previews;
    private int images; // put
    private long bytes;

    /** The stages of a texture's preview that are not in the archive yet. */
    private static final class Waiting {
        final PreviewCoder coder = new PreviewCoder();
        int stages; // put
        byte[] next; // coded, or null
    }

    /** @param plans one per texture, in their order; the images are put in this order */
    TextureBatches(List<Texture> textures, List<TexturePlan> plans, BatchList batches) {
        if (plans.size() != textures.size())
            throw new IllegalArgumentException(plans.size() + " plans for " + textures.size() + " textures");
        this.textures = textures;
        this.plans = plans;
        this.batches = batches;
        previews = new Waiting[textures.size()];
        for (int i = 0; i < previews.length; i++) previews[i] = new Waiting();
    }

    /** Bytes put so far. */
    long bytes() {
        return bytes;
    }

    /** Puts what gains at least so much per byte, the best first. Leaves out what gains nothing. */
    void putWorth(double gainPerByte) throws MalformedStreamException {
        while (images < textures.size()) {
            double best = perByte(plans.get(images).gain(), textures.get(images).bytes().length);
            int preview = -1;
            for (int i = images; i < previews.length; i++) {
                double worth = worthOfStage(i);
                if (worth <= best) continue;
                best = worth;
                preview = i;
            }
            if (best < gainPerByte || best <= 0) return;
            if (preview >= 0) putStage(preview);
            else putImage();
        }
    }

    /** Puts all images that are left. */
    void putAll() {
        while (images < textures.size()) putImage();
    }

    private static double perByte(double gain, int size) {
        return gain / (size + ArchiveLayout.CRC_BYTES);
    }

    private double worthOfStage(int texture) throws MalformedStreamException {
        Waiting w = previews[texture];
        List<TexturePlan.Stage> stages = plans.get(texture).stages();
        if (w.stages == stages.size()) return 0;
        TexturePlan.Stage stage = stages.get(w.stages);
        if (w.next == null) w.next = code(w.coder, texture, stage);
        // Keeps batches small in proportion to what came before them.
        if (w.next.length + ArchiveLayout.CRC_BYTES > IndexCoder.largest(batches.bytes())) return 0;
        return perByte(stage.gain(), w.next.length);
    }

    private static byte[] code(PreviewCoder coder, int texture, TexturePlan.Stage stage)
            throws MalformedStreamException {
        RangeEncoder stream = new RangeEncoder();
        PreviewStages.codeTexture(stream, texture);
        coder.codeStage(stream, stage.width(), stage.height(), stage.rgb());
        return stream.finish();
    }

    private void putStage(int texture) {
        Waiting w = previews[texture];
        bytes += w.next.length;
        batches.addWhole(BatchKind.PREVIEW, w.next);
        w.next = null;
        w.stages++;
    }

    private void putImage() {
        byte[] image = textures.get(images++).bytes();
        bytes += image.length;
        for (int at = 0; at < image.length; ) at = batches.addPortion(BatchKind.TEXTURE, image, at);
    }
}
