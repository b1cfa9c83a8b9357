package org.dronemap.ws.testserver;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.ClaimResult;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** A vehicle at the end of a channel: keeps what it was asked for, and ends each command as the test says. */
public final class ScriptedVehicle implements VehicleChannel {
    private static final Identification COPTER =
            new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null);
    private static final Capabilities ALL =
            new Capabilities(Set.of(Capability.values()), List.of("STABILIZE", "GUIDED", "AUTO"));

    private final List<Command> performed = new CopyOnWriteArrayList<>();
    private final List<Setpoint> setpoints = new CopyOnWriteArrayList<>();
    private volatile Function<Command, Outcome> script = command -> new Outcome.Succeeded();
    private volatile boolean slow;
    private volatile @Nullable Report underWay;
    private final DroneLink link;
    private final DroneKey key;
    private final String name;

    private ScriptedVehicle(CloudManager cloud, DroneKey key, String name, Identification identification) {
        this.key = key;
        this.name = name;
        LinkSession session = new LinkSession(key, "udp", false, name, this);
        if (!(cloud.admit(new Claim(session, identification, null, true, 0)) instanceof ClaimResult.Bound bound)) {
            throw new AssertionError("it was not let in");
        }
        link = bound.link();
    }

    /** In contact, at a place near Zürich, disarmed on the ground. */
    public static ScriptedVehicle connect(CloudManager cloud, int port) {
        ScriptedVehicle vehicle =
                new ScriptedVehicle(cloud, new DroneKey("127.0.0.1", port, 1), "Copter " + port, COPTER);
        vehicle.says(new DroneEvent.Identified(COPTER, ALL));
        vehicle.says(new DroneEvent.ModeReported("GUIDED", false));
        vehicle.says(new DroneEvent.PositionReported(new Position(new Geodetic(47.3977, 8.5456), 488.0, 0.0)));
        // News go by the drone's lane: a test must not overtake them.
        ConditionWait.until(
                "the vehicle is known", () -> cloud.drone(vehicle.link.id()).filter(state -> state.position() != null));
        return vehicle;
    }

    /** In contact, and nothing more said yet. */
    public static ScriptedVehicle silent(CloudManager cloud, DroneKey key, String name, Identification identification) {
        return new ScriptedVehicle(cloud, key, name, identification);
    }

    /** A drone of a recording that is played; its id. */
    public static String played(CloudManager cloud, int port) {
        Claim claim = new Claim(session(port, true), COPTER, null, true, 0);
        if (!(cloud.admit(claim) instanceof ClaimResult.Bound bound)) {
            throw new AssertionError("it was not let in");
        }
        return bound.link().id().value();
    }

    /** Comes from where nobody is trusted, and waits to be let in; the id that it waits under. */
    public static String stranger(CloudManager cloud, int port) {
        LinkSession session = session(port, false);
        if (!(cloud.admit(new Claim(session, COPTER, null, false, 0)) instanceof ClaimResult.NotAdmitted)) {
            throw new AssertionError("it was let in");
        }
        return cloud.waiting().stream()
                .filter(waiting -> waiting.key().equals(session.key()))
                .map(org.dronemap.core.cloud.WaitingVehicle::id)
                .findFirst()
                .orElseThrow();
    }

    private static LinkSession session(int port, boolean replay) {
        return new LinkSession(
                new DroneKey("127.0.0.1", port, 1), "udp", replay, "Copter " + port, new UnresponsiveChannel());
    }

    /** Takes no command. */
    private static final class UnresponsiveChannel implements VehicleChannel {
        @Override
        public void steer(SendAuthority mandate, Setpoint setpoint) {
            throw new AssertionError("nobody steers here");
        }

        @Override
        public void perform(SendAuthority mandate, Command command, Report report) {
            report.ended(new Outcome.Failed("It hears nothing."));
        }

        @Override
        public void cancel(CommandId id) {
            // nothing is under way
        }

        @Override
        public void probe() {
            // nobody is there to be asked
        }
    }

    public String name() {
        return name;
    }

    public String id() {
        return link.id().value();
    }

    /** How every command from now on ends. */
    public void ends(Function<Command, Outcome> how) {
        script = how;
    }

    /** From now on the test says how far a command is. */
    public void takesItsTime() {
        slow = true;
    }

    /** The one that takes its time; null: none does yet. */
    public @Nullable Report underWay() {
        return underWay;
    }

    public void says(DroneEvent event) {
        link.lane().execute(() -> link.accept(event));
    }

    /** Its link is as good as that. */
    public void isReached(LinkQuality quality) {
        link.lane().execute(() -> link.linkChanged(new LinkReport(key, "udp", quality, List.of())));
    }

    /** What reached the vehicle. */
    public List<Setpoint> setpoints() {
        return List.copyOf(setpoints);
    }

    public List<Command> performed() {
        return List.copyOf(performed);
    }

    @Override
    public void steer(SendAuthority mandate, Setpoint setpoint) {
        mandate.fence().pass(() -> setpoints.add(setpoint));
    }

    @Override
    public void perform(SendAuthority mandate, Command command, Report report) {
        // As at a real link: what was admitted before somebody else took control must not act after theirs.
        mandate.fence().pass(() -> {
            performed.add(command);
            report.accepted();
            if (slow) {
                underWay = report;
                return;
            }
            Outcome outcome = script.apply(command);
            // What the vehicle has said on the way is known before its answer is.
            link.lane().execute(() -> report.ended(outcome));
        });
    }

    @Override
    public void cancel(CommandId id) {
        // who waits for one that takes its time says how it ends
    }

    @Override
    public void probe() {
        link.lane().execute(link::received);
    }
}
