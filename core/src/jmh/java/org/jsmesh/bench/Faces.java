package org.jsmesh.bench;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** Counts faces beside the runs of a benchmark, so that its speed on meshes of different sizes can be compared. */
@AuxCounters(AuxCounters.Type.OPERATIONS)
@State(Scope.Thread)
public class Faces {
    /** Faces worked on; JMH divides them by the time. */
    public long faces;
}
