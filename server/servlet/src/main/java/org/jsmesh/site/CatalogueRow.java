package org.jsmesh.site;

/**
 * What a catalogue says of one model, or that it shall say nothing of it any more.
 *
 * @param id of the model
 * @param json one JSON object on one line, as {@link ModelPublisher} gives it; null to take the model off the catalogue
 */
public record CatalogueRow(String id, String json) {
    /**
     * Takes a model off the catalogue.
     *
     * @param id of the model, which need not be there
     * @return the change
     */
    public static CatalogueRow removal(String id) {
        return new CatalogueRow(id, null);
    }

    boolean isRemoval() {
        return json == null;
    }
}
