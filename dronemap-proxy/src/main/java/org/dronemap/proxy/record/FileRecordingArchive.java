package org.dronemap.proxy.record;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.tlog.TlogReader;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The recordings on disk: lists, opens, cuts and deletes them, and removes old ones to keep within the space limit.
 * Removals run on the journal's thread, behind the writes that were asked for before them. Any thread.
 */
public final class FileRecordingArchive implements RecordingArchive {
    private static final Logger LOG = LoggerFactory.getLogger(FileRecordingArchive.class);
    private static final Duration BETWEEN_LOOKS_AT_AGE = Duration.ofMinutes(10);
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    /** The time, and a frame of 280 bytes at most. */
    private static final int LONGEST_RECORD = 512;

    private final RecordingFiles files;
    private final RecordingPolicy policy;
    private final Recorder.Dependencies keeping;
    private final Time time;
    private final Recorder recorder;
    private final AtomicLong usedBytes = new AtomicLong();
    private final AtomicLong removed = new AtomicLong();
    private final AtomicBoolean tidying = new AtomicBoolean();
    private volatile @Nullable String notice;
    private volatile Instant nextLookAtAge = Instant.MIN;

    FileRecordingArchive(
            RecordingFiles files, RecordingPolicy policy, Recorder.Dependencies keeping, Time time, Recorder recorder) {
        this.files = files;
        this.policy = policy;
        this.keeping = keeping;
        this.time = time;
        this.recorder = recorder;
    }

    @Override
    public List<Recording> recordings() {
        Map<String, Recording> all = new LinkedHashMap<>();
        keeping.store().recordings().forEach(recording -> all.put(recording.id(), recording));
        recorder.unfinished().forEach(recording -> all.put(recording.id(), recording));
        List<Recording> sorted = new ArrayList<>(all.values());
        sorted.sort(Comparator.comparing(Recording::start)
                .thenComparing(Recording::id)
                .reversed());
        return sorted;
    }

    @Override
    public void part(DroneId drone) throws IOException {
        recorder.part(drone);
    }

    @Override
    public Optional<Recording> recording(String id) {
        Recording now = recorder.unfinished(id);
        return now == null ? keeping.store().recording(id) : Optional.of(now);
    }

    @Override
    public Optional<Path> file(String id) throws IOException {
        return written(id, files::path);
    }

    @Override
    public Optional<Path> sent(String id) throws IOException {
        return written(id, files::sentPath);
    }

    private Optional<Path> written(String id, Function<String, Path> path) throws IOException {
        Optional<Recording> found = recording(id);
        if (found.isEmpty()) {
            return Optional.empty();
        }
        if (found.get().state() == Recording.State.RUNNING) {
            recorder.flush();
        }
        return Optional.of(path.apply(found.get().id())).filter(Files::isReadable);
    }

    @Override
    public long cut(String id, Instant from, Instant until, OutputStream out) throws IOException {
        Path file = file(id).orElse(null);
        if (file == null || !RecordingFiles.isOfFrames(file)) {
            return 0;
        }
        long first = micros(from);
        long end = micros(until);
        long count = 0;
        ByteBuffer bytes = ByteBuffer.allocate(LONGEST_RECORD);
        try (InputStream in = Files.newInputStream(file)) {
            TlogReader reader = new TlogReader(in);
            for (TlogReader.Timed record = reader.next(); record != null; record = reader.next()) {
                if (record.micros() >= first && record.micros() < end) {
                    bytes.clear().putLong(record.micros());
                    record.frame().writeTo(bytes);
                    out.write(bytes.array(), 0, bytes.position());
                    count++;
                }
            }
        }
        return count;
    }

    private static long micros(Instant time) {
        return ChronoUnit.MICROS.between(Instant.EPOCH, time);
    }

    @Override
    public Optional<String> delete(String id) throws IOException {
        Recording found = recording(id).orElse(null);
        if (found == null) {
            return Optional.of("There is no recording " + id + ".");
        }
        if (found.state() == Recording.State.RUNNING) {
            return Optional.of("The recording goes on; it can be deleted when the drone is disarmed.");
        }
        CompletableFuture<Void> gone = new CompletableFuture<>();
        keeping.journal()
                .write(
                        "the removal of recording " + id,
                        () -> {
                            remove(found);
                            gone.complete(null);
                        },
                        () -> gone.completeExceptionally(new IOException("The recording could not be deleted.")));
        try {
            Void unused = time.await(gone, PATIENCE);
            return Optional.empty();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("Interrupted while the recording was deleted.", e);
        } catch (ExecutionException | TimeoutException e) {
            throw new IOException("The recording could not be deleted.", e);
        }
    }

    @Override
    public DiskUsage room() {
        return new DiskUsage(usedBytes.get(), policy.mostBytes(), policy.keepDays(), removed.get(), notice);
    }

    void measure() {
        usedBytes.set(keeping.store().recordings().stream()
                .mapToLong(Recording::bytes)
                .sum());
    }

    void grown(long bytes) {
        usedBytes.addAndGet(bytes);
    }

    /** Makes room when there is too much, the oldest first; returns at once. */
    void keepWithin() {
        Instant now = time.clock().instant();
        boolean ageIsDue = policy.keepDays() > 0 && !now.isBefore(nextLookAtAge);
        boolean tooMuch = usedBytes.get() > policy.mostBytes();
        if ((ageIsDue || tooMuch) && tidying.compareAndSet(false, true)) {
            nextLookAtAge = now.plus(BETWEEN_LOOKS_AT_AGE);
            keeping.journal().write("making room for recordings", () -> tidy(now), () -> tidying.set(false));
        }
    }

    private void tidy(Instant now) {
        Instant tooOld = policy.keepDays() == 0 ? Instant.MIN : now.minus(Duration.ofDays(policy.keepDays()));
        List<Recording> oldestFirst = new ArrayList<>(keeping.store().recordings());
        oldestFirst.sort(Comparator.comparing(Recording::start));
        long count = 0;
        for (Recording recording : oldestFirst) {
            boolean over = usedBytes.get() > policy.mostBytes();
            boolean old = recording.start().isBefore(tooOld);
            boolean goesOn = recorder.unfinished(recording.id()) != null;
            if ((over || old) && !goesOn) {
                remove(recording);
                count++;
            }
        }
        if (count > 0) {
            String days = policy.keepDays() == 0 ? "" : " and " + policy.keepDays() + " days";
            notice = "On " + now + " the " + count + " oldest recordings were removed, to keep within "
                    + policy.mostBytes() / 1_000_000 + " MB" + days + ".";
            removed.addAndGet(count);
            LOG.warn("{}", notice);
        }
    }

    private void remove(Recording recording) {
        try {
            Files.deleteIfExists(files.path(recording.id()));
            Files.deleteIfExists(files.sentPath(recording.id()));
        } catch (IOException e) {
            notice = "Recording " + recording.id() + " cannot be removed: " + e.getMessage() + ".";
            throw new UncheckedIOException(e);
        }
        keeping.store().delete(recording.id());
        usedBytes.addAndGet(-recording.bytes());
    }
}
