package org.jsmesh.test.material;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Small OBJ files, one for each property of MTL that has a counterpart in glTF. */
public final class MtlModels {
    /** sRGB .5 in linear light. */
    private static final String HALF = ".21404";

    private static final String BOTH_SIDES = ",'doubleSided':true}";
    private static final String PLAIN =
            "{'pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':.5}" + BOTH_SIDES;

    private MtlModels() {}

    /** {@return every model of this class, in one order} */
    public static List<MaterialModel> all() {
        String surface = "{'pbrMetallicRoughness':{";
        String grey = surface + "'metallicFactor':0,'roughnessFactor':.5,'baseColorFactor':[" + HALF + "," + HALF + ","
                + HALF + ",1]}";
        return List.of(
                sphere(
                        "mtl-metal-and-roughness",
                        "Kd 1 .5 0\nPm .9\nPr .3",
                        surface + "'metallicFactor':.9,'roughnessFactor':.3,'baseColorFactor':[1," + HALF + ",0,1]}"
                                + BOTH_SIDES,
                        PLAIN),
                sphere(
                        "mtl-images-of-metal-and-roughness",
                        "Kd 0 0 0\nmap_Kd 0.png\nmap_Pm 1.png\nmap_Pr 1.png",
                        surface + "'baseColorTexture':{'index':0},'metallicRoughnessTexture':{'index':1}}" + BOTH_SIDES,
                        surface + "'baseColorTexture':{'index':0}}" + BOTH_SIDES,
                        TestImages.quarters(),
                        TestImages.greys()),
                sphere(
                        "mtl-image-of-light",
                        "Kd .5 .5 .5\nPr .5\nmap_Ke 0.png",
                        grey + ",'emissiveFactor':[1,1,1],'emissiveTexture':{'index':0}" + BOTH_SIDES,
                        grey + BOTH_SIDES,
                        TestImages.quarters()),
                sphere(
                        "mtl-normals",
                        "Kd .5 .5 .5\nPr .5\nnorm 0.png",
                        grey + ",'normalTexture':{'index':0}" + BOTH_SIDES,
                        grey + BOTH_SIDES,
                        TestImages.ridges()),
                sphere(
                        "mtl-bumps",
                        "Kd .5 .5 .5\nPr .5\nmap_Bump -bm 12 0.png",
                        grey + ",'extensions':{'EXT_materials_bump':{'bumpFactor':12,'bumpTexture':{'index':0}}}"
                                + BOTH_SIDES,
                        grey + BOTH_SIDES,
                        TestImages.waves()),
                sphere(
                        "mtl-placed-image",
                        "map_Kd -s 2 3 1 -o .25 .5 0 0.png\nPr .5",
                        surface + "'metallicFactor':0,'roughnessFactor':.5,'baseColorTexture':{'index':0,'extensions':"
                                + "{'KHR_texture_transform':{'scale':[2,3],'offset':[.25,-2.5]}}}}" + BOTH_SIDES,
                        surface + "'metallicFactor':0,'roughnessFactor':.5,'baseColorTexture':{'index':0}}"
                                + BOTH_SIDES,
                        TestImages.quarters()),
                sphere(
                        "mtl-glass",
                        "Kd .5 .5 .5\nPr .5\nd .5",
                        grey.replace(",1]}", ",.5]}") + ",'alphaMode':'BLEND'" + BOTH_SIDES,
                        grey + BOTH_SIDES));
    }

    private static MaterialModel sphere(String name, String mtl, String gltf, String without, byte[]... images) {
        Map<String, byte[]> files = new HashMap<>();
        String statements = mtl;
        for (int i = 0; i < images.length; i++) {
            String image = name + "-" + i + ".png";
            statements = statements.replace(" " + i + ".png", " " + image);
            files.put(image, images[i]);
        }
        files.put(name + ".mtl", text("newmtl m\n" + statements + "\n"));
        files.put(name + ".obj", text("mtllib " + name + ".mtl\nusemtl m\n" + obj(Shape.sphere())));
        return new MaterialModel(name, files, glb(gltf, images), glb(without, images));
    }

    private static byte[] glb(String material, byte[]... images) {
        return new GlbScene()
                .images(images)
                .material(material)
                .part(Shape.sphere(), 0)
                .bytes();
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static String obj(Shape shape) {
        StringBuilder obj = new StringBuilder();
        float[] p = shape.values("POSITION");
        float[] n = shape.values("NORMAL");
        float[] t = shape.values("TEXCOORD_0");
        for (int i = 0; i < shape.vertices(); i++) {
            obj.append(line("v %s %s %s", p[3 * i], p[3 * i + 1], p[3 * i + 2]));
            obj.append(line("vn %s %s %s", n[3 * i], n[3 * i + 1], n[3 * i + 2]));
            obj.append(line("vt %s %s", t[2 * i], 1 - t[2 * i + 1]));
        }
        int[] f = shape.indices();
        for (int i = 0; i < f.length; i += 3)
            obj.append(line("f %1$d/%1$d/%1$d %2$d/%2$d/%2$d %3$d/%3$d/%3$d", f[i] + 1, f[i + 1] + 1, f[i + 2] + 1));
        return obj.toString();
    }

    private static String line(String format, Object... values) {
        return String.format(Locale.ROOT, format, values) + "\n";
    }
}
