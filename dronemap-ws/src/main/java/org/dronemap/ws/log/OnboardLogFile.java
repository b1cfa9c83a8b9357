package org.dronemap.ws.log;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.BitSet;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import org.dronemap.core.command.VehicleLogSink;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.ws.budget.WorkKind;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One vehicle log that is being downloaded to disk, piece by piece, and can be resumed. The lane gives pieces; the
 * shelf's thread writes them.
 */
final class OnboardLogFile implements VehicleLogSink {
    private static final Logger LOG = LoggerFactory.getLogger(OnboardLogFile.class);
    private static final int PIECES_BETWEEN_KEEPING = 512;

    private final Path stem;
    private final VehicleLog log;
    private final Executor writer;
    private final BitSet atStart;
    // Owned by the writing thread.
    private final BitSet written;
    private @Nullable FileChannel open;
    private int sinceKept;
    private volatile State state = State.OPEN;

    OnboardLogFile(Path stem, VehicleLog log, Executor writer) throws IOException {
        this.stem = stem;
        this.log = log;
        this.writer = writer;
        boolean resumes = Files.exists(kept(stem)) && Files.exists(part(stem));
        this.atStart = resumes ? BitSet.valueOf(Files.readAllBytes(kept(stem))) : new BitSet();
        this.written = (BitSet) atStart.clone();
    }

    static Path whole(Path stem) {
        return stem.resolveSibling(stem.getFileName() + ".log");
    }

    static Path part(Path stem) {
        return stem.resolveSibling(stem.getFileName() + ".part");
    }

    static Path kept(Path stem) {
        return stem.resolveSibling(stem.getFileName() + ".kept");
    }

    @Override
    public BitSet kept() {
        return (BitSet) atStart.clone();
    }

    @Override
    public boolean put(int piece, byte[] bytes) {
        return later(() -> {
            channel().write(ByteBuffer.wrap(bytes), (long) piece * PIECE_BYTES);
            written.set(piece);
            if (++sinceKept == PIECES_BETWEEN_KEEPING) {
                sinceKept = 0;
                keep();
            }
        });
    }

    @Override
    public boolean complete(long sizeBytes) {
        return later(() -> {
            try (FileChannel channel = channel()) {
                channel.truncate(sizeBytes);
                channel.force(true);
            }
            open = null;
            Files.move(part(stem), whole(stem), StandardCopyOption.REPLACE_EXISTING);
            Files.deleteIfExists(kept(stem));
            state = State.WRITTEN;
        });
    }

    @Override
    public void interrupted() {
        later(() -> {
            FileChannel channel = open;
            if (channel != null) {
                keep();
                channel.close();
                open = null;
            }
        });
    }

    /** Opened with the first piece: a command that is refused leaves no trace. */
    private FileChannel channel() throws IOException {
        FileChannel now = open;
        if (now == null) {
            now = FileChannel.open(part(stem), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            open = now;
        }
        return now;
    }

    /** Bytes first, then the word that they are there. */
    private void keep() throws IOException {
        channel().force(true);
        Files.write(kept(stem), written.toByteArray());
    }

    @Override
    public State state() {
        return state;
    }

    private interface WorkKind {
        void run() throws IOException;
    }

    private boolean later(WorkKind work) {
        try {
            writer.execute(() -> {
                try {
                    work.run();
                } catch (IOException e) {
                    state = State.FAILED;
                    LOG.error("Log {} cannot be written to {}", log.number(), stem, e);
                }
            });
            return true;
        } catch (RejectedExecutionException full) {
            LOG.debug("The disk is slow; a piece of log {} will be fetched again", log.number(), full);
            return false;
        }
    }
}
