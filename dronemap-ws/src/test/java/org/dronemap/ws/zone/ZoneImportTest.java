package org.dronemap.ws.zone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What other programs write: one odd piece never throws the rest away, and is never dropped in silence. */
class ZoneImportTest {
    private static final String RING = "[[9.1,46.2],[9.2,46.2],[9.2,46.3],[9.1,46.2]]";
    private static final String AREA = "{\"type\":\"Polygon\",\"coordinates\":[" + RING + "]}";
    private static final String CORNERS = "9.1,46.2,0 9.2,46.2,0 9.2,46.3,0 9.1,46.2,0";

    private static ZoneFile read(String text) {
        return ZoneImport.read(text.getBytes(StandardCharsets.UTF_8));
    }

    private static String feature(String name, String geometry) {
        return "{\"type\":\"Feature\",\"properties\":{\"name\":\"" + name + "\"},\"geometry\":" + geometry + "}";
    }

    private static String collection(String... features) {
        return "{\"type\":\"FeatureCollection\",\"features\":[" + String.join(",", features) + "]}";
    }

    private static String polygon(String corners) {
        return "<Polygon><outerBoundaryIs><LinearRing><coordinates>" + corners
                + "</coordinates></LinearRing></outerBoundaryIs></Polygon>";
    }

    private static String placemark(String name, String shape) {
        return "<Placemark><name>" + name + "</name>" + shape + "</Placemark>";
    }

    private static String kml(String... placemarks) {
        return "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><name>All</name>" + String.join("", placemarks)
                + "</Document></kml>";
    }

    private static List<String> names(ZoneFile file) {
        return file.parts().stream()
                .map(part -> part.feature().properties().name())
                .toList();
    }

    private static List<String> leftOut(ZoneFile file) {
        return file.leftOut().stream().map(ZoneFile.LeftOut::at).toList();
    }

    private static FenceArea shape(ZoneFile.Part part) {
        return new ZoneReader(part.at(), part.feature()).shape();
    }

    /** What is no zone, or only with what is said of it. */
    static Stream<Arguments> oddPieces() {
        return Stream.of(
                Arguments.of(feature("odd", "null"), "a geometry"),
                Arguments.of("{\"type\":\"Feature\",\"properties\":null}", "a geometry"),
                Arguments.of("null", "a Feature"),
                Arguments.of("7", "a Feature"),
                Arguments.of("{\"type\":\"Topology\"}", "a Feature"),
                Arguments.of(
                        feature("odd", "{\"type\":\"LineString\",\"coordinates\":" + RING + "}"), "\"LineString\""),
                Arguments.of(feature("odd", "{\"type\":\"Point\",\"coordinates\":[9.1,46.2]}"), "radius"),
                Arguments.of(
                        feature("odd", "{\"type\":\"Polygon\",\"coordinates\":\"9.1 46.2\"}"), "rings of positions"),
                Arguments.of(
                        feature("odd", "{\"type\":\"Polygon\",\"coordinates\":[[[\"9.1\",46.2]]]}"),
                        "rings of positions"),
                Arguments.of(
                        feature("odd", "{\"type\":\"Polygon\",\"coordinates\":[[[9.1,46.2,0,9.2,46.2,0]]]}"),
                        "longitude, latitude"),
                Arguments.of(feature("odd", "{\"type\":\"MultiPolygon\",\"coordinates\":5}"), "a list"),
                Arguments.of(
                        "{\"type\":\"Feature\",\"properties\":{\"name\":\"odd\",\"floor\":\"GND\"},\"geometry\":" + AREA
                                + "}",
                        "\"floor\" must be a number"),
                Arguments.of("{\"type\":\"Feature\",\"properties\":[1],\"geometry\":" + AREA + "}", "properties"));
    }

    @ParameterizedTest
    @MethodSource("oddPieces")
    void anOddFeatureIsNamedAndTheOthersAreTaken(String odd, String words) {
        ZoneFile file = read(collection(feature("A", AREA), odd, feature("B", AREA)));

        assertThat(names(file)).containsExactly("A", "B");
        assertThat(leftOut(file)).containsExactly("features[1]");
        assertThat(file.leftOut().get(0).why().sentence()).contains(words);
    }

