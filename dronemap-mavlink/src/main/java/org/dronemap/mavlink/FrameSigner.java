package org.dronemap.mavlink;

/** Writes the signature into a MAVLink 2 frame, whose last bytes are reserved for it. */
@FunctionalInterface
public interface FrameSigner {
    /** Writes link id, timestamp and signature into the last {@link Frame#SIGNATURE_BYTES} bytes of {@code frame}. */
    void sign(byte[] frame);
}
