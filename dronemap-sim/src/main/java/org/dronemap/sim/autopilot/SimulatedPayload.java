package org.dronemap.sim.autopilot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CameraFeedback;
import org.dronemap.mavlink.message.CameraImageCaptured;
import org.dronemap.mavlink.message.GimbalManagerSetPitchyaw;
import org.dronemap.mavlink.message.NamedValueFloat;
import org.dronemap.mavlink.message.ServoOutputRaw;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.VehicleBody;
import org.jspecify.annotations.Nullable;

/**
 * The payload of a simulated vehicle (camera, relays, servos, sensors, gimbal), which counts what was done to it. Owned
 * by its vehicle.
 */
public final class SimulatedPayload {
    private static final int RELAYS = 6;
    private static final int OUTPUTS = 16;
    private static final int MOTORS = 4;
    private static final int IDLE_MICROS = 1_000;
    private static final int LONGEST_NAME = 10;
    private static final int OFF = 0;
    private static final int ON = 1;

    private final boolean[] relays = new boolean[RELAYS];
    private final int[] outputs = new int[OUTPUTS];
    private final Map<String, Float> sensors = new TreeMap<>();
    private @Nullable SimulatedGimbal mount;
    private int pictures;

    /** One more picture. */
    public void takePicture() {
        pictures++;
    }

    /** ArduPilot's numbers: 0 off, 1 on, any other toggles. */
    public SimulatedCommandResult setRelay(int relay, int setting) {
        if (relay < 0 || relay >= RELAYS) {
            return SimulatedCommandResult.FAILED;
        }
        relays[relay] = setting == ON || (setting != OFF && !relays[relay]);
        return SimulatedCommandResult.ACCEPTED;
    }

    /** False for an output that a motor has, or that there is not. */
    public boolean setServo(int output, int pulseMicros) {
        if (output <= MOTORS || output > OUTPUTS) {
            return false;
        }
        outputs[output - 1] = pulseMicros;
        return true;
    }

    /** A sensor measures that from now on; its name has at most {@value #LONGEST_NAME} characters. */
    public void measure(String name, float value) {
        sensors.put(name.substring(0, Math.min(LONGEST_NAME, name.length())), value);
    }

    public void forgetSensors() {
        sensors.clear();
    }

    /** Lives on, with a gimbal or without one. */
    public void step(boolean mounted, double seconds) {
        if (!mounted) {
            mount = null;
            return;
        }
        if (mount == null) {
            mount = new SimulatedGimbal();
        }
        mount.step(seconds);
    }

    /** Somebody says to a vehicle, maybe this one, where to look. */
    void point(GimbalManagerSetPitchyaw message, int systemId) {
        if (mount != null && message.targetSystem() == systemId) {
            mount.apply(message);
        }
    }

    List<Message> readings(long bootMillis) {
        List<Message> readings = new ArrayList<>();
        if (mount != null) {
            readings.add(mount.status(bootMillis));
        }
        sensors.forEach((name, value) -> readings.add(new NamedValueFloat(bootMillis, name, value)));
        return readings;
    }

    Message outputs(long bootMillis) {
        for (int motor = 0; motor < MOTORS; motor++) {
            outputs[motor] = IDLE_MICROS;
        }
        return new ServoOutputRaw(
                bootMillis * 1_000 & 0xFFFF_FFFFL,
                0,
                outputs[0],
                outputs[1],
                outputs[2],
                outputs[3],
                outputs[4],
                outputs[5],
                outputs[6],
                outputs[7],
                outputs[8],
                outputs[9],
                outputs[10],
                outputs[11],
                outputs[12],
                outputs[13],
                outputs[14],
                outputs[15]);
    }

    /** What ArduPilot says of the last picture. */
    public Message feedback(SimulatedCraft craft, long timeMicros) {
        VehicleBody body = craft.body();
        LocalFrame frame = craft.frame();
        return new CameraFeedback(
                timeMicros,
                0,
                0,
                pictures,
                (int) Math.round(frame.latitudeOf(body.position()) * 1e7),
                (int) Math.round(frame.longitudeOf(body.position()) * 1e7),
                (float) frame.altitudeOf(body.position()),
                (float) craft.aboveHome(),
                degrees(body.roll()),
                degrees(body.pitch()),
                degrees(body.yaw()),
                0,
                0,
                pictures);
    }

    private static float degrees(double radians) {
        return (float) Math.toDegrees(radians);
    }

    /** "pictures 3 relays on: 0 4", "servo 9: 1900" for each that was moved, and "gimbal -45.0" if it carries one. */
    public String words() {
        StringBuilder on = new StringBuilder();
        for (int relay = 0; relay < RELAYS; relay++) {
            if (relays[relay]) {
                on.append(' ').append(relay);
            }
        }
        StringBuilder words = new StringBuilder(
                String.format(Locale.ROOT, "pictures %d relays on:%s", pictures, on.isEmpty() ? " none" : on));
        for (int output = MOTORS; output < OUTPUTS; output++) {
            if (outputs[output] > 0) {
                words.append(String.format(Locale.ROOT, " servo %d: %d", output + 1, outputs[output]));
            }
        }
        if (mount != null) {
            words.append(String.format(Locale.ROOT, " gimbal %.1f", mount.pitchDegrees()));
        }
        return words.toString();
    }

    /** What PX4 says of the last picture. */
    public Message captured(SimulatedCraft craft, long bootMillis) {
        NeuPosition here = craft.body().position();
        LocalFrame frame = craft.frame();
        return new CameraImageCaptured(
                bootMillis,
                0,
                0,
                (int) Math.round(frame.latitudeOf(here) * 1e7),
                (int) Math.round(frame.longitudeOf(here) * 1e7),
                (int) Math.round(frame.altitudeOf(here) * 1000),
                (int) Math.round(craft.aboveHome() * 1000),
                new float[] {1, 0, 0, 0},
                pictures,
                1,
                "");
    }
}