    static Stream<Arguments> oddPlacemarks() {
        String line = "<LineString><coordinates>" + CORNERS + "</coordinates></LineString>";
        return Stream.of(
                Arguments.of(line, "A line is no area"),
                Arguments.of("<Point><coordinates>9,46</coordinates></Point>", "A point is no area"),
                Arguments.of("<gx:Track><gx:coord>9 46 0</gx:coord></gx:Track>", "A track is no area"),
                Arguments.of("", "It has no Polygon"),
                Arguments.of(
                        polygon("9.1,46.2,0 9.2,46.2,0,9.2,46.3,0 9.1,46.3,0 9.1,46.2,0"), "\"9.2,46.2,0,9.2,46.3,0\""),
                Arguments.of(polygon("9.1;46.2 9.2;46.2 9.2;46.3"), "\"9.1;46.2\""),
                Arguments.of(polygon("9.1,46.2,x 9.2,46.2 9.2,46.3"), "\"9.1,46.2,x\""));
    }

    @ParameterizedTest
    @MethodSource("oddPlacemarks")
    void anOddPlacemarkIsNamedAndTheOthersAreTaken(String odd, String words) {
        ZoneFile file =
                read(kml(placemark("A", polygon(CORNERS)), placemark("odd", odd), placemark("B", polygon(CORNERS))));

        assertThat(names(file)).containsExactly("A", "B");
        assertThat(leftOut(file)).containsExactly("Placemark[1]");
        assertThat(file.leftOut().get(0).name()).isEqualTo("odd");
        assertThat(file.leftOut().get(0).why().sentence()).contains(words);
    }

    @Test
    void whatLiesElsewhereIsNamed() {
        ZoneFile file = read(kml(
                "<NetworkLink><Link><href>http://127.0.0.1/more.kml</href></Link></NetworkLink>",
                placemark("A", polygon(CORNERS)),
                "<GroundOverlay><name>Map</name></GroundOverlay>"));

        assertThat(names(file)).containsExactly("A");
        assertThat(leftOut(file)).containsExactly("NetworkLink", "GroundOverlay");
    }

    @Test
    void aMixedGeometryGivesItsAreasAndNamesTheRest() {
        ZoneFile kml = read(kml(placemark(
                "Park",
                "<MultiGeometry>" + polygon(CORNERS) + "<Point><coordinates>9,46</coordinates></Point>"
                        + polygon(CORNERS) + "</MultiGeometry>")));
        ZoneFile json = read(collection(feature(
                "Park",
                "{\"type\":\"GeometryCollection\",\"geometries\":[" + AREA
                        + ",{\"type\":\"LineString\",\"coordinates\":" + RING + "}]}")));

        assertThat(names(kml)).containsExactly("Park (1)", "Park (2)");
        assertThat(leftOut(kml)).containsExactly("Placemark[0]");
        assertThat(names(json)).containsExactly("Park");
        assertThat(leftOut(json)).containsExactly("features[0]");
    }

    @ParameterizedTest
    @CsvSource(
            value = {
                "9.1,46.2 9.2,46.2 9.2,46.3 9.1,46.3 9.1,46.2|4",
                "9.1,46.2,0 9.2,46.2,0 9.2,46.3,0 9.1,46.3,0 9.1,46.2,0 9.1,46.2,0|4",
                "9.1,46.2 9.1,46.2 9.2,46.2 9.2,46.3 9.2,46.3 9.1,46.3 9.1000000001,46.2|4",
                "9.1, 46.2, 0 9.2, 46.2, 0 9.2, 46.3, 0 9.1, 46.2, 0|3"
            },
            delimiter = '|')
    void repeatedCornersCountOnce(String corners, int different) {
        ZoneFile file = read(kml(placemark("A", polygon(corners))));

        assertThat(file.leftOut()).isEmpty();
        assertThat(((FenceArea.Polygon) shape(file.parts().get(0))).corners()).hasSize(different);
    }

