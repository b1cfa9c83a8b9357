package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.MissionAbilities;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** A copter of the tests: straight flight at given speeds, and faults on demand. Behaves as ArduCopter does where it matters. */
final class TestVehicle {
    static final double GROUND = 400;
    private static final LocalPlane PLANE = new LocalPlane(PlanningFixtures.point(0, 0));
    final DroneId id;
    VehicleKind kind = VehicleKind.MULTICOPTER;
    MissionAbilities missions = MissionAbilities.ALL;
    final double homeEast;
    final double homeNorth;
    double cruise = 10;
    double joules = 1e9;
    double fullJoules = 1e9;
    double drain;
    double east;
    double north;
    double altitude = GROUND;
    double climb;
    String mode = "LOITER";
    boolean armed;
    /** So many seconds it stays just above the ground before it climbs. */
    double lingers;

    /** So many seconds after a start in the air it does not move yet, as vehicles do that gather speed. */
    double hesitates;

    private double hesitating;

    /** It has just lost its motors: it leans and sinks, and goes on with its mission as long as it can. */
    boolean tumbles;

    boolean falling;
    boolean fallen;
    boolean cut;
    double cutFor;
    /** It stays where it is when it misses the cloud. */
    boolean withoutFailSafe;
    /** Nobody is there to be heard, nor hears it. */
    boolean alone;
    /** So many seconds the cloud does not know its mission yet. */
    double untold;

    double heardFor = 60;

    @Nullable
    String takenBy;

    /** Somebody else's, of its mission: no other one is taken. */
    @Nullable
    String transfer;

    MissionCloudLossPolicy onCloudLoss = MissionCloudLossPolicy.RETURN_TO_LAUNCH;
    Command.@Nullable GoTo aim;
    List<MissionItem> items = List.of();
    int current;
    final TreeSet<Integer> reached = new TreeSet<>();
    boolean complete;
    private double held;
    /** Over its home; as ArduCopter is delivered. */
    double returnMeters = 15;

    @Nullable
    ReturnHeight returning;

    double stillFor;
    /** Places that it came to by its missions, with the moment. */
    final List<MissionItem.Waypoint> visits = new ArrayList<>();

    final List<Geodetic> photos = new ArrayList<>();
    final List<MissionItem.SetServo> moved = new ArrayList<>();
    private final TestVehicleReport report = new TestVehicleReport(this);
    boolean tellsPhotos = true;

    @Nullable
    Double reading;

    TestVehicle(int number, double east, double north) {
        this.id = new DroneId("d" + number);
        this.homeEast = east;
        this.homeNorth = north;
        this.east = east;
        this.north = north;
    }

    boolean isUp() {
        return altitude > GROUND + 0.3;
    }

    boolean fliesMission() {
        return armed && mode.equals("AUTO") && !fallen && !falling;
    }

    void step(double seconds) {
        double e = east;
        double n = north;
        double a = altitude;
        cutFor = cut || alone ? cutFor + seconds : 0;
        heardFor = cut || alone ? 0 : heardFor + seconds;
        untold -= seconds;
        if (cutFor > 5 && armed && missesTheCloud()) {
            mode = "RTL";
            armed = isUp();
        }
        joules -= isUp() ? (150 + drain) * seconds : 0;
        move(seconds);
        climb = (altitude - a) / seconds;
        boolean moved = Math.hypot(east - e, north - n) > 0.01 || Math.abs(altitude - a) > 0.01;
        stillFor = moved || !armed ? 0 : stillFor + seconds;
    }

    /** Who flies a mission may be told to go on; who waits for the cloud never is, and pilots are not minded. */
    private boolean missesTheCloud() {
        if (withoutFailSafe) {
            return false;
        }
        return mode.equals("AUTO")
                ? onCloudLoss == MissionCloudLossPolicy.RETURN_TO_LAUNCH
                : mode.equals("GUIDED") || mode.equals("BRAKE");
    }

    /** The cloud has forgotten what it heard. */
    void forgotten() {
        reached.clear();
        untold = 1.6;
    }

    private void move(double seconds) {
        if (falling) {
            altitude = Math.max(GROUND, altitude - 11.8 * seconds);
            fallen = fallen || altitude == GROUND;
        } else if (armed) {
            steer(seconds);
        }
    }

    private void steer(double seconds) {
        hesitating -= seconds;
        if (hesitating > 0) {
            return;
        }
        switch (mode) {
            case "AUTO" -> fly(seconds);
            case "RTL" -> comeHome(seconds);
            case "LAND" -> land(seconds);
            case "GUIDED" -> goTo(seconds);
            default -> {}
        }
    }

    /** It never flies. */
    boolean drives() {
        return kind == VehicleKind.ROVER || kind == VehicleKind.BOAT;
    }

    private void comeHome(double seconds) {
        if (drives()) {
            to(homeEast, homeNorth, altitude, seconds);
        } else if (kind == VehicleKind.FIXED_WING) {
            circle(seconds);
        } else if (Math.hypot(east - homeEast, north - homeNorth) < 0.5) {
            land(seconds);
        } else if (altitude < GROUND + returnMeters - 0.3) {
            altitude = Math.min(GROUND + returnMeters, altitude + 2 * seconds);
        } else {
            to(homeEast, homeNorth, altitude, seconds);
        }
    }

