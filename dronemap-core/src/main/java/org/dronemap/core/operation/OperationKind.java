package org.dronemap.core.operation;

/**
 * Operations of one machine.
 *
 * @param name for ever: what is stored goes by it
 */
public record OperationKind<S, I>(String name, Operation<S, I> machine, OperationCodec<S, I> codec) {}
