package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Setpoint;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.junit.jupiter.api.Test;

class SetpointEncoderTest {
    private static final MavlinkTarget TARGET = new MavlinkTarget(7, 1, message -> {});
    private final SetpointEncoder copter = new SetpointEncoder(TARGET, VehicleKind.MULTICOPTER);
    private final SetpointEncoder rover = new SetpointEncoder(TARGET, VehicleKind.ROVER);

    @Test
    void speedsAreLocalTargetsOfWhichNothingElseCounts() {
        assertThat(copter.encode(new Setpoint.Velocity(Frame.EARTH, 3, -2, 1, Facing.ANY)))
                .contains(new SetPositionTargetLocalNed(0, 7, 1, 1, 0xDC7, 0, 0, 0, 3, -2, 1, 0, 0, 0, 0, 0));
    }

    @Test
    void speedsOfItsOwnAreCountedFromItsNoseWithATurn() {
        assertThat(copter.encode(new Setpoint.Velocity(Frame.VEHICLE, 3, 0, 0, new Facing.Turning(90))))
                .contains(new SetPositionTargetLocalNed(
                        0, 7, 1, 8, 0x5C7, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, (float) (Math.PI / 2)));
    }

    @Test
    void aPlaceThatMovesIsAGlobalTargetWithItsSpeedAndHeading() {
        Setpoint.Velocity moving = new Setpoint.Velocity(Frame.EARTH, 1.5, 0.5, 0, Facing.ANY);
        assertThat(copter.encode(new Setpoint.Track(
                        new Geodetic(47.3977, 8.5456), Altitude.aboveHome(20), moving, new Facing.Heading(180))))
                .contains(new SetPositionTargetGlobalInt(
                        0, 7, 1, 6, 0x9C0, 473977000, 85456000, 20, 1.5f, 0.5f, 0, 0, 0, 0, (float) Math.PI, 0));
        assertThat(copter.encode(new Setpoint.Track(
                        new Geodetic(47.3977, 8.5456), new Altitude(430, Altitude.Reference.AMSL), null, Facing.ANY)))
                .contains(new SetPositionTargetGlobalInt(
                        0, 7, 1, 5, 0xDF8, 473977000, 85456000, 430, 0, 0, 0, 0, 0, 0, 0, 0));
    }

    @Test
    void sticksAreManualControlWithTheThrottlesMiddleAtHalf() {
        assertThat(copter.encode(new Setpoint.Sticks(0.5, -1, 0, 0.25)))
                .contains(new ManualControl(7, 500, -1000, 500, 250, 0, 0, 0, 0, 0));
        assertThat(copter.encode(new Setpoint.Sticks(0, 0, -1, 0)))
                .contains(new ManualControl(7, 0, 0, 0, 0, 0, 0, 0, 0, 0));
    }

    @Test
    void aRoverTakesItsThrottleFromZAndItsSteeringFromY() {
        assertThat(rover.encode(new Setpoint.Sticks(0.5, 0, 0, -1)))
                .contains(new ManualControl(7, 0, -1000, 500, 0, 0, 0, 0, 0, 0));
    }

    @Test
    void eachAutopilotDeclaresWhatItIsSteeredBy() {
        assertThat(of(3, 2)).contains(Capability.STICKS, Capability.VELOCITY, Capability.TRACK);
        assertThat(of(3, 10)).contains(Capability.STICKS, Capability.VELOCITY, Capability.TRACK);
        assertThat(of(3, 1)).contains(Capability.STICKS).doesNotContain(Capability.VELOCITY, Capability.TRACK);
        assertThat(of(12, 2)).doesNotContain(Capability.STICKS, Capability.VELOCITY, Capability.TRACK);
        assertThat(of(8, 2)).isEmpty();
    }

    private static java.util.Set<Capability> of(int autopilot, int type) {
        return AutopilotAdapter.of(new Heartbeat(type, autopilot, 0, 0, 0, 3))
                .capabilities()
                .commands();
    }
}
