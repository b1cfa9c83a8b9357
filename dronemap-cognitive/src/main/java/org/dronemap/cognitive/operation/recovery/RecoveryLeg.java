package org.dronemap.cognitive.operation.recovery;

import java.time.Instant;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * One drone of a recovery, with the command that is under way.
 *
 * @param number which drone of the recovery it is, from 0
 * @param highestMeters above its home: the most that zones and the order let it fly home at
 * @param slot its part of the plan; null: there is none yet, or it could not be planned for
 * @param issued the command that is under way; null: none
 * @param sent by what it was sent on the move that it is in; null: it was not yet
 * @param height the height at which it returns, as the recovery sets it
 * @param signs since when it is silent, or may go on
 * @param end what became of it; null: it is under way
 */
@Stored(names = "drone name number highestMeters slot step issued attempts sent height signs end")
public record RecoveryLeg(
        DroneId drone,
        String name,
        int number,
        double highestMeters,
        @Nullable RecoverySlot slot,
        RecoveryStep step,
        @Nullable IssuedCommand issued,
        Attempts attempts,
        IssuedCommand.@Nullable Purpose sent,
        HeightSetting height,
        Signs signs,
        @Nullable LegEnd end) {
    /** A command that the drone was given. */
    @Stored(names = "command purpose at")
    public record IssuedCommand(CommandId command, Purpose purpose, Instant at) {
        /** The purpose of the command. */
        @Stored(names = "HOLD HEIGHT GO_TO RETURN LAND DISARM")
        public enum Purpose {
            HOLD,
            HEIGHT,
            GO_TO,
            RETURN,
            LAND,
            DISARM
        }
    }

    /**
     * Attempts of all commands, and of those that failed in a row.
     *
     * @param notBefore nothing is tried before; null: it may be at once
     */
    @Stored(names = "given failed notBefore")
    public record Attempts(int given, int failed, @Nullable Instant notBefore) {
        static final Attempts NONE = new Attempts(0, 0, null);
    }

    /**
     * The return height of the vehicle.
     *
     * @param asked it was set, or could not be
     * @param beforeMeters what was set before; null: nothing has to be put back
     */
    @Stored(names = "asked beforeMeters")
    public record HeightSetting(boolean asked, @Nullable Double beforeMeters) {
        static final HeightSetting NONE = new HeightSetting(false, null);
    }

    /**
     * Moments of the drone.
     *
     * @param silentSince null: it is heard
     * @param readySince since when it may go on and others are looked out for; null: it may not yet
     * @param note what is not as it should be, as a sentence; null: nothing
     */
    @Stored(names = "silentSince readySince note")
    public record Signs(
            @Nullable Instant silentSince,
            @Nullable Instant readySince,
            @Nullable String note) {
        static final Signs NONE = new Signs(null, null, null);
    }

    /** {@code why}: as a sentence; null: there is nothing to add. */
    @Stored(names = "outcome why")
    public record LegEnd(RecoveryOutcome outcome, @Nullable String why) {}

    static RecoveryLeg of(DroneId drone, String name, int number, double highestMeters) {
        return new RecoveryLeg(
                drone,
                name,
                number,
                highestMeters,
                null,
                RecoveryStep.ALOFT,
                null,
                Attempts.NONE,
                null,
                HeightSetting.NONE,
                Signs.NONE,
                null);
    }

    public boolean isOver() {
        return end != null;
    }

    RecoveryLeg with(@Nullable IssuedCommand command, Attempts tried) {
        return new RecoveryLeg(
                drone, name, number, highestMeters, slot, step, command, tried, sent, height, signs, end);
    }

    RecoveryLeg planned(@Nullable RecoverySlot part, RecoveryStep first) {
        return new RecoveryLeg(
                drone, name, number, highestMeters, part, first, issued, attempts, null, height, signs, end);
    }

    /** {@code moving}: by what it was sent on its way; null: it stands. */
    RecoveryLeg at(RecoveryStep next, IssuedCommand.@Nullable Purpose moving) {
        Signs now = new Signs(signs.silentSince(), null, signs.note());
        return new RecoveryLeg(
                drone, name, number, highestMeters, slot, next, issued, attempts, moving, height, now, end);
    }

    RecoveryLeg sent(IssuedCommand.@Nullable Purpose moving) {
        return new RecoveryLeg(
                drone, name, number, highestMeters, slot, step, issued, attempts, moving, height, signs, end);
    }

    RecoveryLeg with(HeightSetting other) {
        return new RecoveryLeg(
                drone, name, number, highestMeters, slot, step, issued, attempts, sent, other, signs, end);
    }

    RecoveryLeg with(Signs other) {
        return new RecoveryLeg(
                drone, name, number, highestMeters, slot, step, issued, attempts, sent, height, other, end);
    }

    RecoveryLeg noted(@Nullable String what) {
        return with(new Signs(signs.silentSince(), signs.readySince(), what));
    }

    RecoveryLeg ready(@Nullable Instant since) {
        return with(new Signs(signs.silentSince(), since, signs.note()));
    }

    RecoveryLeg silent(@Nullable Instant since) {
        return with(new Signs(since, signs.readySince(), signs.note()));
    }

    RecoveryLeg ended(RecoveryOutcome outcome, @Nullable String why) {
        return new RecoveryLeg(
                drone,
                name,
                number,
                highestMeters,
                slot,
                step,
                null,
                attempts,
                sent,
                height,
                signs,
                new LegEnd(outcome, why));
    }
}