    @ParameterizedTest
    @ValueSource(strings = {"ISO-8859-1", "windows-1252", "UTF-8", "UTF-16"})
    void namesAreReadInTheEncodingThatIsDeclared(String encoding) {
        String text = "<?xml version=\"1.0\" encoding=\"" + encoding + "\"?>"
                + kml(placemark("Zürich Flüh", polygon(CORNERS)));

        assertThat(names(ZoneImport.read(text.getBytes(Charset.forName(encoding)))))
                .containsExactly("Zürich Flüh");
    }

    @Test
    void anotherEncodingThanDeclaredIsRefusedAndNotFilledIn() {
        byte[] kml = kml(placemark("Zürich", polygon(CORNERS))).getBytes(StandardCharsets.ISO_8859_1);
        byte[] json = collection(feature("Zürich", AREA)).getBytes(StandardCharsets.ISO_8859_1);

        assertThat(catchThrowableOfType(Rejection.class, () -> ZoneImport.read(kml))
                        .sentence())
                .contains("not in the encoding that it declares");
        assertThat(catchThrowableOfType(Rejection.class, () -> ZoneImport.read(json))
                        .sentence())
                .startsWith("This is not JSON in UTF-8: line 1, column ");
    }

    @Test
    void aMarkOfByteOrderIsNoContent() {
        assertThat(names(read("\uFEFF" + collection(feature("A", AREA))))).containsExactly("A");
        assertThat(names(read("\uFEFF" + kml(placemark("A", polygon(CORNERS))))))
                .containsExactly("A");
    }

    @Test
    void prefixesNeedNotBeDeclared() {
        String kml = "<kml><Document xsi:schemaLocation=\"x y\">" + "<kml:Placemark><kml:name>A</kml:name><gx:balloon/>"
                + polygon(CORNERS).replace("<Polygon", "<kml:Polygon").replace("</Polygon", "</kml:Polygon")
                + "</kml:Placemark></Document></kml>";

        assertThat(names(read(kml))).containsExactly("A");
    }

    @Test
    void heightsOfCornersAreNamedWhereTheyMeanSomething() {
        String high = CORNERS.replace(",0", ",914");
        ZoneFile onTheGround = read(kml(placemark("A", polygon(high))));
        ZoneFile absolute = read(
                kml(placemark("A", polygon(high).replace("<outer", "<altitudeMode>absolute</altitudeMode><outer"))));
        ZoneFile json = read(collection(feature("A", AREA.replace("46.3]", "46.3,914]"))));

        assertThat(onTheGround.leftOut()).isEmpty();
        for (ZoneFile file : List.of(absolute, json)) {
            assertThat(names(file)).containsExactly("A");
            assertThat(file.leftOut()).hasSize(1);
            assertThat(file.leftOut().get(0).why().sentence())
                    .contains("914.0 m")
                    .contains("all heights");
        }
    }

    @Test
    void aNameThatIsTooLongIsCutAndSaidSo() {
        ZoneFile file = read(kml(placemark("n".repeat(95) + "\n2", polygon(CORNERS))));

        assertThat(names(file)).allMatch(name -> name.length() == 80 && name.endsWith("…"));
        assertThat(file.leftOut().get(0).why().sentence()).contains("97 characters");
    }

    @Test
    void aKmzIsUnpackedAndItsSecondFileNamed() throws IOException {
        ZoneFile file = ZoneImport.read(zip(
                List.of("picture.png", "doc.kml", "more/more.kml"),
                kml(placemark("A", polygon(CORNERS))).getBytes(StandardCharsets.UTF_8)));

        assertThat(names(file)).containsExactly("A");
        assertThat(leftOut(file)).containsExactly("more/more.kml");
    }

    @Test
    void aKmzThatUnpacksTooLargeIsRefused() throws IOException {
        byte[] bomb = zip(List.of("doc.kml"), new byte[33 * 1024 * 1024]);

        assertThat(catchThrowableOfType(Rejection.class, () -> ZoneImport.read(bomb))
                        .sentence())
                .contains("more than 32 MB");
    }

    private static byte[] zip(List<String> names, byte[] content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            for (String name : names) {
                zip.putNextEntry(new ZipEntry(name));
                zip.write(content);
            }
        }
        return bytes.toByteArray();
    }
}
