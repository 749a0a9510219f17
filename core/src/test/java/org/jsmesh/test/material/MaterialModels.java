package org.jsmesh.test.material;

import java.util.ArrayList;
import java.util.List;

/** Small models, one for each property of materials that glTF has without extensions, or with those of all viewers. */
public final class MaterialModels {
    private static final String COLOUR = "'baseColorFactor':[.8,.3,.1,1]";
    private static final String TEXTURED =
            "{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorTexture':{'index':0}}}";
    private static final String PLAIN = "{'pbrMetallicRoughness':{'metallicFactor':0}}";

    private MaterialModels() {}

    /** {@return every model of this class, in one order} */
    public static List<MaterialModel> all() {
        List<MaterialModel> all = new ArrayList<>();
        all.addAll(surfaces());
        all.addAll(light());
        all.addAll(opacities());
        all.addAll(sides());
        all.addAll(placed());
        all.addAll(vertexColours());
        return all;
    }

    private static MaterialModel onSphere(String name, String with, String without, byte[]... images) {
        return on(Shape.sphere(), name, with, without, images);
    }

    private static MaterialModel on(Shape shape, String name, String with, String without, byte[]... images) {
        return new MaterialModel(name, scene(shape, with, images), scene(shape, without, images));
    }

    private static GlbScene scene(Shape shape, String material, byte[]... images) {
        return new GlbScene().images(images).material(material).part(shape, 0);
    }

    private static String dielectric(String more) {
        return "{'pbrMetallicRoughness':{'metallicFactor':0," + COLOUR + "}" + more + "}";
    }

    private static List<MaterialModel> surfaces() {
        String metalRough = "{'pbrMetallicRoughness':{" + COLOUR + ",'metallicFactor':.9,'roughnessFactor':.8,"
                + "'metallicRoughnessTexture':{'index':0}}}";
        String normal = dielectric(",'normalTexture':{'index':0}");
        Shape tangents = Shape.sphere().withTangentsDown();
        return List.of(
                onSphere("base-colour-factor", dielectric(""), PLAIN),
                onSphere("base-colour-texture", TEXTURED, PLAIN, TestImages.quarters()),
                onSphere(
                        "base-colour-both",
                        "{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorTexture':{'index':0}," + COLOUR + "}}",
                        TEXTURED,
                        TestImages.quarters()),
                onSphere("no-factors", "{}", PLAIN),
                onSphere(
                        "metal-rough-factors",
                        "{'pbrMetallicRoughness':{" + COLOUR + ",'metallicFactor':.9,'roughnessFactor':.25}}",
                        dielectric("")),
                onSphere(
                        "metal-rough-texture",
                        metalRough,
                        metalRough.replace(",'metallicRoughnessTexture':{'index':0}", ""),
                        TestImages.gradient(0, 0, 0, 255, 0, 255)),
                onSphere("normal", normal, dielectric(""), TestImages.ridges()),
                onSphere(
                        "normal-scale",
                        dielectric(",'normalTexture':{'index':0,'scale':-.5}"),
                        normal,
                        TestImages.ridges()),
                new MaterialModel(
                        "normal-tangents",
                        scene(tangents, normal, TestImages.ridges()),
                        scene(Shape.sphere(), normal, TestImages.ridges())),
                new MaterialModel(
                        "normal-tangents-of-some", twoSpheres(normal, tangents), twoSpheres(dielectric(""), tangents)));
    }

    /** Two balls with a material each, of which the first alone has tangents. */
    private static GlbScene twoSpheres(String material, Shape tangents) {
        Shape moved = Shape.sphere();
        float[] positions = moved.values("POSITION").clone();
        for (int i = 0; i < positions.length; i += 3) positions[i] += 2.1f;
        return scene(tangents, material, TestImages.ridges())
                .material(material.replace("[.8,.3,.1,1]", "[.8,.6,.1,1]"))
                .part(moved.with("POSITION", 3, positions), 1);
    }

