package org.dronemap.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.core.safety.LinkLossAvoidance.Holder;
import org.junit.jupiter.api.Test;

class LinkLossAvoidanceTest {
    private static final LinkTrend FALLING = new LinkTrend(LinkTrend.State.FALLING, 60, "It gets worse.");
    private static final LinkTrend SOON = new LinkTrend(LinkTrend.State.FALLING, 10, "It gets worse.");
    private static final LinkTrend WORSE = new LinkTrend(LinkTrend.State.WORSE, null, "It is worse.");
    private static final LinkTrend STEADY = new LinkTrend(LinkTrend.State.STEADY, null, "As usual.");

    private final LinkLossAvoidance avoidance = new LinkLossAvoidance();
    private LinkActPlanner.WayCheck zones = way -> Optional.empty();
    private double now;

    /** Far from home, 20 m high. */
    private static DroneState drone(LinkTrend trend) {
        DroneState old = ReturnPlannerTest.with(null);
        LinkStatus link = old.link();
        return new DroneState(
                old.id(),
                old.name(),
                old.replay(),
                new LinkStatus(
                        link.key(),
                        link.transport(),
                        link.state(),
                        link.lastHeard(),
                        link.quality(),
                        trend,
                        List.of(),
                        List.of()),
                old.identification(),
                old.standing(),
                old.capabilities(),
                old.mode(),
                old.armed(),
                old.readyToArm(),
                old.phase(),
                old.position(),
                old.local(),
                old.motion(),
                old.attitude(),
                old.battery(),
                old.gps(),
                old.home(),
                old.returnHeight(),
                old.payload(),
                old.mission(),
                old.messages(),
                old.lastUpdate(),
                old.version(),
                old.groundAmslMeters());
    }

    private Optional<LinkAct> after(double seconds, LinkTrend trend, Holder holder, boolean inMission) {
        now += seconds;
        return avoidance.next(drone(trend), holder, inMission, now, zones);
    }

    private LinkAct.Kind kindAfter(double seconds, LinkTrend trend) {
        return after(seconds, trend, Holder.NOBODY, true).map(LinkAct::kind).orElse(null);
    }

    @Test
    void climbsAndGoesOnWithItsMissionWhenThatHelps() {
        assertThat(kindAfter(0, FALLING)).isEqualTo(LinkAct.Kind.CLIMB);
        assertThat(kindAfter(10, WORSE)).isNull();
        Optional<LinkAct> act = after(10, STEADY, Holder.NOBODY, false);
        assertThat(act.map(LinkAct::kind)).contains(LinkAct.Kind.GO_ON);
        assertThat(act.map(LinkAct::command)).containsInstanceOf(Command.StartMission.class);
    }

    @Test
    void comesHomeOnceWhenThatDoesNotHelp() {
        assertThat(kindAfter(0, FALLING)).isEqualTo(LinkAct.Kind.CLIMB);
        assertThat(kindAfter(10, FALLING)).isNull();
        assertThat(kindAfter(6, FALLING)).isEqualTo(LinkAct.Kind.RETURN);
        assertThat(avoidance.returns()).isTrue();
        assertThat(kindAfter(1, FALLING)).isNull();
        assertThat(kindAfter(1, STEADY)).isNull();
        assertThat(avoidance.returns()).as("whatever the link does meanwhile").isTrue();
    }

    @Test
    void triesNothingTwiceInFiveMinutes() {
        assertThat(kindAfter(0, FALLING)).isEqualTo(LinkAct.Kind.CLIMB);
        assertThat(kindAfter(20, STEADY)).isEqualTo(LinkAct.Kind.GO_ON);
        assertThat(kindAfter(60, FALLING)).isEqualTo(LinkAct.Kind.RETURN);
    }

    @Test
    void triesNothingWithTooLittleTime() {
        assertThat(kindAfter(0, SOON)).isEqualTo(LinkAct.Kind.RETURN);
    }

    @Test
    void doesNotClimbWhereAZoneForbidsIt() {
        zones = way -> Optional.of("No.");
        assertThat(kindAfter(0, FALLING)).isEqualTo(LinkAct.Kind.RETURN);
    }

    @Test
    void warnsOnceWhoHasItInHand() {
        Optional<LinkAct> act = after(0, FALLING, Holder.USER, false);
        assertThat(act.map(LinkAct::kind)).contains(LinkAct.Kind.WARN);
        assertThat(after(1, FALLING, Holder.USER, false)).isEmpty();
        assertThat(after(1, WORSE, Holder.USER, false)).isEmpty();
        assertThat(after(1, FALLING, Holder.USER, false)).isEmpty();
        assertThat(after(1, STEADY, Holder.USER, false)).isEmpty();
        assertThat(after(1, FALLING, Holder.USER, false).map(LinkAct::kind)).contains(LinkAct.Kind.WARN);
    }

    @Test
    void actsAsSoonAsNobodyHasItAnyMore() {
        assertThat(after(0, FALLING, Holder.USER, false)).isPresent();
        assertThat(kindAfter(5, FALLING)).isEqualTo(LinkAct.Kind.CLIMB);
    }

    @Test
    void leavesItToAnOperation() {
        assertThat(after(0, FALLING, Holder.OPERATION, true)).isEmpty();
    }
}
