package org.dronemap.ws.link;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.link.DtlsKey;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.ws.reading.SecretEncryption;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The DTLS keys of vehicles: stored encrypted, and decrypted when a vehicle connects to an encrypted endpoint. Any
 * thread.
 */
public final class DtlsKeyRing {
    private static final Logger LOG = LoggerFactory.getLogger(DtlsKeyRing.class);
    /** Part of what seals a secret: with other words, the secrets sealed before would not open. */
    private static final String PURPOSE = "link key of ";

    private final EndpointStore store;
    private final SecretEncryption sealing;
    private final Map<String, DtlsKey> keys = new ConcurrentHashMap<>();

    public DtlsKeyRing(EndpointStore store, SecretEncryption sealing) {
        this.store = store;
        this.sealing = sealing;
        store.keys().forEach(key -> keys.put(key.identity(), key));
    }

    /** The secret of that vehicle; empty when it has no key, or the key was revoked. */
    public Optional<byte[]> secret(String identity) {
        DtlsKey key = keys.get(identity);
        if (key == null) {
            return Optional.empty();
        }
        Optional<byte[]> secret = sealing.open(PURPOSE + identity, key.sealedSecret());
        if (secret.isEmpty()) {
            LOG.warn("The key of {} was sealed by another installation; make a new one.", identity);
        }
        return secret;
    }

    List<DtlsKey> keys() {
        return store.keys();
    }

    /** Returns once the key is durable. */
    void put(DtlsKey unsealed, byte[] secret) {
        DtlsKey key = new DtlsKey(
                unsealed.identity(),
                unsealed.label(),
                sealing.seal(PURPOSE + unsealed.identity(), secret),
                unsealed.madeBy(),
                unsealed.madeAt());
        store.saveKey(key);
        keys.put(key.identity(), key);
    }

    boolean remove(String identity) {
        keys.remove(identity);
        return store.deleteKey(identity);
    }
}
