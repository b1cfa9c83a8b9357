package org.dronemap.core.link;

import java.util.HexFormat;

/** Key for connection limits per client host: an IPv4 address, or the /64 network of an IPv6 address. */
public record ClientHost(String key) {
    private static final int IPV4_BYTES = 4;
    private static final int NETWORK_BYTES = 8;

    /** Of an address as it goes over the wire: 4 or 16 bytes. */
    public static ClientHost of(byte[] address) {
        int significant = address.length == IPV4_BYTES ? IPV4_BYTES : NETWORK_BYTES;
        return new ClientHost(HexFormat.of().formatHex(address, 0, significant));
    }
}
