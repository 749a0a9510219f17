/** Model files in, archives and notes out: {@code org.jsmesh.files.ModelEncoding} is the one road. */
module org.jsmesh.encoder {
    requires transitive org.jsmesh.core;
    requires com.fasterxml.jackson.databind;
    requires static info.picocli;
    requires java.desktop;
    requires org.apache.commons.imaging;

    exports org.jsmesh.files;
    exports org.jsmesh.memory;
    exports org.jsmesh.objects;
    exports org.jsmesh.poster;

    uses org.jsmesh.objects.ObjectStoreProvider;

    opens org.jsmesh.files to
            com.fasterxml.jackson.databind;
}
