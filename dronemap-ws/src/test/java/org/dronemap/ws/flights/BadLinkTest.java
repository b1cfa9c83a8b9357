package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.ScriptedPeer;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Commands over a link that delays by 500 ± 200 ms, loses a tenth each way, doubles and reorders. */
class BadLinkTest {
    private static final Duration LONGEST = Duration.ofMinutes(2);
    private static final Set<Integer> HOMEWARD = Set.of(CountingCopter.GUIDED, CountingCopter.RTL, CountingCopter.LAND);
    /** Control that came with a command has ended by then. */
    private static final Duration LEFT_ALONE = Duration.ofSeconds(25);

    private static final List<String> MODES = List.of("LOITER", "BRAKE");
    private static final List<Double> MODE_NUMBERS = List.of(5.0, 17.0);

    private static String type(CommandRequest body) {
        return WireNames.lowerFirst(body.kind().word());
    }

    /** One command of one drone as the server ended it. */
    private record Given(long nanos, CommandRequest body, String result) {
        /** Whether that is what the vehicle does when it carries this command out. */
        boolean showsIn(CountingCopter.Act act) {
            if (!act.kind().equals(type(body))) {
                return false;
            }
            List<Double> said = act.parameters();
            return switch (act.kind()) {
                case "setMode" ->
                    said.get(1).equals(MODE_NUMBERS.get(MODES.indexOf(((CommandRequest.SetMode) body).mode())));
                case "setRelay" ->
                    said.get(0).intValue() == Objects.requireNonNull(((CommandRequest.SetRelay) body).relay());
                case "turn" -> {
                    double degrees = Objects.requireNonNull(((CommandRequest.Turn) body).degrees());
                    yield said.get(0) == Math.abs(degrees) && said.get(2) * degrees > 0;
                }
                case "goTo" ->
                    Math.abs(said.get(0) - Objects.requireNonNull(((CommandRequest.GoTo) body).latitude()) * 1e7) < 2;
                default -> true;
            };
        }
    }

    /** One command beside what the vehicle's own log says of it. */
    private record Line(CommandRequest body, String result, int executions) {
        boolean isOnce() {
            return CountingCopter.ONCE.containsValue(type(body));
        }

        boolean isGood() {
            return result.equals("succeeded") || (result.equals("unknown") && isOnce());
        }
    }

    /** Somebody who gives one copter its commands, one after the other. */
    private static final class Giver {
        private final Pilot pilot;
        private final Laboratory lab;
        private final CountingCopter copter;
        private final Deque<CommandRequest> left;
        private final List<Given> given = new ArrayList<>();
        private @Nullable CommandRequest body;
        private @Nullable CompletableFuture<CommandView> end;
        private long began;
        private long endedNanos = Long.MAX_VALUE;

        Giver(Laboratory lab, Pilot pilot, CountingCopter copter, List<CommandRequest> commands) {
            this.lab = lab;
            this.pilot = pilot;
            this.copter = copter;
            this.left = new ArrayDeque<>(commands);
        }

        /** Gives the next one when the one before has ended; true when all have. */
        boolean goOn() {
            if (end != null) {
                if (!end.isDone()) {
                    return false;
                }
                CommandView.OutcomeView outcome =
                        Objects.requireNonNull(end.join().outcome());
                given.add(new Given(began, Objects.requireNonNull(body), outcome.result()));
                end = null;
            }
            body = left.poll();
            if (body == null) {
                endedNanos = Math.min(endedNanos, lab.time().nanos());
                return true;
            }
            began = lab.time().nanos();
            end = lab.server().commands().awaitEnd(pilot.give(copter.peer(), body), LONGEST);
            return false;
        }

