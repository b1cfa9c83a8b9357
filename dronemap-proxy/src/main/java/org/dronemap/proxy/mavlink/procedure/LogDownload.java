package org.dronemap.proxy.mavlink.procedure;

import java.util.BitSet;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.VehicleLogSink;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.LogData;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.LogRequestEnd;
import org.jspecify.annotations.Nullable;

/** Downloads one onboard log of a vehicle block by block, and resumes after a break of the link. */
public final class LogDownload implements Exchange {
    private static final int PIECE = VehicleLogSink.PIECE_BYTES;
    private static final int BLOCK_PIECES = 512;
    private static final long IDLE_NANOS = 500_000_000L;

    private final MavlinkTarget target;
    private final VehicleLog log;
    private final VehicleLogSink sink;
    private final ExchangeObserver observer;
    private final TransferTimeout patience = new TransferTimeout();
    private final BitSet got;
    private RetrySchedule pace = new RetrySchedule(0, 0, 0);
    private int pieces;
    private long sizeBytes;
    private int askedUntil;
    private long lastDataNanos;
    private boolean completed;
    private @Nullable Outcome outcome;

    public LogDownload(MavlinkTarget target, VehicleLog log, VehicleLogSink sink, ExchangeObserver observer) {
        this.target = target;
        this.log = log;
        this.sink = sink;
        this.observer = observer;
        this.got = sink.kept();
        this.sizeBytes = log.sizeBytes();
        this.pieces = piecesOf(sizeBytes);
    }

    @Override
    public void start(long nowNanos) {
        pace = RetrySchedule.of(target.roundTrip(), 0);
        patience.begin(nowNanos);
        lastDataNanos = nowNanos;
        next(nowNanos);
    }

    /** Asks for the first gap, which is a whole block where nothing came yet. */
    private void next(long nowNanos) {
        int from = got.nextClearBit(0);
        if (from >= pieces) {
            finish();
            return;
        }
        int gap = got.nextSetBit(from);
        askedUntil = Math.min(Math.min(gap < 0 ? pieces : gap, from + BLOCK_PIECES), pieces);
        target.send(new LogRequestData(
                target.systemId(),
                target.componentId(),
                log.number(),
                (long) from * PIECE,
                (long) (askedUntil - from) * PIECE));
        patience.asked(nowNanos);
        lastDataNanos = nowNanos;
    }

    /** The outcome comes when the whole log is safe. */
    private void finish() {
        completed = sink.complete(sizeBytes);
    }

    private void end(Outcome how) {
        target.send(new LogRequestEnd(target.systemId(), target.componentId()));
        if (!(how instanceof Outcome.Succeeded)) {
            sink.interrupted();
        }
        outcome = how;
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        patience.received(nowNanos);
        if (frame.messageId() == LogData.ID) {
            LogData data = LogData.decode(frame);
            if (data.id() == log.number()) {
                blockReceived(data, nowNanos);
            }
        }
    }

    private void blockReceived(LogData data, long nowNanos) {
        lastDataNanos = nowNanos;
        if (completed || data.ofs() % PIECE != 0 || data.ofs() > sizeBytes) {
            return;
        }
        byte[] bytes = bytes(data);
        if (bytes.length < PIECE && data.ofs() + bytes.length < sizeBytes) {
            // Some autopilots round the size up: a piece that is not full tells the true end.
            sizeBytes = data.ofs() + bytes.length;
            pieces = piecesOf(sizeBytes);
            askedUntil = Math.min(askedUntil, pieces);
        }
        keep((int) (data.ofs() / PIECE), bytes, nowNanos);
        if (got.nextClearBit(0) >= askedUntil) {
            next(nowNanos);
        }
    }

    private void keep(int piece, byte[] bytes, long nowNanos) {
        if (bytes.length > 0 && piece < pieces && !got.get(piece) && sink.put(piece, bytes)) {
            got.set(piece);
            patience.progressed(nowNanos);
            observer.progress((int) Math.min(total(), (long) got.cardinality() * PIECE), total());
        }
    }

    private static int piecesOf(long bytes) {
        return (int) ((bytes + PIECE - 1) / PIECE);
    }

    private int total() {
        return (int) Math.min(Integer.MAX_VALUE, sizeBytes);
    }

    private static byte[] bytes(LogData data) {
        byte[] bytes = new byte[Math.min(PIECE, data.count())];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) data.data()[i];
        }
        return bytes;
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome != null) {
            return;
        }
        if (sink.state() == VehicleLogSink.State.WRITTEN) {
            end(new Outcome.Succeeded());
            return;
        }
        if (sink.state() == VehicleLogSink.State.FAILED) {
            end(new Outcome.Failed("The server cannot write the log to its disk."));
            return;
        }
        if (completed || nowNanos - lastDataNanos < Math.max(IDLE_NANOS, pace.firstNanos())) {
            return;
        }
        Outcome given = patience.end(nowNanos);
        if (given != null) {
            end(given);
        } else {
            next(nowNanos);
        }
    }

    @Override
    public void cancel(long nowNanos) {
        if (outcome == null) {
            end(new Outcome.Superseded("cancelled"));
        }
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
