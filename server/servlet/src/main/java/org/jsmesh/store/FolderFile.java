package org.jsmesh.store;

import org.jsmesh.store.ids.ModelPath;

/** A file of the folder that is a model, or the source of an archive that stands for it. */
final class FolderFile {
    final String place;
    long bytes;
    long modifiedSeconds;

    /** Null while an archive stands for it. */
    volatile ModelEntry entry;

    FolderFile(String place) {
        this.place = place;
    }

    /** Made anew each time: it takes more memory than everything else that is known of a file. */
    ModelPath path() {
        return ModelPath.of(place);
    }
}
