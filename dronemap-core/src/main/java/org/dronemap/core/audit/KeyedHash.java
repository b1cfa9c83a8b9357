package org.dronemap.core.audit;

/** Makes hashes that only the holder of this server's key can make; the same for the same content. Thread-safe. */
public interface KeyedHash {
    /** 64 hexadecimal digits. */
    String of(byte[] content);
}
