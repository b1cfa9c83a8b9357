package org.dronemap.core.link;

import java.util.HexFormat;

/** Host key for connection limits: an IPv4 address, or the 64-bit network of an IPv6 subscriber. */
public record ClientHost(String key) {
    private static final int IPV4_BYTES = 4;
    private static final int NETWORK_BYTES = 8;

    /** Of an address as it goes over the wire: 4 or 16 bytes. */
    public static ClientHost of(byte[] address) {
        int significant = address.length == IPV4_BYTES ? IPV4_BYTES : NETWORK_BYTES;
        return new ClientHost(HexFormat.of().formatHex(address, 0, significant));
    }
}
