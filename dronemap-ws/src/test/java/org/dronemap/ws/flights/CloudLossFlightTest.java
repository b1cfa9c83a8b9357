package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whoever does not hear the cloud any more comes home, and is its owner's again afterwards. */
class CloudLossFlightTest {
    private static final double METERS = 10;
    private static final Duration HOMEWARD = Duration.ofMinutes(3);
    /** Control runs out, and then it has to stand for a while. */
    private static final Duration GIVEN_BACK = Duration.ofSeconds(60);

    private static final List<String> CONCERNED = List.of(
            "FS_GCS_ENABLE",
            "FS_GCS_TIMEOUT",
            "FS_OPTIONS",
            "RTL_ALT",
            "NAV_DLL_ACT",
            "COM_DL_LOSS_T",
            "RTL_RETURN_ALT");

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final Pilot bob = lab.pilot("bob", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    static Stream<VehicleSpec> autopilots() {
        return VehicleSpec.autopilots();
    }

    private static Map<String, Double> settings(LabDrone drone) {
        return CONCERNED.stream()
                .filter(name -> drone.vehicle().autopilot().parameters().indexOf(name) >= 0)
                .collect(Collectors.toMap(name -> name, name -> parameter(drone, name)));
    }

    private static double parameter(LabDrone drone, String name) {
        return drone.vehicle().autopilot().parameters().value(name);
    }

    private void hovers(LabDrone drone) {
        drone.known()
                .filter(state -> state.capabilities().modes().contains("GUIDED"))
                .ifPresent(state -> ann.does(drone, CommandRequests.setMode("GUIDED")));
        ann.does(drone, CommandRequests.arm()).does(drone, CommandRequests.takeOff(METERS));
        lab.until("it hovers", Duration.ofSeconds(30), () -> drone.height() > METERS - 1);
    }

    private void isGivenBack(LabDrone drone, Map<String, Double> owners) {
        lab.until(
                "it is given back",
                GIVEN_BACK,
                () -> settings(drone).equals(owners)
                        && lab.stores().owners().all().isEmpty());
    }

    /** When it was told what to set, and was armed. */
    private static void isNeverWrittenToWhenArmed(LabDrone drone) {
        assertThat(drone.wire().traffic().down(0, ParamSet.ID))
                .isNotEmpty()
                .allSatisfy(set -> assertThat(
                                drone.track().since(set.atNanos()).get(0).armed())
                        .isFalse());
    }

    @ParameterizedTest
    @MethodSource("autopilots")
    void whoeverDoesNotHearTheCloudAnyMoreComesHomeAndIsItsOwnersAgain(VehicleSpec kit) {
        LabDrone drone = lab.ready(lab.add(kit));
        Map<String, Double> owners = settings(drone);
        hovers(drone);
        assertThat(settings(drone)).isNotEqualTo(owners);
        assertThat(lab.server().house().cloud().cloudLoss(drone.id()).sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 20 s.");

        lab.crashServer();
        lab.throughout("it waits", Duration.ofSeconds(15), () -> drone.height() > METERS - 2);
        lab.until("it is down", HOMEWARD, drone::isDown);
        assertThat(drone.away()).isLessThan(2);
        lab.startServer();

        isGivenBack(drone, owners);
        isNeverWrittenToWhenArmed(drone);
        assertThat(lab.server().house().cloud().cloudLoss(drone.id())).isEqualTo(CloudLossState.UNKNOWN);
    }

    @Test
    void oneThatNobodyHasControlOfAnyMoreIsGivenBackOnTheGroundOnly() {
        LabDrone drone = lab.copter();
        Map<String, Double> owners = settings(drone);
        hovers(drone);

        lab.until("it comes home by itself and is down", Duration.ofMinutes(5), drone::isDown);

        isGivenBack(drone, owners);
        isNeverWrittenToWhenArmed(drone);
    }

    @Test
    void oneWhoseLinkIsCutInTheMiddleOfItIsGivenBackWhenItIsHeardAgain() {
        LabDrone drone = lab.copter();
        Map<String, Double> owners = settings(drone);
        ann.give(drone, CommandRequests.arm());
        lab.until(
                "a part is written",
                Duration.ofSeconds(5),
                () -> !settings(drone).equals(owners));
        drone.wire().cut();
        lab.goOn(Duration.ofSeconds(60));
        assertThat(lab.stores().owners().all()).hasSize(1);
        assertThat(settings(drone)).isNotEqualTo(owners);
        lab.crashServer();
        lab.startServer();
        assertThat(lab.server().house().cloud().cloudLoss(drone.id()).outstanding())
                .isNotEmpty();

        drone.wire().mend();

        lab.until("it is down", Duration.ofMinutes(1), drone::isDown);
        isGivenBack(drone, owners);
    }

    @Test
    void aServerThatIsKilledBeforeItIsWrittenKnowsWhatItsOwnerHad() {
        LabDrone drone = lab.copter();
        Map<String, Double> owners = settings(drone);
        ann.give(drone, CommandRequests.arm());
        lab.until(
                "it is kept",
                Duration.ofSeconds(5),
                () -> !lab.stores().owners().all().isEmpty());
        lab.crashServer();
        lab.goOn(Duration.ofSeconds(40));
        lab.startServer();
        lab.ready(drone);

        ann.does(drone, CommandRequests.arm());
        lab.until("it disarms by itself", Duration.ofSeconds(30), drone::isDown);

        isGivenBack(drone, owners);
    }

    @Test
    void twoThatAreArmedAtTheSameMomentFlyHomeAtDifferentHeights() {
        List<LabDrone> drones = lab.copters(2);
        LabDrone one = drones.get(0);
        LabDrone other = drones.get(1);

        var first = ann.give(one, CommandRequests.arm());
        var second = bob.give(other, CommandRequests.arm());
        ann.succeeds(first);
        bob.succeeds(second);

        assertThat(Math.abs(parameter(one, "RTL_ALT") - parameter(other, "RTL_ALT")))
                .isGreaterThanOrEqualTo(1_500);
        lab.until("they disarm by themselves", Duration.ofSeconds(30), () -> one.isDown() && other.isDown());
        lab.until(
                "both are given back",
                GIVEN_BACK,
                () -> parameter(one, "RTL_ALT") == 1_500 && parameter(other, "RTL_ALT") == 1_500);
    }

    @Test
    void twoThatFlyAboveTheirReturnHeightsSideBySideAreWarnedAndNotOnceTheyAreApart() {
        List<LabDrone> drones = lab.copters(2);
        LabDrone one = drones.get(0);
        LabDrone other = drones.get(1);
        ann.takesOff(one, 20);
        bob.takesOff(other, 20);
        lab.goOn(Duration.ofSeconds(30));
        assertThat(warned(one)).isZero();
        assertThat(warned(other)).isZero();

        ann.fliesTo(one, one.place(20, 0), 45);
        bob.fliesTo(other, other.place(20, 0), 45);
        lab.until("both are warned", Duration.ofSeconds(40), () -> warned(one) == 1 && warned(other) == 1);
        assertThat(one.state().messages())
                .anyMatch(said -> said.text()
                        .matches("Without the cloud it would now fly home at 4\\d m, as high as "
                                + other.state().name() + ": their ways home may cross\\."));

        ann.fliesTo(one, one.place(20, 0), 60);
        lab.goOn(Duration.ofSeconds(25));
        ann.fliesTo(one, one.place(20, 0), 45);
        lab.until("it is warned anew", Duration.ofSeconds(40), () -> warned(one) == 2);
    }

    private static long warned(LabDrone drone) {
        return drone.state().messages().stream()
                .filter(said -> said.text().startsWith("Without the cloud it would now fly home"))
                .count();
    }

    @Test
    void oneThatIsRemovedMeanwhileStaysListed() {
        LabDrone drone = lab.copter();
        ann.takesOff(drone, METERS);
        drone.wire().cut();
        lab.until("it is lost", Duration.ofSeconds(10), drone::isLost);

        var id = drone.id();
        assertThat(lab.server().house().cloud().forget(id)).isEmpty();

        assertThat(lab.server().house().cloud().outstandingOverrides())
                .singleElement()
                .satisfies(left -> assertThat(left.drone()).isEqualTo(id));
    }
}
