package org.dronemap.ws.zone;

import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;
import org.xml.sax.ErrorHandler;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/** Reads the polygons of a KML file as zones; lines, points, styles and heights are ignored. */
final class KmlZoneReader {
    private KmlZoneReader() {}

    static List<ZoneImport.Part> parts(String text) {
        NodeList places = parse(text).getElementsByTagNameNS("*", "Placemark");
        List<ZoneImport.Part> parts = new ArrayList<>();
        for (int i = 0; i < places.getLength(); i++) {
            if (places.item(i) instanceof Element place) {
                addAreas(place, "Placemark[" + i + "].", "Zone " + (i + 1), parts);
            }
        }
        if (parts.isEmpty()) {
            throw new InvalidInput(
                    ValueProblem.FILE_UNUSABLE,
                    "Placemark",
                    "at least one Polygon",
                    "There is no Polygon in this KML file.");
        }
        return parts;
    }

    private static void addAreas(Element place, String at, String fallback, List<ZoneImport.Part> parts) {
        NodeList areas = place.getElementsByTagNameNS("*", "Polygon");
        String given = text(place, "name");
        String name = given == null || given.isBlank() ? fallback : given;
        for (int i = 0; i < areas.getLength(); i++) {
            if (areas.item(i) instanceof Element area) {
                String numbered = areas.getLength() > 1 ? name + " (" + (i + 1) + ")" : name;
                parts.add(new ZoneImport.Part(at, ZoneImport.feature(rings(area, at), numbered)));
            }
        }
    }

    /** The outer one first, then those of holes, as GeoJSON has them. */
    private static List<List<List<Double>>> rings(Element area, String at) {
        NodeList coordinates = area.getElementsByTagNameNS("*", "coordinates");
        List<List<List<Double>>> rings = new ArrayList<>();
        for (int i = 0; i < coordinates.getLength(); i++) {
            List<List<Double>> ring = new ArrayList<>();
            for (String tuple : coordinates.item(i).getTextContent().strip().split("\\s+", -1)) {
                ring.add(position(tuple, at));
            }
            rings.add(ring);
        }
        return rings;
    }

    private static List<Double> position(String tuple, String at) {
        try {
            String[] numbers = tuple.split(",", -1);
            return List.of(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]));
        } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED, at + "coordinates", "longitude,latitude pairs", "\"" + tuple + "\"");
        }
    }

    private static @Nullable String text(Element element, String name) {
        for (Node child = element.getFirstChild(); child != null; child = child.getNextSibling()) {
            if (name.equals(child.getLocalName())) {
                return child.getTextContent().strip();
            }
        }
        return null;
    }

    private static Document parse(String text) {
        try {
            DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
            factory.setNamespaceAware(true);
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            // No entities of whatever kind: KML needs none, and they reach files and memory.
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            DocumentBuilder builder = factory.newDocumentBuilder();
            builder.setErrorHandler(new SilentErrorHandler());
            return builder.parse(new InputSource(new StringReader(text)));
        } catch (SAXParseException e) {
            throw Rejection.of(
                    RequestProblem.KML_UNREADABLE,
                    "This is not KML that can be read: it goes wrong in line " + e.getLineNumber() + ", column "
                            + e.getColumnNumber() + "; a DOCTYPE is not taken.",
                    ProblemParameter.LINE.is(e.getLineNumber()),
                    ProblemParameter.COLUMN.is(e.getColumnNumber()));
        } catch (SAXException | IOException e) {
            throw Rejection.of(RequestProblem.KML_UNREADABLE, "This is not KML.");
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Says nothing on the server's console; who sent the file is told. */
    private static final class SilentErrorHandler implements ErrorHandler {
        @Override
        public void warning(SAXParseException e) {
            // a warning keeps nothing from being read
        }

        @Override
        public void error(SAXParseException e) throws SAXParseException {
            throw e;
        }

        @Override
        public void fatalError(SAXParseException e) throws SAXParseException {
            throw e;
        }
    }
}
