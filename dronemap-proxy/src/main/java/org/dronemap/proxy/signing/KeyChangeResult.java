package org.dronemap.proxy.signing;

/** The result of a change of the signing key on a vehicle. */
public sealed interface KeyChangeResult {
    /** The vehicle was heard to do as it should. */
    record Done() implements KeyChangeResult {}

    /** The vehicle goes on as before, and so does the cloud. */
    record Failed(KeyChangeFault fault, String why) implements KeyChangeResult {}

    /** Nobody knows: both keys are accepted until the vehicle is heard. */
    record Unknown(String why) implements KeyChangeResult {}
}
