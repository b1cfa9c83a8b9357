package org.dronemap.ws.server;

import java.util.Optional;
import org.dronemap.store.secret.SecretBox;
import org.dronemap.ws.reading.SecretEncryption;

/** Encrypts stored DTLS keys of vehicles under the server's secret. */
public record SecretBoxEncryption(SecretBox box) implements SecretEncryption {
    @Override
    public String seal(String purpose, byte[] secret) {
        return box.seal(secret, purpose);
    }

    @Override
    public Optional<byte[]> open(String purpose, String sealed) {
        return box.open(sealed, purpose);
    }
}
