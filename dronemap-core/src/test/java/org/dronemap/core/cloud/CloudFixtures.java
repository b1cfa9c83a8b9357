package org.dronemap.core.cloud;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.lease.SavedLease;
import org.jspecify.annotations.Nullable;

/** A vehicle and stores that remember what was asked of them. */
public final class CloudFixtures {
    public static final Capabilities ALL = new Capabilities(Set.of(Capability.values()), List.of("GUIDED", "LOITER"));

    private CloudFixtures() {}

    static Outcome refused(OutcomeCode code, String sentence) {
        return new Outcome.Refused(CommandGate.GATE, sentence, code);
    }

    public static Identification copter(@Nullable String uid) {
        return new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", uid);
    }

    public static DroneLink bound(ClaimResult admission) {
        if (admission instanceof ClaimResult.Bound bound) {
            return bound.link();
        }
        throw new AssertionError(admission);
    }

    /** Takes commands and lets the test say how they end. */
    public static final class RecordingChannel implements VehicleChannel {
        public final List<Command> performed = new CopyOnWriteArrayList<>();
        /** What it has no way to do, and nobody thought of. */
        public volatile @Nullable Class<? extends Command> forgotten;

        public final List<Setpoint> setpoints = new CopyOnWriteArrayList<>();
        public final List<CommandId> cancelled = new CopyOnWriteArrayList<>();
        public final ConcurrentHashMap<CommandId, Report> reports = new ConcurrentHashMap<>();
        public final ConcurrentHashMap<Report, EpochGuard> fences = new ConcurrentHashMap<>();

        /** What it does without the cloud is set and put back at once, and not remembered here. */
        public volatile boolean settlesAtOnce = true;

        @Override
        public void perform(SendAuthority mandate, Command command, Report report) {
            if (settlesAtOnce && (command instanceof SetCloudLossAction || command instanceof RestoreParameters)) {
                report.ended(new Outcome.Succeeded());
                return;
            }
            if (command.getClass() == forgotten) {
                throw new IllegalStateException("nobody handles " + command);
            }
            performed.add(command);
            fences.put(report, mandate.fence());
            reports.put(Objects.requireNonNull(mandate.command()), report);
        }

        @Override
        public void steer(SendAuthority mandate, Setpoint setpoint) {
            mandate.fence().pass(() -> setpoints.add(setpoint));
        }

        @Override
        public void cancel(CommandId id) {
            cancelled.add(id);
        }

        @Override
        public void probe() {}
    }

    public static final class InMemoryCommandStore implements CommandStore {
        public final ConcurrentHashMap<CommandId, CommandRecord> records = new ConcurrentHashMap<>();
        public volatile boolean broken;
        /** What the next intents fail with; null: they do not. */
        public volatile @Nullable RuntimeException beginFailure;

        /** Outcomes wait for it before they are written. */
        public volatile CountDownLatch disk = new CountDownLatch(0);
        /** Intents, and whoever looks for a command, wait for it. */
        public volatile CountDownLatch answers = new CountDownLatch(0);

        @Override
        public boolean begin(CommandRecord command) {
            awaits(answers);
            RuntimeException failure = beginFailure;
            if (failure != null) {
                throw failure;
            }
            if (broken) {
                throw new IllegalStateException("the disk is full");
            }
            return records.putIfAbsent(command.id(), command) == null;
        }

        @Override
        public void finish(CommandRecord command) {
            awaits(disk);
            if (broken) {
                throw new IllegalStateException("the disk is full");
            }
            records.put(command.id(), command);
        }

        private static void awaits(CountDownLatch latch) {
            try {
                latch.await();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }

        @Override
        public Optional<CommandRecord> command(CommandId id) {
            awaits(answers);
            if (broken) {
                throw new IllegalStateException("the disk is full");
            }
            return Optional.ofNullable(records.get(id));
        }

        @Override
        public List<CommandRecord> commandsOf(DroneId drone, int limit) {
            return records.values().stream()
                    .filter(record -> record.drone().equals(drone))
                    .limit(limit)
                    .toList();
        }

        @Override
        public int endUnfinished(Outcome outcome, Instant at) {
            return 0;
        }
    }

    public static final class InMemoryDroneStore implements DroneStore {
        public final ConcurrentHashMap<DroneId, DroneRecord> records = new ConcurrentHashMap<>();
        public final ConcurrentHashMap<DroneId, KnownMission> missions = new ConcurrentHashMap<>();

        @Override
        public List<DroneRecord> drones() {
            return new ArrayList<>(records.values());
        }

        @Override
        public void save(DroneRecord drone) {
            records.put(drone.id(), drone);
        }

        @Override
        public void delete(DroneId id) {
            records.remove(id);
        }

        @Override
        public Optional<KnownMission> knownMission(DroneId id) {
            return Optional.ofNullable(missions.get(id));
        }

        @Override
        public void saveKnownMission(DroneId id, KnownMission mission) {
            missions.put(id, mission);
        }
    }

    public static final class InMemoryLeaseStore implements LeaseStore {
        public final ConcurrentHashMap<DroneId, SavedLease> leases = new ConcurrentHashMap<>();
        /** How many were saved as what a call is about. */
        public final AtomicLong ofCalls = new AtomicLong();

        private final AtomicLong reserved = new AtomicLong();

        @Override
        public List<SavedLease> leases() {
            return List.copyOf(leases.values());
        }

        @Override
        public void save(SavedLease lease) {
            leases.put(lease.drone(), lease);
            AuditedCall.current().ifPresent(call -> ofCalls.incrementAndGet());
        }

        @Override
        public void delete(DroneId drone) {
            leases.remove(drone);
        }

        @Override
        public long reserve(int count) {
            return reserved.addAndGet(count);
        }
    }

    public static final class InMemoryParameterOverrideStore implements ParameterOverrideStore {
        public final ConcurrentHashMap<DroneId, ParameterOverrides> kept = new ConcurrentHashMap<>();
        public volatile boolean broken;

        @Override
        public List<ParameterOverrides> all() {
            return List.copyOf(kept.values());
        }

        @Override
        public void save(ParameterOverrides values) {
            if (broken) {
                throw new IllegalStateException("the disk is full");
            }
            kept.put(values.drone(), values);
        }

        @Override
        public void delete(DroneId drone) {
            kept.remove(drone);
        }
    }
}
