package org.dronemap.example;

import static org.dronemap.example.RestCalls.orProblem;

import java.time.Duration;
import java.util.Set;
import java.util.function.Predicate;
import org.dronemap.example.rest.ApiClient;
import org.dronemap.example.rest.CommandsApi;
import org.dronemap.example.rest.ControlApi;
import org.dronemap.example.rest.DronesApi;
import org.dronemap.example.rest.model.ArmCommand;
import org.dronemap.example.rest.model.CommandOutcomeView;
import org.dronemap.example.rest.model.CommandRequest;
import org.dronemap.example.rest.model.ControlHeartbeatRequest;
import org.dronemap.example.rest.model.DronePositionView;
import org.dronemap.example.rest.model.DroneView;
import org.dronemap.example.rest.model.GoToCommand;
import org.dronemap.example.rest.model.ReturnToLaunchCommand;
import org.dronemap.example.rest.model.SetModeCommand;
import org.dronemap.example.rest.model.TakeOffCommand;

/** A drone under control of this program, by REST, until it is closed; one that is in the air then is called home. */
final class RestDrone implements AutoCloseable {
    private static final double OUTCOME_SECONDS = 30;
    private static final Duration LONGEST_WAY = Duration.ofMinutes(5);

    private final CommandsApi commands;
    private final ControlApi control;
    private final DronesApi drones;
    private final String id;
    private final Heartbeat heartbeat;

    RestDrone(Connection connection, String id) throws FlightException {
        ApiClient client = RestCalls.client(connection);
        commands = new CommandsApi(client);
        control = new ControlApi(client);
        drones = new DronesApi(client);
        this.id = id;
        ControlApi quick = new ControlApi(RestCalls.client(connection).setReadTimeout(Heartbeat.LONGEST));
        long taken = orProblem(() -> control.takeControl(id)).getEpoch();
        heartbeat = new Heartbeat(
                taken,
                epoch -> orProblem(() -> quick.keepControl(id, new ControlHeartbeatRequest().epoch(epoch)))
                        .getEpoch());
    }

    void arm() throws FlightException {
        String mode = state().getActions().get("arm").getMode();
        if (mode != null) {
            // The vehicle arms in another mode only, as after a return.
            SetModeCommand change = new SetModeCommand().type(SetModeCommand.TypeEnum.SET_MODE);
            carryOut(new CommandRequest(change.mode(mode).epoch(heartbeat.epoch())));
        }
        ArmCommand command = new ArmCommand().type(ArmCommand.TypeEnum.ARM);
        carryOut(new CommandRequest(command.epoch(heartbeat.epoch())));
    }

    /** Returns when it is so many metres above home. */
    void takeOff(double height) throws FlightException {
        TakeOffCommand command = new TakeOffCommand().type(TakeOffCommand.TypeEnum.TAKE_OFF);
        carryOut(new CommandRequest(command.altitude(height).epoch(heartbeat.epoch())));
        waitUntil("it is " + height + " m above home", drone -> isAt(height, drone.getPosition()));
    }

    /** Returns when it is there, at so many metres above home. */
    void goTo(Place place, double height) throws FlightException {
        GoToCommand command = new GoToCommand().type(GoToCommand.TypeEnum.GO_TO);
        command.latitude(place.latitude()).longitude(place.longitude()).altitude(height);
        carryOut(new CommandRequest(command.epoch(heartbeat.epoch())));
        waitUntil("it is at " + place, drone -> {
            DronePositionView now = drone.getPosition();
            return isAt(height, now) && place.isNear(now.getLatitude(), now.getLongitude());
        });
    }

    /** Returns when it has landed and its motors stand. */
    void returnHome() throws FlightException {
        callHome();
        waitUntil("it has landed", drone -> Boolean.FALSE.equals(drone.getArmed()));
    }

    @Override
    public void close() throws FlightException {
        try {
            if (heartbeat.holds() && isInTheAir()) {
                callHome();
            }
        } finally {
            heartbeat.close();
            if (heartbeat.holds()) {
                orProblem(() -> control.releaseControl(id));
            }
        }
    }

    private void callHome() throws FlightException {
        ReturnToLaunchCommand command =
                new ReturnToLaunchCommand().type(ReturnToLaunchCommand.TypeEnum.RETURN_TO_LAUNCH);
        carryOut(new CommandRequest(command.epoch(heartbeat.epoch())));
    }

    /** Returns when the command has succeeded. */
    private void carryOut(CommandRequest command) throws FlightException {
        CommandOutcomeView outcome = orProblem(() -> commands.giveCommand(id, command, OUTCOME_SECONDS))
                .getOutcome();
        if (outcome == null) {
            throw new FlightException("The command is still under way after " + OUTCOME_SECONDS + " s.");
        }
        if (outcome.getResult() != CommandOutcomeView.ResultEnum.SUCCEEDED) {
            throw FlightException.ofOutcome(outcome.getResult().getValue(), outcome.getReason(), outcome.getCode());
        }
    }

    private void waitUntil(String what, Predicate<DroneView> holds) throws FlightException {
        Waiting.until(what, LONGEST_WAY, () -> {
            heartbeat.check();
            return holds.test(state());
        });
    }

    private DroneView state() throws FlightException {
        return orProblem(() -> drones.getDrone(id));
    }

    private static boolean isAt(double height, DronePositionView now) {
        // What nobody knows is null.
        return now != null && now.getAltitudeAboveHome() != null && Math.abs(now.getAltitudeAboveHome() - height) <= 1;
    }

    /** What comes down already is left alone. */
    private boolean isInTheAir() throws FlightException {
        DroneView now = state();
        return now.getFlight() == null
                ? Boolean.TRUE.equals(now.getArmed())
                : Set.of(DroneView.FlightEnum.TAKING_OFF, DroneView.FlightEnum.IN_AIR)
                        .contains(now.getFlight());
    }
}
