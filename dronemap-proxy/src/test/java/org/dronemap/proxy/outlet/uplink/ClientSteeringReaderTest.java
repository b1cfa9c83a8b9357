package org.dronemap.proxy.outlet.uplink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.RcChannelsOverride;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ClientSteeringReaderTest {
    private static final int SPEEDS = 0xDC7;
    private static final int SPEEDS_AND_HEADING = 0x9C7;

    @ParameterizedTest
    @ValueSource(ints = {0, 3, 5, 6})
    void speedsInGlobalFramesAreCountedFromNorth(int frame) {
        assertThat(wish(global(frame, SPEEDS)))
                .isEqualTo(
                        new ClientSteeringReader.Intent.Steer(new Setpoint.Velocity(Frame.EARTH, 1, 2, 0, Facing.ANY)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 8, 77})
    void speedsInNoGlobalFrameAreRefusedAsGlobalTargets(int frame) {
        assertThat(wish(global(frame, SPEEDS))).isInstanceOf(ClientSteeringReader.Intent.Denied.class);
    }

    @Test
    void localTargetsBringSpeedsWithAHeadingAndNoPlaces() {
        assertThat(wish(new SetPositionTargetLocalNed(
                        0, 1, 1, 8, SPEEDS_AND_HEADING, 0, 0, 0, 1, 2, 0, 0, 0, 0, (float) (Math.PI / 2), 0)))
                .isEqualTo(new ClientSteeringReader.Intent.Steer(new Setpoint.Velocity(
                        Frame.VEHICLE, 1, 2, 0, new Facing.Heading(Math.toDegrees((float) (Math.PI / 2))))));
        assertThat(wish(new SetPositionTargetLocalNed(0, 1, 1, 1, 0xDF8, 5, 5, -5, 0, 0, 0, 0, 0, 0, 0, 0)))
                .isInstanceOf(ClientSteeringReader.Intent.Denied.class);
    }

    @Test
    void buttonsAndChannelsThatDoNothingKeepNoStickFromSteering() {
        assertThat(wish(new ManualControl(1, 500, Short.MAX_VALUE, 500, 0, 4, 0, 0, 0, 0)))
                .isEqualTo(new ClientSteeringReader.Intent.Steer(
                        new Setpoint.Sticks(0.5, 0, 0, 0),
                        Optional.of("Buttons of joysticks do nothing through the cloud; only sticks do.")));
        assertThat(wish(new RcChannelsOverride(
                        1, 1, 1500, 1250, 1500, 1500, 1900, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)))
                .isInstanceOfSatisfying(ClientSteeringReader.Intent.Steer.class, steer -> {
                    assertThat(steer.setpoint()).isEqualTo(new Setpoint.Sticks(0.5, 0, 0, 0));
                    assertThat(steer.remark()).isPresent();
                });
    }

    private static SetPositionTargetGlobalInt global(int frame, int mask) {
        return new SetPositionTargetGlobalInt(0, 1, 1, frame, mask, 0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0);
    }

    private static ClientSteeringReader.Intent wish(Message message) {
        List<org.dronemap.mavlink.Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(new FrameWriter(255, 190, 2).frame(message)), frames::add);
        return ClientSteeringReader.of(frames.get(0), VehicleKind.MULTICOPTER);
    }
}
