package org.dronemap.proxy.record;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.recording.RecordingStore;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.proxy.session.FrameTap;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Records the messages to and from drones on disk, one file for each flight (or in parts, if always recording).
 * Sessions put frames down on their tapes; one writer thread takes them to the disk, so that no endpoint and no lane
 * ever waits for it. {@link #open} and {@link #flush} from any thread, all else belongs to the writer.
 */
public final class Recorder implements FrameTap.Factory, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Recorder.class);
    private static final Duration ROUND = Duration.ofMillis(100);
    private static final Duration LONGEST_FLUSH = Duration.ofSeconds(5);
    private static final Duration LONGEST_CLOSE = Duration.ofSeconds(10);
    private static final int MOST_WAITING = 256;
    private static final int ROUNDS_BETWEEN_LOOKS = 10;
    private static final long WAITING_BYTES = 48_000_000;
    private static final long LEAST_FREE_BYTES = 200_000_000;
    private static final long LONGEST_PART_BYTES = 64_000_000;
    private static final String CONTACT_LOST =
            "Contact was lost while the drone was armed or at work; what came after that is missing.";
    private static final String STOPPED = "The server was stopped during this recording; what came after is missing.";

    private final RecordingFiles files;
    private final RecordingPolicy policy;
    private final Dependencies keeping;
    private final Time time;
    private final LongSupplier freeBytes;
    private final BufferBudget room = new BufferBudget(WAITING_BYTES);
    private final Collection<RecordingBuffer> tapes = new CopyOnWriteArrayList<>();
    private final Map<String, RecordingFileWriter> unfinished = new ConcurrentHashMap<>();
    private final FileRecordingArchive archive;
    private final Worker writer;
    private final AtomicBoolean closed = new AtomicBoolean();
    // Owned by the writer.
    private final Map<DroneId, RecordingFileWriter> open = new HashMap<>();
    private final Map<DroneId, RecordingBuffer> newest = new HashMap<>();
    private RecordingChunk spare = RecordingBuffer.empty();
    private int rounds;

    /** The store of recordings, the thread that writes to it, and the names of drones. */
    public record Dependencies(RecordingStore store, StoreWriter journal, Function<DroneId, String> names) {}

    public Recorder(Path directory, RecordingPolicy policy, Dependencies keeping, Time time) {
        this(directory, policy, keeping, time, () -> usable(directory));
    }

    Recorder(Path directory, RecordingPolicy policy, Dependencies keeping, Time time, LongSupplier freeBytes) {
        this.files = new RecordingFiles(directory);
        this.policy = policy;
        this.keeping = keeping;
        this.time = time;
        this.writer = time.worker("recorder", MOST_WAITING);
        this.freeBytes = freeBytes;
        this.archive = new FileRecordingArchive(files, policy, keeping, time, this);
    }

    /**
     * Mends what a crash left behind, and begins to write.
     *
     * @throws IOException when the folder cannot be used
     */
    public void start() throws IOException {
        Files.createDirectories(files.directory());
        new RecordingRecovery(keeping.store(), files, keeping.names()).clear();
        archive.measure();
        ScheduledTask unused = writer.every(ROUND, ROUND, this::round);
    }

    /** What is recorded, for those who read it. */
    public FileRecordingArchive archive() {
        return archive;
    }

    @Override
    public FrameTap open(int componentId) {
        if (policy.when() == RecordingPolicy.When.NEVER) {
            return FrameTap.NONE;
        }
        FrameRecordingBuffer tape =
                new FrameRecordingBuffer(time.clock(), room, componentId, policy.when() == RecordingPolicy.When.ALWAYS);
        tapes.add(tape);
        return tape;
    }

    /** The same for a session that speaks in texts. */
    public TextMessageTap openLines() {
        if (policy.when() == RecordingPolicy.When.NEVER) {
            return TextMessageTap.NONE;
        }
        LineRecordingBuffer tape =
                new LineRecordingBuffer(time.clock(), room, policy.when() == RecordingPolicy.When.ALWAYS);
        tapes.add(tape);
        return tape;
    }

    /** The recording as it is now, while it goes on. Any thread. */
    @Nullable
    Recording unfinished(String id) {
        RecordingFileWriter file = unfinished.get(id);
        return file == null ? null : file.recording();
    }

    List<Recording> unfinished() {
        return unfinished.values().stream().map(RecordingFileWriter::recording).toList();
    }

    /** Puts all that waits into the files; returns when it is there. */
    void flush() throws IOException {
        onWriter(() -> writeAll(true));
    }

    /** Ends what is recorded of that drone, and forgets what came before; what is heard from now on begins anew. */
    void part(DroneId drone) throws IOException {
        onWriter(() -> {
            writeAll(true);
            tapes.stream().filter(tape -> drone.equals(tape.drone())).forEach(RecordingBuffer::forgetBefore);
            RecordingFileWriter file = open.get(drone);
            if (file != null) {
                finish(file, null);
            }
        });
    }

    private void onWriter(Runnable work) throws IOException {
        try {
            Boolean unused = time.await(writer.submit(() -> done(work)), LONGEST_FLUSH);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("Interrupted while a recording was written.", e);
        } catch (ExecutionException | TimeoutException e) {
            throw new IOException("The recording could not be written within 5 s.", e);
        } catch (RejectedExecutionException e) {
            throw new IOException("The recording cannot be written now, as too many others are.", e);
        }
    }

    private static Boolean done(Runnable work) {
        work.run();
        return true;
    }

    private void round() {
        try {
            List<RecordingBuffer> over =
                    tapes.stream().filter(RecordingBuffer::isEnded).toList();
            writeAll(false);
            for (RecordingFileWriter file : List.copyOf(open.values())) {
                endWhenOver(file);
            }
            tapes.removeAll(over);
            rounds++;
            if (rounds % ROUNDS_BETWEEN_LOOKS == 0) {
                lookAtDisk();
                archive.keepWithin();
            }
        } catch (RuntimeException e) {
            LOG.error("A round of the recorder failed", e);
        }
    }

    private void writeAll(boolean all) {
        newest.clear();
        for (RecordingBuffer tape : tapes) {
            DroneId drone = tape.drone();
            if (drone != null) {
                newest.merge(drone, tape, (a, b) -> b.receivedMicros() > a.receivedMicros() ? b : a);
            }
        }
        tapes.forEach(tape -> write(tape, all));
    }

    private void write(RecordingBuffer tape, boolean all) {
        DroneId drone = tape.drone();
        // One that was bound only since the round began has its turn in the next, or its file would be ended at once.
        if (drone == null || !newest.containsKey(drone)) {
            return;
        }
        RecordingChunk full = tape.drain(spare, all);
        long drops = tape.drainDrops();
        RecordingFileWriter file = open.get(drone);
        // What still goes to an old address begins no new recording of the drone that came back from another.
        if (file == null && (full != null || drops > 0) && mayBegin(drone, tape)) {
            file = begin(
                    drone,
                    tape.ending(),
                    full == null ? tape.receivedMicros() : full.records().firstMicros());
        }
        if (file != null) {
            file.dropped(drops);
        }
        if (full != null) {
            int length = full.records().length();
            if (file != null) {
                long before = file.recording().bytes();
                file.append(full);
                archive.grown(file.recording().bytes() - before);
            }
            room.release(length);
            full.clear();
            spare = full;
        }
    }

    private boolean mayBegin(DroneId drone, RecordingBuffer tape) {
        RecordingBuffer latest = newest.get(drone);
        return latest == null || latest == tape || latest.isRecording();
    }

    private RecordingFileWriter begin(DroneId drone, String ending, long micros) {
        RecordingFileWriter file = RecordingFileWriter.open(
                files.with(ending), drone, keeping.names().apply(drone), micros);
        open.put(drone, file);
        unfinished.put(file.recording().id(), file);
        Recording recording = file.recording();
        keeping.journal()
                .write("recording " + recording.id(), () -> keeping.store().save(recording), () -> {});
        LOG.info("Recording {} of {} has begun", recording.id(), recording.droneName());
        return file;
    }

    private void endWhenOver(RecordingFileWriter file) {
        RecordingBuffer tape = newest.get(file.recording().drone());
        if (tape == null || tape.isOver()) {
            boolean lost = tape != null && tape.isEnded() && tape.isArmed();
            finish(file, lost ? CONTACT_LOST : null);
        } else if (policy.when() == RecordingPolicy.When.ALWAYS
                && file.recording().bytes() > LONGEST_PART_BYTES) {
            finish(file, null);
        }
    }

    private void finish(RecordingFileWriter file, @Nullable String notice) {
        Recording done = file.finish(notice);
        open.remove(done.drone());
        if (done.state() == Recording.State.INCOMPLETE) {
            LOG.warn("Recording {} is not complete: {}", done.id(), done.notice());
        } else {
            LOG.info("Recording {} has ended with {} messages", done.id(), done.frames());
        }
        keeping.journal()
                .write("recording " + done.id(), () -> keeping.store().save(done), () -> unfinished.remove(done.id()));
    }

    private void lookAtDisk() {
        if (!open.isEmpty() && freeBytes.getAsLong() < LEAST_FREE_BYTES) {
            String why = "It was ended, as the disk has less than " + LEAST_FREE_BYTES / 1_000_000 + " MB left.";
            open.values().forEach(file -> file.fail(why));
        }
    }

    private static long usable(Path directory) {
        try {
            return Files.getFileStore(directory).getUsableSpace();
        } catch (IOException e) {
            LOG.warn("The free room of {} is not known", directory, e);
            return Long.MAX_VALUE;
        }
    }

    /** Ends what is being recorded; a second time does nothing. */
    @Override
    public void close() {
        if (!closed.compareAndSet(false, true)) {
            return;
        }
        try {
            Boolean unused = time.await(writer.submit(() -> done(this::endAll)), LONGEST_CLOSE);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (ExecutionException | TimeoutException | RejectedExecutionException e) {
            LOG.error("The recordings could not be ended; the next start mends them", e);
        }
        writer.close();
    }

    private void endAll() {
        writeAll(true);
        for (RecordingFileWriter file : List.copyOf(open.values())) {
            RecordingBuffer tape = newest.get(file.recording().drone());
            boolean flying = tape != null && tape.isArmed();
            finish(file, flying ? STOPPED : null);
        }
    }
}
