package org.dronemap.core.operation;

/**
 * Writes what an operation works with as text, and reads it again: the same value gives the same text, also after it was
 * read, and what cannot be read is an IllegalArgumentException.
 */
public interface OperationCodec<S, I> {
    String state(S state);

    S state(String text);

    String input(I input);

    I input(String text);

    /** With the state that it leads to, or what vouches for it; is compared, never read. */
    String decision(OperationDecision<S, I> decision);
}
