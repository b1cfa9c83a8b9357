package org.dronemap.ws.zone;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;

/**
 * Reads zones from GeoJSON, KML or KMZ files made by other programs: what cannot be a zone is named, and the rest is
 * taken.
 */
final class ZoneImport {
    private static final char MARK = '\uFEFF';
    /** Bytes of a mark of byte order are no less. */
    private static final int FIRST_OF_MARK = 0xBB;

    private ZoneImport() {}

    /** In whatever form it is. */
    static ZoneFile read(byte[] file) {
        if (KmzFile.isOne(file)) {
            KmzFile packed = KmzFile.of(file);
            ZoneFile read = KmlZoneReader.read(packed.kml());
            packed.others().forEach(name -> read.leaveOut(name, name, "second KML file of a KMZ"));
            return read;
        }
        return isXml(file) ? KmlZoneReader.read(file) : GeoJsonZoneReader.read(text(file));
    }

    /** The first byte that is no blank, in whatever encoding. */
    private static boolean isXml(byte[] file) {
        for (byte one : file) {
            int value = one & 0xFF;
            if (value > ' ' && value < FIRST_OF_MARK) {
                return value == '<';
            }
        }
        return false;
    }

    /** JSON is UTF-8; what is not must not be filled in with other characters. */
    private static String text(byte[] file) {
        ByteBuffer bytes = ByteBuffer.wrap(file);
        CharBuffer text = CharBuffer.allocate(file.length + 1);
        CharsetDecoder decoder = charset(file)
                .newDecoder()
                .onMalformedInput(CodingErrorAction.REPORT)
                .onUnmappableCharacter(CodingErrorAction.REPORT);
        CoderResult end = decoder.decode(bytes, text, true);
        text.flip();
        if (end.isError()) {
            String read = text.toString();
            long line = read.chars().filter(each -> each == '\n').count() + 1;
            int column = read.length() - read.lastIndexOf('\n');
            throw Rejection.of(
                    RequestProblem.JSON_UNREADABLE,
                    "This is not JSON in UTF-8: line " + line + ", column " + column
                            + " has a byte of another encoding; save the file as UTF-8.",
                    ProblemParameter.LINE.is(line),
                    ProblemParameter.COLUMN.is(column));
        }
        boolean marked = text.length() > 0 && text.charAt(0) == MARK;
        return marked ? text.subSequence(1, text.length()).toString() : text.toString();
    }

    private static Charset charset(byte[] file) {
        boolean wide = file.length > 1 && ((file[0] & 0xFF) == 0xFE || (file[0] & 0xFF) == 0xFF);
        return wide ? StandardCharsets.UTF_16 : StandardCharsets.UTF_8;
    }
}
