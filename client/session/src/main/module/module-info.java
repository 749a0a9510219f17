/** A streaming client without a window: fetches, measures, plans, decodes, resumes and keeps what came. */
module org.jsmesh.session {
    requires transitive org.jsmesh.core;
    requires java.net.http;
    requires com.fasterxml.jackson.databind;

    exports org.jsmesh.session;
}
