package org.dronemap.mavlink;

/** Fills in the signature of a version 2 frame that is whole but for it. */
@FunctionalInterface
public interface FrameSigner {
    /** Writes link id, timestamp and signature into the last {@link Frame#SIGNATURE_BYTES} bytes of {@code frame}. */
    void sign(byte[] frame);
}
