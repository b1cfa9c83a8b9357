package org.dronemap.ws.zone;

import java.io.ByteArrayInputStream;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.UnsupportedEncodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParser;
import javax.xml.parsers.SAXParserFactory;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/** Reads the polygons of a KML file as zones, in the encoding that it declares. */
final class KmlZoneReader {
    private static final String OTHER_ENCODING =
            "This KML is not in the encoding that it declares (UTF-8 where it declares none); save it as UTF-8, or name"
                    + " the right one in its first line";

    private static final byte[] UTF_8_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};
    private static final String BLANKS = " \t\r\n";

    private KmlZoneReader() {}

    static ZoneFile read(byte[] kml) {
        KmlPlacemarks placemarks = new KmlPlacemarks();
        try {
            parser().parse(source(kml), placemarks);
        } catch (SAXParseException e) {
            throw unreadable(e);
        } catch (UnsupportedEncodingException e) {
            throw Rejection.of(
                    RequestProblem.KML_UNREADABLE,
                    "This KML declares an encoding that is not known: " + e.getMessage() + ".");
        } catch (CharConversionException e) {
            throw Rejection.of(RequestProblem.KML_UNREADABLE, OTHER_ENCODING + ".");
        } catch (SAXException | IOException e) {
            throw Rejection.of(RequestProblem.KML_UNREADABLE, "This is not KML.");
        }
        return placemarks.file();
    }

    /**
     * A mark of UTF-8 counts more than what the first line declares: programs convert files and leave that line. Blanks
     * before that line, which XML does not allow, mean nothing.
     */
    private static InputSource source(byte[] kml) {
        boolean marked =
                kml.length >= UTF_8_MARK.length && Arrays.equals(Arrays.copyOf(kml, UTF_8_MARK.length), UTF_8_MARK);
        int begin = marked ? UTF_8_MARK.length : 0;
        while (begin < kml.length && BLANKS.indexOf(kml[begin]) >= 0) {
            begin++;
        }
        InputSource source = new InputSource(new ByteArrayInputStream(kml, begin, kml.length - begin));
        if (marked) {
            source.setEncoding(StandardCharsets.UTF_8.name());
        }
        return source;
    }

    private static Rejection unreadable(SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        String place = "line " + e.getLineNumber() + ", column " + e.getColumnNumber();
        String broken = "This is not KML that can be read: it goes wrong in " + place;
        String sentence = broken + ".";
        if (message.contains("DOCTYPE")) {
            sentence = broken + "; a DOCTYPE is not taken.";
        } else if (message.contains("entity")) {
            sentence = broken + "; a lone & is written &amp; in KML, and no other names but those of XML are known.";
        } else if (message.startsWith("Invalid byte")) {
            sentence = OTHER_ENCODING + " (" + place + ").";
        }
        return Rejection.of(
                RequestProblem.KML_UNREADABLE,
                sentence,
                ProblemParameter.LINE.is(e.getLineNumber()),
                ProblemParameter.COLUMN.is(e.getColumnNumber()));
    }

    /** Without namespaces: elements are known by their names, and programs forget to declare prefixes. */
    private static SAXParser parser() throws SAXException {
        try {
            SAXParserFactory factory = SAXParserFactory.newInstance();
            factory.setNamespaceAware(false);
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            // No entities of whatever kind: KML needs none, and they reach files and memory.
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            return factory.newSAXParser();
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException(e);
        }
    }
}
