package org.dronemap.mavlink;

/** A MAVLink message that can be encoded: its raw fields as on the wire. */
public interface Message {
    /** The message's number in the MAVLink definitions. */
    int messageId();

    /** Writes all fields in wire order. */
    void write(PayloadWriter out);
}
