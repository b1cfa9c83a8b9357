package org.dronemap.core.lease;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever people, pilots and time do in whatever order: one holder, rising epochs, and the same again. */
class LeaseWalkTest {
    private static final int STEPS = 20_000;
    private static final String[] USERS = {"ann", "bob", "carl", "sue"};

    private record Walk(List<LeaseEvent> events, List<ClockReading> moments, List<ControlState> controls) {}

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void neverHasTwoHoldersNorAnEpochTwice(long seed) {
        Walk walk = walk(seed);
        ControlState before = ControlState.FREE;
        for (int i = 0; i < STEPS; i++) {
            ControlState now = walk.controls().get(i);
            LeaseEvent event = walk.events().get(i);
            assertThat(now.epoch()).as("step %d: %s", i, event).isGreaterThanOrEqualTo(before.epoch());
            if (isNewHolder(before, now)) {
                assertThat(now.epoch()).as("step %d: %s", i, event).isGreaterThan(before.epoch());
            }
            if (before.tenure() != null && now.tenure() != null && now.epoch() == before.epoch()) {
                assertThat(now.tenure().holder()).isEqualTo(before.tenure().holder());
            }
            assertThat(now.requests()).noneMatch(request -> now.isHeldBy(request.by()));
            before = now;
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void letsOnlyTheHolderCommand(long seed) {
        Walk walk = walk(seed);
        AtomicLong epochs = new AtomicLong(1_000_000);
        LeaseMachine machine = new LeaseMachine(LeaseRules.DEFAULT, epochs::incrementAndGet);
        for (int i = 0; i < STEPS; i += 7) {
            ControlState now = walk.controls().get(i);
            for (String user : USERS) {
                LeaseStep asked = machine.apply(
                        now, new LeaseEvent.Command(user, null), walk.moments().get(i));
                boolean allowed = now.tenure() == null || now.isHeldBy(user);
                assertThat(asked.answer() instanceof LeaseAnswer.Granted).isEqualTo(allowed);
                assertThat(asked.control().isHeldBy(user)).isEqualTo(allowed);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void knowsBeforeAskingWhetherTimeChangesAnything(long seed) {
        Walk walk = walk(seed);
        AtomicLong epochs = new AtomicLong(1_000_000);
        LeaseMachine machine = new LeaseMachine(LeaseRules.DEFAULT, epochs::incrementAndGet);
        for (int i = 0; i < STEPS; i++) {
            ControlState now = walk.controls().get(i);
            ClockReading moment = walk.moments().get(i);
            boolean due = machine.isDue(now, moment.nanos());
            ControlState then = machine.apply(now, new LeaseEvent.TimeAdvanced(false, true), moment)
                    .control();
            assertThat(then.equals(now)).as("step %d: %s", i, now).isNotEqualTo(due);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {9, 10})
    void goesTheSameWayAgain(long seed) {
        assertThat(walk(seed)).isEqualTo(walk(seed));
    }

    private static boolean isNewHolder(ControlState before, ControlState now) {
        return now.tenure() != null
                && (before.tenure() == null
                        || !before.tenure().holder().equals(now.tenure().holder()));
    }

    private static Walk walk(long seed) {
        Random random = new Random(seed);
        AtomicLong epochs = new AtomicLong();
        LeaseMachine machine = new LeaseMachine(LeaseRules.DEFAULT, epochs::incrementAndGet);
        Walk walk = new Walk(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        ControlState control = ControlState.FREE;
        long nanos = 0;
        for (int i = 0; i < STEPS; i++) {
            nanos += random.nextInt(20) == 0 ? random.nextLong(40_000_000_000L) : random.nextLong(2_000_000_000L);
            ClockReading now = new ClockReading(Instant.EPOCH.plusNanos(nanos), nanos);
            LeaseEvent event = any(random, control);
            control = machine.apply(control, event, now).control();
            walk.events().add(event);
            walk.moments().add(now);
            walk.controls().add(control);
        }
        return walk;
    }

    private static LeaseEvent any(Random random, ControlState control) {
        String user = USERS[random.nextInt(USERS.length)];
        String other = USERS[random.nextInt(USERS.length)];
        long epoch = control.epoch() - random.nextInt(2);
        return switch (random.nextInt(16)) {
            case 0, 1 -> new LeaseEvent.Command(user, null);
            case 2 -> new LeaseEvent.Command(user, epoch);
            case 3 -> new LeaseEvent.TakeControl(user);
            case 4, 5 -> new LeaseEvent.Request(user, random.nextBoolean() ? "why" : null);
            case 6 -> new LeaseEvent.Grant(user, other);
            case 7 -> new LeaseEvent.Refuse(user, other, null);
            case 8 -> new LeaseEvent.HandOver(user, other);
            case 9 -> new LeaseEvent.TakeOver(user, "because");
            case 10, 11 -> new LeaseEvent.Heartbeat(user, epoch);
            case 12 -> new LeaseEvent.Release(user);
            case 13 -> random.nextInt(4) == 0 ? new LeaseEvent.Expel(user) : new LeaseEvent.PilotActed("LOITER");
            case 14 -> new LeaseEvent.PilotLeft();
            default -> new LeaseEvent.TimeAdvanced(random.nextBoolean(), random.nextBoolean());
        };
    }
}
