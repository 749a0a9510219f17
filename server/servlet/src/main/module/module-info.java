/** The HTTP resources of streaming meshes, a servlet under any path of its host. */
module org.jsmesh.servlet {
    requires transitive org.jsmesh.encoder;
    requires transitive jakarta.servlet;
    requires com.fasterxml.jackson.databind;
    requires jdk.management;

    exports org.jsmesh.page;
    exports org.jsmesh.sandbox;
    exports org.jsmesh.secret;
    exports org.jsmesh.servlet;
    exports org.jsmesh.site;
    exports org.jsmesh.store;
    exports org.jsmesh.store.bucket;
    exports org.jsmesh.upload;
    exports org.jsmesh.servlet.http to
            org.jsmesh.webapp;
}
