package org.dronemap.mavlink;

/** Signs a MAVLink 2 frame that is complete but for its signature. */
@FunctionalInterface
public interface FrameSigner {
    /** Writes link id, timestamp and signature into the last {@link Frame#SIGNATURE_BYTES} bytes of {@code frame}. */
    void sign(byte[] frame);
}
