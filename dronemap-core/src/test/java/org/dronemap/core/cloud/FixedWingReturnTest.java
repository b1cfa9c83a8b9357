package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.dronemap.core.cloud.outlook.Outlook;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What is said of a fixed wing that would circle above its home, before it flies and in the air. */
class FixedWingReturnTest extends CloudLossTestBase {
    private static final String CIRCLES =
            "it flies home and circles there until its pilot or a mission lands it, or its battery is empty.";
    private static final String HAS_NONE =
            "It has no landing sequence (DO_LAND_START) in a mission on board: " + CIRCLES;
    private static final String IS_NOT_KNOWN =
            "Its mission is not known, so it is not known whether it has a landing sequence (DO_LAND_START): without one "
                    + CIRCLES;
    private static final CloudLossAction BY_MISSION =
            new CloudLossAction("it returns home", 20.0, "", CloudLossAction.AtHome.BY_MISSION);
    private static final CloudLossAction ON_ROTORS =
            new CloudLossAction("it returns home", 20.0, "", CloudLossAction.AtHome.BY_ITSELF);

    @BeforeEach
    void isAPlane() {
        Set<Capability> can = EnumSet.allOf(Capability.class);
        can.remove(Capability.LAND);
        hear(new DroneEvent.Identified(
                new Identification(VehicleKind.FIXED_WING, "ArduPilot", "ArduPlane", "4.5.6", null),
                new Capabilities(
                        can,
                        List.of("GUIDED", "AUTO", "RTL"),
                        Map.of("GUIDED", Steering.ORDERS, "AUTO", Steering.MISSION, "RTL", Steering.HOME))));
        landed();
    }

    private void hasAMission(boolean landing) {
        hear(new DroneEvent.MissionRead(List.of(new MissionItem.TakeOff(40)), null, false, landing));
    }

    private CommandRecord isArmed(CloudLossAction doing) {
        CommandRecord arm = arms("arm-00001");
        SetCloudLossAction command = rule(SetCloudLossAction.class);
        assertThat(command.keeper()
                        .keep(new ParameterOverrideRecorder.OverridePlan(GOES_ON, doing, List.of(VALUE), null)))
                .isNotNull();
        time.settle();
        ruleReport(SetCloudLossAction.class).ended(new Outcome.Succeeded());
        time.settle();
        return arm;
    }

    private void fliesFor() {
        hear(new DroneEvent.HomeReported(new Home(HERE, 600)));
        hear(new DroneEvent.PositionReported(new Position(HERE, null, 40.0)));
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        until(() -> cloud.controls().outlook(link.id()).isPresent());
        awaitTick();
    }

    private Outlook outlook() {
        return cloud.controls().outlook(link.id()).orElseThrow();
    }

    @Test
    void saysBeforeItIsArmedThatItWouldCircle() {
        assertThat(shown().sentence()).endsWith(IS_NOT_KNOWN);
        hasAMission(false);

        assertThat(shown().sentence())
                .isEqualTo("What it does without the cloud is as its owner has set it, until it is armed from here. "
                        + HAS_NONE);
    }

    @Test
    void saysWhenItIsArmedThatItWouldCircle() {
        hasAMission(false);
        isArmed(BY_MISSION);

        assertThat(shown().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 20 s. " + HAS_NONE);
        assertThat(told()).containsOnlyOnce(HAS_NONE);
    }

    @Test
    void saysWhenItIsArmedThatNothingIsKnownOfItsMission() {
        isArmed(BY_MISSION);

        assertThat(told()).containsOnlyOnce(IS_NOT_KNOWN);
    }

    @Test
    void saysThatItLandsByItsMission() {
        hasAMission(true);
        assertThat(shown().sentence()).endsWith("a return that is commanded from here lands by that.");
        isArmed(BY_MISSION);

        assertThat(shown().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 20 s."
                        + " Its mission has a landing sequence (DO_LAND_START): at home it lands by that.");
        assertThat(told()).noneMatch(text -> text.contains("landing sequence"));
    }

    @Test
    void saysItOfAnotherMissionThatCameSince() {
        hasAMission(true);
        report(isArmed(BY_MISSION)).ended(new Outcome.Succeeded());
        hasAMission(false);

        assertThat(shown().sentence()).endsWith(HAS_NONE);
        report(arms("arm-00002"));
        assertThat(told()).containsOnlyOnce(HAS_NONE);
    }

    @Test
    void saysNothingOfOneWithRotors() {
        hasAMission(false);
        isArmed(ON_ROTORS);

        assertThat(shown().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 20 s.");
        assertThat(told()).noneMatch(text -> text.contains("circles"));
    }

    @Test
    void comesDownNowhereInTheAirWhereItWouldCircle() {
        hasAMission(false);
        report(isArmed(BY_MISSION)).ended(new Outcome.Succeeded());
        fliesFor();

        assertThat(outlook().then())
                .endsWith(" At home it circles until somebody lands it: it has no landing sequence on board.");
        assertThat(outlook().comesDown()).isNull();
        assertThat(outlook().comesDownWords()).isNull();
    }

    @Test
    void doesNotClaimThatItComesDownWhileItsMissionIsNotKnown() {
        report(isArmed(BY_MISSION)).ended(new Outcome.Succeeded());
        fliesFor();

        assertThat(outlook().then())
                .endsWith(" Whether it lands at home or circles there is not known: its mission was not read.");
        assertThat(outlook().comesDownWords()).isNull();
    }

    @Test
    void comesDownByItsLandingSequence() {
        hasAMission(true);
        report(isArmed(BY_MISSION)).ended(new Outcome.Succeeded());
        fliesFor();

        assertThat(outlook().comesDown()).as("only the vehicle knows where").isNull();
        assertThat(outlook().comesDownWords()).isEqualTo("at the end of its landing sequence");
    }

    @Test
    void comesDownAtHomeOnItsRotors() {
        hasAMission(false);
        report(isArmed(ON_ROTORS)).ended(new Outcome.Succeeded());
        fliesFor();

        assertThat(Objects.requireNonNull(outlook().comesDown())).isEqualTo(HERE);
        assertThat(outlook().comesDownWords()).isEqualTo("home");
    }
}
