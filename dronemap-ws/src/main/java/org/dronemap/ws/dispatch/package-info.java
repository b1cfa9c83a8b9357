/**
 * Sending a drone of the pool to a place.
 *
 * <p>Enters: use cases about dispatches.
 *
 * <p>Never: what the drone is told on its way: that is cognitive.
 */
@NullMarked
package org.dronemap.ws.dispatch;

import org.jspecify.annotations.NullMarked;
