package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.cloud.EpochGuard;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.GimbalDeviceAttitudeStatus;
import org.dronemap.mavlink.message.GimbalManagerSetPitchyaw;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;

class GimbalControlTest {
    private static final long MILLI = 1_000_000;

    private static final SendAuthority MANDATE = new SendAuthority(null, 4L, "mia", EpochGuard.NONE);

    private final List<GimbalManagerSetPitchyaw> told = new ArrayList<>();
    private final List<SendAuthority> by = new ArrayList<>();
    private final GimbalControl gimbal =
            new GimbalControl(new MavlinkTarget(7, 1, message -> {}), (message, mandate) -> {
                told.add((GimbalManagerSetPitchyaw) message);
                by.add(mandate);
            });

    private void heard(Message message) {
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(new FrameWriter(7, 1, 2).frame(message)), frames::add);
        frames.forEach(gimbal::received);
    }

    private void hasOne() {
        heard(new GimbalDeviceAttitudeStatus(0, 0, 0, 12, new float[] {1, 0, 0, 0}, 0, 0, 0, 0, 0, 0));
    }

    private static Setpoint track(Double cameraElevationDegrees) {
        return new Setpoint.Track(
                new Geodetic(47.4, 8.5), Altitude.aboveHome(20), null, Setpoint.Facing.ANY, cameraElevationDegrees);
    }

    @Test
    void saysNothingToVehiclesWithoutOne() {
        heard(new Heartbeat(0, 2, 3, 0, 4, 3));
        gimbal.steered(MANDATE, track(-30.0), 0);
        gimbal.advance(60_000 * MILLI);
        assertThat(told).isEmpty();
    }

    @Test
    void pointsItTwiceInASecond() {
        hasOne();
        for (long milli = 0; milli < 10_000; milli += 100) {
            gimbal.steered(MANDATE, track(-45.0), milli * MILLI);
            gimbal.advance(milli * MILLI);
        }
        assertThat(told).hasSize(20);
        gimbal.steered(MANDATE, track(-90.0), 10_000 * MILLI);
        GimbalManagerSetPitchyaw last = told.get(20);
        assertThat(last.targetSystem()).isEqualTo(7);
        assertThat(last.pitch()).isEqualTo((float) (-Math.PI / 2));
        assertThat(last.yaw()).isZero();
        assertThat(last.pitchRate()).isNaN();
    }

    @Test
    void letsGoOfItByTheSameRightWhenNobodyPointsItAnyMore() {
        hasOne();
        gimbal.steered(MANDATE, track(-45.0), 0);
        gimbal.steered(MANDATE, track(null), 2_000 * MILLI);
        gimbal.advance(2_900 * MILLI);
        assertThat(told).hasSize(1);
        for (long milli = 3_000; milli < 20_000; milli += 100) {
            gimbal.advance(milli * MILLI);
        }
        assertThat(told.subList(1, told.size()))
                .hasSize(3)
                .allMatch(each -> each.flags() == 2 && Float.isNaN(each.pitch()));
        assertThat(by).containsOnly(MANDATE);
        gimbal.steered(MANDATE, track(-45.0), 20_000 * MILLI);
        assertThat(told).as("again").hasSize(5);
    }
}
