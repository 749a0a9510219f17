package org.jsmesh.desktop;

import java.nio.file.Path;
import org.jsmesh.desktop.draw.DrawStyle;

/**
 * How windows begin.
 *
 * @param waitMillis that a round takes
 * @param size of the picture
 * @param cache folder in which archives are kept, or null
 * @param original whether everything is loaded at once
 * @param style of the picture
 */
record ViewerOptions(int waitMillis, PictureSize size, Path cache, boolean original, DrawStyle style) {
    /** Two seconds, 1024x768 pixels, nothing kept. */
    static ViewerOptions defaults() {
        return new ViewerOptions(2000, new PictureSize(1024, 768), null, false, DrawStyle.defaults());
    }

    ViewerOptions withSize(PictureSize other) {
        return new ViewerOptions(waitMillis, other, cache, original, style);
    }
}
