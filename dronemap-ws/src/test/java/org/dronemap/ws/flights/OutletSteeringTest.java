package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.mavlink.message.VfrHud;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.lab.Administrator;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.GroundStation;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabPeerLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Speeds and sticks of other programs steer through the outlet, and the drone stands when they stop. */
class OutletSteeringTest {
    private static final Duration SOON = Duration.ofSeconds(10);
    private static final Duration A_FLIGHT = Duration.ofMinutes(1);
    private static final ControlRequest HELICOPTER = new ControlRequest.TakeOver("a helicopter");
    private static final int ACCEPTED = 0;
    private static final int DENIED = 2;
    private static final int LAND = 21;
    private static final int TAKE_OFF = 22;
    private static final int SET_MODE = 176;
    private static final int ARM = 400;
    private static final int GUIDED = 4;
    private static final int LOITER = 5;
    private static final int GIMBAL = 154;

    private final Laboratory lab = new Laboratory(1);
    private final LabDrone copter = lab.copter();
    private final Administrator administrator = lab.administrator();
    private final Pilot pilot = administrator.granted("ann", Role.OPERATOR, copter);
    private final Pilot supervisor = administrator.granted("sue", Role.SUPERVISOR, copter);
    private final GroundStation ground = lab.station(LabPeerLink.Kind.TCP, pilot.passphrase(), 255);
    private final int number = ground.hears(1).get(0);

    @AfterEach
    void close() {
        lab.close();
    }

    /** Over ground, in m/s, as it was told last. */
    private double speed() {
        List<VfrHud> told = ground.heard(VfrHud.ID, number, VfrHud::decode);
        return told.isEmpty() ? 0 : told.get(told.size() - 1).groundspeed();
    }

    private void takeOff() {
        assertThat(ground.command(number, SET_MODE, 1, GUIDED)).isEqualTo(ACCEPTED);
        assertThat(ground.command(number, ARM, 1)).isEqualTo(ACCEPTED);
        assertThat(ground.command(number, TAKE_OFF, 0, 0, 0, 0, 0, 0, 15)).isEqualTo(ACCEPTED);
        lab.until("it is up", A_FLIGHT, () -> copter.height() > 14);
        lab.until("it stands up there", SOON, () -> trueSpeed() < 0.3);
    }

    private double trueSpeed() {
        return copter.craft().body().groundSpeed();
    }

    /** As the server shows it. */
    private double shownSpeed() {
        DroneView.MotionView motion = lab.server()
                .drones()
                .drone(supervisor.principal(), copter.id().value())
                .motion();
        Double shown = motion == null ? null : motion.groundSpeed();
        return shown == null ? 0 : shown;
    }

    private void awaitSpeed(String what) {
        lab.until(what, SOON, () -> speed() > 3 && trueSpeed() > 3);
    }

    private void awaitStand(String what) {
        lab.until(what, Duration.ofSeconds(20), () -> speed() < 0.5 && trueSpeed() < 0.5);
    }

    private Message northward(int component) {
        return new SetPositionTargetLocalNed(0, number, component, 1, 0xDC7, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0);
    }

    /** The log of who steered, and who was not let to, the newest first, once each has ended. */
    private List<CommandView> entries() {
        return administrator.account().commandsOf(copter).stream()
                .filter(one -> one.summary().startsWith("steer by ") && one.outcome() != null)
                .toList();
    }

    private static CommandView.OutcomeView end(CommandView entry) {
        return Objects.requireNonNull(entry.outcome());
    }

    private List<CommandView> turns() {
        return entries().stream()
                .filter(one -> !end(one).result().equals("refused"))
                .toList();
    }

    private void land(Pilot who) {
        who.does(copter, CommandRequests.land());
        lab.until(
                "it is down",
                A_FLIGHT,
                () -> copter.isDown() && Boolean.FALSE.equals(copter.state().armed()));
    }

    @Test
    void speedsSteerADroneAndItStandsWhenTheyStop() {
        takeOff();
        ScheduledTask said = ground.saysOn(northward(1));
        awaitSpeed("it is steered by speeds");
        said.cancel();
        awaitStand("it stands without another word");
        lab.until("its turn is written down", SOON, () -> turns().size() == 1);
        CommandView turn = turns().get(0);
        assertThat(List.of(turn.by(), turn.face(), turn.summary())).containsExactly("ann", "outlet", "steer by speeds");
        assertThat(end(turn).result()).isEqualTo("timedOut");
        assertThat(end(turn).reason()).contains("stand still");
    }

