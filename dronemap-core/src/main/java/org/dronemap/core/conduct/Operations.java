package org.dronemap.core.conduct;

import java.time.Clock;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Starts, runs and ends operations (mission runs and follows), all on one thread. Looked at by any thread; changes wait
 * for the conductor, which writes each decision down before anything of it happens.
 */
public final class Operations implements CloudListener, AutoCloseable {
    /** The way in that commands of operations come by. */
    public static final String FACE = "operation";

    /** So long an operation that has ended is kept, with its journal. */
    public static final Duration KEPT = Duration.ofDays(90);

    private static final Logger LOG = LoggerFactory.getLogger(Operations.class);
    private static final String SET_ASIDE = "The server set it aside, and sent its drones home; its journal says why.";
    private static final Duration RHYTHM = Duration.ofMillis(100);
    private static final Duration BETWEEN_TIDYINGS = Duration.ofHours(6);
    private static final int COMPUTING_THREADS = 2;
    private static final int MOST_WAITING = 16;

    private final CloudManager cloud;
    private final OperationStore store;
    private final Clock clock;
    private final ComputationExecutor computations;
    private final OperationRegistry book;
    private final CopyOnWriteArrayList<OperationListener> listeners = new CopyOnWriteArrayList<>();
    private final AtomicBoolean woken = new AtomicBoolean();
    private final ExecutionThread thread;

    /** A change that cannot be made, with the sentence why. */
    public static final class Refused extends RuntimeException {
        private static final long serialVersionUID = 1L;

        @SuppressWarnings("serial") // refusals stay within the process
        private final Objection objection;

        public Refused(Objection objection) {
            super(objection.sentence(), null, false, false);
            this.objection = objection;
        }

        public Objection objection() {
            return objection;
        }

        public String why() {
            return objection.sentence();
        }
    }

    /** Control of a drone cannot be had, with a sentence that names the drone by its id. */
    public static final class NoControl extends RuntimeException {
        private static final long serialVersionUID = 1L;

        @SuppressWarnings("serial")
        private final DroneId drone;

        NoControl(DroneId drone, String why) {
            super(why, null, false, false);
            this.drone = drone;
        }

        public DroneId drone() {
            return drone;
        }

        public String why() {
            return String.valueOf(getMessage());
        }
    }

    /**
     * An operation with its state, as they are at one moment.
     *
     * @param setAside nobody conducts it any more although its state says so; then a sentence
     */
    public record Snapshot<S>(
            SavedOperation saved, S state, @Nullable String setAside) {}

    /** {@code kinds}: all that can be stored, so that they are known after a restart. */
    public Operations(
            CloudManager cloud,
            OperationStore store,
            OperationRights rights,
            SeparationBoard board,
            Time time,
            Collection<OperationKind<?, ?>> kinds) {
        this.cloud = cloud;
        this.store = store;
        this.clock = time.clock();
        this.thread = new ExecutionThread(time, "operations");
        LongSupplier nanoTime = time::nanos;
        this.computations = new ComputationExecutor(time, COMPUTING_THREADS, MOST_WAITING);
        DroneGateway crew = new DroneGateway(cloud, FACE);
        OperationExecution.Context means = new OperationExecution.Context(
                store,
                crew,
                new ObservationBuilder(cloud, crew, rights, board, time),
                board,
                computations,
                clock,
                nanoTime,
                this::wake,
                (saved, why) -> listeners.forEach(listener -> listener.changed(saved, why)));
        FaultedOperations aside = new FaultedOperations(means, new ReturnCommander(crew, time), cloud::drone);
        this.book = new OperationRegistry(
                means, aside, kinds, () -> cloud.drones().stream().map(DroneState::id));
    }

    /** What was under way when the process ended is there again, in control of its drones; it is left as it is. */
    public void restore() {
        book.restore();
        cloud.addListener(this);
    }

    /** Instead of taking up what was under way: none of it goes on, and its drones go home. */
    public void setAside(String why) {
        book.setAside(why);
        cloud.addListener(this);
    }

    /** For when vehicles can be heard: how long they are silent counts from here. */
    public void goOn() {
        thread.ask(() -> {
            book.goOn();
            return true;
        });
        thread.every(RHYTHM, this::turn);
        thread.every(BETWEEN_TIDYINGS, this::tidy);
    }

    /** The names of what it conducts. */
    public Set<String> kinds() {
        return book.kinds();
    }

    public void addListener(OperationListener listener) {
        listeners.add(listener);
    }

    /**
     * Takes control of all of its drones, writes it down, and goes on with it.
     *
     * @param begun without entries and without text of a state
     * @throws NoControl when control of a drone cannot be had
     */
    public <S, I> Snapshot<S> begin(OperationKind<S, I> kind, SavedOperation begun, S state) {
        return thread.ask(() -> {
            JournalEntry first =
                    new JournalEntry(0, begun.beganAt(), kind.codec().state(state), "");
            return picture(book.begin(kind, begun, first, state));
        });
    }

