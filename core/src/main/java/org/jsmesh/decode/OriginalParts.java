package org.jsmesh.decode;

import java.util.ArrayList;
import java.util.Arrays;
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
    private final GrowingBytes images = new GrowingBytes();
    private final GrowingBytes remainder = new GrowingBytes();
    private final GrowingBytes order = new GrowingBytes();
    private final List<Texture> textures = new ArrayList<>();
    private int wholeImages; // among these textures
    private int wholeBytes; // of these images
    private Mesh original; // once it is whole, if it is not what the coder shows

    /** Are batches of this kind parts of this sort? */
    static boolean hold(BatchKind kind) {
        return kind == BatchKind.TEXTURE || kind == BatchKind.REMAINDER || kind == BatchKind.ORDER;
    }

    void take(BatchKind kind, byte[] bytes, int offset, int length) {
        GrowingBytes part = kind == BatchKind.TEXTURE ? images : kind == BatchKind.REMAINDER ? remainder : order;
        part.take(bytes, offset, length);
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
        while (wholeImages < known.size() && known.get(wholeImages).bytes() <= images.length() - wholeBytes) {
            ImageInfo image = known.get(wholeImages++);
            byte[] bytes = Arrays.copyOfRange(images.bytes(), wholeBytes, wholeBytes + image.bytes());
            wholeBytes += image.bytes();
            for (String path : image.paths()) textures.add(new Texture(path, bytes));
        }
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
