package org.dronemap.core.operation;

/** A reason why a wish is not taken, as programs know it. Each kind of what is conducted has an enum of its own. */
public interface ObjectionCode {
    ObjectionEntry entry();
}
