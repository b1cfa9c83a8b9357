package org.dronemap.store.postgres;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.sql.SQLException;
import java.time.Instant;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;
import org.postgresql.copy.CopyIn;

/**
 * Writes telemetry rows to PostgreSQL in the binary form of its COPY command, which is much cheaper than text. One
 * thread.
 */
final class CopyBuffer {
    private static final byte[] HEADER = {
        'P', 'G', 'C', 'O', 'P', 'Y', '\n', (byte) 0xFF, '\r', '\n', 0, 0, 0, 0, 0, 0, 0, 0, 0
    };
    private static final long EPOCH_2000_SECONDS = 946_684_800L;
    private static final int SIZE = 65_536;
    private static final int NULL = -1;

    private final CopyIn copy;
    private final ByteBuffer bytes = ByteBuffer.allocate(SIZE);

    CopyBuffer(CopyIn copy) {
        this.copy = copy;
        bytes.put(HEADER);
    }

    /** Begins a row of so many columns, each of which is to follow. */
    void row(int columns) throws SQLException {
        room(Short.BYTES);
        bytes.putShort((short) columns);
    }

    void text(@Nullable String value) throws SQLException {
        if (value == null) {
            nothing();
            return;
        }
        // PostgreSQL's text cannot hold the zero character.
        byte[] encoded = value.replace('\0', '\uFFFD').getBytes(StandardCharsets.UTF_8);
        room(Integer.BYTES);
        bytes.putInt(encoded.length);
        if (encoded.length > SIZE) {
            flush();
            copy.writeToCopy(encoded, 0, encoded.length);
            return;
        }
        room(encoded.length);
        bytes.put(encoded);
    }

    void time(Instant value) throws SQLException {
        Instant kept = StoredInstant.of(value);
        room(Integer.BYTES + Long.BYTES);
        bytes.putInt(Long.BYTES)
                .putLong((kept.getEpochSecond() - EPOCH_2000_SECONDS) * 1_000_000L + kept.getNano() / 1_000);
    }

    void float8(@Nullable Double value) throws SQLException {
        room(Integer.BYTES + Double.BYTES);
        if (value == null) {
            bytes.putInt(NULL);
        } else {
            bytes.putInt(Double.BYTES).putDouble(value);
        }
    }

    void float4(@Nullable Double value) throws SQLException {
        room(Integer.BYTES + Float.BYTES);
        if (value == null) {
            bytes.putInt(NULL);
        } else {
            bytes.putInt(Float.BYTES).putFloat(value.floatValue());
        }
    }

    void integer(@Nullable Integer value) throws SQLException {
        room(Integer.BYTES + Integer.BYTES);
        if (value == null) {
            bytes.putInt(NULL);
        } else {
            bytes.putInt(Integer.BYTES).putInt(value);
        }
    }

    void bool(@Nullable Boolean value) throws SQLException {
        room(Integer.BYTES + 1);
        if (value == null) {
            bytes.putInt(NULL);
        } else {
            bytes.putInt(1).put((byte) (value ? 1 : 0));
        }
    }

    /** Ends the copy; how many rows there were. */
    long end() throws SQLException {
        room(Short.BYTES);
        bytes.putShort((short) -1);
        flush();
        return copy.endCopy();
    }

    private void nothing() throws SQLException {
        room(Integer.BYTES);
        bytes.putInt(NULL);
    }

    private void room(int needed) throws SQLException {
        if (bytes.remaining() < needed) {
            flush();
        }
    }

    private void flush() throws SQLException {
        copy.writeToCopy(bytes.array(), 0, bytes.position());
        bytes.clear();
    }
}
