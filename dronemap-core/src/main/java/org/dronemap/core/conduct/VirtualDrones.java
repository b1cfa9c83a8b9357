package org.dronemap.core.conduct;

import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.UnaryOperator;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.DroneSelection;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualDroneObjection;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.core.virtual.VirtualRunOrder;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Creates, changes and runs virtual drones, all on one thread. Looked at by any thread; changes wait for the conductor,
 * which writes them down before anything is commanded.
 */
public final class VirtualDrones implements CloudListener, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(VirtualDrones.class);
    /** The way in that commands of virtual drones come by. */
    static final String FACE = "virtual";

    private static final Duration USUAL_RHYTHM = Duration.ofMillis(200);
    /** Of these turns one looks for drones for those that wait. */
    private static final int TURNS_PER_SEARCH = 5;

    private final CloudManager cloud;
    private final VirtualDroneRegistry book;
    private final VirtualRunMachine machine;
    private final VirtualRunExecutor runs;
    private final VirtualRunQueue queue;
    private final LostDroneRecall recalls;
    private final Duration rhythm;
    private final Clock clock;
    private final LongAdder failed = new LongAdder();
    private final ExecutionThread thread;
    // Owned by the thread.
    private int turn;

    /** A change that cannot be made, with the reason why. */
    public static final class Refused extends RuntimeException {
        private static final long serialVersionUID = 1L;

        @SuppressWarnings("serial") // refusals stay within the process
        private final Objection objection;

        private Refused(VirtualDroneObjection why, String sentence) {
            super(sentence, null, false, false);
            this.objection = Objection.of(why, sentence);
        }

        public Objection objection() {
            return objection;
        }
    }

    /** A place in the queue, counted from 1, of so many. */
    public record QueuePosition(int position, int length) {}

    public VirtualDrones(
            CloudManager cloud,
            VirtualDroneStore store,
            VirtualRunMachine machine,
            VirtualDroneRights rights,
            SeparationBoard board,
            Time time) {
        this(cloud, store, machine, rights, board, USUAL_RHYTHM, time);
    }

    /** {@code rhythm}: between two looks at all that is under way. */
    public VirtualDrones(
            CloudManager cloud,
            VirtualDroneStore store,
            VirtualRunMachine machine,
            VirtualDroneRights rights,
            SeparationBoard board,
            Duration rhythm,
            Time time) {
        this.cloud = cloud;
        this.book = new VirtualDroneRegistry(store);
        this.machine = machine;
        this.rhythm = rhythm;
        this.clock = time.clock();
        this.thread = new ExecutionThread(time, "conductor");
        DroneGateway crew = new DroneGateway(cloud, FACE);
        VirtualRunExecutor.Context context = new VirtualRunExecutor.Context(machine, rights, board, time);
        this.runs = new VirtualRunExecutor(cloud, book, crew, context);
        this.queue = new VirtualRunQueue(cloud, book, crew, context);
        this.recalls = new LostDroneRecall(cloud, book, new ReturnCommander(crew, time));
    }

    /** Takes up what was under way when the process ended, before it returns; then goes on with it. */
    public void start() {
        runs.restore();
        goOn();
    }

    /** The same, but what was under way is suspended: its drones go home, and nothing waits for drones any more. */
    public void startSuspended(String why) {
        runs.suspendAll(why);
        goOn();
    }

    private void goOn() {
        cloud.addListener(this);
        thread.every(rhythm, this::turn);
    }

    public void addListener(VirtualDroneListener listener) {
        book.addListener(listener);
    }

    /** The oldest first. */
    public List<VirtualDrone> all() {
        return book.all();
    }

    public Optional<VirtualDrone> find(VirtualDroneId id) {
        return book.find(id);
    }

    /** Empty when it does not wait. */
    public Optional<QueuePosition> place(VirtualDroneId id) {
        List<VirtualDroneId> waiting =
                book.waiting().stream().map(VirtualDrone::id).toList();
        int index = waiting.indexOf(id);
        return index < 0 ? Optional.empty() : Optional.of(new QueuePosition(index + 1, waiting.size()));
    }

    /** Why the drones of the warehouse cannot serve it now; nothing when it does not wait. */
    public List<DroneSelection.Unfit> waitingFor(VirtualDroneId id) {
        return queue.waitingFor(id);
    }

    public void add(VirtualDrone drone) {
        thread.ask(() -> {
            book.put(drone);
            return drone;
        });
    }

    /** Name, needs and mission, as they are to be next time. */
    public VirtualDrone edit(VirtualDroneId id, UnaryOperator<VirtualDrone> change) {
        return thread.ask(() -> put(change.apply(known(id))));
    }

    /** Asks for its mission to be flown, by as many drones as it may have; it waits for its turn. */
    public VirtualDrone launch(VirtualDroneId id, MissionCloudLossPolicy onCloudLoss) {
        return thread.ask(() -> {
            VirtualDrone drone = known(id);
            Mission mission = drone.mission();
            if (mission == null) {
                throw new Refused(VirtualDroneObjection.NO_MISSION, "Plan its mission first.");
            }
            if (drone.isUnderWay()) {
                throw new Refused(VirtualDroneObjection.UNDER_WAY, "Its mission is under way already.");
            }
            VirtualRunOrder order = new VirtualRunOrder(
                    book.nextTicket(), mission, onCloudLoss, drone.plan().upTo());
            return put(drone.with(List.of(VirtualRun.asked(order, clock.instant()))));
        });
    }

    public VirtualDrone stop(VirtualDroneId id) {
        return thread.ask(() -> {
            VirtualDrone drone = known(id);
            if (!drone.isUnderWay()) {
                throw new Refused(VirtualDroneObjection.NOT_UNDER_WAY, "Its mission is not under way.");
            }
            return put(drone.with(drone.runs().stream()
                    .map(run -> machine.stop(run, clock.instant()))
                    .toList()));
        });
    }

    /** Goes on with the waypoints that are not flown, of all shares that wait for that. */
    public VirtualDrone resume(VirtualDroneId id) {
        return thread.ask(() -> {
            VirtualDrone drone = known(id);
            List<VirtualRun> resumed = drone.runs().stream()
                    .map(run -> machine.resume(run, clock.instant()).orElse(run))
                    .toList();
            if (resumed.equals(drone.runs())) {
                throw new Refused(VirtualDroneObjection.NOT_SUSPENDED, "It does not wait for being resumed.");
            }
            return put(drone.with(resumed));
        });
    }

    public void remove(VirtualDroneId id) {
        thread.ask(() -> {
            VirtualDrone drone = known(id);
            if (drone.isUnderWay()) {
                throw new Refused(VirtualDroneObjection.UNDER_WAY, "Its mission is under way; stop it first.");
            }
            if (!drone.recalled().isEmpty()) {
                throw new Refused(VirtualDroneObjection.DRONE_AWAY, "A drone that served it is not back yet.");
            }
            book.remove(drone);
            return drone;
        });
    }

    /** Drones that may serve virtual ones. */
    public Set<DroneId> warehouse() {
        return book.warehouse();
    }

    /** What waits for a drone, the first in turn first, and what that one would fly of it at once. Changes nothing. */
    public List<VirtualDroneMatch> prospects(DroneState drone) {
        return thread.ask(() -> queue.prospects(drone));
    }

    public void addToWarehouse(DroneId drone) {
        thread.ask(() -> {
            book.addToWarehouse(drone);
            return drone;
        });
    }

    /** What it serves now it serves to the end. */
    public void removeFromWarehouse(DroneId drone) {
        thread.ask(() -> {
            book.removeFromWarehouse(drone);
            return drone;
        });
    }

    /** For how long its thread has been at the same thing; zero: it rests. */
    public Duration busyFor() {
        return thread.busyFor();
    }

    /** Turns that failed, each logged. */
    public long failedCount() {
        return failed.sum();
    }

    @Override
    public void commandChanged(CommandRecord command) {
        boolean others = !command.face().equals(FACE)
                && !command.face().equals(SeparationConductor.FACE)
                && command.phase() == CommandPhase.SENT
                && CommandKind.named(command.type())
                        .filter(kind -> kind.purpose().interrupts())
                        .isPresent();
        if (others) {
            soon(() -> book.all().stream()
                    .filter(drone -> drone.bound().contains(command.drone()))
                    .forEach(drone -> runs.interrupt(
                            drone, command.drone(), command.by() + " told the drone: " + command.summary() + ".")));
        }
    }

    @Override
    public void droneRemoved(DroneId id) {
        soon(() -> book.forget(id));
    }

    private VirtualDrone known(VirtualDroneId id) {
        return book.find(id)
                .orElseThrow(() -> new Refused(VirtualDroneObjection.GONE, "There is no virtual drone " + id + "."));
    }

    private VirtualDrone put(VirtualDrone drone) {
        book.put(drone);
        return drone;
    }

    private void turn() {
        for (VirtualDrone drone : book.all()) {
            guard(() -> {
                runs.resume(drone);
                book.find(drone.id()).ifPresent(recalls::recall);
            });
        }
        guard(runs::publishIntents);
        turn = (turn + 1) % TURNS_PER_SEARCH;
        if (turn == 0) {
            guard(queue::serve);
        }
    }

    private void soon(Runnable work) {
        thread.soon(() -> guard(work));
    }

    /** One that cannot be conducted must not keep the others from it. */
    private void guard(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException e) {
            failed.increment();
            LOG.error("Conducting a virtual drone failed; it is tried again", e);
        }
    }

    @Override
    public void close() {
        cloud.removeListener(this);
        thread.close();
    }
}
