package org.dronemap.proxy.mavlink.translate;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CameraFeedback;
import org.dronemap.mavlink.message.CameraImageCaptured;
import org.dronemap.mavlink.message.NamedValueFloat;
import org.dronemap.mavlink.message.ServoOutputRaw;
import org.jspecify.annotations.Nullable;

/** Translates MAVLink messages about cameras, servos and sensors of a vehicle into drone events. Stateless. */
final class PayloadTranslator {
    private static final int AUXILIARY = 1;
    private static final int UNUSED = 65_535;

    private PayloadTranslator() {}

    /** Whoever on the vehicle says it. */
    static Optional<DroneEvent> translate(Frame frame) {
        return Optional.ofNullable(
                switch (frame.messageId()) {
                    case CameraFeedback.ID -> photo(CameraFeedback.decode(frame));
                    case CameraImageCaptured.ID -> photo(CameraImageCaptured.decode(frame));
                    case NamedValueFloat.ID -> reading(NamedValueFloat.decode(frame));
                    default -> null;
                });
    }

    private static DroneEvent photo(CameraFeedback message) {
        return new DroneEvent.PhotoReported(message.imgIdx(), point(message.lat(), message.lng()));
    }

    /** One that failed is none. */
    private static @Nullable DroneEvent photo(CameraImageCaptured message) {
        return message.captureResult() == 1
                ? new DroneEvent.PhotoReported(message.imageIndex(), point(message.lat(), message.lon()))
                : null;
    }

    private static @Nullable Geodetic point(int latitudeE7, int longitudeE7) {
        return TelemetryDecoder.point(latitudeE7, longitudeE7);
    }

    private static @Nullable DroneEvent reading(NamedValueFloat message) {
        String name = message.name().strip();
        return name.isEmpty() || !Float.isFinite(message.value())
                ? null
                : new DroneEvent.ReadingReported(name, Math.round(message.value() * 1_000) / 1_000.0);
    }

    /** Of the first port alone: a second one begins to count anew. */
    static Optional<DroneEvent> outputs(ServoOutputRaw message) {
        return message.port() >= AUXILIARY
                ? Optional.empty()
                : Optional.of(new DroneEvent.OutputsReported(pulses(
                        message.servo1Raw(),
                        message.servo2Raw(),
                        message.servo3Raw(),
                        message.servo4Raw(),
                        message.servo5Raw(),
                        message.servo6Raw(),
                        message.servo7Raw(),
                        message.servo8Raw(),
                        message.servo9Raw(),
                        message.servo10Raw(),
                        message.servo11Raw(),
                        message.servo12Raw(),
                        message.servo13Raw(),
                        message.servo14Raw(),
                        message.servo15Raw(),
                        message.servo16Raw())));
    }

    /** One that is marked as unused has none. */
    private static List<Integer> pulses(int... micros) {
        return Arrays.stream(micros)
                .map(pulse -> pulse == UNUSED ? 0 : pulse)
                .boxed()
                .toList();
    }
}
