package org.jsmesh.test.material;

import java.util.List;

/**
 * Small models, one for each extension of glTF's materials that changes how a surface reflects or lets through light.
 */
public final class ExtensionModels {
    private static final String COLOUR = "'baseColorFactor':[.8,.3,.1,1]";
    private static final String DARK =
            "{'pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':%s," + "'baseColorFactor':[.02,.02,.04,1]}";
    private static final String GLASS = "{'pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':.1}";

    private static final Shape BALL = Shape.sphere().withTangentsDown();

    private ExtensionModels() {}

    /** {@return every model of this class, in one order} */
    public static List<MaterialModel> all() {
        return List.of(
                sphere("clearcoat", DARK.formatted("1"), "'KHR_materials_clearcoat':{'clearcoatFactor':1}"),
                sphere(
                        "clearcoat-textures",
                        DARK.formatted("1"),
                        "'KHR_materials_clearcoat':{'clearcoatFactor':1,'clearcoatTexture':{'index':0},"
                                + "'clearcoatRoughnessFactor':.2,'clearcoatNormalTexture':{'index':1}}",
                        TestImages.gradient(255, 60, 0, 0, 0, 0),
                        TestImages.ridges()),
                sphere(
                        "sheen",
                        DARK.formatted("1"),
                        "'KHR_materials_sheen':{'sheenColorFactor':[.9,.3,.6],'sheenRoughnessFactor':.5}"),
                before("transmission", GLASS, "'KHR_materials_transmission':{'transmissionFactor':.9}"),
                before(
                        "volume",
                        GLASS,
                        "'KHR_materials_transmission':{'transmissionFactor':1},'KHR_materials_ior':{'ior':1.3},"
                                + "'KHR_materials_volume':{'thicknessFactor':1,'attenuationDistance':.6,"
                                + "'attenuationColor':[.2,.8,.4]}"),
                before(
                        "dispersion",
                        GLASS,
                        "'KHR_materials_transmission':{'transmissionFactor':1},'KHR_materials_ior':{'ior':1.6},"
                                + "'KHR_materials_volume':{'thicknessFactor':1},"
                                + "'KHR_materials_dispersion':{'dispersion':5}"),
                sphere("ior", DARK.formatted(".2"), "'KHR_materials_ior':{'ior':2.4}"),
                sphere(
                        "specular",
                        DARK.formatted(".3"),
                        "'KHR_materials_ior':{'ior':2.2},'KHR_materials_specular':{'specularFactor':.9,"
                                + "'specularColorFactor':[.2,.4,1],'specularColorTexture':{'index':0}}",
                        TestImages.quarters()),
                sphere(
                        "iridescence",
                        "{'pbrMetallicRoughness':{'metallicFactor':1,'roughnessFactor':.3,'baseColorFactor':[.3,.3,.3,1]}",
                        "'KHR_materials_iridescence':{'iridescenceFactor':1,'iridescenceIor':1.8,"
                                + "'iridescenceThicknessMaximum':500,'iridescenceThicknessTexture':{'index':0}}",
                        TestImages.gradient(0, 0, 0, 255, 0, 0)),
                sphere(
                        "anisotropy",
                        "{'pbrMetallicRoughness':{" + COLOUR + ",'metallicFactor':1,'roughnessFactor':.4}",
                        "'KHR_materials_anisotropy':{'anisotropyStrength':.9,'anisotropyRotation':1}"),
                specularGlossiness());
    }

    private static MaterialModel sphere(String name, String material, String extensions, byte[]... images) {
        return new MaterialModel(
                name,
                new GlbScene()
                        .images(images)
                        .material(extended(material, extensions))
                        .part(BALL, 0),
                new GlbScene().images(images).material(material + "}").part(BALL, 0));
    }

    /** A ball before bands that it bends. */
    private static MaterialModel before(String name, String material, String extensions) {
        return new MaterialModel(name, before(extended(material, extensions)), before(material + "}"));
    }

    private static GlbScene before(String material) {
        return new GlbScene()
                .images(TestImages.bands())
                .material(material)
                .material("{'pbrMetallicRoughness':{'metallicFactor':0,'baseColorTexture':{'index':0}}}")
                .part(Shape.sphere(), 0)
                .part(Shape.rectangle(-1.5f, -1.5f, 1.5f, 1.5f, -1.2f), 1);
    }

    private static String extended(String material, String extensions) {
        return material + ",'extensions':{" + extensions + "}}";
    }

    /** Drawn by the reference as the same surface in other words, as three.js no longer knows this extension. */
    private static MaterialModel specularGlossiness() {
        String old = "{'extensions':{'KHR_materials_pbrSpecularGlossiness':{'diffuseFactor':[.8,.3,.1,1],"
                + "'specularFactor':[.2,.4,.1],'glossinessFactor':.7,'diffuseTexture':{'index':0}}}}";
        String converted = "{'pbrMetallicRoughness':{" + COLOUR + ",'metallicFactor':0,'roughnessFactor':.3,"
                + "'baseColorTexture':{'index':0}},'extensions':{'KHR_materials_ior':{'ior':1000},"
                + "'KHR_materials_specular':{'specularColorFactor':[.2,.4,.1]}}}";
        return new MaterialModel(
                "specular-glossiness", glb(old), glb(converted), glb("{'pbrMetallicRoughness':{'metallicFactor':0}}"));
    }

    private static GlbScene glb(String material) {
        return new GlbScene().images(TestImages.quarters()).material(material).part(Shape.sphere(), 0);
    }
}
