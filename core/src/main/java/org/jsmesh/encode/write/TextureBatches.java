package org.jsmesh.encode.write;

import java.util.List;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.PreviewStages;
import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.codec.PreviewModel;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Puts images and their previews where they do more for the picture per byte than anything else. Half an image shows
 * nothing, nor does half a stage of a preview, so the batches of one follow each other.
 */
final class TextureBatches {
    private final List<SharedImage> images;
    private final List<TexturePlan> plans;
    private final BatchList batches;
    private final PreviewCoder[] previews;
    private final int[] steps; // put, of each preview
    private int put; // images
    private long bytes;

    /** @param plans one per image, in their order; the images are put in this order */
    TextureBatches(List<SharedImage> images, List<TexturePlan> plans, BatchList batches) {
        if (plans.size() != images.size())
            throw new IllegalArgumentException(plans.size() + " plans for " + images.size() + " images");
        this.images = images;
        this.plans = plans;
        this.batches = batches;
        PreviewModel model = new PreviewModel();
        steps = new int[images.size()];
        previews = new PreviewCoder[images.size()];
        for (int i = 0; i < previews.length; i++) previews[i] = new PreviewCoder(model);
    }

    /** Bytes put so far. */
    long bytes() {
        return bytes;
    }

    /** Puts what gains at least so much per byte, the best first. Leaves out what gains nothing. */
    void putWorth(double gainPerByte) throws MalformedStreamException {
        while (put < images.size()) {
            double best = perByte(plans.get(put).gain(), images.get(put).bytes().length);
            int preview = -1;
            for (int i = put; i < previews.length; i++) {
                double worth = worthOfStep(i);
                if (worth <= best) continue;
                best = worth;
                preview = i;
            }
            if (best < gainPerByte || best <= 0) return;
            if (preview >= 0) putStep(preview);
            else putImage();
        }
    }

    /** Puts all images that are left. */
    void putAll() throws MalformedStreamException {
        while (put < images.size()) putImage();
    }

    private static double perByte(double gain, int size) {
        return gain / (size + ArchiveLayout.CRC_BYTES);
    }

    private double worthOfStep(int image) {
        if (steps[image] == plans.get(image).steps().size()) return 0;
        TexturePlan.Step step = plans.get(image).steps().get(steps[image]);
        return perByte(step.gain(), step.bytes());
    }

    private void putStep(int image) throws MalformedStreamException {
        for (PreviewCoder.Wanted stage :
                plans.get(image).steps().get(steps[image]).stages()) {
            do putPortion(image, stage);
            while (previews[image].isAmidStage());
        }
        steps[image]++;
    }

    private void putPortion(int image, PreviewCoder.Wanted stage) throws MalformedStreamException {
        RangeEncoder stream = new RangeEncoder();
        PreviewStages.codeImage(stream, image);
        int room = batches.cap() - ArchiveLayout.CRC_BYTES;
        // Nobody knows how large the next row becomes: there is room for twice the largest so far.
        int[] before = {stream.estimatedBytes()};
        int[] largest = {0};
        previews[image].codePortion(stream, stage, () -> {
            int size = stream.estimatedBytes();
            largest[0] = Math.max(largest[0], size - before[0]);
            before[0] = size;
            return size + 2 * largest[0] > room;
        });
        byte[] portion = stream.finish();
        bytes += portion.length;
        batches.addWhole(BatchKind.PREVIEW, portion);
    }

    private void putImage() throws MalformedStreamException {
        for (int i = put; i < previews.length; i++) while (plans.get(i).isShape() && worthOfStep(i) > 0) putStep(i);
        byte[] image = images.get(put++).bytes();
        bytes += image.length;
        for (int at = 0; at < image.length; ) at = batches.addPortion(BatchKind.TEXTURE, image, at);
    }
}
