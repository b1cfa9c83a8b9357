package org.dronemap.ws.zone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Zone files that say one thing and are another: read as they are meant, or refused with the reason. */
class OddZoneFileTest {
    private static final String AREA =
            "{\"type\":\"Polygon\",\"coordinates\":[[[9.1,46.2],[9.2,46.2],[9.2,46.3],[9.1,46.2]]]}";
    private static final String GOOD = feature("\"name\":\"good\"", AREA);
    private static final String CORNERS = "9.1,46.2,0 9.2,46.2,0 9.2,46.3,0 9.1,46.2,0";

    private static String feature(String properties, String geometry) {
        return "{\"type\":\"Feature\",\"properties\":{" + properties + "},\"geometry\":" + geometry + "}";
    }

    private static String collection(String before, String after, String... features) {
        return "{\"type\":\"FeatureCollection\"" + before + ",\"features\":[" + String.join(",", features) + "]" + after
                + "}";
    }

    private static String kml(String head, String name, String corners) {
        return head + "<kml><Placemark><name>" + name + "</name><Polygon><outerBoundaryIs><LinearRing><coordinates>"
                + corners + "</coordinates></LinearRing></outerBoundaryIs><innerBoundaryIs><LinearRing><coordinates>\n"
                + "</coordinates></LinearRing></innerBoundaryIs></Polygon></Placemark></kml>";
    }

    private static ZoneFile read(String text) {
        return ZoneImport.read(text.getBytes(StandardCharsets.UTF_8));
    }

    private static List<String> names(ZoneFile file) {
        return file.parts().stream()
                .map(part -> part.feature().properties().name())
                .toList();
    }

    private static String refusal(String text) {
        return catchThrowableOfType(Rejection.class, () -> read(text)).sentence();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "urn:ogc:def:crs:EPSG::3857",
                "EPSG:2056",
                "http://www.opengis.net/def/crs/EPSG/0/32632",
                "WGS 84"
            })
    void otherCoordinatesThanDegreesAreRefusedWhereverTheFileSaysSo(String system) {
        String crs = ",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"" + system + "\"}}";

        assertThat(refusal(collection(crs, "", GOOD))).contains(system, "longitude and latitude in degrees");
        assertThat(refusal(collection("", crs, GOOD))).contains(system, "save the file in that system");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"type\":\"name\",\"properties\":{\"name\":\"urn:ogc:def:crs:OGC:1.3:CRS84\"}}",
                "{\"type\":\"name\",\"properties\":{\"name\":\"EPSG:4326\"}}",
                "{\"type\":\"name\",\"properties\":{\"name\":\"http://www.opengis.net/def/crs/OGC/1.3/CRS84\"}}",
                "null"
            })
    void degreesByAnyNameAreTaken(String crs) {
        assertThat(names(read(collection(",\"crs\":" + crs, "", GOOD)))).containsExactly("good");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"type\":\"MultiPolygon\",\"coordinates\":[]}",
                "{\"type\":\"GeometryCollection\",\"geometries\":[]}",
                "{\"type\":\"Polygon\",\"coordinates\":[[[NaN,46.2],[9.2,46.2],[9.2,46.3],[9.1,46.2]]]}"
            })
    void whatIsEmptyOrNoNumberCostsOnlyItself(String odd) {
        ZoneFile file = read(collection("", "", feature("\"name\":\"odd\"", odd), GOOD));

        long unusable =
                file.parts().stream().filter(OddZoneFileTest::isUnusable).count();
        assertThat(names(file)).contains("good");
        assertThat(file.leftOut().size() + unusable).isEqualTo(1);
    }

    private static boolean isUnusable(ZoneFile.Part part) {
        return catchThrowableOfType(Rejection.class, () -> new ZoneReader(part.at(), part.feature()).shape()) != null;
    }

    @Test
    void jsonThatIsNestedTooDeeplyIsToldSo() {
        String deep = "{\"type\":\"Polygon\",\"coordinates\":" + "[".repeat(600) + "]".repeat(600) + "}";

        assertThat(refusal(collection("", "", feature("", deep)))).contains("nested too deeply");
    }

    @ParameterizedTest
    @CsvSource({
        "\"NAME\":\"CTR\", CTR",
        "\"Name\":\"CTR\", CTR",
        "\"name\":\"a\\ud800b\", a?b",
        "\"names\":\"x\", Zone 1"
    })
    void namesAreFoundInAnyCaseAndCanBeWrittenAsXml(String property, String name) {
        assertThat(names(read(collection("", "", feature(property, AREA))))).containsExactly(name);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\uFEFF<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>",
                "\uFEFF\n<?xml version=\"1.0\"?>",
                "\r\n \t<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
            })
    void aMarkOfUtf8CountsMoreThanTheFirstLineAndBlanksBeforeItMeanNothing(String head) {
        ZoneFile file = read(kml(head, "Zürich", CORNERS));

        assertThat(names(file)).containsExactly("Zürich");
        assertThat(isUnusable(file.parts().get(0))).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"R & D", "R&nbsp;D"})
    void whatXmlCannotNameIsRefusedWithTheWayOut(String name) {
        assertThat(refusal(kml("", name, CORNERS))).contains("written &amp;");
    }

    @ParameterizedTest
    @ValueSource(strings = {"9.1d,46.2f", "0x1p3,46.2", "NaN,46.2", "9.1,Infinity"})
    void whatOnlyJavaTakesForANumberIsNone(String corner) {
        ZoneFile file = read(kml("", "odd", corner + " 9.2,46.2 9.2,46.3"));

        assertThat(file.parts()).isEmpty();
        assertThat(file.leftOut().get(0).why().sentence()).contains("\"" + corner + "\"");
    }
}
