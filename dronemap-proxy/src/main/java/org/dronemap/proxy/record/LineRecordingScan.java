package org.dronemap.proxy.record;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.mavlink.tlog.TlogScan;

/** Scans the recording of a robot line by line, to find its length and times up to the last whole line. */
final class LineRecordingScan {
    private static final Pattern TIME = Pattern.compile("\\{\"at\":(\\d{1,18}),.*");
    private static final int LONGEST_LINE = 65_536;

    private LineRecordingScan() {}

    static TlogScan of(Path file) throws IOException {
        long lines = 0;
        long whole = 0;
        long first = 0;
        long last = 0;
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            String line = next(in);
            Matcher time = TIME.matcher(line);
            while (line.endsWith("\n") && time.lookingAt()) {
                last = Long.parseLong(time.group(1));
                first = lines == 0 ? last : first;
                lines++;
                whole += line.length();
                line = next(in);
                time.reset(line);
            }
        }
        return new TlogScan(lines, whole, first, last);
    }

    /** Up to the end of the line or of the file, a character for each byte. */
    private static String next(InputStream in) throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        int read = in.read();
        while (read >= 0 && line.size() < LONGEST_LINE) {
            line.write(read);
            if (read == '\n') {
                break;
            }
            read = in.read();
        }
        return line.toString(StandardCharsets.ISO_8859_1);
    }
}
