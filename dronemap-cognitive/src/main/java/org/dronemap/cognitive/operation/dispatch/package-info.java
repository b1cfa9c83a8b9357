/**
 * Sending a drone of the pool to a place and giving its control to whoever asked: a state machine.
 *
 * <p>Enters: an input, a decision or a stage of dispatches.
 *
 * <p>Never: the choice of a drone; threads, clocks and stores.
 */
@NullMarked
package org.dronemap.cognitive.operation.dispatch;

import org.jspecify.annotations.NullMarked;
