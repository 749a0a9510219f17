package org.jsmesh.web;

import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Sha256;
import org.teavm.jso.JSObject;
import org.teavm.jso.core.JSString;

/** What the workshop calls in place of the class library: see {@code WorkshopParts}. */
final class BrowserParts {
    private BrowserParts() {}

    /** A string of the browser. */
    private interface BrowserText extends JSObject {
        /** The text with letters and accents put together (NFC). */
        String normalize();
    }

    /** In place of {@link java.text.Normalizer}. Nobody asks for another form than NFC. */
    @SuppressWarnings("deprecation") // what stands in its place checks the type, which no interface of JavaScript has
    static String normalize(CharSequence text) {
        return JSString.valueOf(text.toString()).<BrowserText>cast().normalize();
    }

    /** In place of the platform's. */
    static MeshIdentity.Hash sha256() {
        return new Sha256();
    }
}
