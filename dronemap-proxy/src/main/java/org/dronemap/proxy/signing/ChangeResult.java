package org.dronemap.proxy.signing;

/** The result of a key change on a vehicle. */
public sealed interface ChangeResult {
    /** The vehicle was heard to do as it should. */
    record Done() implements ChangeResult {}

    /** The vehicle goes on as before, and so does the cloud. */
    record Failed(ChangeFault fault, String why) implements ChangeResult {}

    /** Nobody knows: both keys are accepted until the vehicle is heard. */
    record Unknown(String why) implements ChangeResult {}
}
