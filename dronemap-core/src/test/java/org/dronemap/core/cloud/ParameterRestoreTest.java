package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.parameter.ParameterValue;
import org.junit.jupiter.api.Test;

/** What its owner had set is put back once the use of a drone is over, whatever happens in between. */
class ParameterRestoreTest extends CloudLossTestBase {
    @Test
    void putsItBackOnceNobodyHasControlOfItAndItStands() {
        wasUsed();

        RestoreParameters command = rule(RestoreParameters.class);
        assertThat(command.values()).containsExactly(VALUE);
        assertThat(owners.kept).containsKey(link.id());
        ruleReport(RestoreParameters.class).ended(new Outcome.Succeeded());
        until(owners.kept::isEmpty);

        assertThat(shown()).isEqualTo(CloudLossState.UNKNOWN);
        assertThat(cloud.drone(link.id()).orElseThrow().returnHeight()).isNull();
        arms("arm-00002");
        rule(SetCloudLossAction.class);
    }

    @Test
    void putsNothingBackInTheAirWhoeverHasControl() {
        wasUsed();
        hear(new DroneEvent.ModeReported("AUTO", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));

        SteppedUntil.throughout(
                time,
                Duration.ofSeconds(60),
                () -> vehicle.performed.stream().noneMatch(RestoreParameters.class::isInstance));

        landed();
        rule(RestoreParameters.class);
    }

    @Test
    void putsNothingBackWhileSomebodyHasControl() {
        wasUsed();
        apply(new LeaseEvent.TakeControl("ann"));

        SteppedUntil.throughout(time, Duration.ofSeconds(30), () -> {
            apply(new LeaseEvent.Heartbeat("ann", control().epoch()));
            return vehicle.performed.isEmpty();
        });
    }

    @Test
    void writesNoMoreBackWhenAPilotArmsIt() {
        wasUsed();
        rule(RestoreParameters.class);

        hear(new DroneEvent.ModeReported("LOITER", true));

        until(() -> !vehicle.cancelled.isEmpty());
        assertThat(owners.kept).containsKey(link.id());
    }

    @Test
    void triesAgainAMinuteLaterAndSaysSoOnce() {
        wasUsed();
        ruleReport(RestoreParameters.class).ended(new Outcome.TimedOut("The vehicle did not tell it."));
        long failed = time.nanos();
        vehicle.performed.clear();

        assertThat(time.advanceUntil(() -> !vehicle.performed.isEmpty(), Duration.ofMinutes(2)))
                .isTrue();

        assertThat(Duration.ofNanos(time.nanos() - failed)).isGreaterThan(Duration.ofSeconds(59));
        ruleReport(RestoreParameters.class).ended(new Outcome.TimedOut("The vehicle did not tell it."));
        time.settle();
        assertThat(owners.kept).containsKey(link.id());
        assertThat(told())
                .filteredOn(text -> text.contains("could not be put back yet"))
                .hasSize(1);
    }

    @Test
    void tellsWhatSomebodyElseHasChangedAndDropsIt() {
        wasUsed();
        rule(RestoreParameters.class).keeper().skipped(List.of(new ParameterValue("FS_GCS_ENABLE", 5)));
        ruleReport(RestoreParameters.class).ended(new Outcome.Succeeded());
        until(owners.kept::isEmpty);

        assertThat(told())
                .contains("FS_GCS_ENABLE = 5 was changed by somebody else meanwhile, so it stays; its owner had set"
                        + " FS_GCS_ENABLE = 0.");
    }

    @Test
    void givesWayToWhoArmsItWhileItIsPutBack() {
        wasUsed();
        rule(RestoreParameters.class);

        arms("arm-00002");

        assertThat(rule(SetCloudLossAction.class).kept()).containsExactly(VALUE);
        assertThat(vehicle.cancelled).isNotEmpty();
    }

    @Test
    void putsThemBackAfterACrashBeforeThat() {
        wasUsed();

        CloudManager next = cloud();
        assertThat(next.cloudLoss(link.id()).outstanding()).containsExactly(VALUE);
        link = bound(next);
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), MODES));
        landed();

        assertThat(rule(RestoreParameters.class).values()).containsExactly(VALUE);
    }

    @Test
    void doesNotReadTheHeightOfARunForTheOwnersAfterACrash() {
        wasUsed();

        CloudManager next = cloud();
        link = bound(next);
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), MODES));
        landed();
        next.gate().submit(ANN, link.id(), id("height-02"), new SetReturnHeight(20, false));

        until(() -> !vehicle.performed.isEmpty());
        assertThat(vehicle.performed).containsExactly(new SetReturnHeight(20, false));
    }

    @Test
    void listsWhatIsOutstandingOnADroneThatWasRemoved() {
        ParameterOverrides left =
                new ParameterOverrides(new DroneId("gone-1"), "Falcon", BEGAN, 15.0, true, List.of(VALUE));
        owners.kept.put(left.drone(), left);

        CloudManager next = cloud();

        assertThat(next.outstandingOverrides()).containsExactly(left);
        assertThat(cloud.outstandingOverrides()).isEmpty();
    }
}
