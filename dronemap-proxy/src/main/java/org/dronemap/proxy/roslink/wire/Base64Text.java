package org.dronemap.proxy.roslink.wire;

import java.util.Base64;
import java.util.Optional;

/** Decodes Base64 as ROSLink bridges send it, on one line or broken into several. */
public final class Base64Text {
    private Base64Text() {}

    /** Empty when it is no Base64. */
    public static Optional<byte[]> decode(String text) {
        StringBuilder joined = new StringBuilder(text.length());
        text.chars().filter(c -> c > ' ').forEach(c -> joined.append((char) c));
        try {
            byte[] bytes = Base64.getDecoder().decode(joined.toString());
            return bytes.length == 0 ? Optional.empty() : Optional.of(bytes);
        } catch (IllegalArgumentException e) {
            // Bad input is an ordinary answer here: the session counts it.
            return Optional.empty();
        }
    }
}
