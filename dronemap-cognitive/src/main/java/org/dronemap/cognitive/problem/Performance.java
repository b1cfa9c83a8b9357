package org.dronemap.cognitive.problem;

import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.stored.Stored;

/**
 * The flight performance that a drone is planned with: speeds, power draw and response to wind.
 *
 * @param assumed nobody measured it: the careful figures of its kind
 */
@Stored(names = "speeds power response assumed")
public record Performance(Speeds speeds, Power power, WindResponse response, boolean assumed) {
    public Performance(Speeds speeds, Power power, WindResponse response) {
        this(speeds, power, response, false);
    }

    /**
     * The same with the speeds that copters have as that autopilot is delivered, which says itself neither how fast it flies nor
     * how gently it sets off.
     *
     * @param autopilot as users know it
     */
    public static Performance of(VehicleKind kind, String autopilot) {
        Performance usual = of(kind);
        return kind == VehicleKind.MULTICOPTER
                ? switch (autopilot) {
                    case "ArduPilot" -> usual.with(new Speeds(10, 2.5, 1.5, 0.5, 17, 2));
                    case "PX4" -> usual.with(new Speeds(5, 3, 1.5, 0.7, 12, 2));
                    default -> usual;
                }
                : usual;
    }

    private Performance with(Speeds other) {
        return new Performance(other, power, response, assumed);
    }

    /** Of a small vehicle of that kind, rather slow and thirsty. */
    public static Performance of(VehicleKind kind) {
        return switch (kind) {
            case MULTICOPTER, UNKNOWN ->
                new Performance(
                        new Speeds(8, 2.5, 1.5, 0.5, 14, 2.5),
                        new Power(250, 280, 350),
                        WindResponse.KEEPS_GROUND_SPEED,
                        true);
            case HELICOPTER ->
                new Performance(
                        new Speeds(10, 2.5, 1.5, 0.5, 18, 2.5),
                        new Power(900, 800, 1_200),
                        WindResponse.KEEPS_GROUND_SPEED,
                        true);
            case FIXED_WING ->
                new Performance(
                        new Speeds(15, 3, 3, 2, 25, Double.POSITIVE_INFINITY),
                        new Power(150, 150, 300),
                        WindResponse.KEEPS_AIRSPEED,
                        true);
            case VTOL ->
                new Performance(
                        new Speeds(16, 2.5, 2, 0.5, 25, 3),
                        new Power(700, 200, 900),
                        WindResponse.KEEPS_AIRSPEED,
                        true);
            case AIRSHIP ->
                new Performance(
                        new Speeds(5, 1, 1, 0.5, 8, 0.5), new Power(30, 120, 150), WindResponse.KEEPS_AIRSPEED, true);
            case ROVER, BOAT, SUBMARINE ->
                new Performance(
                        new Speeds(1.5, 1, 1, 1, 1.5, 0.5), new Power(20, 80, 80), WindResponse.UNTOUCHED, true);
        };
    }
}
