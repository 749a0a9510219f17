package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.jsmesh.desktop.gpu.GpuSamplers;
import org.jsmesh.desktop.gpu.ShaderProgram;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.LiveStep;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.display.Slot;
import org.jsmesh.display.TextureUse;
import org.jsmesh.studio.Lighting;
import org.jsmesh.studio.LinearColour;
import org.jsmesh.studio.Opacity;

/** What the shader is told of a material, and the images that it needs. Used on the thread that holds the context. */
final class Surface {
    /** Texture units from here on are free. */
    static final int UNITS = Slot.values().length;

    private static final String[] IMAGES = elements("images", UNITS);
    private static final String[] SHOWN = elements("shown", UNITS);
    private static final String[] SETS = elements("sets", UNITS);
    private static final String[] CHANNELS = elements("channels", UNITS);
    private static final String[] FACTORS = elements("factors", UNITS);
    private static final String[] ROWS = elements("rows", 2 * UNITS);
    private static final int ALPHA = 3;
    private static final int NEVER = -1;
    private static final List<Float> NO_COAT = List.of(0f, 0f);

    private final GpuTextures colours = GpuTextures.ofColours();
    private final GpuTextures numbers = GpuTextures.ofNumbers();
    private final GpuTextures masks = GpuTextures.ofNumbers();
    private final GpuSamplers samplers = new GpuSamplers();
    private ShownScene scene;
    private Map<String, TextureImage> images;

    /** Brings the images of a scene to the graphics card that are not there yet. */
    void upload(GL3 gl, ShownScene next) {
        scene = next;
        if (images == scene.images) return;
        images = scene.images;
        Map<String, TextureImage> ofColours = new HashMap<>();
        Map<String, TextureImage> ofNumbers = new HashMap<>();
        for (DisplayMaterial material : scene.slots.materials()) {
            material.textures().forEach((slot, use) -> {
                TextureImage image = images.get(use.path());
                if (image != null) (isColour(slot) ? ofColours : ofNumbers).put(use.path(), image);
            });
        }
        colours.upload(gl, ofColours);
        numbers.upload(gl, ofNumbers);
        masks.upload(gl, scene.masks);
    }

    private static boolean isColour(Slot slot) {
        return slot == Slot.COLOUR || slot == Slot.EMISSION;
    }

    /** Whether what is behind the surface shines through somewhere. */
    boolean isTranslucent(DisplayMaterial material) {
        return !material.isOpaque() || has(material, Opacity.GLASS);
    }

    /** Whether nothing behind the surface is seen through it. */
    boolean isSolid(DisplayMaterial material) {
        return !isTranslucent(material)
                && material.alpha() != DisplayMaterial.Alpha.MASK
                && !has(material, Opacity.HOLES);
    }

    /** Whether an image of a material that leaves it to its images has opacity of this kind. */
    private boolean has(DisplayMaterial material, Opacity opacity) {
        return material.alpha() == DisplayMaterial.Alpha.BY_IMAGE
                && (isShown(material.textures().get(Slot.COLOUR))
                                && colours.opacity(material.image(Slot.COLOUR)) == opacity
                        || isShown(material.textures().get(Slot.OPACITY))
                                && masks.opacity(material.image(Slot.OPACITY)) == opacity);
    }

    private boolean isShown(TextureUse use) {
        return use != null && use.set() < RenderMesh.SETS && scene.arrays.has(LiveStep.FIRST_SET + use.set());
    }

    void set(GL3 gl, ShaderProgram program, DisplayMaterial material) {
        boolean textured = false;
        for (Slot slot : Slot.values()) {
            boolean shown = set(gl, program, slot, material.textures().get(slot));
            if (slot == Slot.COLOUR) textured = shown;
        }
        float[] surface = LinearColour.of(material, textured);
        program.set(gl, "surface", surface);
        program.set(gl, "emission", LinearColour.emission(material));
        program.set(gl, "metallic", Math.max(0, material.metallic()));
        program.set(gl, "roughness", material.roughness() < 0 ? Lighting.PLAIN_ROUGHNESS : material.roughness());
        float[] reflectance = new float[4];
        for (int k = 0; k < 4; k++) reflectance[k] = material.reflectance().get(k);
        program.set(gl, "reflectance", reflectance);
        List<Float> coat = material.coat() == null ? NO_COAT : material.coat();
        program.set(gl, "coat", coat.get(0), coat.get(1));
        program.set(gl, "unlit", material.unlit());
        program.set(gl, "blended", isTranslucent(material));
        boolean byImage = material.alpha() == DisplayMaterial.Alpha.BY_IMAGE;
        program.set(gl, "imageOpacity", !byImage || colours.opacity(material.image(Slot.COLOUR)) != Opacity.OPAQUE);
        float cutoff = NEVER;
        if (material.alpha() == DisplayMaterial.Alpha.MASK) cutoff = material.cutoff();
        if (has(material, Opacity.HOLES)) cutoff = material.cutoff() * surface[ALPHA];
        program.set(gl, "cutoff", cutoff);
    }

    private boolean set(GL3 gl, ShaderProgram program, Slot slot, TextureUse use) {
        int unit = slot.ordinal();
        boolean shown = isShown(use) && bind(gl, slot, use);
        program.set(gl, SHOWN[unit], shown);
        if (!shown) return false;
        program.set(gl, SETS[unit], use.set());
        program.set(gl, CHANNELS[unit], slot == Slot.OPACITY ? ALPHA : use.channel());
        program.set(gl, FACTORS[unit], use.factor());
        for (int row = 0; row < 2; row++) {
            float[] t = new float[3];
            for (int k = 0; k < 3; k++) t[k] = use.transform().get(3 * row + k);
            program.set(gl, ROWS[2 * unit + row], t);
        }
        return true;
    }

    private boolean bind(GL3 gl, Slot slot, TextureUse use) {
        GpuTextures textures = slot == Slot.OPACITY ? masks : isColour(slot) ? colours : numbers;
        gl.glActiveTexture(GL.GL_TEXTURE0 + slot.ordinal());
        boolean there = textures.bind(gl, use.path());
        samplers.bind(gl, slot.ordinal(), use.sampler());
        gl.glActiveTexture(GL.GL_TEXTURE0);
        return there;
    }

    private static String[] elements(String array, int count) {
        return IntStream.range(0, count).mapToObj(i -> array + "[" + i + "]").toArray(String[]::new);
    }

    /** Samplers of two kinds must not read from one unit, also where no image is shown. */
    static void giveUnits(GL3 gl, ShaderProgram program) {
        for (int unit = 0; unit < UNITS; unit++) program.set(gl, IMAGES[unit], unit);
    }

    /** Leaves no texture and no sampler bound. */
    static void unbind(GL3 gl) {
        for (int unit = UNITS - 1; unit >= 0; unit--) {
            gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
            gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
            gl.glBindSampler(unit, 0);
        }
    }

    void dispose(GL3 gl) {
        colours.dispose(gl);
        numbers.dispose(gl);
        masks.dispose(gl);
        samplers.dispose(gl);
    }
}
