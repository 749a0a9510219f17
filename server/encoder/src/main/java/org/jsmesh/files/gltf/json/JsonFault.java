package org.jsmesh.files.gltf.json;

import com.fasterxml.jackson.core.JsonProcessingException;

/** Why a text is no JSON, and where. */
public final class JsonFault extends JsonProcessingException {
    private static final long serialVersionUID = 1;

    JsonFault(JsonProcessingException cause, String reason) {
        super(reason, cause.getLocation(), cause);
    }

    /** The reason alone. */
    @Override
    public String getMessage() {
        return getOriginalMessage();
    }

    /** The line of the text, from 1, or "" when nobody knows it. */
    public String place() {
        int line = getLocation() == null ? -1 : getLocation().getLineNr();
        return line < 0 ? "" : "line " + line + " of the JSON";
    }
}