        /** The outcomes line by line beside the log, whose every line must belong to a command. */
        List<Line> compared() {
            int[] executions = new int[given.size()];
            for (CountingCopter.Act act : copter.log()) {
                int likely = IntStream.range(0, given.size())
                        .filter(n -> given.get(n).nanos() <= act.nanos()
                                && given.get(n).showsIn(act))
                        .max()
                        .orElse(-1);
                if (likely >= 0) {
                    executions[likely]++;
                } else {
                    // Going somewhere may begin with the mode that this needs; whoever is left alone comes home.
                    assertThat(act.kind()).as(act.toString()).isEqualTo("setMode");
                    boolean leftAlone = act.nanos() - endedNanos > LEFT_ALONE.toNanos();
                    assertThat(act.parameters().get(1).intValue())
                            .as(act.toString())
                            .isIn(leftAlone ? HOMEWARD : Set.of(CountingCopter.GUIDED));
                }
            }
            return IntStream.range(0, given.size())
                    .mapToObj(n -> new Line(given.get(n).body(), given.get(n).result(), executions[n]))
                    .toList();
        }
    }

    /** Every kind in turn; like ones of one drone lie far apart, so that its log tells them apart. */
    private static List<CommandRequest> mixed(int count, long seed) {
        SplittableRandom chance = new SplittableRandom(seed);
        return IntStream.range(0, count)
                .mapToObj(number -> switch (number % 5) {
                    case 0 -> CommandRequests.takePicture();
                    case 1 -> CommandRequests.setMode(MODES.get(number / 5 % 2));
                    case 2 -> CommandRequests.setRelay(number % 16, "toggle");
                    case 3 -> CommandRequests.goTo(47.3 + number / 1e5, 8.5, 30.0);
                    default -> CommandRequests.turn((number % 359 + 1) * (chance.nextBoolean() ? 1.0 : -1.0));
                })
                .toList();
    }

    @Test
    void outcomesOfAHundredCommandsAgreeWithWhatTheVehiclesDid() {
        assertThat(fly(10, 10)).isNotEmpty();
    }

    @Test
    void theSameCommandsOverTheSameBadLinksAreTheSameFlight() {
        assertThat(fly(3, 4)).isEqualTo(fly(3, 4));
    }

    @Test
    void outcomesOfAThousandCommandsAgreeWithWhatTheVehiclesDid() {
        assertThat(fly(20, 50)).isNotEmpty();
    }

    /** What the whole flight has in common with an equal one. */
    private static String fly(int drones, int each) {
        try (Laboratory lab = new Laboratory(1)) {
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            List<CountingCopter> copters = IntStream.range(0, drones)
                    .mapToObj(number -> new CountingCopter(lab, 150 + number))
                    .toList();
            lab.until(
                    "the copters are listed in the air",
                    Duration.ofSeconds(30),
                    () -> copters.stream().allMatch(copter -> isInTheAir(copter.peer())));
            copters.forEach(copter -> spoil(copter.peer().wire()));
            List<Giver> givers = copters.stream()
                    .map(copter -> new Giver(
                            lab, ann, copter, mixed(each, copter.peer().port())))
                    .toList();
            lab.until("all has ended", Duration.ofMinutes(20), () -> allGoOn(givers));
            // Whatever was on its way when the last outcome came has arrived by then, and may act.
            lab.goOn(Duration.ofSeconds(2));

            judge(givers.stream().flatMap(giver -> giver.compared().stream()).toList(), drones * each);
            return lab.sum();
        }
    }

    private static void spoil(LabVehicleLink wire) {
        wire.is(LabVehicleLink.Quality.BAD);
        wire.doubles(0.02);
    }

    private static boolean allGoOn(List<Giver> givers) {
        return givers.stream().filter(giver -> !giver.goOn()).count() == 0;
    }

    private static boolean isInTheAir(ScriptedPeer peer) {
        return peer.known()
                .filter(state -> Boolean.TRUE.equals(state.armed()))
                .filter(DroneState::airborne)
                .isPresent();
    }

    private static void judge(List<Line> lines, int expected) {
        assertThat(lines).hasSize(expected);
        for (Line line : lines) {
            if (line.isOnce()) {
                assertThat(line.executions()).as(line.toString()).isLessThanOrEqualTo(1);
            }
            if (line.result().equals("succeeded")) {
                assertThat(line.executions()).as(line.toString()).isPositive();
            } else if (!line.result().equals("unknown")) {
                assertThat(line.executions()).as(line.toString()).isZero();
            }
        }
        assertThat(lines.stream().filter(Line::isGood).count() * 1_000L)
                .as(lines.stream().filter(line -> !line.isGood()).toList().toString())
                .isGreaterThanOrEqualTo(expected * 999L);
    }
}