    /**
     * Tells an operation what a user wants.
     *
     * @throws Refused when that cannot be taken now
     */
    public <S, I> Snapshot<S> request(OperationKind<S, I> kind, OperationId id, I input) {
        return thread.ask(() -> {
            OperationExecution<S, I> conducted = book.find(kind, id)
                    .orElseThrow(() -> new Refused(
                            Objection.of(OperationObjection.OVER, "It is over, or there is no such operation.")));
            Optional<Objection> why = conducted.request(input);
            if (why.isPresent()) {
                throw new Refused(why.get());
            }
            book.tidy();
            return picture(conducted);
        });
    }

    /** Tells an operation where what it is about was seen. */
    public <S, I> TargetReportResult reported(OperationKind<S, I> kind, OperationId id, TargetReport sighting) {
        return book.find(kind, id).map(one -> one.reported(sighting)).orElse(TargetReportResult.NOT_EXPECTED);
    }

    /** Tells an operation how whoever tells it of sightings is reached; false when it is not under way. */
    public <S, I> boolean reporterStateChanged(OperationKind<S, I> kind, OperationId id, ReporterState how) {
        Optional<OperationExecution<S, I>> conducted = book.find(kind, id);
        conducted.ifPresent(one -> one.reporterStateChanged(how));
        return conducted.isPresent();
    }

    /** How that one is reached; empty: it is not known, or the operation is not under way. */
    public <S, I> Optional<ReporterState> reporterState(OperationKind<S, I> kind, OperationId id) {
        return book.find(kind, id).flatMap(OperationExecution::reporterState);
    }

    /** Where that was seen last since the process began; empty: nowhere, or the operation is not under way. */
    public <S, I> Optional<TargetReport> newestReport(OperationKind<S, I> kind, OperationId id) {
        return book.find(kind, id).flatMap(OperationExecution::newestReport);
    }

    /** Under way, set aside or over. */
    public <S, I> Optional<Snapshot<S>> find(OperationKind<S, I> kind, OperationId id) {
        Optional<Snapshot<S>> underWay = book.find(kind, id).map(Operations::picture);
        return underWay.isPresent() ? underWay : store.find(id).flatMap(saved -> picture(kind, saved));
    }

    /** Those of a kind that are under way, the oldest first. */
    public <S, I> List<Snapshot<S>> underWay(OperationKind<S, I> kind) {
        return book.all(kind).stream().map(Operations::picture).toList();
    }

    /** Those of a kind that were set aside and still have drones to see to, and can be read. */
    public <S, I> List<Snapshot<S>> setAside(OperationKind<S, I> kind) {
        return book.aside().ofKind(kind.name()).stream()
                .flatMap(saved -> picture(kind, saved).stream())
                .toList();
    }

    /** As it is stored; empty: it is another kind of operation, or cannot be read. */
    public <S, I> Optional<Snapshot<S>> picture(OperationKind<S, I> kind, SavedOperation saved) {
        if (!saved.kind().equals(kind.name())) {
            return Optional.empty();
        }
        try {
            S state = kind.codec().state(saved.state());
            boolean conducted = saved.endedAt() == null || kind.machine().isOver(state);
            String why = book.aside().reasons().getOrDefault(saved.id(), conducted ? null : SET_ASIDE);
            return Optional.of(new Snapshot<>(saved, state, why));
        } catch (IllegalArgumentException unreadable) {
            LOG.warn("The operation {} cannot be read", saved.id(), unreadable);
            return Optional.empty();
        }
    }

    /** The newest of an organisation and kind, under way or over, the newest first. */
    public List<SavedOperation> latest(OrganisationId organisation, OperationKind<?, ?> kind, int limit) {
        return store.latest(organisation, kind.name(), limit);
    }

    /** Entries of a journal from that number on, in order. */
    public List<JournalEntry> journal(OperationId id, long from, int limit) {
        return store.journal(id, from, limit);
    }

    private static <S, I> Snapshot<S> picture(OperationExecution<S, I> conducted) {
        OperationExecution.Snapshot<S> now = conducted.now();
        return new Snapshot<>(now.saved(), now.state(), null);
    }

    /** For how long its thread has been at the same thing; zero: it rests. */
    public Duration busyFor() {
        return thread.busyFor();
    }

    /** Turns that failed since the start. */
    public long failedCount() {
        return book.failedCount();
    }

    /** What keeps operations from going on now, as sentences. */
    public List<String> troubles() {
        return book.troubles();
    }

    @Override
    public void commandChanged(CommandRecord command) {
        if (command.face().equals(FACE) && command.outcome() != null) {
            wake();
        }
    }

    @Override
    public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
        if (now.interruption() != null) {
            thread.soon(() -> book.interrupted(drone));
        }
    }

    private void turn() {
        woken.set(false);
        book.turn();
    }

    private void tidy() {
        try {
            int forgotten = store.forgetEndedBefore(clock.instant().minus(KEPT));
            if (forgotten > 0) {
                LOG.info("{} operations that ended more than {} days ago were forgotten", forgotten, KEPT.toDays());
            }
        } catch (RuntimeException e) {
            LOG.warn("Old operations cannot be forgotten now; it is tried again", e);
        }
    }

    private void wake() {
        if (woken.compareAndSet(false, true)) {
            thread.soon(this::turn);
        }
    }

    @Override
    public void close() {
        cloud.removeListener(this);
        thread.close();
        computations.close();
    }
}
