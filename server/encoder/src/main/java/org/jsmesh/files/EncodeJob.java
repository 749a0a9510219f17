package org.jsmesh.files;

import java.nio.file.Path;

/**
 * One model file to encode.
 *
 * @param input the model file
 * @param output the archive to write
 */
public record EncodeJob(Path input, Path output) {}
