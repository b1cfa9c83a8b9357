package org.dronemap.proxy.roslink;

import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotMessage.Triple;
import org.jspecify.annotations.Nullable;

/**
 * Translates the reports of a ROSLink robot into drone events; what was not measured is unknown, never 0. Owned by the
 * session's lane.
 */
final class RobotTelemetryTranslator {
    private static final double MILLIVOLTS_FROM = 1_000;
    private static final int MOST_PERCENT = 100;
    /** ArduPilot's word for a drone on the ground, and for one in the air, behind mavros. */
    private static final int STANDBY = 3;

    private static final int ACTIVE = 4;
    private static final int LAST_SYSTEM_STATUS = 8;

    /** The protocol has no word for it, and public bridges go on as they were told. */
    static final String WITHOUT_CLOUD =
            "What it does when the cloud falls silent is not known: robots over ROSLink do not tell.";

    private static final Set<Capability> IN_THE_AIR = Set.of(Capability.TAKE_OFF, Capability.LAND);
    private static final Set<Capability> ON_WHEELS =
            Set.of(Capability.EMERGENCY_STOP, Capability.GO_TO_LOCAL, Capability.READ_MAP);
    private static final Set<Capability> BY_FLIGHT_CONTROLLER =
            Set.of(Capability.ARM, Capability.DISARM, Capability.SET_MODE, Capability.RETURN_TO_LAUNCH);

    private final RobotType type;
    private final @Nullable String hardware;
    private final Consumer<DroneEvent> news;
    private final RobotSensorTranslator senses;
    private RobotStatus facts = RobotStatus.NONE;
    private boolean emergency;
    private @Nullable Geodetic point;
    private @Nullable Double altitude;

    /** {@code hardware}: what tells the robot from others where it can show no key; null when nothing does. {@code unreadable}: told of what is no picture. */
    RobotTelemetryTranslator(
            RobotType type, @Nullable String hardware, Consumer<DroneEvent> news, Runnable unreadable) {
        senses = new RobotSensorTranslator(news, unreadable);
        this.type = type;
        this.hardware = hardware;
        this.news = news;
    }

    RobotStatus facts() {
        return facts;
    }

    Identification identification() {
        return new Identification(type.kind(), "ROS", type.label(), null, hardware);
    }

    Capabilities capabilities() {
        boolean named = type.words() == RobotType.Dialect.MAVROS;
        return named
                ? Capabilities.of(can(), RobotModes.all(), RobotModes.steering(), RobotModes.usual())
                : Capabilities.of(can(), List.of(), Map.of(), Map.of());
    }

    /** What is not here it cannot. */
    private Set<Capability> can() {
        RobotType.Dialect words = type.words();
        EnumSet<Capability> can = EnumSet.of(Capability.HOLD, Capability.VELOCITY);
        can.addAll(words.flies() ? IN_THE_AIR : ON_WHEELS);
        if (words == RobotType.Dialect.MAVROS) {
            can.addAll(BY_FLIGHT_CONTROLLER);
        }
        return can;
    }

    /** A drone listens from now on that knows nothing of the robot yet. */
    void identified() {
        news.accept(new DroneEvent.Identified(identification(), capabilities()));
        news.accept(new DroneEvent.TextReported(Severity.INFO, WITHOUT_CLOUD));
    }

    void received(RobotMessage message) {
        if (message instanceof RobotMessage.Status status) {
            status(status);
        } else if (message instanceof RobotMessage.Motion motion) {
            motion(motion);
        } else if (message instanceof RobotMessage.Satellites satellites) {
            satellites(satellites);
        } else if (message instanceof RobotMessage.Scan scan) {
            senses.scanned(scan);
        } else if (message instanceof RobotMessage.Image image) {
            senses.saw(image);
        } else if (message instanceof RobotMessage.MapImage map) {
            facts = facts.mapped(senses.mapped(map));
        }
    }

    private void status(RobotMessage.Status status) {
        Integer state = status.state();
        if (state != null && type.words() == RobotType.Dialect.MAVROS) {
            flightController(state);
        } else if (state != null && type.words() == RobotType.Dialect.AR_DRONE) {
            arDrone(state);
        }
        Battery battery = battery(status);
        if (battery != null) {
            news.accept(new DroneEvent.BatteryReported(battery));
        }
    }

    /** Thousands say how the system stands, hundreds whether it is armed, the rest is the mode. */
    private void flightController(int state) {
        int system = state / 1_000;
        int armed = state % 1_000 / 100;
        if (state < 0 || system > LAST_SYSTEM_STATUS || armed > 1) {
            facts = facts.flying(null, null, null);
            return;
        }
        int mode = state % 100;
        FlightPhase phase = switch (system) {
            case STANDBY -> FlightPhase.ON_GROUND;
            case ACTIVE -> FlightPhase.IN_AIR;
            default -> null;
        };
        facts = facts.flying(mode, armed == 1, phase);
        news.accept(new DroneEvent.ModeReported(RobotModes.name(mode), armed == 1));
        publishPhase(phase);
    }

