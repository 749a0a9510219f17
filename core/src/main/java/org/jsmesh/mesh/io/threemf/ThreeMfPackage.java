package org.jsmesh.mesh.io.threemf;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.zip.PackedException;
import org.jsmesh.mesh.io.zip.ZipArchive;

/**
 * A 3MF package (3MF Consortium, Core Specification 1.3; Open Packaging Conventions): a ZIP archive of parts, of which
 * one is the model. Names of parts do not depend on the case of their letters. Not thread-safe.
 */
public final class ThreeMfPackage {
    private static final String MODEL = ".model";
    private static final String USUAL_ROOT = "3d/3dmodel.model";
    private static final String RELATIONSHIPS = "_rels/.rels";
    private static final String MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

    private final ZipArchive zip;
    private final Map<String, String> names = new HashMap<>();
    private final Map<String, ModelPart> parts = new HashMap<>();
    private final Set<String> used = new HashSet<>();
    private final PackageNotes notes = new PackageNotes();

    private ThreeMfPackage(ZipArchive zip) {
        this.zip = zip;
        for (String name : zip.names()) names.putIfAbsent(lower(name), name);
    }

    /**
     * Tells 3MF from other archives.
     *
     * @param zip any archive
     * @return true when it has relationships and a model part
     */
    public static boolean isThreeMf(ZipArchive zip) {
        boolean related = false;
        boolean model = false;
        for (String name : zip.names()) {
            related |= lower(name).equals(RELATIONSHIPS);
            model |= lower(name).endsWith(MODEL);
        }
        return related && model;
    }

    /**
     * Reads the model.
     *
     * @param zip an archive
     * @param notes gets what the package says and the mesh does not
     * @return what its build items make
     * @throws ThreeMfException when it is no 3MF package or a damaged one, requires more than is known here, or makes
     *     more than is allowed
     * @throws PackedException when a part cannot be unpacked
     */
    public static ThreeMfMesh read(ZipArchive zip, List<Note> notes) throws ThreeMfException, PackedException {
        ThreeMfPackage all = new ThreeMfPackage(zip);
        ModelPart root = all.part(all.root());
        ExpansionLimits.check(all, root);
        ThreeMfMesh mesh = new Expansion(all, all.notes).build(root);
        for (String name : zip.names()) {
            String key = lower(name);
            boolean known = key.endsWith(".rels") || key.equals("[content_types].xml") || all.used.contains(key);
            if (!known) PackageNotes.keep(all.notes.parts, name);
        }
        for (ModelPart part : all.parts.values()) all.notes.unused += part.objects.size();
        all.notes.unused -= all.notes.usedObjects;
        all.notes.report(notes);
        return mesh;
    }

    private static String lower(String name) {
        return name.toLowerCase(Locale.ROOT);
    }

    private String root() throws ThreeMfException, PackedException {
        byte[] relationships = find(RELATIONSHIPS);
        if (relationships != null) {
            XmlPart xml = new XmlPart(RELATIONSHIPS, relationships);
            if (xml.next()) {
                while (xml.next()) {
                    if (MODEL_TYPE.equals(xml.attribute("Type")) && xml.attribute("Target") != null)
                        return PackagePaths.absolute("", xml.attribute("Target"));
                    xml.skip();
                }
            }
        }
        return USUAL_ROOT;
    }

    /** Parses a part, or finds it parsed. */
    ModelPart part(String path) throws ThreeMfException, PackedException {
        ModelPart part = parts.get(lower(path));
        if (part != null) return part;
        byte[] content = find(path);
        if (content == null)
            throw new ThreeMfException(path, "the package has no such model part", "Export the model as 3MF anew");
        part = ModelPartParser.parse(path, content, notes);
        parts.put(lower(path), part);
        return part;
    }

    /** The part that has the object of a reference. */
    ModelPart part(ModelPart from, ModelPart.Reference reference) throws ThreeMfException, PackedException {
        return reference.part() == null ? from : part(reference.part());
    }

    ModelPart.Item object(ModelPart part, ModelPart.Reference reference) throws ThreeMfException {
        ModelPart.Item item = part.objects.get(reference.object());
        if (item == null)
            throw new ThreeMfException(
                    part.path, "there is no object " + reference.object(), "Export the model as 3MF anew");
        return item;
    }

    /** Null when there is no such part. */
    byte[] find(String path) throws PackedException {
        String name = names.get(lower(path));
        if (name == null) return null;
        used.add(lower(path));
        return zip.find(name);
    }
}
