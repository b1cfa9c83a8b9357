package org.dronemap.core.command;

import java.util.Locale;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;

/** What may be asked of a drone. Discrete: each one ends in exactly one {@link Outcome}. */
public sealed interface Command {
    /** What the vehicle must be able to do for it. */
    Capability needs();

    /** A phrase for people: "take off to 20 m". */
    String summary();

    record Arm() implements Command {
        @Override
        public Capability needs() {
            return Capability.ARM;
        }

        @Override
        public String summary() {
            return "arm";
        }
    }

    /** {@code force} stops the motors even in the air. */
    record Disarm(boolean force) implements Command {
        @Override
        public Capability needs() {
            return Capability.DISARM;
        }

        @Override
        public String summary() {
            return force ? "stop the motors at once" : "disarm";
        }
    }

    record SetMode(String mode) implements Command {
        @Override
        public Capability needs() {
            return Capability.SET_MODE;
        }

        @Override
        public String summary() {
            return "change mode to " + mode;
        }
    }

    /** Climb to a height of 1 to 500 m above home. */
    record TakeOff(double altitudeMeters) implements Command {
        public TakeOff {
            if (!(altitudeMeters >= 1 && altitudeMeters <= 500)) {
                throw new IllegalArgumentException("take-off altitude must be 1 to 500 m: " + altitudeMeters);
            }
        }

        @Override
        public Capability needs() {
            return Capability.TAKE_OFF;
        }

        @Override
        public String summary() {
            return String.format(Locale.ROOT, "take off to %.0f m", altitudeMeters);
        }
    }

    record Land() implements Command {
        @Override
        public Capability needs() {
            return Capability.LAND;
        }

        @Override
        public String summary() {
            return "land";
        }
    }

    record ReturnToLaunch() implements Command {
        @Override
        public Capability needs() {
            return Capability.RETURN_TO_LAUNCH;
        }

        @Override
        public String summary() {
            return "return to launch";
        }
    }

    record Hold() implements Command {
        @Override
        public Capability needs() {
            return Capability.HOLD;
        }

        @Override
        public String summary() {
            return "hold";
        }
    }

    record GoTo(Geodetic point, Altitude altitude) implements Command {
        @Override
        public Capability needs() {
            return Capability.GO_TO;
        }

        @Override
        public String summary() {
            return String.format(
                    Locale.ROOT,
                    "go to %.6f, %.6f at %.0f m",
                    point.latitudeDegrees(),
                    point.longitudeDegrees(),
                    altitude.meters());
        }
    }

    record UploadMission(Mission mission) implements Command {
        @Override
        public Capability needs() {
            return Capability.UPLOAD_MISSION;
        }

        @Override
        public String summary() {
            return "upload a mission of " + mission.items().size() + " items";
        }
    }

    /** {@code onCloudLoss}: what the vehicle shall do by itself when the cloud falls silent on the way. */
    record StartMission(CloudLoss onCloudLoss) implements Command {
        @Override
        public Capability needs() {
            return Capability.START_MISSION;
        }

        @Override
        public String summary() {
            return "start the mission";
        }
    }

    record PauseMission() implements Command {
        @Override
        public Capability needs() {
            return Capability.PAUSE_MISSION;
        }

        @Override
        public String summary() {
            return "pause the mission";
        }
    }

    record ClearMission() implements Command {
        @Override
        public Capability needs() {
            return Capability.CLEAR_MISSION;
        }

        @Override
        public String summary() {
            return "clear the mission";
        }
    }

    /** Which commands compete with each other on one vehicle. */
    enum Contention {
        /** Motors on or off; the newer one wins. */
        ARMING,
        /** Where to fly; the newer one wins. */
        FLIGHT,
        /** Mission items on the wire; the first one goes on. */
        TRANSFER
    }

    /** What this command competes for. */
    default Contention contention() {
        return switch (needs()) {
            case ARM, DISARM -> Contention.ARMING;
            case UPLOAD_MISSION, CLEAR_MISSION -> Contention.TRANSFER;
            default -> Contention.FLIGHT;
        };
    }
}
