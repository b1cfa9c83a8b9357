package org.dronemap.ws.zone;

import java.io.ByteArrayInputStream;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.UnsupportedEncodingException;
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

    private KmlZoneReader() {}

    static ZoneFile read(byte[] kml) {
        KmlPlacemarks placemarks = new KmlPlacemarks();
        try {
            parser().parse(new InputSource(new ByteArrayInputStream(kml)), placemarks);
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

    private static Rejection unreadable(SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        String place = "line " + e.getLineNumber() + ", column " + e.getColumnNumber();
        String broken = "This is not KML that can be read: it goes wrong in " + place;
        String sentence = broken + ".";
        if (message.contains("DOCTYPE")) {
            sentence = broken + "; a DOCTYPE is not taken.";
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
