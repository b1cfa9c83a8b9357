package org.dronemap.core.operation;

/**
 * A stable code for why an operation or a virtual drone refuses a user's request; one enum for each kind. Each kind of
 * what is conducted has an enum of its own.
 */
public interface ObjectionCode {
    ObjectionEntry entry();
}
