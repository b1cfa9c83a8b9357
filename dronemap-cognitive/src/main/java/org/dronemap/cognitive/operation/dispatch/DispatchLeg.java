package org.dronemap.cognitive.operation.dispatch;

import java.time.Instant;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * One drone of a dispatch: the one that comes, or one that flies home, with the command that is under way.
 *
 * @param number which drone of the dispatch it is, from 0 in the order in which they were chosen
 * @param issued the command that is under way; null: none
 * @param going it was told to go to the place
 * @param failure why it cannot be told what it has to be told, as a sentence; null: it can
 */
@Stored(names = "chosen number issued attempts going failure")
public record DispatchLeg(
        ChosenDrone chosen,
        int number,
        @Nullable IssuedCommand issued,
        Attempts attempts,
        boolean going,
        @Nullable String failure) {
    /** A command that the drone was given. */
    @Stored(names = "command purpose")
    public record IssuedCommand(CommandId command, Purpose purpose) {
        /** The purpose of the command. */
        @Stored(names = "CLOUD_LOSS MODE ARM TAKE_OFF GO_TO HOME DISARM")
        public enum Purpose {
            CLOUD_LOSS("told to come home when the cloud is lost"),
            MODE("put into the mode in which it can be led"),
            ARM("armed"),
            TAKE_OFF("told to take off"),
            GO_TO("told to go there"),
            HOME("told to fly home"),
            DISARM("disarmed");

            private final String done;

            Purpose(String done) {
                this.done = done;
            }

            /** What was done to the drone if it succeeded, as a part of a sentence. */
            String done() {
                return done;
            }
        }
    }

    /**
     * Attempts of all commands, and of those that failed in a row.
     *
     * @param given commands so far
     * @param failed in a row
     * @param refusedSince when it was first refused to be armed; null: it was not
     * @param notBefore nothing is tried before; null: it may be at once
     */
    @Stored(names = "given failed refusedSince notBefore")
    public record Attempts(
            int given,
            int failed,
            @Nullable Instant refusedSince,
            @Nullable Instant notBefore) {
        static final Attempts NONE = new Attempts(0, 0, null, null);
    }

    static DispatchLeg of(ChosenDrone chosen, int number) {
        return new DispatchLeg(chosen, number, null, Attempts.NONE, false, null);
    }

    public DroneId drone() {
        return chosen.drone();
    }

    public String name() {
        return chosen.name();
    }

    DispatchLeg giving(IssuedCommand command) {
        Attempts next = new Attempts(attempts.given() + 1, attempts.failed(), attempts.refusedSince(), null);
        return new DispatchLeg(chosen, number, command, next, going, failure);
    }

    /** What it was told last is done. */
    DispatchLeg succeeded(IssuedCommand.Purpose purpose, Instant notBefore) {
        boolean goes = going || purpose == IssuedCommand.Purpose.GO_TO;
        return new DispatchLeg(chosen, number, null, new Attempts(attempts.given(), 0, null, notBefore), goes, failure);
    }

    /** What it was told last did not come about, for the reason that it is not ready yet. */
    DispatchLeg notReady(Instant at, Instant notBefore) {
        Instant since = attempts.refusedSince() == null ? at : attempts.refusedSince();
        Attempts next = new Attempts(attempts.given(), attempts.failed(), since, notBefore);
        return new DispatchLeg(chosen, number, null, next, going, failure);
    }

    DispatchLeg failed(Instant notBefore) {
        Attempts next = new Attempts(attempts.given(), attempts.failed() + 1, attempts.refusedSince(), notBefore);
        return new DispatchLeg(chosen, number, null, next, going, failure);
    }

    DispatchLeg failing(String why) {
        return new DispatchLeg(chosen, number, issued, attempts, going, why);
    }

    /** It stands for another one, and is told anew where to go. */
    DispatchLeg standing() {
        return new DispatchLeg(chosen, number, issued, attempts, false, failure);
    }

    /** Nothing of what it was told counts any more: it goes home, or is told anew where to go. */
    DispatchLeg anew() {
        return new DispatchLeg(chosen, number, null, new Attempts(attempts.given(), 0, null, null), false, null);
    }
}