    private void arDrone(int state) {
        FlightPhase phase = switch (state) {
            case 1, 2 -> FlightPhase.ON_GROUND;
            case 3, 4 -> FlightPhase.IN_AIR;
            case 5 -> FlightPhase.TAKING_OFF;
            default -> null;
        };
        facts = facts.flying(null, null, phase);
        publishPhase(phase);
        if (state == 0 && !emergency) {
            news.accept(new DroneEvent.TextReported(Severity.EMERGENCY, "The drone says that it is in an emergency."));
        }
        emergency = state == 0;
    }

    private void publishPhase(@Nullable FlightPhase phase) {
        if (phase != null) {
            news.accept(new DroneEvent.PhaseReported(phase));
        }
    }

    /** Null when nothing of it was measured: a robot without a battery sends zeros, or nothing. */
    private static @Nullable Battery battery(RobotMessage.Status status) {
        Double volts = volts(status.batteryVoltage());
        Double remaining = status.batteryRemaining();
        Integer percent = null;
        if (remaining != null && remaining <= MOST_PERCENT && (remaining > 0 || (remaining == 0 && volts != null))) {
            percent = (int) Math.round(remaining);
        }
        if (volts == null && percent == null) {
            return null;
        }
        return new Battery(percent, volts, null);
    }

    /** Some bridges say millivolts. */
    private static @Nullable Double volts(@Nullable Double said) {
        if (said == null || said <= 0) {
            return null;
        }
        return said >= MILLIVOLTS_FROM ? said / 1_000 : said;
    }

    private void motion(RobotMessage.Motion motion) {
        Triple place = motion.place();
        boolean flies = type.words().flies();
        Double height = flies ? place.z() : null;
        facts = facts.moving(new RobotStatus.Kinematics(
                place.x(), place.y(), height, greatest(motion.speed()), greatest(motion.turn())));
        if (place.x() != null && place.y() != null) {
            Double yaw = motion.angles().heading();
            if (yaw == null && type.words() == RobotType.Dialect.WHEELS) {
                yaw = place.z();
            }
            news.accept(new DroneEvent.LocalPositionReported(
                    new LocalPosition(place.x(), place.y(), height, yaw == null ? null : Math.toDegrees(yaw))));
        }
        if (height != null) {
            news.accept(new DroneEvent.PositionReported(new Position(point, altitude, height)));
        }
        Double ground = ground(motion.speed());
        if (ground != null) {
            news.accept(new DroneEvent.MotionReported(
                    new Motion(ground, null, flies ? motion.speed().z() : null, null)));
        }
    }

    private static @Nullable Double ground(Triple speed) {
        return speed.x() == null || speed.y() == null ? null : (Double) Math.hypot(speed.x(), speed.y());
    }

    /** Null when it says nothing of it. */
    private static @Nullable Double greatest(Triple axes) {
        return Stream.of(axes.x(), axes.y(), axes.z())
                .flatMap(Stream::ofNullable)
                .map(Math::abs)
                .max(Double::compare)
                .orElse(null);
    }

    private void satellites(RobotMessage.Satellites satellites) {
        GpsFix fix = fix(satellites.fix());
        if (fix != null) {
            news.accept(new DroneEvent.GpsReported(new Gps(fix, satellites.visible(), null)));
        }
        Double latitude = satellites.latitude();
        Double longitude = satellites.longitude();
        if (latitude == null || longitude == null || fix == GpsFix.NONE || (latitude == 0 && longitude == 0)) {
            return;
        }
        if (Math.abs(latitude) <= 90 && Math.abs(longitude) <= 180) {
            point = new Geodetic(latitude, longitude);
            Double above = satellites.altitude();
            altitude = above == null || above == 0 ? null : above;
            news.accept(new DroneEvent.PositionReported(new Position(point, altitude, facts.height())));
        }
    }

    /** Bridges count in more than one way, where 0 and 1 may be a fix or none: these say nothing. */
    private static @Nullable GpsFix fix(@Nullable Integer number) {
        if (number == null || number == 0 || number == 1) {
            return null;
        }
        return switch (number) {
            case -1 -> GpsFix.NONE;
            case 2 -> GpsFix.TWO_D;
            case 3 -> GpsFix.THREE_D;
            case 4 -> GpsFix.DGPS;
            case 5 -> GpsFix.RTK_FLOAT;
            case 6 -> GpsFix.RTK_FIXED;
            default -> null;
        };
    }
}
