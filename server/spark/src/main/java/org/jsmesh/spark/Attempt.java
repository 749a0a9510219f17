package org.jsmesh.spark;

import org.apache.spark.TaskContext;

/** One of the times that a task is tried. */
interface Attempt {
    /** {@return how often the task was begun before} */
    int number();

    /** {@return what no other attempt of the run has} */
    long id();

    /** {@return whether Spark wants no more of it} */
    boolean isInterrupted();

    /** {@return the one that this thread works for} */
    static Attempt current() {
        TaskContext context = TaskContext.get();
        return new Attempt() {
            @Override
            public int number() {
                return context.attemptNumber();
            }

            @Override
            public long id() {
                return context.taskAttemptId();
            }

            @Override
            public boolean isInterrupted() {
                return context.isInterrupted();
            }
        };
    }
}
