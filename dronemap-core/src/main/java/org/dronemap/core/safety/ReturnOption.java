package org.dronemap.core.safety;

/** A way to bring down a drone that nobody controls: return home, another landing site, or land; best first. */
public enum ReturnOption {
    /** Back to where it set off, by its own way. */
    RETURN,
    /** To another place that is known to be fit for a landing. */
    ELSEWHERE,
    /** Down where it is. */
    LAND
}
