package org.dronemap.mavlink;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** The checksum seeds (CRC_EXTRA), names and lengths of all known MAVLink messages, read from resource files. */
public final class MessageTable {
    private static final int LOW_IDS = 512;
    private static final Map<Integer, Entry> ENTRIES = readAll();
    // Most of what vehicles send has a low number: found without a box for the key.
    private static final @Nullable Entry[] LOW = low(ENTRIES);

    /**
     * One message.
     *
     * @param shortestPayload in bytes, without the version 2 extension fields
     * @param longestPayload in bytes, with them
     * @param targetOffset where the payload names the system that it is for, which component follows; -1: it does not
     */
    public record Entry(
            int id, String name, int checksumSeed, int shortestPayload, int longestPayload, int targetOffset) {}

    private MessageTable() {}

    /** Null for a message that is not known here. */
    public static @Nullable Entry find(int messageId) {
        return messageId >= 0 && messageId < LOW.length ? LOW[messageId] : ENTRIES.get(messageId);
    }

    static int checksumSeed(int messageId) {
        return Objects.requireNonNull(find(messageId), "no such message").checksumSeed();
    }

    private static @Nullable Entry[] low(Map<Integer, Entry> entries) {
        @Nullable Entry[] low = new Entry[LOW_IDS];
        for (int id = 0; id < LOW_IDS; id++) {
            low[id] = entries.get(id);
        }
        return low;
    }

    private static Map<Integer, Entry> readAll() {
        Map<Integer, Entry> entries = new HashMap<>();
        read("messages-newer.tsv", entries);
        read("messages.tsv", entries);
        return Map.copyOf(entries);
    }

    private static void read(String resource, Map<Integer, Entry> entries) {
        try (InputStream in = Objects.requireNonNull(MessageTable.class.getResourceAsStream(resource));
                BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (!line.startsWith("#")) {
                    String[] parts = line.split("\t", -1);
                    int id = Integer.parseInt(parts[0]);
                    entries.put(
                            id,
                            new Entry(
                                    id,
                                    parts[1],
                                    Integer.parseInt(parts[2]),
                                    Integer.parseInt(parts[3]),
                                    Integer.parseInt(parts[4]),
                                    Integer.parseInt(parts[5])));
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
