/**
 * Reads and writes PLY, OBJ + MTL, STL, OFF and Hoppe's .m; bytes in, bytes out, no file is opened here.
 *
 * <pre>{@code
 * byte[] content = Files.readAllBytes(Path.of("chair.ply"));
 * ModelFile chair = ModelReader.read("chair.ply", content, ResourceResolver.NONE);
 * for (Note note : chair.notes()) System.out.println(note.kind() + ": " + note.text());
 * ModelWriter.write(chair.mesh(), ModelFormat.STL, "chair.stl", name -> Files.newOutputStream(Path.of(name)));
 * }</pre>
 */
package org.jsmesh.mesh.io;
