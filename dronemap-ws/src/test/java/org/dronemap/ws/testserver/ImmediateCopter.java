package org.dronemap.ws.testserver;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** A copter that does what it is told at once, and flies a mission an item at a time, when the test says. */
public final class ImmediateCopter {
    private static final Capabilities ALL = new Capabilities(
            Set.of(Capability.values()),
            List.of("GUIDED", "AUTO", "RTL", "LAND", "BRAKE", "LOITER"),
            Map.of(
                    "GUIDED",
                    Steering.ORDERS,
                    "AUTO",
                    Steering.MISSION,
                    "RTL",
                    Steering.SAFETY,
                    "LAND",
                    Steering.SAFETY,
                    "BRAKE",
                    Steering.STANDS,
                    "LOITER",
                    Steering.STICKS));

    private final ScriptedVehicle vehicle;
    private final Geodetic stand;
    private volatile @Nullable Class<? extends Command> unwilling;
    private volatile Runnable before = () -> {};
    private volatile boolean armed;
    private volatile boolean grounded;

    /** It stands there, with that system id and name, and a hardware id that goes with both its name and its port. */
    public ImmediateCopter(CloudManager cloud, DroneKey key, String name, Geodetic stand) {
        this.stand = stand;
        String hardware = "uid-of-" + name + "-" + key.port();
        Identification identification =
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", hardware);
        vehicle = ScriptedVehicle.silent(cloud, key, name, identification);
        vehicle.ends(this::obey);
        vehicle.says(new DroneEvent.Identified(identification, ALL));
        vehicle.says(new DroneEvent.HomeReported(new Home(stand, 488)));
        vehicle.says(new DroneEvent.BatteryReported(new Battery(95, null, null)));
        vehicle.says(new DroneEvent.TextReported(Severity.INFO, "I am " + name));
        isOnGround();
        DroneId id = new DroneId(vehicle.id());
        // News go by the drone's lane: a test must not overtake them.
        ConditionWait.until("the copter is known", () -> cloud.drone(id).filter(state -> state.position() != null));
    }

    public String id() {
        return vehicle.id();
    }

    public List<Command> performed() {
        return vehicle.performed();
    }

    /** Its link loses nothing. */
    public ImmediateCopter wellHeard(CloudManager cloud) {
        vehicle.isReached(new LinkQuality(0.0, 0.0, 20.0));
        ConditionWait.until(
                "its link is known",
                () -> cloud.drone(new DroneId(vehicle.id()))
                        .filter(state -> state.link().quality().lossShort() != null));
        return this;
    }

    /** Fails to do this. */
    public void cannot(Class<? extends Command> kind) {
        unwilling = kind;
    }

    /** Does this before it does what it is told. */
    void waitsFor(Runnable first) {
        before = first;
    }

    private Outcome obey(Command command) {
        before.run();
        Class<? extends Command> not = unwilling;
        if (not != null && not.isInstance(command)) {
            return new Outcome.Failed("It does not want to.");
        }
        if (command instanceof Command.UploadMission upload) {
            vehicle.says(new DroneEvent.MissionRead(upload.mission().items(), null, true));
            vehicle.says(new DroneEvent.MissionCurrentReported(0, MissionPhase.STOPPED));
        } else if (command instanceof Command.Arm) {
            armed = true;
            isIn("GUIDED");
        } else if (command instanceof Command.TakeOff && !grounded) {
            isInTheAir();
        } else if (command instanceof Command.StartMission) {
            isInTheAir();
            isIn("AUTO");
        } else if (command instanceof Command.SetMode set) {
            isIn(set.mode());
        } else if (command instanceof Command.ReturnToLaunch) {
            isIn("RTL");
        } else if (command instanceof Command.Land) {
            isIn("LAND");
        } else if (command instanceof Command.Hold) {
            isIn("BRAKE");
        }
        return new Outcome.Succeeded();
    }

    /** However it came to that mode. */
    public void isIn(String mode) {
        vehicle.says(new DroneEvent.ModeReported(mode, armed));
    }

    /** It takes all orders, and never leaves the ground. */
    public void staysDown() {
        grounded = true;
    }

    public void reaches(int item) {
        vehicle.says(new DroneEvent.MissionItemReached(item));
        vehicle.says(new DroneEvent.MissionCurrentReported(item + 1, MissionPhase.RUNNING));
    }

    private void isInTheAir() {
        vehicle.says(new DroneEvent.PositionReported(new Position(stand, 508.0, 20.0)));
        vehicle.says(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
    }

    /** It hovers above its home. */
    public void isAloft(CloudManager cloud) {
        armed = true;
        isIn("GUIDED");
        isInTheAir();
        ConditionWait.until(
                "it is known to be in the air",
                () -> cloud.drone(new DroneId(vehicle.id()))
                        .filter(state -> state.airborne()
                                && Boolean.TRUE.equals(state.armed())
                                && "GUIDED".equals(state.mode())));
    }

    /** What it was steered by. */
    public List<Setpoint> setpoints() {
        return vehicle.setpoints();
    }

    public void feelsWind(double fromDegrees, double metersPerSecond) {
        vehicle.says(new DroneEvent.WindReported(fromDegrees, metersPerSecond));
    }

    /** Its battery has so much left. */
    public void hasLeft(int percent) {
        vehicle.says(new DroneEvent.BatteryReported(new Battery(percent, null, null)));
    }

    /** Down and disarmed. */
    public void isOnGround() {
        vehicle.says(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
        vehicle.says(new DroneEvent.PositionReported(new Position(stand, 488.0, 0.0)));
        armed = false;
        isIn("GUIDED");
    }
}
