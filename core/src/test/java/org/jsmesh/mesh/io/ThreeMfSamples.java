package org.jsmesh.mesh.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** Small 3MF packages. */
final class ThreeMfSamples {
    static final String CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
    static final String MATERIALS = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
    static final String PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

    /** A triangle (0,0,0) (1,0,0) (0,1,0). */
    static final String TRIANGLE = mesh("<triangle v1='0' v2='1' v3='2'/>");

    private static final String RELATIONSHIPS =
            "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'><Relationship Id='r'"
                    + " Target='/3D/3dmodel.model' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/>"
                    + "</Relationships>";

    private ThreeMfSamples() {}

    static String mesh(String triangles) {
        return "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/>"
                + "</vertices><triangles>" + triangles + "</triangles></mesh>";
    }

    static String object(int id, String content) {
        return "<object id='" + id + "' type='model'>" + content + "</object>";
    }

    static String model(String attributes, String resources, String build) {
        return "<?xml version='1.0' encoding='UTF-8'?>\n<model xmlns='" + CORE + "' xmlns:m='" + MATERIALS
                + "' xmlns:p='" + PRODUCTION + "' " + attributes + "><resources>" + resources + "</resources><build>"
                + build + "</build></model>";
    }

    static byte[] file(String model, String... namesAndTexts) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            add(zip, "[Content_Types].xml", "<Types/>");
            add(zip, "_rels/.rels", RELATIONSHIPS);
            if (model != null) add(zip, "3D/3dmodel.model", model);
            for (int i = 0; i < namesAndTexts.length; i += 2) add(zip, namesAndTexts[i], namesAndTexts[i + 1]);
        }
        return out.toByteArray();
    }

    private static void add(ZipOutputStream zip, String name, String text) throws IOException {
        zip.putNextEntry(new ZipEntry(name));
        zip.write(text.getBytes(StandardCharsets.UTF_8));
    }
}
