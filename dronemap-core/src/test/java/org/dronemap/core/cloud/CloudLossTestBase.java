package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.stored.Stored;
import org.junit.jupiter.api.BeforeEach;

/** A copter that stands, and what it is told of what it does without the cloud. */
abstract class CloudLossTestBase extends GuidedFlightTestBase {
    static final OverriddenParameter VALUE = new OverriddenParameter("FS_GCS_ENABLE", 0, 1);
    static final CloudLossAction GOES_ON = new CloudLossAction("it goes on", null, "");
    static final CloudLossAction COMES_HOME = new CloudLossAction("it returns home", 20.0, "");

    @BeforeEach
    void stand() {
        vehicle.settlesAtOnce = false;
        landed();
        // It says something all the time.
        link.lane().execute(() -> link.lane().addTimedTask(() -> link.received()));
    }

    void landed() {
        hear(new DroneEvent.ModeReported("GUIDED", false));
        hear(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
    }

    CommandRecord arms(String id) {
        return gate.submit(ANN, link.id(), id(id), new Command.Arm());
    }

    /** The command of the rule that the vehicle was given last. */
    <C extends Command> C rule(Class<C> kind) {
        until(() -> vehicle.performed.stream().anyMatch(kind::isInstance));
        return vehicle.performed.stream()
                .filter(kind::isInstance)
                .map(kind::cast)
                .reduce((first, second) -> second)
                .orElseThrow();
    }

    VehicleChannel.Report ruleReport(Class<? extends Command> kind) {
        until(() -> vehicle.performed.stream().anyMatch(kind::isInstance));
        return commands.records.values().stream()
                .filter(record -> record.by().equals("dronemap")
                        && record.type().equals(kind.getAnnotation(Stored.class).as()))
                .filter(record -> record.outcome() == null)
                .map(this::report)
                .findFirst()
                .orElseThrow();
    }

    CompletableFuture<Void> keeps(SetCloudLossAction command, OverriddenParameter... values) {
        CompletableFuture<Void> kept = command.keeper()
                .keep(new ParameterOverrideRecorder.OverridePlan(
                        GOES_ON, COMES_HOME, List.of(values), command.keeper().returnMeters(15)));
        time.settle();
        return kept;
    }

    void isSet() {
        SetCloudLossAction command = rule(SetCloudLossAction.class);
        assertThat(keeps(command, VALUE)).isCompleted();
        ruleReport(SetCloudLossAction.class).ended(new Outcome.Succeeded());
        time.settle();
    }

    /** It was armed once from here, and stands again while nobody has control. */
    void wasUsed() {
        CommandRecord arm = arms("arm-used1");
        isSet();
        report(arm).ended(new Outcome.Succeeded());
        vehicle.performed.clear();
    }

    CloudLossState shown() {
        return cloud.cloudLoss(link.id());
    }

    List<String> told() {
        DroneState now = cloud.drone(link.id()).orElseThrow();
        return now.messages().stream().map(message -> message.text()).toList();
    }
}
