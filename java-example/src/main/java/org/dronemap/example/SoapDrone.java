package org.dronemap.example;

import static org.dronemap.example.SoapCalls.orProblem;

import java.time.Duration;
import java.util.Set;
import java.util.function.Predicate;
import org.dronemap.example.soap.DronemapFault;
import org.dronemap.example.soap.MAVLinkActionWebService;
import org.dronemap.example.soap.model.CommandOutcomeView;
import org.dronemap.example.soap.model.CommandView;
import org.dronemap.example.soap.model.DronePositionView;
import org.dronemap.example.soap.model.DroneView;
import org.dronemap.example.soap.model.MapOfDroneActionView;

/** A drone under control of this program, by SOAP, until it is closed; one that is in the air then is called home. */
final class SoapDrone implements AutoCloseable {
    private static final double OUTCOME_SECONDS = 30;
    private static final Duration LONGEST_WAY = Duration.ofMinutes(5);

    private interface Command {
        CommandView give(long epoch) throws DronemapFault;
    }

    private final MAVLinkActionWebService service;
    private final String id;
    private final Heartbeat heartbeat;

    SoapDrone(Connection connection, String id) throws FlightException {
        service = SoapCalls.service(connection, SoapCalls.LONGEST);
        this.id = id;
        MAVLinkActionWebService quick = SoapCalls.service(connection, Heartbeat.LONGEST);
        long taken = orProblem(() -> service.takeControl(id)).getEpoch();
        heartbeat = new Heartbeat(
                taken, epoch -> orProblem(() -> quick.keepControl(id, epoch)).getEpoch());
    }

    // What may be left out of a call is null, such as a command's own id.

    void arm() throws FlightException {
        String mode = modeToArmIn();
        if (mode != null) {
            // The vehicle arms in another mode only, as after a return.
            carryOut(epoch -> service.setMode(id, mode, null, epoch, OUTCOME_SECONDS));
        }
        carryOut(epoch -> service.arm(id, null, epoch, OUTCOME_SECONDS));
    }

    /** Returns when it is so many metres above home. */
    void takeOff(double height) throws FlightException {
        carryOut(epoch -> service.takeoff(id, height, null, epoch, OUTCOME_SECONDS));
        waitUntil("it is " + height + " m above home", drone -> isAt(height, drone.getPosition()));
    }

    /** Returns when it is there, at so many metres above home. */
    void goTo(Place place, double height) throws FlightException {
        carryOut(epoch -> service.gotoPlace(
                id, place.latitude(), place.longitude(), height, "home", null, epoch, OUTCOME_SECONDS));
        waitUntil("it is at " + place, drone -> {
            DronePositionView now = drone.getPosition();
            return isAt(height, now) && place.isNear(now.getLatitude(), now.getLongitude());
        });
    }

    /** Returns when it has landed and its motors stand. */
    void returnHome() throws FlightException {
        callHome();
        waitUntil("it has landed", drone -> Boolean.FALSE.equals(drone.isArmed()));
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
                orProblem(() -> service.releaseControl(id));
            }
        }
    }

    private void callHome() throws FlightException {
        carryOut(epoch -> service.returnToLaunch(id, null, epoch, OUTCOME_SECONDS));
    }

    /** Returns when the command has succeeded. */
    private void carryOut(Command command) throws FlightException {
        long epoch = heartbeat.epoch();
        CommandOutcomeView outcome = orProblem(() -> command.give(epoch)).getOutcome();
        if (outcome == null) {
            throw new FlightException("The command is still under way after " + OUTCOME_SECONDS + " s.");
        }
        if (!outcome.getResult().equals("succeeded")) {
            throw FlightException.ofOutcome(outcome.getResult(), outcome.getReason(), outcome.getCode());
        }
    }

    private void waitUntil(String what, Predicate<DroneView> holds) throws FlightException {
        Waiting.until(what, LONGEST_WAY, () -> {
            heartbeat.check();
            return holds.test(state());
        });
    }

    private DroneView state() throws FlightException {
        return orProblem(() -> service.getDrone(id));
    }

    private String modeToArmIn() throws FlightException {
        return state().getActions().getEntry().stream()
                .filter(action -> action.getKey().equals("arm"))
                .findFirst()
                .map(MapOfDroneActionView.Entry::getMode)
                .orElse(null);
    }

    private static boolean isAt(double height, DronePositionView now) {
        // What nobody knows is null.
        return now != null && now.getAltitudeAboveHome() != null && Math.abs(now.getAltitudeAboveHome() - height) <= 1;
    }

    /** What comes down already is left alone. */
    private boolean isInTheAir() throws FlightException {
        DroneView now = state();
        return now.getFlight() == null
                ? Boolean.TRUE.equals(now.isArmed())
                : Set.of("takingOff", "inAir").contains(now.getFlight());
    }
}
