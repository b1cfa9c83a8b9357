package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Changes of speed and landings that ground stations of other makers ask for. */
class ClientFlightCommandsTest {
    private static final int CHANGE_SPEED = 178;
    private static final int LAND = 21;
    private static final int SET_MODE = 176;
    private static final int DENIED = 2;

    private final OutletTestBench bench = new OutletTestBench();

    ClientFlightCommandsTest() throws IOException {}

    @BeforeEach
    void flies() {
        bench.is(MatrixVehicle.State.FLYING);
    }

    @AfterEach
    void close() throws IOException {
        bench.close();
    }

    private List<CommandLong> reached(int command) {
        return bench.reachedVehicle(CommandLong.ID).stream()
                .map(CommandLong::decode)
                .filter(one -> one.command() == command)
                .toList();
    }

    private static CommandLong speed(float type, float metersPerSecond, float throttle) {
        return new CommandLong(1, 1, CHANGE_SPEED, 0, type, metersPerSecond, throttle, 0, 0, 0, 0);
    }

    /** As MAVSDK and QGroundControl send it to copters; type 0 is what older programs send. */
    @ParameterizedTest
    @CsvSource({"0, -1", "1, -1", "1, 0"})
    void aSpeedReachesTheVehicle(float type, float throttle) {
        OutletTestBench.Station ann = bench.new Station("ann", 255);
        ann.answer(CommandAck.ID, speed(type, 5, throttle));

        assertThat(reached(CHANGE_SPEED)).isNotEmpty().allMatch(sent -> sent.param2() == 5);
    }

    @ParameterizedTest
    @CsvSource({
        "1, 31, -1, 'metersPerSecond must be 0.2 to 30'",
        "1, -2, -1, 'This cannot be asked'",
        "1, NaN, -1, 'This cannot be asked'",
        "1, 5, 60, 'A speed passes without a throttle.'",
        "2, 5, -1, 'Only the speed through the air (0) of planes passes'"
    })
    void aSpeedThatIsNoneIsRefusedWithTheReason(float type, float speed, float throttle, String reason) {
        OutletTestBench.Station ann = bench.new Station("ann", 255);
        CommandAck answer = CommandAck.decode(ann.answer(CommandAck.ID, speed(type, speed, throttle)));

        assertThat(answer.result()).isEqualTo(DENIED);
        ann.awaitText(reason);
        assertThat(reached(CHANGE_SPEED)).isEmpty();
    }

    @Test
    void whoOnlyLooksChangesNoSpeed() {
        OutletTestBench.Station eve = bench.new Station("eve", 255);
        CommandAck answer = CommandAck.decode(eve.answer(CommandAck.ID, speed(1, 5, -1)));

        assertThat(answer.result()).isEqualTo(DENIED);
        assertThat(reached(CHANGE_SPEED)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "NaN, NaN", "47.39774, 8.54559"})
    void aLandingIsOne(float latitude, float longitude) {
        OutletTestBench.Station ann = bench.new Station("ann", 255);
        ann.answer(CommandAck.ID, new CommandLong(1, 1, LAND, 0, 0, 0, 0, 0, latitude, longitude, 0));

        assertThat(reached(SET_MODE)).isNotEmpty();
        assertThat(ann.texts()).doesNotContain("not at the place");
    }

    @Test
    void whoNamesAPlaceToLandAtIsToldThatItLandsWhereItIs() {
        OutletTestBench.Station ann = bench.new Station("ann", 255);
        ann.answer(CommandAck.ID, new CommandLong(1, 1, LAND, 0, 0, 0, 0, 0, 47.4F, 8.55F, 0));

        ann.awaitText("It lands where it is, not at the place that is named");
        assertThat(reached(SET_MODE)).isNotEmpty();
    }

    @Test
    void aPlaceToLookAtIsAnsweredUnsupported() {
        OutletTestBench.Station ann = bench.new Station("ann", 255);
        CommandAck answer = CommandAck.decode(
                ann.answer(CommandAck.ID, new CommandLong(1, 1, 201, 0, 3, 0, 0, 0, 47.4F, 8.55F, 0)));

        assertThat(answer.result()).isEqualTo(3);
        ann.awaitText("Command 201 does not pass the cloud.");
    }
}
