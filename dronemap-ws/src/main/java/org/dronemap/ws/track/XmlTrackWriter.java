package org.dronemap.ws.track;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.ws.reading.PositionedPoints;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Writes a drone's recorded track as KML or GPX. */
final class XmlTrackWriter {
    private static final String KML = "http://www.opengis.net/kml/2.2";
    private static final String GX = "http://www.google.com/kml/ext/2.2";
    private static final String GPX = "http://www.topografix.com/GPX/1/1";
    private static final String NOT_IN_XML = "[^\\t\\n\\r\\u0020-\\uD7FF\\uE000-\\uFFFD\\x{10000}-\\x{10FFFF}]";

    private XmlTrackWriter() {}

    /** The track with its times, and a place mark for each thing that happened. */
    static void kml(TrackFormat.Track track, Writer out) throws IOException {
        List<TelemetryPoint> placed = PositionedPoints.of(track.points());
        try {
            XMLStreamWriter xml = begin(out);
            xml.writeStartElement("kml");
            xml.writeDefaultNamespace(KML);
            xml.writeNamespace("gx", GX);
            xml.writeStartElement("Document");
            element(xml, "name", track.name());
            xml.writeStartElement("Placemark");
            element(xml, "name", track.name());
            xml.writeStartElement("gx:Track");
            element(xml, "altitudeMode", "absolute");
            for (TelemetryPoint point : placed) {
                element(xml, "when", point.at().toString());
            }
            for (TelemetryPoint point : placed) {
                element(xml, "gx:coord", coordinates(point, " "));
            }
            xml.writeEndElement();
            xml.writeEndElement();
            for (HistoryEvent event : track.events()) {
                mark(xml, event, PositionedPoints.at(placed, event.at()).orElse(null));
            }
            end(xml);
        } catch (XMLStreamException e) {
            throw new IOException(e);
        }
    }

    private static void mark(XMLStreamWriter xml, HistoryEvent event, @Nullable TelemetryPoint where)
            throws XMLStreamException {
        if (where == null) {
            return;
        }
        xml.writeStartElement("Placemark");
        element(xml, "name", event.text());
        element(xml, "description", WireNames.camel(event.kind()));
        xml.writeStartElement("TimeStamp");
        element(xml, "when", event.at().toString());
        xml.writeEndElement();
        xml.writeStartElement("Point");
        element(xml, "altitudeMode", "absolute");
        element(xml, "coordinates", coordinates(where, ","));
        xml.writeEndElement();
        xml.writeEndElement();
    }

    static void gpx(TrackFormat.Track track, Writer out) throws IOException {
        try {
            XMLStreamWriter xml = begin(out);
            xml.writeStartElement("gpx");
            xml.writeDefaultNamespace(GPX);
            xml.writeAttribute("version", "1.1");
            xml.writeAttribute("creator", "Dronemap");
            xml.writeStartElement("trk");
            element(xml, "name", track.name());
            xml.writeStartElement("trkseg");
            for (TelemetryPoint point : PositionedPoints.of(track.points())) {
                Geodetic place = PositionedPoints.place(point);
                Double altitude = TelemetryField.ALTITUDE_AMSL.of(point);
                xml.writeStartElement("trkpt");
                xml.writeAttribute("lat", String.valueOf(place.latitudeDegrees()));
                xml.writeAttribute("lon", String.valueOf(place.longitudeDegrees()));
                if (altitude != null) {
                    element(xml, "ele", altitude.toString());
                }
                element(xml, "time", point.at().toString());
                xml.writeEndElement();
            }
            end(xml);
        } catch (XMLStreamException e) {
            throw new IOException(e);
        }
    }

    private static XMLStreamWriter begin(Writer out) throws XMLStreamException {
        XMLStreamWriter xml = XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(out);
        xml.writeStartDocument("UTF-8", "1.0");
        return xml;
    }

    private static void end(XMLStreamWriter xml) throws XMLStreamException {
        xml.writeEndDocument();
        xml.flush();
    }

    private static void element(XMLStreamWriter xml, String name, String text) throws XMLStreamException {
        xml.writeStartElement(name);
        xml.writeCharacters(text.replaceAll(NOT_IN_XML, "\uFFFD"));
        xml.writeEndElement();
    }

    private static String coordinates(TelemetryPoint point, String between) {
        Geodetic place = PositionedPoints.place(point);
        Double altitude = TelemetryField.ALTITUDE_AMSL.of(point);
        return place.longitudeDegrees()
                + between
                + place.latitudeDegrees()
                + (altitude == null ? "" : between + altitude);
    }
}
