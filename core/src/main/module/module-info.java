/**
 * Meshes, simplification, codec, archives, planner: the core of jSM, without any dependency.
 *
 * <p>Begin with {@code org.jsmesh.encode.MeshEncoder} for a mesh in and an archive out, with
 * {@code org.jsmesh.decode.ArchiveDecoder} for the way back, and with {@code org.jsmesh.mesh.io} for model files.
 */
module org.jsmesh.core {
    requires java.xml;

    exports org.jsmesh.archive;
    exports org.jsmesh.decode;
    exports org.jsmesh.display;
    exports org.jsmesh.encode;
    exports org.jsmesh.mesh;
    exports org.jsmesh.mesh.io;
    exports org.jsmesh.plan;
    exports org.jsmesh.simulation;
    exports org.jsmesh.studio to
            org.jsmesh.encoder;
    exports org.jsmesh.mesh.io.zip to
            org.jsmesh.encoder;
    exports org.jsmesh.lock to
            org.jsmesh.encoder,
            org.jsmesh.session,
            org.jsmesh.servlet;
}
