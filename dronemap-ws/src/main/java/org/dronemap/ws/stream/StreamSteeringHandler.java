package org.dronemap.ws.stream;

import org.dronemap.core.access.Principal;
import org.dronemap.ws.control.SteeringRequest;
import org.dronemap.ws.control.SteeringService;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.Rejection;

/**
 * Passes steering requests of stream clients to the steering service, and lets go of drones when a client leaves. Any
 * thread; for one client one at a time, so that nothing is steered by rights that have ended in between.
 */
final class StreamSteeringHandler {
    private static final String FACE = "stream";
    private static final String DRONE = "the id of a drone";

    private final SteeringService steering;

    StreamSteeringHandler(SteeringService steering) {
        this.steering = steering;
    }

    /** False when it was not taken, and its client has just been told why; throws when it is to be told. */
    boolean steer(StreamClient client, StreamRequest.Steer request) {
        String drone = request.drone();
        if (drone == null) {
            throw InvalidInput.missing("drone", DRONE);
        }
        SteeredDrones hands = client.steeredDrones();
        synchronized (hands) {
            // Asked for here: who was shown out meanwhile has none.
            Principal principal = client.principal().orElseThrow(Rejection::sessionEnded);
            try {
                steering.steer(
                        principal,
                        FACE,
                        drone,
                        new SteeringRequest(request.velocity(), request.sticks(), request.epoch()));
                hands.add(drone, principal);
                return true;
            } catch (Rejection why) {
                letGo(hands, drone);
                if (hands.mayNotify(drone, why.sentence(), System.nanoTime())) {
                    throw why;
                }
                return false;
            }
        }
    }

    void letGo(StreamClient client, Principal principal, StreamRequest.LetGo request) {
        String drone = request.drone();
        if (drone == null) {
            throw InvalidInput.missing("drone", DRONE);
        }
        SteeredDrones hands = client.steeredDrones();
        synchronized (hands) {
            if (!letGo(hands, drone)) {
                steering.require(principal, drone);
            }
        }
    }

    /** All that it steers stands still; nothing that it says from now on is taken, as it is nobody any more. */
    void stopSteering(StreamClient client) {
        SteeredDrones hands = client.steeredDrones();
        synchronized (hands) {
            hands.drones().forEach(drone -> letGo(hands, drone));
        }
    }

    private boolean letGo(SteeredDrones hands, String drone) {
        Principal principal = hands.remove(drone);
        if (principal == null) {
            return false;
        }
        steering.letGo(principal, FACE, drone);
        return true;
    }
}
