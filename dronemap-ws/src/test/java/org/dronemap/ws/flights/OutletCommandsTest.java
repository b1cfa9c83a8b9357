package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ControlStatus;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.ws.audit.AuditSearchRequest;
import org.dronemap.ws.audit.AuditView;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.lab.Administrator;
import org.dronemap.ws.lab.GroundStation;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabPeerLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleFrameLog;
import org.dronemap.ws.lab.VehicleSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Ground stations of other makers fly through the outlet, and share the control of drones: two copters of one system id. */
class OutletCommandsTest {
    private static final Duration SOON = Duration.ofSeconds(10);
    private static final Duration A_FLIGHT = Duration.ofMinutes(1);
    private static final int ACCEPTED = 0;
    private static final int DENIED = 2;
    private static final int UNSUPPORTED = 3;
    private static final int FAILED = 4;
    private static final int LAND = 21;
    private static final int TAKE_OFF = 22;
    private static final int SET_MODE = 176;
    private static final int REBOOT = 246;
    private static final int ARM = 400;
    private static final int REQUEST_MESSAGE = 512;
    private static final int OPERATOR_CONTROL = 32_100;
    private static final int GUIDED = 4;

    private final Laboratory lab = new Laboratory(1);
    private final LabDrone first = lab.add(VehicleSpec.COPTER, 1);
    private final LabDrone second = lab.add(VehicleSpec.COPTER, 1);
    private final Administrator administrator = lab.administrator();

    OutletCommandsTest() {
        lab.ready(first);
        lab.ready(second);
    }

    @AfterEach
    void close() {
        lab.close();
    }

    private GroundStation station(Pilot user, int systemId) {
        return lab.station(LabPeerLink.Kind.TCP, user.passphrase(), systemId);
    }

    @Test
    void twoVehiclesOfOneSystemIdAreFlownFromOneClient() {
        Pilot pilot = administrator.granted("ann", Role.OPERATOR, first, second);
        GroundStation ground = station(pilot, 255);
        List<Integer> numbers = ground.hears(2);
        for (int number : numbers) {
            assertThat(ground.command(number, SET_MODE, 1, GUIDED)).isEqualTo(ACCEPTED);
            assertThat(ground.command(number, ARM, 1)).isEqualTo(ACCEPTED);
            assertThat(ground.command(number, TAKE_OFF, 0, 0, 0, 0, 0, 0, 12)).isEqualTo(ACCEPTED);
        }
        for (int number : numbers) {
            lab.until(
                    "it tells that it is up there",
                    A_FLIGHT,
                    () -> ground.heard(GlobalPositionInt.ID, number, GlobalPositionInt::decode).stream()
                            .anyMatch(told -> told.relativeAlt() > 11_000));
        }
        assertThat(List.of(first, second)).allMatch(copter -> copter.height() > 10.5);
        numbers.forEach(number -> assertThat(ground.command(number, LAND)).isEqualTo(ACCEPTED));
        for (LabDrone copter : List.of(first, second)) {
            lab.until(
                    "it is down",
                    A_FLIGHT,
                    () -> copter.isDown() && Boolean.FALSE.equals(copter.state().armed()));
            Set<String> faces = administrator.account().commandsOf(copter).stream()
                    .map(CommandView::face)
                    .collect(Collectors.toSet());
            assertThat(faces).containsExactlyInAnyOrder("outlet", "rule");
            pilot.controls(copter, new ControlRequest.Release());
        }
    }

    @Test
    void aRefusalSaysWhy() {
        VehicleFrameLog log = new VehicleFrameLog(first);
        GroundStation ground = station(administrator.granted("eve", Role.VIEWER, first), 255);
        int number = ground.hears(1).get(0);
        assertThat(ground.command(number, ARM, 1)).isEqualTo(DENIED);
        lab.until("it says why", SOON, () -> ground.texts().contains("Your role may look, not command"));
        assertThat(ground.command(number, REBOOT, 1)).isEqualTo(UNSUPPORTED);
        assertThat(ground.command(number, REQUEST_MESSAGE, 148)).isEqualTo(ACCEPTED);
        lab.until(
                "the version comes from the cache",
                SOON,
                () -> !ground.heard(AutopilotVersion.ID, number).isEmpty());
        lab.goOn(SOON);
        assertThat(log.told()).isEmpty();
        assertThat(first.craft().armed()).isFalse();
    }

