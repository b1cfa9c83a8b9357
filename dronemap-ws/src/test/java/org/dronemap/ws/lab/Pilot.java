package org.dronemap.ws.lab;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.key.AccessKeyRequest;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.outlet.OutletService;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;

/** A user of the laboratory's server, by a face of its own. */
public final class Pilot {
    private static final String FACE = "laboratory";
    private static final Duration LONGEST_COMMAND = Duration.ofMinutes(2);

    private final Laboratory lab;
    private final String name;
    private final Role role;
    private final @Nullable String key;
    private @Nullable String passphrase;

    Pilot(Laboratory lab, String name, Role role, @Nullable String key) {
        this.lab = lab;
        this.name = name;
        this.role = role;
        this.key = key;
    }

    public String name() {
        return name;
    }

    public Role role() {
        return role;
    }

    /** What the ground stations of this user sign with. */
    public String passphrase() {
        if (passphrase == null) {
            passphrase = choosesPassphrase("the passphrase of " + name);
        }
        return passphrase;
    }

    public String choosesPassphrase(String chosen) {
        passphrase = chosen;
        return lab.server()
                .accounts()
                .outlet()
                .setPassphrase(principal(), new OutletService.PassphraseRequest(chosen))
                .passphrase();
    }

    public void clearsPassphrase() {
        passphrase = null;
        lab.server().accounts().outlet().clearPassphrase(principal());
    }

    public Principal principal() {
        return key == null ? lab.principal(name, role) : lab.principal(name, key);
    }

    /** The same user with an access key that is made by this one. */
    public Pilot withKey(AccessKeyRequest wanted) {
        return new Pilot(
                lab,
                name,
                role,
                lab.server().accounts().keys().addKey(principal(), wanted).id());
    }

    /** Says that about the control of a drone. */
    public ControlView controls(LabDrone drone, ControlRequest request) {
        return controls(drone.id().value(), request);
    }

    public ControlView controls(String drone, ControlRequest request) {
        return lab.server()
                .accounts()
                .control()
                .act(principal(), drone, request)
                .control();
    }

    public ControlView takesControl(LabDrone drone) {
        return controls(drone, new ControlRequest.TakeControl());
    }

    public ControlView takesOver(String drone, String reason) {
        return controls(drone, new ControlRequest.TakeOver(reason));
    }

    public ControlView releases(String drone) {
        return controls(drone, new ControlRequest.Release());
    }

    /** Who has control of it. */
    public ControlView control(LabDrone drone) {
        return control(drone.id().value());
    }

    public ControlView control(String drone) {
        return lab.server().accounts().control().control(principal(), drone);
    }

    /** The newest first. */
    public List<CommandView> commandsOf(LabDrone drone) {
        return lab.server().commands().commandsOf(principal(), drone.id().value());
    }

    /** As services want it. */
    public Caller caller() {
        return new Caller(principal(), FACE);
    }

    /** Gives a command and does not wait; refusals are thrown. */
    public CommandView give(LabVehicle drone, CommandRequest what) {
        return give(drone.id(), what);
    }

    public CommandView give(DroneId drone, CommandRequest what) {
        return lab.server().commands().submit(principal(), FACE, drone.value(), what);
    }

    /** Gives a command, and waits for its end whatever that is. */
    public CommandView outcome(LabVehicle drone, CommandRequest what) {
        return end(give(drone, what));
    }

    /** Waits for the end of what was given. */
    public CommandView end(CommandView given) {
        return lab.until(
                given.summary() + " has ended",
                LONGEST_COMMAND,
                () -> Optional.of(now(given)).filter(command -> command.outcome() != null));
    }

    /** How far it is now. */
    public CommandView now(CommandView given) {
        return lab.server().commands().command(principal(), given.id());
    }

    /** Gives a command, waits for its end, and insists on success. */
    public Pilot does(LabVehicle drone, CommandRequest what) {
        return succeeds(give(drone, what));
    }

    /** Waits for the end of what was given, and insists on success. */
    public Pilot succeeds(CommandView given) {
        CommandView ended = end(given);
        CommandView.OutcomeView outcome = Objects.requireNonNull(ended.outcome());
        if (!outcome.result().equals("succeeded")) {
            throw new AssertionError(ended.summary() + ": " + outcome + "; " + lab.picture());
        }
        return this;
    }

    /** The same for any drone that the server knows. */
    public Pilot does(DroneId drone, CommandRequest what) {
        CommandView ended = end(give(drone, what));
        CommandView.OutcomeView outcome = Objects.requireNonNull(ended.outcome());
        if (!outcome.result().equals("succeeded")) {
            throw new AssertionError(ended.summary() + ": " + outcome);
        }
        return this;
    }

    /** The sentence that it is refused with before anything is sent. */
    public String refusal(LabVehicle drone, CommandRequest what) {
        return refusal(drone.id(), what);
    }

    public String refusal(DroneId drone, CommandRequest what) {
        return rejection(drone, what).sentence();
    }

    public Rejection rejection(LabVehicle drone, CommandRequest what) {
        return rejection(drone.id(), what);
    }

    /** What it is refused with before anything is sent. */
    public Rejection rejection(DroneId drone, CommandRequest what) {
        try {
            CommandView given = give(drone, what);
            throw new AssertionError("Not refused: " + given);
        } catch (Rejection refused) {
            return refused;
        }
    }

    /** The sentence of the gate that refuses it, which is in its record as well. */
    public String refusalByGate(LabDrone drone, CommandRequest what) {
        Rejection refused = rejection(drone, what);
        CommandView.OutcomeView outcome = lab.server()
                .commands()
                .command(principal(), Objects.requireNonNull(refused.commandId()))
                .outcome();
        if (!new CommandView.OutcomeView(
                        "refused", "gate", refused.sentence(), refused.code().word())
                .equals(outcome)) {
            throw new AssertionError(refused.sentence() + ": " + outcome);
        }
        return refused.sentence();
    }

    public Pilot takesOff(LabDrone drone, double meters) {
        return does(drone, CommandRequests.setMode("GUIDED"))
                .does(drone, CommandRequests.arm())
                .does(drone, CommandRequests.takeOff(meters));
    }

    public Pilot fliesTo(LabDrone drone, Geodetic place, double meters) {
        return does(drone, CommandRequests.goTo(place.latitudeDegrees(), place.longitudeDegrees(), meters));
    }

    /** Uploads those items. */
    public Pilot uploads(LabDrone drone, List<MissionItem> items) {
        return does(drone, CommandRequests.uploadMission(MissionItemRequest.of(items)));
    }

    /** Arms it, and starts the mission that it has. */
    public Pilot startsMission(LabDrone drone) {
        return does(drone, CommandRequests.arm()).does(drone, CommandRequests.startMission(null));
    }

    /** Uploads a take-off, those places at one height, and the way home. */
    public Pilot plans(LabDrone drone, double meters, Geodetic... places) {
        List<MissionItem> items = new ArrayList<>();
        items.add(new MissionItem.TakeOff(meters));
        for (Geodetic place : places) {
            items.add(new MissionItem.Waypoint(place, Altitude.aboveHome(meters), 0));
        }
        items.add(new MissionItem.ReturnToLaunch());
        return uploads(drone, items);
    }
}
