package org.dronemap.core.operation;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Decision of an operation's state machine on one input: next state and actions.
 *
 * @param actions in this order, after the decision was written down
 * @param why for people, as one or more sentences; null: nothing that they would want to read
 */
public record OperationDecision<S, I>(
        S next, List<OperationAction<I>> actions, @Nullable String why) {
    public OperationDecision {
        actions = List.copyOf(actions);
    }

    public static <S, I> OperationDecision<S, I> unchanged(S state) {
        return new OperationDecision<>(state, List.of(), null);
    }
}