    @Test
    void whoHasNoControlIsRefusedAndToldWhoHas() {
        Pilot holder = administrator.granted("holder", Role.OPERATOR, second);
        Pilot other = administrator.granted("other", Role.OPERATOR, second);
        holder.controls(second, new ControlRequest.TakeControl());
        GroundStation ground = station(other, 255);
        int number = ground.hears(1).get(0);
        assertThat(ground.command(number, SET_MODE, 1, GUIDED)).isEqualTo(DENIED);
        lab.until("it says who has it", SOON, () -> ground.texts().contains("holder"));
        holder.controls(second, new ControlRequest.Release());
        assertThat(ground.command(number, SET_MODE, 1, GUIDED)).isEqualTo(ACCEPTED);
        other.controls(second, new ControlRequest.Release());
    }

    /** Which system has control of the vehicle, as it was told last; -1: it was not told. */
    private static int inControl(GroundStation ground, int number) {
        List<ControlStatus> told = ground.heard(ControlStatus.ID, number, ControlStatus::decode);
        return told.isEmpty() ? -1 : told.get(told.size() - 1).gcsMain();
    }

    @Test
    void controlIsAskedForAndHandedOverBetweenGroundStationsAndLostWithTheHolders() {
        GroundStation ann = station(administrator.granted("ann", Role.OPERATOR, second), 251);
        GroundStation bob = station(administrator.granted("bob", Role.OPERATOR, second), 252);
        int number = ann.hears(1).get(0);
        int his = bob.hears(1).get(0);
        lab.until("it is free", SOON, () -> inControl(ann, number) == 0);
        assertThat(ann.command(number, OPERATOR_CONTROL, 1)).isEqualTo(ACCEPTED);
        lab.until("both are told", SOON, () -> inControl(ann, number) == 251 && inControl(bob, his) == 255);

        assertThat(bob.command(his, OPERATOR_CONTROL, 1)).isEqualTo(FAILED);
        lab.until(
                "the holder is asked",
                SOON,
                () -> !ann.heard(CommandLong.ID, number).isEmpty());
        CommandLong asked =
                ann.heard(CommandLong.ID, number, CommandLong::decode).get(0);
        assertThat(List.of(asked.command(), asked.targetSystem())).containsExactly(OPERATOR_CONTROL, 251);
        lab.until("and told by whom", SOON, () -> ann.texts().contains("bob asks for control"));
        assertThat(ann.command(number, OPERATOR_CONTROL, 1, 1)).isEqualTo(ACCEPTED);
        lab.until("both are told", SOON, () -> inControl(ann, number) == 255 && inControl(bob, his) == 252);

        // Taken on purpose it is kept by heartbeats alone.
        assertThat(bob.command(his, OPERATOR_CONTROL, 1)).isEqualTo(ACCEPTED);
        lab.throughout("heartbeats keep it", Duration.ofSeconds(30), () -> inControl(ann, number) == 255);
        bob.fallsSilent();
        lab.until("it is lost", Duration.ofSeconds(20), () -> inControl(ann, number) == 0);
        assertThat(done()).contains("ann requestControl", "ann handControlOver");
    }

    /** By whom, and what, as it was taken down for good. */
    private List<String> done() {
        AuditSearchRequest search = new AuditSearchRequest(null, second.id().value(), null, "outlet", null, null, null);
        List<AuditView> records = lab.server()
                .accounts()
                .audit()
                .page(administrator.account().principal(), search, null, 100)
                .records();
        return records.stream().map(one -> one.by() + " " + one.operation()).toList();
    }
}
