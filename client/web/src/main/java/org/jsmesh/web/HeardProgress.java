package org.jsmesh.web;

import org.jsmesh.mesh.ProgressListener;
import org.teavm.interop.Import;

/** Tells the worker how far the workshop is. The worker asks for the words, as no text goes that way. */
final class HeardProgress implements ProgressListener {
    private String stage = "";

    /** What is being done. */
    String stage() {
        return stage;
    }

    @Override
    public void progress(String stage, double fraction) {
        this.stage = stage;
        tell(fraction);
    }

    @Import(module = "workshop", name = "progress")
    private static native void tell(double fraction);
}
