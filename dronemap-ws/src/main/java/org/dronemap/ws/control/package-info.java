/**
 * Who commands a drone, and steering it by hand.
 *
 * <p>Enters: use cases about leases and setpoints.
 *
 * <p>Never: commands with an outcome.
 */
@NullMarked
package org.dronemap.ws.control;

import org.jspecify.annotations.NullMarked;
