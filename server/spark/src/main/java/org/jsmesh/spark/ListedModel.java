package org.jsmesh.spark;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.io.Serializable;
import java.time.Instant;
import org.jsmesh.objects.StoredObject;

/**
 * A model file as it was when its store was listed.
 *
 * @param store address of the store
 * @param key of the file in it
 * @param place path among the models of the catalogue, which its id is made of
 * @param bytes of the file
 * @param tag of its version; empty when only its address is known
 * @param modified when that was written; {@link Instant#EPOCH} when that is not known
 */
record ListedModel(String store, String key, String place, long bytes, String tag, Instant modified)
        implements Serializable {
    private static final long serialVersionUID = 1;

    /** {@return its address for people} */
    String input() {
        return store + (store.endsWith("/") ? "" : "/") + key;
    }

    /** {@return the folder of the file in its store: empty, or with a slash at its end} */
    String folder() {
        return key.substring(0, key.lastIndexOf('/') + 1);
    }

    /** {@return the name of the file without folders} */
    String fileName() {
        return key.substring(key.lastIndexOf('/') + 1);
    }

    /** {@return the same file as it is now} */
    ListedModel at(StoredObject now) {
        return new ListedModel(store, key, place, now.bytes(), now.tag(), now.modified());
    }

    /** {@return the version in its store} */
    StoredObject version() {
        return new StoredObject(key, bytes, tag, modified);
    }

    /** {@return whether both are one version of one file in one place} */
    boolean isSameAs(ListedModel other) {
        return store.equals(other.store)
                && key.equals(other.key)
                && place.equals(other.place)
                && bytes == other.bytes
                && tag.equals(other.tag);
    }

    void write(DataOutput out) throws IOException {
        out.writeUTF(store);
        out.writeUTF(key);
        out.writeUTF(place);
        out.writeLong(bytes);
        out.writeUTF(tag);
        out.writeLong(modified.getEpochSecond());
        out.writeInt(modified.getNano());
    }

    static ListedModel read(DataInput in) throws IOException {
        return new ListedModel(
                in.readUTF(),
                in.readUTF(),
                in.readUTF(),
                in.readLong(),
                in.readUTF(),
                Instant.ofEpochSecond(in.readLong(), in.readInt()));
    }
}
