package org.jsmesh.poster;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.ClosedSurface;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.UpAxis;

/** Draws posters. Without state; the bytes depend on mesh, axis and pictures alone. */
public final class Poster {
    /** Pixels across. */
    public static final int WIDTH = 480;

    /** Pixels down. */
    public static final int HEIGHT = 360;

    /** No poster has more bytes. */
    public static final int MOST_BYTES = 8192;

    /** Bytes of a poster, unless it were too coarse. */
    private static final int USUAL_BYTES = 6144;

    /** On JPEG's scale of qualities: the finest of all, and the finest of those that have more bytes. */
    private static final int FINEST = 85;

    private static final int COARSE = 45;

    private Poster() {}

    /**
     * Draws the poster of a model.
     *
     * @param mesh with at least one face
     * @param up the axis that points up
     * @param pictures of the mesh's textures, those with equal bytes once
     * @return a JPEG file of at most {@value #MOST_BYTES} bytes
     */
    public static byte[] jpeg(Mesh mesh, UpAxis up, List<Picture> pictures) {
        Jpeg jpeg = new Jpeg(WIDTH, HEIGHT, pixels(mesh, up, pictures));
        boolean isCoarse = jpeg.file(COARSE).length > USUAL_BYTES;
        return isCoarse ? jpeg.within(MOST_BYTES, COARSE) : jpeg.within(USUAL_BYTES, FINEST);
    }

    static int[] pixels(Mesh mesh, UpAxis up, List<Picture> pictures) {
        return picture(mesh, mesh.bounds(), up, pictures, WIDTH, HEIGHT);
    }

    /**
     * Draws a mesh as its poster shows it, in any size. With the same bounds, several meshes are seen by one camera.
     *
     * @param mesh with at least one face
     * @param bounds of what the picture is to hold: smallest x, y, z, then largest x, y, z
     * @param up the axis that points up
     * @param pictures of the mesh's textures, those with equal bytes once
     * @param width pixels across
     * @param height pixels down
     * @return sRGB of each pixel, red from the third byte on, row by row from the top
     */
    public static int[] picture(Mesh mesh, float[] bounds, UpAxis up, List<Picture> pictures, int width, int height) {
        RenderMesh drawn = RenderMesh.of(mesh, CreaseAngle.cosine(mesh.faces(), 1, mesh.faces()));
        return Painter.paint(drawn, ClosedSurface.is(mesh), bounds, up, byPath(mesh, pictures), width, height);
    }

    /** Textures with equal bytes have one picture, under the path of the first. */
    private static Map<String, Picture> byPath(Mesh mesh, List<Picture> pictures) {
        Map<String, Picture> byPath = new HashMap<>();
        for (Picture picture : pictures) byPath.put(picture.path(), picture);
        Map<ByteBuffer, Picture> byBytes = new HashMap<>();
        for (Texture t : mesh.textures())
            if (byPath.containsKey(t.path())) byBytes.put(ByteBuffer.wrap(t.bytes()), byPath.get(t.path()));
        for (Texture t : mesh.textures()) {
            Picture picture = byBytes.get(ByteBuffer.wrap(t.bytes()));
            if (picture != null) byPath.put(t.path(), picture);
        }
        return byPath;
    }
}
