package org.dronemap.ws.flights.separation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.ws.lab.LaboratorySetup;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Operations of several people through each other's ways: without anything that keeps them apart they come too near to each
 * other, with it they do not, and all is flown nevertheless. Hundreds of seeds are a trial.
 */
class SeparationScenarioTest {
    private static final List<Long> SEEDS = List.of(1L, 3L);
    private static final double BEFORE_THE_MEETING = 4;

    /** Thirty drones take too long for here. */
    static Stream<Arguments> flights() {
        return Arrays.stream(Scenario.values())
                .filter(scenario -> scenario != Scenario.FLEET)
                .flatMap(scenario -> SEEDS.stream().map(seed -> Arguments.of(scenario, seed)));
    }

    @ParameterizedTest
    @MethodSource("flights")
    void dronesOfAllOperationsKeepApart(Scenario scenario, long seed) {
        SeparationFlight flight = SeparationFlight.of(scenario, seed);

        FlownTogether rehearsal = flight.rehearsal();
        FlownTogether flown = flight.together(Disturbance.NONE, 0);

        assertThat(rehearsal.leastShare()).as("where nothing keeps them apart").isLessThan(1);
        assertThat(rehearsal.faults()).isEmpty();
        assertThat(flown.faults()).isEmpty();
        if (LaboratorySetup.isSeparationOn()) {
            assertThat(flown.leastShare()).isGreaterThanOrEqualTo(1);
        }
    }

    /** Whatever it is: all are down in the end. Drones that are left to themselves are for the trial. */
    @ParameterizedTest
    @EnumSource(
            mode = EnumSource.Mode.EXCLUDE,
            names = {"NONE", "SILENT", "KILLED", "RESTARTED"})
    void whatComesBetweenBringsNobodyTogether(Disturbance disturbance) {
        SeparationFlight flight = SeparationFlight.of(Scenario.TWO_RUNS, 1);

        FlownTogether flown = flight.together(disturbance, flight.meeting().seconds() - BEFORE_THE_MEETING);

        assertThat(flown.faults()).isEmpty();
        if (LaboratorySetup.isSeparationOn()) {
            assertThat(flown.leastShare()).isGreaterThanOrEqualTo(1);
        }
    }

    @Test
    void writesDownWhereAllOfThemTrulyWere(@TempDir Path folder) throws IOException {
        FlownTogether flown = SeparationFlight.of(Scenario.VIRTUAL_DRONE, 1).rehearsal();

        Path own = flown.writeInto(folder);

        List<String> lines = Files.readAllLines(own.resolve("tracks.csv"));
        assertThat(lines.get(0)).isEqualTo("seed,second,vehicle,latitude,longitude,amsl,above_pad,armed");
        assertThat(lines.get(1)).matches("1,0\\.0,arducopter 1,47\\.\\d{9},8\\.\\d{9},4\\d\\d\\.\\d{3},-?0\\.000,0");
        assertThat(lines.get(2)).startsWith("1,0.1,arducopter 1,");
        assertThat(Files.readString(own.resolve("facts.json")))
                .contains("\"scenario\" : \"virtual-drone\"", "\"undisturbed\" : ", "\"mechanism\" : false");
    }
}
