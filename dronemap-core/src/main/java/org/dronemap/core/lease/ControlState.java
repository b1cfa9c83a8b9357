package org.dronemap.core.lease;

import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Control of one drone at one moment: the lease in force, open requests, and lapsed control; immutable.
 *
 * @param epoch of the last tenure; rises with each new one, and a command of an older one is not sent any more
 * @param tenure null: nobody
 * @param requests oldest first
 * @param lapse null unless the control of a user ended without another one
 * @param interruption who ended the last tenure for safety's sake, and how, as a sentence; null: it ended otherwise
 */
public record ControlState(
        long epoch,
        @Nullable Lease tenure,
        List<LeaseRequest> requests,
        @Nullable LapsedLease lapse,
        @Nullable String interruption) {
    /** Nobody has ever commanded it. */
    public static final ControlState FREE = new ControlState(0, null, List.of(), null, null);

    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss 'UTC'", Locale.ROOT)
            .withZone(ZoneOffset.UTC);

    public ControlState {
        requests = List.copyOf(requests);
    }

    /** That user has it, and knows it by this epoch. */
    boolean isHeldBy(String user, long known) {
        Long former = tenure == null ? null : tenure.formerEpoch();
        return isHeldBy(user) && (known == epoch || (former != null && known == former));
    }

    public boolean isHeldBy(String user) {
        return tenure != null && tenure.holder().is(user);
    }

    /** The users who have control or ask for it. */
    public Set<String> people() {
        Set<String> people = new LinkedHashSet<>();
        if (tenure != null && tenure.holder() instanceof LeaseHolder.Person person) {
            people.add(person.name());
        }
        requests.forEach(request -> people.add(request.by()));
        return people;
    }

    /** Who has control, since when, and what can be done about it. */
    public String sentence() {
        if (tenure == null) {
            String free = "Nobody has control; take it.";
            return interruption == null ? free : interruption + " " + free;
        }
        return tenure.holder().words() + " has had control of it since " + TIME.format(tenure.since())
                + (tenure.holder() instanceof LeaseHolder.Pilot
                        ? "; take control to command it again."
                        : tenure.holder() instanceof LeaseHolder.Operation
                                ? "; end that first, or let a supervisor take over."
                                : "; ask for it, or wait until it is given back.");
    }

    ControlState with(@Nullable Lease now) {
        return new ControlState(epoch, now, requests, lapse, interruption);
    }

    ControlState withoutLapse() {
        return new ControlState(epoch, tenure, requests, null, interruption);
    }

    ControlState withRequests(List<LeaseRequest> now) {
        return new ControlState(epoch, tenure, now, lapse, interruption);
    }

    ControlState without(String user) {
        return withRequests(
                requests.stream().filter(request -> !request.by().equals(user)).toList());
    }
}
