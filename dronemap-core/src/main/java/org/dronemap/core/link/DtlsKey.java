package org.dronemap.core.link;

import java.time.Instant;

/**
 * The DTLS pre-shared key of one vehicle; the secret only in encrypted form.
 *
 * @param identity what the vehicle calls itself, unique
 * @param label what people call it
 * @param sealedSecret the secret, encrypted by whoever made the key; never the secret itself
 */
public record DtlsKey(String identity, String label, String sealedSecret, String madeBy, Instant madeAt) {
    @Override
    public String toString() {
        return "DtlsKey[" + identity + ", " + label + "]";
    }
}
