package org.dronemap.proxy.record;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import org.dronemap.mavlink.tlog.TlogReader;
import org.dronemap.proxy.session.ReplayFeed;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One replay of a recording: plays its frames in their own time, faster or slower, into sessions of replayed drones.
 * Played on the replay thread, read from anywhere.
 */
public final class RecordingReplay {
    private static final Logger LOG = LoggerFactory.getLogger(RecordingReplay.class);
    private static final String NOTHING =
            "There is not one message of MAVLink in this file; a recording of a link (tlog)"
                    + " is needed. What a vehicle wrote into its own memory (.bin, .ulg) is another kind of file.";
    private static final int RECORDS_AT_ONCE = 2_000;
    /** Longer pauses of the recording are cut to this. */
    private static final long LONGEST_PAUSE_MICROS = 10_000_000;

    private final String id;
    private final String name;
    private final double speed;
    private final long lengthBytes;
    private final InputStream in;
    private final TlogReader reader;
    private final ReplayFeed feed;
    private TlogReader.@Nullable Timed next;
    private long lastMicros;
    private double dueMicros;
    private double clockMicros;
    private long lastStepNanos;
    private long records;
    private volatile boolean cancelled;
    private volatile ReplayStatus status;

    RecordingReplay(String id, ReplayFeed feed, ReplayRegistry.Source recording) {
        this.id = id;
        this.name = recording.name();
        this.speed = recording.speed();
        this.lengthBytes = recording.lengthBytes();
        this.in = recording.in();
        this.reader = new TlogReader(in);
        this.feed = feed;
        status = status(ReplayStatus.State.RUNNING, null);
    }

    public String id() {
        return id;
    }

    public ReplayStatus status() {
        ReplayStatus last = status;
        if (last.state() == ReplayStatus.State.RUNNING && cancelled) {
            // Nothing more plays, though the thread has not come round to say so.
            return last.cancelled();
        }
        return last.state() == ReplayStatus.State.CANCELLED ? last : last.withDrones(feed.drones());
    }

    /** Stops it and takes its drones away; also after its end. */
    public void cancel() {
        cancelled = true;
        feed.vanish();
    }

    boolean isRunning() {
        return status.state() == ReplayStatus.State.RUNNING;
    }

    /** Plays what is due; on the replay thread only. False when it is over. */
    boolean step(long nowNanos) {
        try {
            if (!cancelled && play(nowNanos)) {
                status = status(ReplayStatus.State.RUNNING, null);
                return true;
            }
            if (records == 0 && !cancelled) {
                end(ReplayStatus.State.FAILED, NOTHING);
            } else {
                end(cancelled ? ReplayStatus.State.CANCELLED : ReplayStatus.State.FINISHED, null);
            }
        } catch (IOException e) {
            LOG.warn("The recording {} could not be read", name, e);
            end(ReplayStatus.State.FAILED, "The recording could not be read: " + e.getMessage() + ".");
        }
        return false;
    }

    /** False at the end of the recording. */
    private boolean play(long nowNanos) throws IOException {
        if (records == 0 && next == null) {
            lastStepNanos = nowNanos;
        }
        clockMicros += (nowNanos - lastStepNanos) / 1000.0 * speed;
        lastStepNanos = nowNanos;
        for (int count = 0; count < RECORDS_AT_ONCE; count++) {
            TlogReader.Timed record = next == null ? fetch() : next;
            next = record;
            if (record == null) {
                return false;
            }
            if (dueMicros > clockMicros || !feed.offer(record.frame())) {
                return true;
            }
            records++;
            next = null;
        }
        return true;
    }

    private TlogReader.@Nullable Timed fetch() throws IOException {
        TlogReader.Timed record = reader.next();
        if (record != null) {
            long pause = lastMicros == 0 ? 0 : record.micros() - lastMicros;
            lastMicros = record.micros();
            dueMicros += Math.max(0, Math.min(pause, LONGEST_PAUSE_MICROS));
        }
        return record;
    }

    private void end(ReplayStatus.State state, @Nullable String failure) {
        status = status(state, failure);
        feed.played();
        try {
            in.close();
        } catch (IOException e) {
            LOG.warn("The recording {} could not be closed", name, e);
        }
    }

    private ReplayStatus status(ReplayStatus.State state, @Nullable String failure) {
        TlogReader.Counts counts = reader.counts();
        double read = lengthBytes <= 0 ? 0 : Math.min(1, (double) reader.bytesRead() / lengthBytes);
        return new ReplayStatus(
                id,
                name,
                speed,
                state == ReplayStatus.State.CANCELLED ? List.of() : feed.drones(),
                state,
                records,
                counts.goodFrames(),
                counts.brokenRuns(),
                counts.brokenBytes(),
                state == ReplayStatus.State.FINISHED ? 1 : read,
                failure);
    }
}
