package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.sim.autopilot.items.ArduPilotItemStorage;
import org.dronemap.sim.autopilot.items.MissionItemStorage;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Holds what the simulated vehicles take of mission items, and keep of them, against what real ones did. */
class RecordedItemsTest {
    private static final double CENTIMETER = 0.011;

    /** A real one lets less than no turns run over into the radius. */
    private static final String TURNS_BACKWARDS = "18 negative";

    @ParameterizedTest
    @CsvSource({"arducopter, copter", "arduplane, plane", "ardurover, rover"})
    void takesAndKeepsWhatTheRealOneDid(String recording, String vehicle) {
        MissionItemStorage storage = ArduPilotItemStorage.of(vehicle);
        List<RecordedItems.Probe> probes = RecordedItems.of(recording).probes();
        assertThat(probes).hasSizeGreaterThan(900);
        for (RecordedItems.Probe probe : probes) {
            assertThat(storage.judge(probe.sent(), 1)).as(probe.name()).isEqualTo((int) probe.ack());
            if (probe.ack() == MissionItemStorage.ACCEPTED && !probe.name().equals(TURNS_BACKWARDS)) {
                assertSame(probe.name(), storage.keep(probe.sent()), RecordedItems.read(probe));
            }
        }
    }

    /** Through real messages, of each command what was sent first. */
    @Test
    void answersAnUploadAsTheRealOneDid() {
        VehicleTestBench bench = VehicleTestBench.ready();
        Stream<RecordedItems.Probe> first = RecordedItems.of("arducopter").probes().stream()
                .filter(probe -> probe.name().endsWith(" whole"));
        first.forEach(probe -> {
            bench.heard.clear();
            bench.upload(bench.item(0, 16, 0, 0, 0), message(probe.sent()));
            assertThat(bench.last(MissionAck.ID, MissionAck::decode).type())
                    .as(probe.name())
                    .isEqualTo((int) probe.ack());
            if (probe.ack() == MissionItemStorage.ACCEPTED) {
                bench.send(new MissionRequestInt(1, 1, 1, 0));
                MissionItemInt read = bench.last(MissionItemInt.ID, MissionItemInt::decode);
                assertThat(message(RecordedItems.read(probe))).as(probe.name()).isEqualTo(sentBy(read));
            }
        });
    }

    private static MissionItemInt message(SimulatedMissionItem item) {
        return new MissionItemInt(
                1,
                1,
                1,
                item.frame(),
                item.command(),
                0,
                1,
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                item.x(),
                item.y(),
                item.z(),
                0);
    }

    /** Addressed as the test addresses it. */
    private static MissionItemInt sentBy(MissionItemInt read) {
        return new MissionItemInt(
                1,
                1,
                read.seq(),
                read.frame(),
                read.command(),
                read.current(),
                read.autocontinue(),
                read.param1(),
                read.param2(),
                read.param3(),
                read.param4(),
                read.x(),
                read.y(),
                read.z(),
                read.missionType());
    }

    private static void assertSame(String name, SimulatedMissionItem kept, SimulatedMissionItem real) {
        assertThat(kept.command()).as(name).isEqualTo(real.command());
        assertThat(kept.frame()).as(name).isEqualTo(real.frame());
        assertThat(kept.x()).as(name).isEqualTo(real.x());
        assertThat(kept.y()).as(name).isEqualTo(real.y());
        assertNumber(name, kept.param1(), real.param1());
        assertNumber(name, kept.param2(), real.param2());
        assertNumber(name, kept.param3(), real.param3());
        assertNumber(name, kept.param4(), real.param4());
        assertNumber(name, kept.z(), real.z());
    }

    /** A recording has no word for what is beyond all numbers. */
    private static void assertNumber(String name, float kept, float real) {
        if (Float.isNaN(real)) {
            assertThat(kept).as(name).isInfinite();
        } else {
            assertThat((double) kept).as(name).isEqualTo(real, within(CENTIMETER));
        }
    }
}
