package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.parameter.OverriddenParameter;
import org.jspecify.annotations.Nullable;

/**
 * State of a drone's behaviour on loss of the cloud, and its owner's values still to be restored.
 *
 * @param action null: not known
 * @param returnMeters how high it flies home, where the cloud chose that
 * @param outstanding what its owner had set and is to be put back
 */
public record CloudLossState(
        State state,
        @Nullable CloudLossAction action,
        @Nullable Double returnMeters,
        String sentence,
        List<OverriddenParameter> outstanding) {
    /** State of the cloud-loss setting: set by the cloud, left as the owner set it, or impossible to set. */
    public enum State {
        /** It does what it is told here. */
        SET,
        /** It does what its owner has set. */
        NOT_SET,
        /** There is nothing on this vehicle that the cloud could set. */
        CANNOT_BE_SET
    }

    public static final CloudLossState UNKNOWN = new CloudLossState(
            State.NOT_SET,
            null,
            null,
            "What it does without the cloud is as its owner has set it, until it is armed from here.",
            List.of());

    public CloudLossState {
        outstanding = List.copyOf(outstanding);
    }

    /** With one sentence more. */
    public CloudLossState and(String more) {
        return new CloudLossState(state, action, returnMeters, sentence + " " + more, outstanding);
    }

    public CloudLossState returningAt(double meters) {
        return new CloudLossState(state, action, meters, sentence, outstanding);
    }

    public CloudLossState withOutstanding(List<OverriddenParameter> values) {
        return new CloudLossState(state, action, returnMeters, sentence, values);
    }
}
