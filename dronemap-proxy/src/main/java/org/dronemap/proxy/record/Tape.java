package org.dronemap.proxy.record;

import java.time.Clock;
import java.time.Instant;
import org.dronemap.core.cloud.Mandate;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;
import org.jspecify.annotations.Nullable;

/**
 * What one session heard and said: the last seconds while nothing is recorded, and all that waits for the writer while
 * it is. Endpoint and lane put frames down, the writer takes them away; every method holds the object's lock, never
 * longer than it takes to copy a frame.
 */
final class Tape implements FrameTap {
    static final long BEFORE_MICROS = 5_000_000;
    static final long AFTER_MICROS = 5_000_000;
    private static final int BEFORE_BYTES = 32_768;
    private static final int MOST_WAITING_BYTES = 1 << 20;
    private static final int WORTH_WRITING_BYTES = 8_192;
    private static final long LONGEST_WAIT_MICROS = 1_000_000;
    private static final int TIME_BYTES = 8;
    private static final int ARMED = 128;

    private final Clock clock;
    private final Room room;
    private final int autopilot;
    private final boolean always;
    // What came before, in two halves: when the newer one is full or long enough, the older one is forgotten.
    private Stretch older = new Stretch(BEFORE_BYTES);
    private Stretch newer = new Stretch(BEFORE_BYTES);
    private Stretch waiting = new Stretch(MOST_WAITING_BYTES);
    private @Nullable DroneId drone;
    private boolean armed;
    private boolean recording;
    private boolean ended;
    private long disarmedMicros;
    private long heardMicros;
    private long drops;

    Tape(Clock clock, Room room, int autopilot, boolean always) {
        this.clock = clock;
        this.room = room;
        this.autopilot = autopilot;
        this.always = always;
    }

    @Override
    public synchronized void heard(Frame frame) {
        long now = now();
        heardMicros = now;
        if (frame.messageId() == Heartbeat.ID && frame.componentId() == autopilot && frame.verified()) {
            arming((Heartbeat.decode(frame).baseMode() & ARMED) != 0, now);
        }
        stopWhenOver(now);
        if (!recording) {
            before(now).heard(now, frame);
        } else {
            int before = waiting.records().length();
            settle(TIME_BYTES + frame.length(), before, admit(frame.length()) && waiting.heard(now, frame));
        }
    }

    @Override
    public synchronized void said(byte[] frame, Mandate mandate) {
        long now = now();
        stopWhenOver(now);
        if (!recording) {
            before(now).said(now, frame, mandate);
        } else {
            int before = waiting.records().length();
            settle(TIME_BYTES + frame.length, before, admit(frame.length) && waiting.said(now, frame, mandate));
        }
    }

    @Override
    public synchronized void bound(DroneId now) {
        drone = now;
        beginWhenDue();
    }

    @Override
    public synchronized void ended() {
        ended = true;
    }

    /** The drone that it belongs to, once known. */
    synchronized @Nullable DroneId drone() {
        return drone;
    }

    synchronized boolean isEnded() {
        return ended;
    }

    synchronized long heardMicros() {
        return heardMicros;
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
    synchronized long takeDrops() {
        long taken = drops;
        drops = 0;
        return taken;
    }

    /**
     * What waits, for an empty stretch in exchange; null when it may wait for more. Give the bytes back to the room when
     * they are written.
     */
    synchronized @Nullable Stretch take(Stretch empty, boolean all) {
        boolean worthIt = waiting.records().length() >= WORTH_WRITING_BYTES
                || now() - waiting.records().firstMicros() >= LONGEST_WAIT_MICROS
                || !recording
                || ended
                || all;
        if (waiting.records().frames() == 0 || !worthIt) {
            return null;
        }
        Stretch full = waiting;
        waiting = empty;
        return full;
    }

    static Stretch empty() {
        return new Stretch(MOST_WAITING_BYTES);
    }

    private long now() {
        Instant now = clock.instant();
        return now.getEpochSecond() * 1_000_000 + now.getNano() / 1_000;
    }

    private void arming(boolean nowArmed, long now) {
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

    private void keepBefore(Stretch half) {
        int frames = half.records().frames();
        if (!room.take(half.records().length()) || !waiting.addAll(half)) {
            drops += frames;
        }
        half.clear();
    }

    private void stopWhenOver(long now) {
        if (recording && !armed && !always && now - disarmedMicros > AFTER_MICROS) {
            recording = false;
        }
    }

    private Stretch before(long now) {
        boolean full = newer.records().length() > BEFORE_BYTES - 512;
        if (newer.records().frames() > 0 && (full || now - newer.records().firstMicros() > BEFORE_MICROS)) {
            Stretch forgotten = older;
            older = newer;
            newer = forgotten;
            newer.clear();
        }
        return newer;
    }

    private boolean admit(int frameBytes) {
        return waiting.records().length() + TIME_BYTES + frameBytes <= MOST_WAITING_BYTES
                && room.take(TIME_BYTES + frameBytes);
    }

    /** A frame may take less than was set aside for it: its signature is not kept, and some frames are not at all. */
    private void settle(int setAside, int lengthBefore, boolean kept) {
        if (kept) {
            room.giveBack(setAside - (waiting.records().length() - lengthBefore));
        } else {
            drops++;
        }
    }
}