    private static List<MaterialModel> light() {
        String glow = "{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorFactor':[.1,.1,.1,1]}";
        String occlusion = "{'pbrMetallicRoughness':{'metallicFactor':0},'occlusionTexture':{'index':0";
        String strong = glow + ",'emissiveFactor':[.1,.25,.05],'extensions':"
                + "{'KHR_materials_emissive_strength':{'emissiveStrength':3}}}";
        return List.of(
                onSphere("occlusion", occlusion + "}}", PLAIN, TestImages.bands()),
                onSphere("occlusion-strength", occlusion + ",'strength':.4}}", occlusion + "}}", TestImages.bands()),
                onSphere("emissive-factor", glow + ",'emissiveFactor':[.1,.5,.2]}", glow + "}"),
                onSphere(
                        "emissive-texture",
                        glow + ",'emissiveFactor':[1,.5,1],'emissiveTexture':{'index':0}}",
                        glow + ",'emissiveFactor':[1,.5,1]}",
                        TestImages.quarters()),
                onSphere("emissive-strength", strong, strong.replace("'emissiveStrength':3", "'emissiveStrength':1")),
                onSphere(
                        "unlit",
                        TEXTURED.replaceFirst("}$", ",'extensions':{'KHR_materials_unlit':{}}}"),
                        TEXTURED,
                        TestImages.quarters()));
    }

    private static MaterialModel before(String name, String with, String without, byte[]... images) {
        return new MaterialModel(name, before(with, images), before(without, images));
    }

    /** A square before bands that show through it. */
    private static GlbScene before(String material, byte[]... images) {
        String back =
                "{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorTexture':{'index':" + images.length + "}}}";
        return new GlbScene()
                .images(images)
                .images(TestImages.bands())
                .material(material)
                .material(back)
                .part(Shape.square(), 0)
                .part(Shape.rectangle(-.8f, -.8f, .8f, .8f, -.3f), 1);
    }

    private static List<MaterialModel> opacities() {
        String opaque = TEXTURED.replaceFirst("}$", "");
        String half = "{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorFactor':[.8,.3,.1,.5]}";
        byte[] columns = TestImages.columns(90, 160);
        return List.of(
                before("mask", opaque + ",'alphaMode':'MASK'}", opaque + "}", columns),
                before(
                        "mask-cutoff",
                        opaque + ",'alphaMode':'MASK','alphaCutoff':.8}",
                        opaque + ",'alphaMode':'MASK'}",
                        TestImages.columns(160, 230)),
                before("blend-texture", opaque + ",'alphaMode':'BLEND'}", opaque + "}", TestImages.columns(0, 200)),
                before("blend-factor", half + ",'alphaMode':'BLEND'}", half + "}"),
                before("opaque-alpha", opaque + "}", opaque + ",'alphaMode':'BLEND'}", TestImages.columns(0, 128)),
                before("opaque-factor", half + "}", half + ",'alphaMode':'BLEND'}"),
                new MaterialModel("blend-order", glasses("BLEND"), glasses("OPAQUE")),
                new MaterialModel("blend-order-of-one", colouredGlasses("BLEND"), colouredGlasses("OPAQUE")));
    }

    private static final float[][] GLASS = {{1, .1f, .1f, .6f}, {.1f, 1, .1f, .6f}, {.1f, .1f, 1, .6f}};

    /** Three panes, the foremost first. */
    private static GlbScene glasses(String alphaMode) {
        GlbScene scene = new GlbScene();
        for (int i = 0; i < GLASS.length; i++) {
            float[] c = GLASS[i];
            scene.material("{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorFactor':"
                    + List.of(c[0], c[1], c[2], c[3]) + "},'alphaMode':'" + alphaMode + "','doubleSided':true}");
            scene.part(Shape.rectangle(-1, -1, 1, 1, .4f - .4f * i), i);
        }
        return scene;
    }

