package org.dronemap.sim.personality;

import java.util.Locale;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CameraFeedback;
import org.dronemap.mavlink.message.CameraImageCaptured;
import org.dronemap.sim.flight.Craft;
import org.dronemap.sim.physics.Body;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.Position;

/** A camera and six relays: counts what was done to them, as often as it was done. Owned by its vehicle. */
public final class Payload {
    private static final int RELAYS = 6;
    private static final int OFF = 0;
    private static final int ON = 1;

    private final boolean[] relays = new boolean[RELAYS];
    private int pictures;

    /** One more picture. */
    public void takePicture() {
        pictures++;
    }

    /** ArduPilot's numbers: 0 off, 1 on, any other toggles. */
    public Result setRelay(int relay, int setting) {
        if (relay < 0 || relay >= RELAYS) {
            return Result.FAILED;
        }
        relays[relay] = setting == ON || (setting != OFF && !relays[relay]);
        return Result.ACCEPTED;
    }

    /** What ArduPilot says of the last picture. */
    public Message feedback(Craft craft, long timeMicros) {
        Body body = craft.body();
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

    /** "pictures 3 relays on: 0 4". */
    public String words() {
        StringBuilder on = new StringBuilder();
        for (int relay = 0; relay < RELAYS; relay++) {
            if (relays[relay]) {
                on.append(' ').append(relay);
            }
        }
        return String.format(Locale.ROOT, "pictures %d relays on:%s", pictures, on.isEmpty() ? " none" : on);
    }

    /** What PX4 says of the last picture. */
    public Message captured(Craft craft, long bootMillis) {
        Position here = craft.body().position();
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
