package org.dronemap.ws.zone;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/** Collects the areas of KML's placemarks while it is parsed, and names what else there is. One thread. */
final class KmlPlacemarks extends DefaultHandler {
    private static final Map<String, String> NO_AREAS = Map.of(
            "LineString", "line",
            "Point", "point",
            "LinearRing", "line",
            "Model", "model",
            "Track", "track",
            "MultiTrack", "track");
    private static final Map<String, String> NO_PLACES = Map.of(
            "NetworkLink", "link to another file",
            "GroundOverlay", "picture",
            "PhotoOverlay", "picture",
            "ScreenOverlay", "picture");

    private final ZoneFile file = new ZoneFile();
    private final Deque<String> open = new ArrayDeque<>();
    private final StringBuilder text = new StringBuilder();
    private int count;
    private @Nullable Placemark placemark;
    private @Nullable KmlPolygon polygon;

    /** One of them, with what it has until it ends. */
    private static final class Placemark {
        private final String at;
        private final int number;
        private final List<KmlPolygon> polygons = new ArrayList<>();
        private final List<String> others = new ArrayList<>();
        private @Nullable String name;

        Placemark(int index) {
            at = "Placemark[" + index + "]";
            number = index + 1;
        }
    }

    ZoneFile file() {
        return file;
    }

    @Override
    public void startElement(String uri, String localName, String qualified, Attributes attributes) {
        String name = local(qualified);
        text.setLength(0);
        if (name.equals("Placemark")) {
            placemark = new Placemark(count++);
        } else if (placemark != null && name.equals("Polygon")) {
            polygon = new KmlPolygon(placemark.at + ".coordinates");
        } else if (placemark != null && polygon == null && NO_AREAS.containsKey(name) && !isWithinNoArea()) {
            placemark.others.add(NO_AREAS.getOrDefault(name, name));
        } else if (placemark == null && NO_PLACES.containsKey(name)) {
            file.leaveOut(name, null, NO_PLACES.getOrDefault(name, name));
        }
        open.push(name);
    }

    private boolean isWithinNoArea() {
        String parent = open.peek();
        return parent != null && NO_AREAS.containsKey(parent);
    }

    @Override
    public void characters(char[] letters, int start, int length) {
        text.append(letters, start, length);
    }

    @Override
    public void endElement(String uri, String localName, String qualified) {
        String name = open.pop();
        switch (name) {
            case "name" -> {
                if (placemark != null && "Placemark".equals(open.peek())) {
                    placemark.name = text.toString();
                }
            }
            case "coordinates" -> {
                if (polygon != null) {
                    polygon.ring(text.toString());
                }
            }
            case "altitudeMode" -> {
                if (polygon != null) {
                    polygon.altitudeMode(text.toString().strip());
                }
            }
            case "Polygon" -> {
                if (placemark != null && polygon != null) {
                    placemark.polygons.add(polygon);
                }
                polygon = null;
            }
            case "Placemark" -> {
                if (placemark != null) {
                    end(placemark);
                }
                placemark = null;
            }
            default -> {
                // styles, descriptions and the like
            }
        }
        text.setLength(0);
    }

    private void end(Placemark ended) {
        ZoneFileName name = ZoneFileName.of(ended.name, "Zone " + ended.number);
        ended.others.forEach(kind -> file.leaveOut(ended.at, name.whole(), kind));
        boolean several = ended.polygons.size() > 1;
        for (int i = 0; i < ended.polygons.size(); i++) {
            add(ended, ended.polygons.get(i), name, several ? i + 1 : 0);
        }
        if (ended.polygons.isEmpty() && ended.others.isEmpty()) {
            file.leaveOut(
                    ended.at,
                    name.whole(),
                    new InvalidInput(ValueProblem.FILE_UNUSABLE, ended.at, "a Polygon", "It has no Polygon."));
        }
    }

    private void add(Placemark ended, KmlPolygon area, ZoneFileName name, int number) {
        InvalidInput fault = area.fault();
        if (fault != null) {
            file.leaveOut(ended.at, name.numbered(number), fault);
            return;
        }
        file.add(
                ended.at + ".",
                GeoJsonZoneReader.feature(
                        new ZoneGeometry.Polygon(area.rings()),
                        name.numbered(number),
                        ZoneFeature.ZoneProperties.NONE));
        name.cut(ended.at + ".name").ifPresent(why -> file.leaveOut(ended.at, name.whole(), why));
        if (area.hasHeights()) {
            file.leaveOutHeights(ended.at, name.numbered(number), area.lowest(), area.highest());
        }
    }

    /** Without its prefix, declared or not. */
    private static String local(String qualified) {
        return qualified.substring(qualified.indexOf(':') + 1);
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
