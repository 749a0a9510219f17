package org.jsmesh.archive;

import com.openize.drako.AttributeType;
import com.openize.drako.Draco;
import com.openize.drako.DracoCompressionLevel;
import com.openize.drako.DracoEncodeOptions;
import com.openize.drako.DracoMesh;
import com.openize.drako.DrakoException;
import com.openize.drako.PointAttribute;
import com.openize.drako.Vector3;
import java.util.concurrent.TimeUnit;
import org.jsmesh.bench.BenchmarkMesh;
import org.jsmesh.bench.Faces;
import org.jsmesh.mesh.Mesh;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The peer of {@link DecodeBenchmark}: Openize's Draco in Java decodes positions of 14 bits and faces. */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.SECONDS)
public class DracoBenchmark {
    private static final int BITS = 14;

    @Param(BenchmarkMesh.GENERATED)
    public String model;

    private byte[] file;

    @Setup
    public void encode() throws DrakoException {
        file = encode(BenchmarkMesh.read(model));
    }

    static byte[] encode(Mesh mesh) throws DrakoException {
        DracoEncodeOptions options = new DracoEncodeOptions();
        options.setPositionBits(BITS);
        options.setCompressionLevel(DracoCompressionLevel.OPTIMAL);
        return Draco.encode(draco(mesh), options);
    }

    @Benchmark
    public DracoMesh decode(Faces counter) throws DrakoException {
        DracoMesh mesh = (DracoMesh) Draco.decode(file);
        counter.faces += mesh.getNumFaces();
        return mesh;
    }

    private static DracoMesh draco(Mesh mesh) {
        float[] p = mesh.positions();
        Vector3[] points = new Vector3[mesh.vertices()];
        for (int v = 0; v < points.length; v++) points[v] = new Vector3(p[3 * v], p[3 * v + 1], p[3 * v + 2]);
        DracoMesh draco = new DracoMesh();
        draco.addAttribute(PointAttribute.wrap(AttributeType.POSITION, points));
        draco.setNumPoints(points.length);
        int[] triangles = BenchmarkMesh.triangles(mesh);
        for (int i = 0; i < triangles.length; i += 3)
            draco.addFace(new int[] {triangles[i], triangles[i + 1], triangles[i + 2]});
        return draco;
    }
}
