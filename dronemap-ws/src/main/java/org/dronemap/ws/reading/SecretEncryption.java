package org.dronemap.ws.reading;

import java.util.Optional;

/** Encrypts DTLS keys of vehicles before they are stored, with a key that is not kept beside them. Any thread. */
public interface SecretEncryption {
    /** The secret as text that tells nothing to whoever has not the key; {@code purpose} must be the same to open it. */
    String seal(String purpose, byte[] secret);

    /** Empty when it was sealed with another key or for another purpose, or was changed. */
    Optional<byte[]> open(String purpose, String sealed);
}
