package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.Severity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Receives claims: whom they speak for, and who has to wait outside. Thread-safe. */
final class Reception {
    private static final Logger LOG = LoggerFactory.getLogger(Reception.class);

    private final DroneRegistry registry;
    private final Recognition recognition;
    private final WaitingRoom room;

    Reception(DroneRegistry registry, Clock clock) {
        this.registry = registry;
        this.recognition = new Recognition(registry);
        this.room = new WaitingRoom(clock);
    }

    /** Who does not come in is noted in the waiting room, with an alarm at the drone that it says it is. */
    Verdict judge(Claim claim) {
        if (claim.session().replay()) {
            return new Verdict.Stranger();
        }
        Verdict verdict = stillQuarantined(claim).orElseGet(() -> recognition.judge(claim));
        boolean admitted = verdict instanceof Verdict.Known
                || (verdict instanceof Verdict.Stranger && (claim.trusted() || claim.proof() != null));
        if (admitted) {
            room.leave(claim.session().key());
            return verdict;
        }
        Verdict.Apart apart = verdict instanceof Verdict.Apart known
                ? known
                : new Verdict.Apart(null, "Nobody knows it; an administrator may let it in.");
        if (room.note(claim, apart)) {
            tell(claim, apart);
        }
        return apart;
    }

    /** Who was seen beside the drone that it claims to be stays out until a person or a proof decides. */
    private Optional<Verdict> stillQuarantined(Claim claim) {
        if (claim.proof() != null) {
            return Optional.empty();
        }
        return room.find(claim.session().key())
                .filter(waiting -> waiting.claims() != null
                        && registry.find(waiting.claims()).isPresent())
                .map(waiting -> new Verdict.Apart(waiting.claims(), waiting.why()));
    }

    private void tell(Claim claim, Verdict.Apart apart) {
        DroneKey key = claim.session().key();
        LOG.warn("{} ({}) is kept outside: {}", key, claim.identification().vehicle(), apart.why());
        if (apart.claims() == null) {
            return;
        }
        registry.find(apart.claims())
                .ifPresent(drone -> drone.lane()
                        .execute(() -> drone.say(
                                Severity.ALERT,
                                "Another vehicle at " + key + " says that it is this drone. It is kept in quarantine:"
                                        + " nothing that it says is believed, and no command goes to it.")));
    }

    List<Waiting> waiting() {
        return room.all();
    }

    Optional<Waiting> take(String id) {
        return room.take(id);
    }

    long turnedAway() {
        return room.turnedAway();
    }
}
