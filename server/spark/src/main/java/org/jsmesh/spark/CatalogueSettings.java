package org.jsmesh.spark;

import java.io.Serializable;
import java.util.List;
import org.jsmesh.encode.EncoderSettings;

/**
 * What a run is to do.
 *
 * @param inputs addresses of folders and stores of model files, and of single files
 * @param lists files with an address a line
 * @param site address of the site
 * @param report address of the report
 * @param publicUrl where visitors find the site, with a slash at its end; null when that is not known
 * @param prune whether models go that are not among the inputs
 * @param encoder how to encode, with one thread
 */
record CatalogueSettings(
        List<String> inputs,
        List<String> lists,
        String site,
        String report,
        String publicUrl,
        boolean prune,
        EncoderSettings encoder)
        implements Serializable {
    private static final long serialVersionUID = 1;

    /** {@return all that decides the bytes of an archive but the model and the encoder's version, as a text} */
    String key() {
        return encoder.key();
    }
}
