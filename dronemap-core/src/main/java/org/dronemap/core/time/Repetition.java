package org.dronemap.core.time;

/** Something that is going to happen, once or again and again, until it is called off. */
@FunctionalInterface
public interface Repetition {
    /** What is being done already is done to its end. */
    void callOff();
}