    @Test
    void sticksSteerADroneInLoiterUntilSomebodyTakesOver() {
        takeOff();
        Message forward = new ManualControl(number, 400, 0, 500, 0, 0, 0, 0, 0, 0);
        ground.says(forward);
        lab.until("sticks do nothing in GUIDED", SOON, () -> ground.texts().contains("mode to LOITER"));
        assertThat(trueSpeed()).isLessThan(0.5);
        assertThat(ground.command(number, SET_MODE, 1, LOITER)).isEqualTo(ACCEPTED);
        ScheduledTask said = ground.saysOn(forward);
        awaitSpeed("it is steered by sticks");
        supervisor.controls(copter, HELICOPTER);
        awaitStand("it stands whatever the sticks say");
        lab.throughout("and goes on to stand", SOON, () -> trueSpeed() < 0.5);
        said.cancel();
        assertThat(end(turns().get(0)).result()).isEqualTo("superseded");
        assertThat(entries())
                .as("who may not steer so is written down")
                .anyMatch(one -> end(one).result().equals("refused")
                        && String.valueOf(end(one).reason()).contains("change its mode to LOITER"));
        land(supervisor);
    }

    @Test
    void whoIsDisabledWhileSteeringSteersNoMoreAndHasNoControl() {
        takeOff();
        ScheduledTask said = ground.saysOn(northward(1));
        awaitSpeed("it is steered");
        administrator.disables(pilot);
        lab.until("it stands", SOON, () -> trueSpeed() < 0.5 && shownSpeed() < 0.5);
        lab.throughout("and goes on to stand", SOON, () -> trueSpeed() < 0.5);
        said.cancel();
        assertThat(turns()).hasSize(1).allMatch(turn -> end(turn).result().equals("superseded"));
        assertThat(lab.server()
                        .accounts()
                        .control()
                        .control(supervisor.principal(), copter.id().value())
                        .holder())
                .isNull();
        land(supervisor);
    }

    @Test
    void onlyTheAutopilotIsSteeredAndLanded() {
        takeOff();
        ground.says(northward(GIMBAL));
        lab.until("a gimbal is not steered", SOON, () -> ground.texts().contains("component " + GIMBAL));
        int before = ground.heard(CommandAck.ID, number).size();
        ground.says(new CommandLong(number, GIMBAL, LAND, 0, 0, 0, 0, 0, 0, 0, 0));
        lab.until(
                "nor landed",
                SOON,
                () -> ground.heard(CommandAck.ID, number, CommandAck::decode).stream()
                        .skip(before)
                        .anyMatch(ack -> ack.result() == DENIED));
        assertThat(copter.height()).isGreaterThan(14);
        assertThat(trueSpeed()).isLessThan(0.5);
    }

    private boolean isLed() {
        return administrator.account().commandsOf(copter).stream()
                .anyMatch(one -> one.summary().equals("lead it by a place") && one.outcome() == null);
    }

    @Test
    void aPlaceSaidOverAndOverLeadsUntilSomebodyTakesOver() {
        takeOff();
        int north = (int) Math.round((copter.place(0, 0).latitudeDegrees() + 0.02) * 1e7);
        int east = (int) Math.round(copter.place(0, 0).longitudeDegrees() * 1e7);
        ScheduledTask said = ground.saysOn(
                new SetPositionTargetGlobalInt(0, number, 1, 6, 0xDF8, north, east, 15, 0, 0, 0, 0, 0, 0, 0, 0));
        lab.until("it is led", SOON, this::isLed);
        awaitSpeed("it flies there");
        assertThat(copter.craft().body().velocityNorth()).isGreaterThan(3);
        supervisor.controls(copter, HELICOPTER);
        awaitStand("it stands whatever is said");
        lab.throughout("and goes on to stand", SOON, () -> trueSpeed() < 0.5);
        said.cancel();
        land(supervisor);
    }
}
