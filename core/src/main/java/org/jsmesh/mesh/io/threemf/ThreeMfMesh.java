package org.jsmesh.mesh.io.threemf;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Texture;

/**
 * The triangles that the build items of a package make, each instance with vertices of its own. Arrays are shared, not
 * copied.
 *
 * @param positions x, y, z per vertex
 * @param isFloat whether float32 holds the positions as well as the file means them
 * @param corners three vertices per triangle
 * @param faceMaterials of each triangle, −1 for none
 * @param materials that these number
 * @param textures that they name
 * @param argb colours that corners name, 0xAARRGGBB
 * @param cornerColours a colour per corner, −1 for none
 * @param uv texture coordinates that corners name, two numbers each
 * @param cornerUv a texture coordinate per corner, −1 for none
 * @param faceNames the name of the object of each triangle, as a number of {@code names}
 * @param names of objects; the first is empty
 */
public record ThreeMfMesh(
        double[] positions,
        boolean isFloat,
        int[] corners,
        int[] faceMaterials,
        List<Material> materials,
        List<Texture> textures,
        int[] argb,
        int[] cornerColours,
        float[] uv,
        int[] cornerUv,
        int[] faceNames,
        List<String> names) {}
