package org.jsmesh.files;

import java.util.List;

/**
 * How a mesh was written as a model file.
 *
 * @param losses what the file does not hold or holds in another way, one sentence each; if there are any, the file is
 *     not the mesh bit for bit
 * @param remarks what is in the file but other programs may not find, one sentence each
 */
public record WrittenModel(List<String> losses, List<String> remarks) {
    /**
     * Copies the lists.
     *
     * @param losses see {@link #losses()}
     * @param remarks see {@link #remarks()}
     */
    public WrittenModel {
        losses = List.copyOf(losses);
        remarks = List.copyOf(remarks);
    }
}
