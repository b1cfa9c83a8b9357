package org.dronemap.ws.zone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.mission.FenceArea;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Zone files that were reported to fail, or are of that kind, out of the test data. */
class ZoneCaseFilesTest {
    /** By file: names of zones with the corners of each, and where in the file something is left out. */
    static Stream<Arguments> files() {
        return Stream.of(
                Arguments.of("zone_150_corners.geojson", List.of("CTR 150"), List.of()),
                Arguments.of("zone_closed_twice.kml", List.of("Search 4", "Fine 3"), List.of()),
                Arguments.of("zone_latin1.kml", List.of("Flüelen 3"), List.of()),
                Arguments.of("zone_line_and_null.geojson", List.of("A 4"), List.of("features[1]", "features[2]")),
                Arguments.of("zone_one_comma.kml", List.of(), List.of("Placemark[0]")),
                Arguments.of("zone_prefix_undeclared.kml", List.of("A 3"), List.of()));
    }

    @ParameterizedTest
    @MethodSource("files")
    void whatIsGoodIsTakenAndTheRestIsNamed(String name, List<String> zones, List<String> leftOut) throws IOException {
        String folder = System.getenv("DRONEMAP_TEST_DATA");
        assumeTrue(folder != null, "DRONEMAP_TEST_DATA is not set: case files not read");

        ZoneFile file = ZoneImport.read(Files.readAllBytes(Path.of(folder, "cases", name)));

        assertThat(file.parts()).extracting(ZoneCaseFilesTest::zone).isEqualTo(zones);
        assertThat(file.leftOut()).extracting(ZoneFile.LeftOut::at).isEqualTo(leftOut);
    }

    private static String zone(ZoneFile.Part part) {
        ZoneReader reader = new ZoneReader(part.at(), part.feature());
        return reader.name() + " "
                + ((FenceArea.Polygon) reader.shape()).corners().size();
    }
}
