package org.dronemap.core.audit;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;

/** Encodes a list of values unambiguously as bytes, each with its length before it, as input of a keyed hash. */
final class CanonicalEncoder {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    CanonicalEncoder(String purpose) {
        add(purpose);
    }

    CanonicalEncoder add(@Nullable Object value) {
        byte[] text = value == null ? new byte[0] : text(value).getBytes(StandardCharsets.UTF_8);
        bytes.writeBytes(
                ByteBuffer.allocate(4).putInt(value == null ? -1 : text.length).array());
        bytes.writeBytes(text);
        return this;
    }

    private static String text(Object value) {
        return value instanceof Enum<?> constant ? StoredNames.of(constant) : value.toString();
    }

    byte[] bytes() {
        return bytes.toByteArray();
    }
}