    /** Round its home, until somebody brings it down. */
    private void circle(double seconds) {
        double angle = Math.atan2(north - homeNorth, east - homeEast) + 0.3;
        to(homeEast + 60 * Math.cos(angle), homeNorth + 60 * Math.sin(angle), altitude, seconds);
    }

    private void goTo(double seconds) {
        Command.GoTo there = aim;
        if (there != null && isUp()) {
            PlanePoint spot = PLANE.spot(there.point());
            to(spot.eastMeters(), spot.northMeters(), there.altitude().meters(), seconds);
        }
    }

    private void fly(double seconds) {
        if (current >= items.size()) {
            return;
        }
        MissionItem item = items.get(current);
        if (item instanceof MissionItem.TakeOff takeOff) {
            lingers -= seconds;
            double top = lingers > 0 ? GROUND + 0.5 : GROUND + takeOff.altitudeMeters();
            altitude = Math.min(top, altitude + 2 * seconds);
            passed(altitude >= GROUND + takeOff.altitudeMeters() - 0.01);
        } else if (item instanceof MissionItem.Waypoint waypoint) {
            PlanePoint spot = PLANE.spot(waypoint.point());
            boolean there = to(
                    spot.eastMeters(), spot.northMeters(), waypoint.altitude().meters(), seconds);
            held = there ? held + seconds : 0;
            if (there && held >= waypoint.holdSeconds()) {
                visits.add(waypoint);
                hesitating = waypoint.holdSeconds() > 0 ? hesitates : 0;
                passed(true);
            }
        } else if (item instanceof MissionItem.Wait wait) {
            held += seconds;
            passed(held >= wait.seconds());
        } else if (!MissionLegs.isFlown(item)) {
            obey(item);
            passed(true);
        } else {
            end(item, seconds);
        }
    }

    private void end(MissionItem item, double seconds) {
        if (item instanceof MissionItem.ReturnToLaunch) {
            mode = "RTL";
        } else if (item instanceof MissionItem.Land) {
            land(seconds);
            if (!armed) {
                reached.add(current);
                complete = true;
            }
        }
    }

    private void obey(MissionItem action) {
        if (action instanceof MissionItem.TakePhoto) {
            photos.add(PlanningFixtures.point(east, north));
        } else if (action instanceof MissionItem.SetServo servo) {
            moved.add(servo);
        }
    }

    private void passed(boolean done) {
        if (done) {
            reached.add(current);
            held = 0;
            current++;
            complete |= current == items.size();
        }
    }

    private void land(double seconds) {
        altitude = Math.max(GROUND, altitude - (altitude > GROUND + 10 ? 1 : 0.5) * seconds);
        armed = armed && altitude > GROUND;
    }

    /** Straight there, as fast as its slower way lets it. */
    private boolean to(double toEast, double toNorth, double toAltitude, double seconds) {
        double meters = Math.hypot(toEast - east, toNorth - north);
        double up = drives() ? 0 : toAltitude - altitude;
        double takes = Math.max(meters / cruise, up > 0 ? up / 2 : -up / 1.5);
        double part = takes > seconds ? seconds / takes : 1;
        east += (toEast - east) * part;
        north += (toNorth - north) * part;
        altitude += up * part;
        return Math.hypot(toEast - east, toNorth - north) < 0.5 && (drives() || Math.abs(toAltitude - altitude) < 0.3);
    }

    /** Null: succeeded. */
    @Nullable
    String carryOut(Command command) {
        if (command instanceof Command.UploadMission upload) {
            items = upload.mission().items();
            reached.clear();
            complete = false;
        } else if (command instanceof SetReturnHeight set) {
            double meters = set.atLeast() ? Math.max(returnMeters, set.meters()) : set.meters();
            returning = new ReturnHeight(meters, returnMeters);
            returnMeters = meters;
        } else if (command instanceof Command.Arm || command instanceof Command.Disarm) {
            return motors(command instanceof Command.Arm);
        } else if (command instanceof Command.StartMission start) {
            return start(start);
        } else if (command instanceof Command.GoTo goTo) {
            mode = "GUIDED";
            aim = goTo;
        } else {
            aim = null;
            mode = command instanceof Command.SetMode set
                    ? set.mode()
                    : command instanceof Command.PauseMission ? (drives() ? "HOLD" : "BRAKE") : "RTL";
        }
        return null;
    }

    private @Nullable String motors(boolean on) {
        if (on && !mode.equals("GUIDED")) {
            return "It cannot be armed in " + mode + ".";
        }
        if (!on && isUp()) {
            return "It is in the air.";
        }
        armed = on;
        return null;
    }

    private @Nullable String start(Command.StartMission start) {
        if (!armed) {
            return "It is not armed.";
        }
        onCloudLoss = start.onCloudLoss();
        current = start.anew() || (!isUp() && !drives()) ? 0 : current;
        held = 0;
        hesitating = isUp() ? hesitates : 0;
        mode = "AUTO";
        return null;
    }

    DroneState state(Instant now) {
        return report.of(now);
    }
}
