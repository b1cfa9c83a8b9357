package org.dronemap.core.cloud;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.dronemap.core.cloud.rule.RecentModeCommands;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Contention;
import org.dronemap.core.drone.Capabilities;
import org.jspecify.annotations.Nullable;

/**
 * All commands under way: those whose outcome is not known or not stored yet. Any thread; each one belongs to its
 * drone's lane.
 */
final class PendingCommands {
    private final ConcurrentHashMap<CommandId, PendingCommand> all = new ConcurrentHashMap<>();

    @Nullable
    PendingCommand find(CommandId id) {
        return all.get(id);
    }

    /** The one with this id that is under way already; null when there is none, and this one is now. */
    @Nullable
    PendingCommand add(PendingCommand entry) {
        return all.putIfAbsent(entry.open().record().id(), entry);
    }

    void remove(PendingCommand entry) {
        all.remove(entry.open().record().id(), entry);
    }

    /** A drone's. */
    List<PendingCommand> of(ManagedDrone drone) {
        return all.values().stream().filter(entry -> entry.drone() == drone).toList();
    }

    /** Something that was given under the control of now is under way. */
    boolean isBusy(ManagedDrone drone) {
        return open(drone).anyMatch(PendingCommand::isUnderControl);
    }

    /** What may change the drone's way, as people call it: changes of mode alone leave it to whoever steers. */
    Optional<String> manoeuvre(ManagedDrone drone) {
        return open(drone)
                .filter(entry -> contention(entry) == Contention.FLIGHT
                        && entry.open().command().kind() != CommandKind.SET_MODE)
                .map(entry -> entry.open().record().summary())
                .findFirst();
    }

    /** What brings a mission, or the like, to the drone or from it, as people call it. */
    Optional<String> transfer(ManagedDrone drone) {
        return open(drone)
                .filter(entry -> contention(entry) == Contention.TRANSFER)
                .map(entry -> entry.open().record().summary())
                .findFirst();
    }

    /** What writes parameters of its drone, other than that one, as people call it. */
    Optional<String> writingParameters(PendingCommand except) {
        return open(except.drone())
                .filter(entry -> !entry.equals(except)
                        && contention(entry) == Contention.PARAMETERS
                        && entry.open().command().kind() != CommandKind.READ_PARAMETERS)
                .map(entry -> entry.open().record().summary())
                .findFirst();
    }

    /** Something that may put the drone into that mode. */
    boolean mayLeadTo(ManagedDrone drone, String mode, Capabilities can) {
        return of(drone).stream()
                .anyMatch(entry -> RecentModeCommands.mayLeadTo(entry.open().command(), mode, can));
    }

    /** One that has ended stays in the list until its outcome is written. */
    private Stream<PendingCommand> open(ManagedDrone drone) {
        return of(drone).stream().filter(entry -> entry.open().record().outcome() == null);
    }

    /** What competes with that one, and was asked for before it. */
    List<PendingCommand> before(PendingCommand entry) {
        return open(entry.drone())
                .filter(other -> !other.equals(entry)
                        && other.open().order() <= entry.open().order())
                .filter(other -> contention(other) == contention(entry))
                .toList();
    }

    private static Contention contention(PendingCommand entry) {
        return entry.open().command().kind().contention();
    }
}
