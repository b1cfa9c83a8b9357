package org.dronemap.proxy.record;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.dronemap.core.cloud.SendAuthority;

/**
 * The index beside a recording that says by which command, control epoch and user each sent frame went out. Owned by
 * the writer.
 */
final class SentFrameIndex implements AutoCloseable {
    static final String HEADER = "offset\tcommand\tepoch\tby\n";

    private static final String NONE = "-";

    private final FileChannel channel;

    private SentFrameIndex(FileChannel channel) {
        this.channel = channel;
    }

    static SentFrameIndex open(Path file) throws IOException {
        SentFrameIndex index = new SentFrameIndex(FileChannel.open(
                file, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE));
        index.write(HEADER);
        return index;
    }

    /** {@code start}: where the stretch begins in the recording. */
    void append(long start, List<RecordingChunk.Sent> sent) throws IOException {
        StringBuilder lines = new StringBuilder();
        for (RecordingChunk.Sent each : sent) {
            SendAuthority mandate = each.mandate();
            lines.append(start + each.offset())
                    .append('\t')
                    .append(mandate.command() == null ? NONE : mandate.command().value())
                    .append('\t')
                    .append(mandate.epoch() == null ? NONE : mandate.epoch().toString())
                    .append('\t')
                    .append(mandate.by())
                    .append('\n');
        }
        write(lines.toString());
    }

    /** Leaves out half a line at the end, and lines about what is not in the recording any more. */
    static void repair(Path file, long wholeBytes) throws IOException {
        if (!Files.exists(file)) {
            return;
        }
        String text = Files.readString(file);
        StringBuilder whole = new StringBuilder(HEADER);
        text.substring(0, text.lastIndexOf('\n') + 1)
                .lines()
                .skip(1)
                .filter(line -> Long.parseLong(line, 0, line.indexOf('\t'), 10) < wholeBytes)
                .forEach(line -> whole.append(line).append('\n'));
        Files.writeString(file, whole);
    }

    private void write(String lines) throws IOException {
        ByteBuffer bytes = StandardCharsets.UTF_8.encode(lines);
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
