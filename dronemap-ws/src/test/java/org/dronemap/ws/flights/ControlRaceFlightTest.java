package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.HoveringVehicle;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Two users want one drone at once and take it from each other: judged by what comes to the vehicle. */
class ControlRaceFlightTest {
    private static final int ROUNDS = 60;
    private static final double STEP_DEGREES = 1e-5;
    private static final int SET_MODE = 176;
    private static final int REPOSITION = 192;
    private static final int RETURN = 20;
    private static final int UNSUPPORTED = 3;
    private static final long GUIDED = 4;
    private static final Duration CALM = Duration.ofMillis(1_200);

    private final List<Seen> moves = new ArrayList<>();

    /** A go-to at the vehicle that only one command asked for, as its latitude says. */
    private record Seen(int move, long atNanos) {}

    /** From then on, as its user was told. */
    private record Taken(long atNanos, long epoch) {}

    /** One side: what it was allowed to send, by the epoch that the server gave it. */
    private static final class Racer {
        private final Pilot pilot;
        private final Map<Integer, Long> allowed = new HashMap<>();
        private final Set<Integer> refused = new HashSet<>();
        private final List<Taken> taken = new ArrayList<>();
        private int next;

        Racer(Pilot pilot, int first) {
            this.pilot = pilot;
            this.next = first;
        }
    }

    /** In the air, guided, and slow to acknowledge: most commands are repeated until somebody stops them. */
    private void obey(HoveringVehicle peer, Frame frame, long atNanos) {
        if (frame.messageId() == CommandLong.ID) {
            CommandLong order = CommandLong.decode(frame);
            obey(peer, order.command(), order.param2());
        } else if (frame.messageId() == CommandInt.ID) {
            CommandInt order = CommandInt.decode(frame);
            if (order.command() == REPOSITION) {
                moves.add(new Seen((int) Math.round((order.x() / 1e7 - 10) / STEP_DEGREES), atNanos));
                if (moves.size() % 3 != 0) {
                    return;
                }
                peer.say(new CommandAck(REPOSITION, 0, 0, 0, 0, 0));
            } else {
                obey(peer, order.command(), order.param2());
            }
        }
    }

    private static void obey(HoveringVehicle peer, int command, float mode) {
        boolean known = command == SET_MODE || command == RETURN;
        if (known) {
            peer.is(true, command == RETURN ? 6 : (long) mode);
        }
        peer.say(new CommandAck(command, known ? 0 : UNSUPPORTED, 0, 0, 0, 0));
        peer.beat();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void twoUsersWhoRaceNeverBothHaveTheDrone(long seed) {
        try (Laboratory lab = new Laboratory(seed)) {
            HoveringVehicle peer =
                    lab.hoverer((one, frame) -> obey(one, frame, lab.time().nanos()));
            peer.is(true, GUIDED);
            lab.until(
                    "it is known",
                    Duration.ofSeconds(10),
                    () -> lab.server().house().cloud().drones().stream()
                            .anyMatch(drone -> Boolean.TRUE.equals(drone.armed())
                                    && drone.capabilities().known()));
            String drone = peer.state().id().value();
            List<Racer> both = List.of(
                    new Racer(lab.pilot("ann", Role.SUPERVISOR), 0), new Racer(lab.pilot("bob", Role.SUPERVISOR), 1));
            SplittableRandom chance = new SplittableRandom(seed);
            for (int round = 0; round < 2 * ROUNDS; round++) {
                race(lab, both.get(chance.nextInt(2)), drone, chance);
                lab.goOn(Duration.ofNanos(chance.nextLong(10_000_000)));
            }
            lab.goOn(Duration.ofSeconds(30));

            assertThat(judge(both)).isGreaterThan(1);
            assertThat(both).allSatisfy(racer -> assertThat(racer.allowed).isNotEmpty());
            assertThat(both).anySatisfy(racer -> assertThat(racer.refused).isNotEmpty());
        }
    }

    private static void race(Laboratory lab, Racer racer, String drone, SplittableRandom chance) {
        if (chance.nextDouble() < 0.4) {
            long epoch = racer.pilot.takesOver(drone, "a race").epoch();
            racer.taken.add(new Taken(lab.time().nanos(), epoch));
            if (racer.taken.size() % 8 == 1) {
                // Nobody commands: what is repeated now is of an epoch that is over.
                lab.goOn(CALM);
            }
        }
        int move = racer.next;
        racer.next += 2;
        CommandRequest there = CommandRequests.goTo(10 + move * STEP_DEGREES, 8.0, 20.0);
        try {
            Long epoch = lab.server()
                    .commands()
                    .submit(racer.pilot.principal(), "laboratory", drone, there)
                    .epoch();
            racer.allowed.put(move, epoch);
        } catch (Rejection refused) {
            assertThat(refused.kind()).isEqualTo(RejectionKind.CONFLICT);
            racer.refused.add(move);
        }
    }

    /**
     * No refused command, epochs that never fall, one holder each; and nothing of an epoch after somebody had been told of a
     * later one. Returns how often control changed hands at the vehicle.
     */
    private int judge(List<Racer> both) {
        Map<Long, Racer> holders = new HashMap<>();
        long newest = 0;
        int changes = 0;
        for (Seen seen : moves) {
            Racer racer = both.get(seen.move() % 2);
            assertThat(racer.refused).doesNotContain(seen.move());
            assertThat(racer.allowed).containsKey(seen.move());
            long epoch = racer.allowed.get(seen.move());
            // What was under way to the vehicle when control was taken is not called back.
            long told = both.stream()
                    .flatMap(one -> one.taken.stream())
                    .filter(taken -> taken.atNanos()
                            < seen.atNanos() - Duration.ofMillis(5).toNanos())
                    .mapToLong(Taken::epoch)
                    .max()
                    .orElse(0);
            assertThat(epoch).isGreaterThanOrEqualTo(newest).isGreaterThanOrEqualTo(told);
            changes += epoch > newest && newest > 0 ? 1 : 0;
            newest = epoch;
            assertThat(holders.computeIfAbsent(epoch, unused -> racer)).isSameAs(racer);
        }
        return changes;
    }
}
