package org.dronemap.core.operation;

/**
 * A kind of operation, such as mission run or follow: its name, state machine and codec.
 *
 * @param name for ever: what is stored goes by it
 */
public record OperationKind<S, I>(String name, Operation<S, I> machine, OperationCodec<S, I> codec) {}