    /** Three panes of one material, coloured by their vertices. */
    private static GlbScene colouredGlasses(String alphaMode) {
        GlbScene scene = new GlbScene()
                .material(dielectric(",'alphaMode':'" + alphaMode + "','doubleSided':true")
                        .replace(COLOUR, "'baseColorFactor':[1,1,1,1]"));
        for (int i = 0; i < GLASS.length; i++)
            scene.part(Shape.rectangle(-1, -1, 1, 1, .4f - .4f * i).everywhere("COLOR_0", GLASS[i]), 0);
        return scene;
    }

    private static List<MaterialModel> sides() {
        String two = dielectric(",'doubleSided':true");
        return List.of(
                new MaterialModel("single-sided", frontAndBack(dielectric("")), frontAndBack(two)),
                new MaterialModel("double-sided", frontAndBack(two), frontAndBack(dielectric(""))));
    }

    private static GlbScene frontAndBack(String material) {
        return scene(Shape.rectangle(-1, -.7f, -.05f, .7f, 0), material)
                .part(Shape.rectangle(.05f, -.7f, 1, .7f, 0).turned(), 0);
    }

    private static MaterialModel sampled(String name, String sampler, float factor, byte[] image) {
        Shape shape = Shape.square().repeated("TEXCOORD_0", factor);
        return new MaterialModel(name, scene(shape, TEXTURED, image).sampler(sampler), scene(shape, TEXTURED, image));
    }

    private static List<MaterialModel> placed() {
        Shape second = Shape.square().repeated("TEXCOORD_1", 1).repeated("TEXCOORD_0", .3f);
        String other = TEXTURED.replace("'index':0", "'index':0,'texCoord':1");
        // glTF scales before it turns, three.js after that: what is turned has one scale.
        String transform = "'extensions':{'KHR_texture_transform':{'offset':[.2,.1],'rotation':.6,'scale':[1.4,1.4]}}";
        String turned = TEXTURED.replace("'index':0", "'index':0," + transform);
        String two = "{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorTexture':{'index':0," + transform
                + "}},'emissiveFactor':[.6,.6,.6],'emissiveTexture':{'index':1,'extensions':"
                + "{'KHR_texture_transform':{'scale':[2,1.5],'texCoord':1}}}}";
        return List.of(
                sampled("clamp", "{'wrapS':33071,'wrapT':33071}", 2, TestImages.quarters()),
                sampled("mirror", "{'wrapS':33648,'wrapT':33071}", 3, TestImages.quarters()),
                sampled("nearest", "{'magFilter':9728,'minFilter':9728}", 1, TestImages.fewPixels()),
                on(second, "second-coordinates", other, TEXTURED, TestImages.quarters()),
                on(Shape.square(), "transform", turned, TEXTURED, TestImages.quarters()),
                on(
                        second,
                        "transforms-of-two",
                        two,
                        two.replace("'scale':[2,1.5],'texCoord':1", "'scale':[2,1.5]"),
                        TestImages.quarters(),
                        TestImages.fewPixels()));
    }

    private static List<MaterialModel> vertexColours() {
        float[] rgb = {.2f, .02f, .02f, .02f, .2f, .02f, .02f, .02f, .2f, .2f, .2f, .02f};
        float[] rgba = {1, .1f, .1f, 1, .1f, 1, .1f, 1, .1f, .1f, 1, .1f, 1, 1, .1f, .1f};
        GlbScene plain = scene(Shape.square(), PLAIN);
        String blend = PLAIN.replaceFirst("}$", ",'alphaMode':'BLEND'}");
        return List.of(
                new MaterialModel("vertex-colours", scene(Shape.square().with("COLOR_0", 3, rgb), PLAIN), plain),
                new MaterialModel(
                        "vertex-colours-short", scene(Shape.square().withShorts("COLOR_0", 3, rgb), PLAIN), plain),
                new MaterialModel(
                        "vertex-opacity",
                        scene(Shape.square().withShorts("COLOR_0", 4, rgba), blend),
                        scene(Shape.square().withShorts("COLOR_0", 4, rgba), PLAIN)));
    }
}
