/**
 * Following a phone with one drone: a state machine, and who steers while it follows.
 *
 * <p>Enters: an input, a decision or a stage of follows.
 *
 * <p>Never: threads, clocks and stores.
 */
@NullMarked
package org.dronemap.cognitive.operation.follow;

import org.jspecify.annotations.NullMarked;
