package org.dronemap.core.operation;

/** Writes state, inputs and decisions of one kind of operation as text for its journal, and reads them again. */
public interface OperationCodec<S, I> {
    String state(S state);

    S state(String text);

    String input(I input);

    I input(String text);

    /** With the state that it leads to, or what vouches for it; is compared, never read. */
    String decision(OperationDecision<S, I> decision);
}
