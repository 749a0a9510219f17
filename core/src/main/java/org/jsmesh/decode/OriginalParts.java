package org.jsmesh.decode;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.FaceChannelInfo;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.OrderCoder;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.codec.exact.RemainderCoder;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Texture;

/**
 * The parts of an original that are collected as bytes while batches arrive: images, what the codec does not know of
 * the mesh, and the order.
 */
final class OriginalParts {
    private final GrowingBytes image = new GrowingBytes(); // the first one that is not whole
    private final GrowingBytes remainder = new GrowingBytes();
    private final GrowingBytes order = new GrowingBytes();
    private final List<Texture> textures = new ArrayList<>();
    private int wholeImages; // among these textures
    private Mesh original; // once it is whole, if it is not what the coder shows

    /** Are batches of this kind parts of this sort? */
    static boolean hold(BatchKind kind) {
        return kind == BatchKind.TEXTURE || kind == BatchKind.REMAINDER || kind == BatchKind.ORDER;
    }

    /** @param known images of the archive */
    void take(BatchKind kind, List<ImageInfo> known, byte[] bytes, int offset, int length)
            throws MalformedStreamException {
        if (kind == BatchKind.TEXTURE) takeTexture(known, bytes, offset, length);
        else if (!(kind == BatchKind.REMAINDER ? remainder : order).take(bytes, offset, length))
            throw new MalformedStreamException(-1, "the batches of one kind are together larger than 2 GiB");
    }

    /** All images may be larger than an array can be, so each has one. What is behind the last image is no image. */
    private void takeTexture(List<ImageInfo> known, byte[] bytes, int offset, int length)
            throws MalformedStreamException {
        int at = offset;
        int end = offset + length;
        while (at < end && wholeImages < known.size()) {
            int count = Math.min(end - at, known.get(wholeImages).bytes() - image.length());
            if (!image.take(bytes, at, count)) throw new MalformedStreamException(-1, "an image is larger than 2 GiB");
            at += count;
            closeImages(known);
        }
    }

    private void closeImages(List<ImageInfo> known) {
        while (wholeImages < known.size()
                && image.length() == known.get(wholeImages).bytes()) {
            byte[] whole = image.drain();
            for (String path : known.get(wholeImages).paths()) textures.add(new Texture(path, whole));
            wholeImages++;
        }
    }

    /** Completes the mesh when all batches have come. */
    void finish(MeshCoder coder, NumberForms forms, ArchiveHeader header) throws MalformedStreamException {
        if (forms.isPlain() && header.faceChannels().isEmpty()) return;
        List<FaceChannel> kinds = new ArrayList<>();
        for (FaceChannelInfo c : header.faceChannels())
            kinds.add(new FaceChannel(c.name(), c.components(), c.type(), new int[0], List.of()));
        RangeDecoder stream = new RangeDecoder(remainder.bytes(), 0, remainder.length());
        Mesh coded = coder.snapshot(header.materials(), List.of(), List.of());
        Mesh read = RemainderCoder.read(stream, forms, coded, kinds);
        if (remainder.length() > 0 && stream.isExhausted())
            throw new MalformedStreamException(-1, "the last bits end early");
        original = read;
    }

    /** The whole mesh without images; null before it is whole, or when the coder's own mesh is the original. */
    Mesh original() {
        return original;
    }

    /** The images that have arrived whole, each under all its paths. Those of one image share its bytes. */
    List<Texture> textures(List<ImageInfo> known) {
        closeImages(known); // an empty one needs no bytes
        return List.copyOf(textures);
    }

    /** How many images those textures are. */
    int wholeImages() {
        return wholeImages;
    }

    /** The mesh in its original order, where that has come. */
    Mesh inOrder(Mesh mesh) throws MalformedStreamException {
        if (order.length() == 0) return mesh;
        return OrderCoder.read(new RangeDecoder(order.bytes(), 0, order.length()), mesh, order.length());
    }
}
