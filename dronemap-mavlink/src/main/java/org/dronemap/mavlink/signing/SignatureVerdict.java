package org.dronemap.mavlink.signing;

/** The verdict of a MAVLink signature check on one received frame. */
public enum SignatureVerdict {
    /** Signed with the key, and newer than everything before in its stream. */
    VALID,
    /** It carries no signature. */
    UNSIGNED,
    /** Another key made the signature, or the frame was changed on its way. */
    BAD_SIGNATURE,
    /** The key is right, but the timestamp is not later than the last of its stream: heard before. */
    REPLAYED,
    /** The key is right, but a stream that was never heard begins more than a minute behind. */
    TOO_OLD,
    /** The key is right, but there are as many streams as are remembered. */
    TOO_MANY_STREAMS;

    public boolean isValid() {
        return this == VALID;
    }
}
