package org.dronemap.proxy.record;

import java.time.Clock;
import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Buffers the messages of one session: the seconds before a recording begins, and what waits to be written. Endpoint
 * and lane put records down, the writer takes them away; every method holds the object's lock, never longer than it
 * takes to copy a record.
 */
abstract sealed class RecordingBuffer permits FrameRecordingBuffer, LineRecordingBuffer {
    static final long BEFORE_MICROS = 5_000_000;
    static final long AFTER_MICROS = 5_000_000;
    private static final int MOST_WAITING_BYTES = 1 << 20;
    private static final int WORTH_WRITING_BYTES = 8_192;
    private static final long LONGEST_WAIT_MICROS = 1_000_000;
    /** At least what a record takes beside what it holds. */
    private static final int TIME_BYTES = 24;

    private final Clock clock;
    private final BufferBudget room;
    private final int halfBytes;
    private final int longest;
    private final boolean always;
    // What came before, in two halves: when the newer one is full or long enough, the older one is forgotten.
    private RecordingChunk older;
    private RecordingChunk newer;
    private RecordingChunk waiting = new RecordingChunk(MOST_WAITING_BYTES);
    private @Nullable DroneId drone;
    private boolean armed;
    private boolean recording;
    private boolean ended;
    private long disarmedMicros;
    private long receivedMicros;
    private long drops;

    /**
     * @param halfBytes what may be kept of what came before, half of it
     * @param longest record, in bytes
     */
    RecordingBuffer(Clock clock, BufferBudget room, boolean always, int halfBytes, int longest) {
        this.clock = clock;
        this.room = room;
        this.always = always;
        this.halfBytes = halfBytes;
        this.longest = longest;
        older = new RecordingChunk(halfBytes);
        newer = new RecordingChunk(halfBytes);
    }

    /** Puts down what takes so many bytes beside its time, at the time of now. */
    final synchronized void keep(int length, Put put) {
        long now = now();
        stopWhenOver(now);
        if (!recording) {
            put.into(before(now), now);
        } else {
            int before = waiting.records().length();
            settle(TIME_BYTES + length, before, admit(length) && put.into(waiting, now));
        }
    }

    /** Puts one record into a stretch; false when there is no room. */
    interface Put {
        boolean into(RecordingChunk stretch, long micros);
    }

    final synchronized void markReceived() {
        receivedMicros = now();
    }

    /** The ending of its file's name. */
    abstract String ending();

    public final synchronized void bound(DroneId now) {
        drone = now;
        beginWhenDue();
    }

    public final synchronized void ended() {
        ended = true;
    }

    /** The drone that it belongs to, once known. */
    synchronized @Nullable DroneId drone() {
        return drone;
    }

    synchronized boolean isEnded() {
        return ended;
    }

    synchronized long receivedMicros() {
        return receivedMicros;
    }

    /** A flight goes on, or its last seconds. */
    synchronized boolean isRecording() {
        stopWhenOver(now());
        return recording && !ended;
    }

    /** Nothing more is recorded, and nothing that was waits for the writer: only then may its file be ended. */
    synchronized boolean isOver() {
        return !isRecording() && waiting.records().frames() == 0;
    }

    /** The vehicle said that it is armed and has not taken it back. */
    synchronized boolean isArmed() {
        return armed;
    }

    /** How many frames found no room since this was last asked. */
    synchronized long drainDrops() {
        long taken = drops;
        drops = 0;
        return taken;
    }

    /**
     * What waits, for an empty stretch in exchange; null when it may wait for more. Give the bytes back to the room when
     * they are written.
     */
    synchronized @Nullable RecordingChunk drain(RecordingChunk empty, boolean all) {
        boolean worthIt = waiting.records().length() >= WORTH_WRITING_BYTES
                || now() - waiting.records().firstMicros() >= LONGEST_WAIT_MICROS
                || !recording
                || ended
                || all;
        if (waiting.records().frames() == 0 || !worthIt) {
            return null;
        }
        RecordingChunk full = waiting;
        waiting = empty;
        return full;
    }

    static RecordingChunk empty() {
        return new RecordingChunk(MOST_WAITING_BYTES);
    }

    private long now() {
        Instant now = clock.instant();
        return now.getEpochSecond() * 1_000_000 + now.getNano() / 1_000;
    }

    /** From when it says so it is recorded, until some seconds after it took that back. */
    final synchronized void arming(boolean nowArmed) {
        long now = now();
        if (armed && !nowArmed) {
            disarmedMicros = now;
        }
        armed = nowArmed;
        beginWhenDue();
    }

    private void beginWhenDue() {
        if (recording || drone == null || !(armed || always)) {
            return;
        }
        recording = true;
        keepBefore(older);
        keepBefore(newer);
    }

    /** What begins from now on has nothing of what came before. */
    final synchronized void forgetBefore() {
        older.clear();
        newer.clear();
    }

    private void keepBefore(RecordingChunk half) {
        int frames = half.records().frames();
        if (!room.tryAcquire(half.records().length()) || !waiting.addAll(half)) {
            drops += frames;
        }
        half.clear();
    }

    private void stopWhenOver(long now) {
        if (recording && !armed && !always && now - disarmedMicros > AFTER_MICROS) {
            recording = false;
        }
    }

    private RecordingChunk before(long now) {
        boolean full = newer.records().length() > halfBytes - longest;
        if (newer.records().frames() > 0 && (full || now - newer.records().firstMicros() > BEFORE_MICROS)) {
            RecordingChunk forgotten = older;
            older = newer;
            newer = forgotten;
            newer.clear();
        }
        return newer;
    }

    private boolean admit(int frameBytes) {
        return waiting.records().length() + TIME_BYTES + frameBytes <= MOST_WAITING_BYTES
                && room.tryAcquire(TIME_BYTES + frameBytes);
    }

    /** A frame may take less than was set aside for it: its signature is not kept, and some frames are not at all. */
    private void settle(int setAside, int lengthBefore, boolean kept) {
        if (kept) {
            room.release(setAside - (waiting.records().length() - lengthBefore));
        } else {
            drops++;
        }
    }
}
