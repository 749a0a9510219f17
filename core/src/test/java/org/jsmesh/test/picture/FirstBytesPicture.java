package org.jsmesh.test.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/**
 * Draws what the first hundredth of an archive's bytes shows, above the original. Arguments: the picture to write, then
 * models.
 */
public final class FirstBytesPicture {
    private static final int WIDTH = 200;
    private static final int HEIGHT = 170;
    private static final int TEXT = 34;

    private FirstBytesPicture() {}

    public static void main(String[] arguments) throws IOException, MalformedStreamException {
        int models = arguments.length - 1;
        BufferedImage picture = new BufferedImage(models * WIDTH, 2 * HEIGHT + TEXT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, picture.getWidth(), picture.getHeight());
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        for (int i = 0; i < models; i++) drawColumn(graphics, i * WIDTH, LevelPictures.read(Path.of(arguments[i + 1])));
        graphics.dispose();
        ImageIO.write(picture, "png", Path.of(arguments[0]).toFile());
    }

    private static void drawColumn(Graphics2D graphics, int left, Mesh mesh) throws MalformedStreamException {
        EncodedArchive archive = new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE);
        ArchiveDecoder decoder = new ArchiveDecoder();
        int first = archive.bytes().length / 100;
        decoder.feed(archive.bytes(), 0, first);
        View view = View.framing(mesh.bounds(), 35, 20, 40, 1.2, (double) WIDTH / HEIGHT);
        graphics.setColor(Color.DARK_GRAY);
        if (decoder.batches() == 0) {
            graphics.drawString("nothing", left + 8, 16);
        } else {
            graphics.drawString(first + " bytes: " + decoder.faces() + " faces", left + 8, 16);
            graphics.drawImage(LevelPictures.draw(decoder.mesh(), view, WIDTH, HEIGHT), left, TEXT, null);
        }
        graphics.drawString("of " + archive.bytes().length + ": " + mesh.faces(), left + 8, 31);
        graphics.drawImage(LevelPictures.draw(mesh, view, WIDTH, HEIGHT), left, TEXT + HEIGHT, null);
    }
}
