package org.dronemap.proxy.roslink.wire;

import org.jspecify.annotations.Nullable;

/**
 * The header of a ROSLink message: system id, message id, sequence number, key and owner.
 *
 * @param systemId 0 to 65535
 * @param sequence counts one way or another, or starts again: null where there is none
 * @param key what the robot proves itself with, not to be logged; null where there is none
 * @param owner null from bridges older than 2018
 * @param version of the protocol, 1 where it is not said
 * @param rosVersion 0 where it is not said
 */
public record RoslinkHeader(
        PacketLayout shape,
        int systemId,
        int messageId,
        @Nullable Long sequence,
        @Nullable StringOrNumber key,
        @Nullable StringOrNumber owner,
        int version,
        int rosVersion) {
    /** Without the key, which belongs in no log. */
    @Override
    public String toString() {
        return "message " + messageId + " of system " + systemId + (sequence == null ? "" : ", number " + sequence);
    }
}
