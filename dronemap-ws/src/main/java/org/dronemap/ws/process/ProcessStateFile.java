package org.dronemap.ws.process;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.process.ActivePeers;
import org.dronemap.core.process.ProcessCrash;

/**
 * Memory-mapped file that survives a crash and tells the next server process how and over which peer this one ended.
 * Any thread; a thread has one place, which only it writes. It is read by the next process of the same data directory.
 */
final class ProcessStateFile implements ActivePeers {
    private static final int VERSION = 1;
    private static final byte RUNNING = 1;
    private static final byte STOPPED = 2;
    private static final byte ENDED = 3;

    private static final int STATE_AT = 4;
    private static final int SIGN_AT = 8;
    private static final int THREAD_AT = 16;
    private static final int PART_AT = 32;
    private static final int WHY_AT = 160;
    private static final int PLACES_AT = 1024;
    private static final int PLACE_BYTES = 128;
    private static final int PLACES = 120;
    private static final int BYTES = PLACES_AT + PLACES * PLACE_BYTES;

    /** What Java ends with by ExitOnOutOfMemoryError. */
    private static final String MEMORY_USED_UP = "3";

    private static final String KILLED = "137";

    private static final int EVERY_THREAD = -1;
    private static final int NO_PLACE = -2;

    private final MappedByteBuffer bytes;
    private final Optional<ProcessCrash> before;
    private final AtomicInteger given = new AtomicInteger();
    private final ThreadLocal<Integer> place = ThreadLocal.withInitial(() -> {
        int next = given.getAndIncrement();
        return next < PLACES ? next : NO_PLACE;
    });

    private ProcessStateFile(MappedByteBuffer bytes, String exitCode) {
        this.bytes = bytes;
        this.before = read(exitCode);
    }

    /**
     * Reads what the process before left, and begins anew.
     *
     * @param exitCode of the process before; empty: nobody knows it
     */
    static ProcessStateFile begin(Path file, Instant now, String exitCode) {
        try (FileChannel channel =
                FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
            ProcessStateFile run =
                    new ProcessStateFile(channel.map(FileChannel.MapMode.READ_WRITE, 0, BYTES), exitCode);
            run.begin(now);
            return run;
        } catch (IOException e) {
            throw new UncheckedIOException("The file " + file + " cannot be written: " + e.getMessage(), e);
        }
    }

    /** How the process before ended; empty: it was stopped, or there was none. */
    Optional<ProcessCrash> before() {
        return before;
    }

    private void begin(Instant now) {
        for (int at = THREAD_AT; at < BYTES; at++) {
            bytes.put(at, (byte) 0);
        }
        bytes.putInt(0, VERSION);
        bytes.putInt(THREAD_AT, EVERY_THREAD);
        sign(now);
        bytes.put(STATE_AT, RUNNING);
    }

    /** It is alive. */
    void sign(Instant now) {
        bytes.putLong(SIGN_AT, now.toEpochMilli());
    }

    /** It was stopped: nothing is wrong. */
    void stopped() {
        bytes.put(STATE_AT, STOPPED);
    }

    /**
     * It is about to end. The first one counts.
     *
     * @param part that cannot go on
     * @param ofThisThread only this thread's work can have to do with it
     */
    synchronized void ending(Instant now, String part, String why, boolean ofThisThread) {
        if (bytes.get(STATE_AT) == ENDED) {
            return;
        }
        sign(now);
        put(PART_AT, WHY_AT - PART_AT, part);
        put(WHY_AT, PLACES_AT - WHY_AT, why);
        bytes.putInt(THREAD_AT, ofThisThread ? place.get() : EVERY_THREAD);
        bytes.put(STATE_AT, ENDED);
    }

    @Override
    public void begin(String peer) {
        int mine = place.get();
        if (mine != NO_PLACE) {
            put(PLACES_AT + mine * PLACE_BYTES, PLACE_BYTES, peer);
        }
    }

    @Override
    public void done() {
        int mine = place.get();
        if (mine != NO_PLACE) {
            bytes.putShort(PLACES_AT + mine * PLACE_BYTES, (short) 0);
        }
    }

    /** Length last: whoever ends in between leaves the place empty. Only plain letters are kept. */
    private void put(int at, int room, String text) {
        int length = Math.min(text.length(), Math.min(room - 2, Short.MAX_VALUE));
        bytes.putShort(at, (short) 0);
        for (int i = 0; i < length; i++) {
            char letter = text.charAt(i);
            bytes.put(at + 2 + i, letter < 127 ? (byte) letter : (byte) '?');
        }
        bytes.putShort(at, (short) length);
    }

    private Optional<ProcessCrash> read(String exitCode) {
        byte state = bytes.get(STATE_AT);
        if (bytes.getInt(0) != VERSION || (state != RUNNING && state != ENDED)) {
            return Optional.empty();
        }
        boolean told = state == ENDED;
        String part = told ? text(PART_AT, WHY_AT - PART_AT) : exitCode.equals(MEMORY_USED_UP) ? "memory" : "process";
        String why = told ? text(WHY_AT, PLACES_AT - WHY_AT) : whyUntold(exitCode);
        // Who was killed from outside was not killed by what a peer sent.
        boolean byItself = told || exitCode.equals(MEMORY_USED_UP);
        return Optional.of(new ProcessCrash(
                Instant.ofEpochMilli(bytes.getLong(SIGN_AT)),
                part,
                why,
                byItself ? ProcessCrash.names(peers()) : List.of()));
    }

    private static String whyUntold(String exitCode) {
        return switch (exitCode) {
            case MEMORY_USED_UP -> "Java's memory was used up.";
            case KILLED -> "It was killed (SIGKILL), by somebody or by the system for want of memory.";
            case "" -> "It was killed, or the machine stopped.";
            default -> "It ended with the exit code " + exitCode + ".";
        };
    }

    private List<String> peers() {
        int only = bytes.getInt(THREAD_AT);
        List<String> peers = new ArrayList<>();
        for (int number = 0; number < PLACES; number++) {
            if (only == EVERY_THREAD || only == number) {
                peers.add(text(PLACES_AT + number * PLACE_BYTES, PLACE_BYTES));
            }
        }
        return peers;
    }

    private String text(int at, int room) {
        int length = bytes.getShort(at);
        if (length < 0 || length > room - 2) {
            return "";
        }
        ByteBuffer text = bytes.slice(at + 2, length);
        return StandardCharsets.US_ASCII.decode(text).toString();
    }
}
