package org.dronemap.core.audit;

/** A keyed hash (MAC) with this server's secret, used to chain and sign audit records. Thread-safe. */
public interface KeyedHash {
    /** 64 hexadecimal digits. */
    String of(byte[] content);
}
