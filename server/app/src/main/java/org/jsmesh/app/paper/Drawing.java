package org.jsmesh.app.paper;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.jsmesh.files.ModelPictures;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.poster.Poster;

/** Pictures of meshes in rows and columns, drawn as posters are. */
final class Drawing {
    static final int WIDTH = 192;
    static final int HEIGHT = 144;

    /** The last two bits of a colour, which nobody sees, make most of the bytes of a picture. */
    private static final int SEEN = 0xfcfcfc;

    private static final int HALF = 0x020202;

    private final BufferedImage sheet;

    Drawing(int columns, int rows) {
        sheet = new BufferedImage(columns * WIDTH, rows * HEIGHT, BufferedImage.TYPE_INT_RGB);
    }

    /** Draws a mesh; a model has one camera, whatever is shown of it. */
    void draw(int column, int row, Mesh mesh, StandIn model) {
        int[] pixels = Poster.picture(mesh, model.mesh().bounds(), model.up(), ModelPictures.of(mesh), WIDTH, HEIGHT);
        for (int i = 0; i < pixels.length; i++) pixels[i] = pixels[i] & SEEN | HALF;
        sheet.setRGB(column * WIDTH, row * HEIGHT, WIDTH, HEIGHT, pixels, 0, WIDTH);
    }

    byte[] png() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        ImageWriteParam settings = writer.getDefaultWriteParam();
        settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        settings.setCompressionQuality(0); // the smallest file
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            writer.setOutput(out);
            writer.write(null, new IIOImage(sheet, null, null), settings);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    /** A figure: its picture, and what it shows. */
    record Figure(String name, String title, String text, List<String> header, List<List<String>> rows, byte[] png) {
        String markdown() {
            StringBuilder lines = new StringBuilder("# " + title + "\n\n" + PaperTable.wrapped(text) + "\n\n");
            lines.append("![").append(title).append("](").append(name).append(".png)\n\n");
            PaperTable table = new PaperTable(name, title, text, "", header, rows);
            return lines.append(table.grid()).toString();
        }
    }
}
